# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .tir file of a fit."""

from biface.errors import BifaceError
from . import coefficients as known
from .coefficients import NAMES_52
from .text import of_combined
from .tir_file import SI_UNITS, SIDES, TirFile
from .units import one_of


def make_tir(fit, side="LEFT", title="", vertical=None, structural=None):
    """The file of a Fit: a TirFile.

    side        where the tire was mounted when it was measured, LEFT or RIGHT
    title       the first line of comments
    vertical    the Vertical of the data; None if it is not known
    structural  the Structural of results; None without them

    Comments tell the residuals, and which coefficients the data do not determine."""
    if side not in SIDES:
        raise BifaceError(f"the side is '{side}', but must be {one_of(SIDES)}.")
    formula = fit.formula
    is_old = formula.name == "5.2"
    file = TirFile(remarks=[title] if title else [])
    file.remarks += [f"Magic Formula {formula.name}, fitted to {len(fit.data)} states by "
                     "biface-tire-model.",
                     "RMS and largest residual in % of the peak of each channel:"]
    file.remarks += [f"  {channel}  {100 * residual.rms / (residual.peak or 1):7.3f} "
                     f"{100 * residual.largest / (residual.peak or 1):7.3f}"
                     for channel, residual in fit.residuals.items()]
    file.remarks += of_combined(fit)
    header = file.section("MDI_HEADER")
    for name, value in (("FILE_TYPE", "tir"), ("FILE_VERSION", 3.0),
                        ("FILE_FORMAT", "ASCII")):
        header.set(name, value)
    for name, value in {**SI_UNITS, "PRESSURE": "pascal"}.items():
        file.section("UNITS").set(name, value)
    model = file.section("MODEL")
    if is_old:
        model.set("PROPERTY_FILE_FORMAT", "PAC2002")
        model.set("USE_MODE", 4.0, "combined forces and moments")
        # without coefficients of combined slip its forces would not reduce each other
        is_combined = not {"RBX1", "RBY1"} & (set(fit.reasons) - fit.typical)
        model.set("FE_METHOD", "NO" if is_combined else "YES",
                  "combined slip by " + ("its coefficients" if is_combined else
                                         "a friction ellipse"))
    model.set("FITTYP", 6.0 if is_old else 61.0, f"Magic Formula {formula.name}")
    model.set("TYRESIDE", side, "side of the vehicle at the test")
    model.set("LONGVL", formula.velocity, "reference velocity")
    file.section("DIMENSION").set("UNLOADED_RADIUS",
                                  formula.coefficients["UNLOADED_RADIUS"])
    if formula.nominal_pressure:
        section = file.section("TIRE_CONDITIONS" if is_old else "OPERATING_CONDITIONS")
        for name in ("INFLPRES", "NOMPRES"):
            section.set(NAMES_52[name] if is_old else name, formula.nominal_pressure)
    file.section("VERTICAL").set("FNOMIN", formula.coefficients["FNOMIN"],
                                 "nominal load")
    if vertical:
        file.section("VERTICAL").set(
            "VERTICAL_STIFFNESS", float(f"{vertical.stiffness:.9g}"),
            f"of a line through the loaded radii from {vertical.lowest:.5g} to "
            f"{vertical.highest:.5g} N")
    if structural and not is_old:
        structural.write(file)
    add_ranges(file, fit.data)
    add_coefficients(file, fit)
    if structural and is_old:
        structural.write(file)
    return file


def add_ranges(file, data):
    """The ranges of the data."""
    for section, low, high, name in (
            ("LONG_SLIP_RANGE", "KPUMIN", "KPUMAX", "slip_ratio"),
            ("SLIP_ANGLE_RANGE", "ALPMIN", "ALPMAX", "slip_angle"),
            ("INCLINATION_ANGLE_RANGE", "CAMMIN", "CAMMAX", "inclination_angle"),
            ("VERTICAL_FORCE_RANGE", "FZMIN", "FZMAX", "F_z"),
            ("INFLATION_PRESSURE_RANGE", "PRESMIN", "PRESMAX", "pressure")):
        values = data[name]
        if values is not None:
            file.section(section).set(low, float(values.min()))
            file.section(section).set(high, float(values.max()))


def add_coefficients(file, fit):
    """The coefficients, each with its meaning and what is to be said of it."""
    formula = fit.formula
    is_old = formula.name == "5.2"
    for name, coefficient in known.COEFFICIENTS.items():
        if formula.name not in coefficient.formulas or name in known.EXTRA:
            continue
        if is_old and name in ("PPX1", "PPX2", "PPX3", "PPX4", "PPY1", "PPY2", "PPY3",
                               "PPY4", "PPZ1", "PPZ2", "PPMX1") \
                and not formula.nominal_pressure:
            continue
        comment = coefficient.meaning
        if name in fit.typical:
            comment += f"; typical, of {known.TYPICAL_TIRE}: {fit.reasons[name]}"
        elif name in fit.reasons:
            comment += f"; neutral: {fit.reasons[name]}"
        elif name in fit.at_bound:
            comment += "; at its bound"
        value = formula.coefficients.get(name, formula.neutral[name])
        file.section(coefficient.section).set(
            NAMES_52.get(name, name) if is_old else name,
            float(f"{value:.9g}"), comment)
