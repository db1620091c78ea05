# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is missing or unusual in a .tir file."""

import numpy as np

from biface.errors import BifaceError
from .coefficients import ALIASES, COEFFICIENTS, CONSTANTS, EXTRA
from .tir_file import DIMENSIONS, FITTYP, SIDES

# What would change forces and moments, in whichever section it stands
DECAY = "the decay of friction with the slip velocity"

# Entries of files that have other purposes than the formulas here
OTHER = {
    DECAY: ("LMUV",),
    "relaxation": ("PTX1", "PTX2", "PTX3", "PTX4", "PTY1", "PTY2", "PTY3", "LSGKP",
                   "LSGAL", "LGYR", "QTZ1"),
    "turn slip": ("PDXP1", "PDXP2", "PDXP3", "PKYP1", "PDYP1", "PDYP2", "PDYP3", "PDYP4",
                  "PHYP1", "PHYP2", "PHYP3", "PHYP4", "PECP1", "PECP2", "QDTP1", "QCRP1",
                  "QCRP2", "QBRP1", "QDRP1", "LMP"),
    "vertical and other stiffness": (
        "LCZ", "LIP", "PFZ1", "PCFX1", "PCFX2", "PCFX3", "PCFY1", "PCFY2", "PCFY3",
        "PCMZ1", "QFZ1", "QFZ2", "QFZ3", "QPFZ1", "QFCX1", "QFCY1", "QFCG1", "QV1", "QV2"),
}

# Between which constants of real tires lie, in SI units; others are a wrong unit
USUAL = {"UNLOADED_RADIUS": (0.01, 3, "m"), "FNOMIN": (20, 1e6, "N"),
         "LONGVL": (0.1, 150, "m/s"), "INFLPRES": (1e3, 1e7, "Pa"),
         "NOMPRES": (1e3, 1e7, "Pa")}

# Where a formula has coefficients: the sections in which unknown entries count
SECTIONS = sorted({coefficient.section for coefficient in COEFFICIENTS.values()})


def used_by(formula):
    """The coefficients of a formula."""
    return [coefficient for coefficient in COEFFICIENTS.values()
            if formula.name in coefficient.formulas]


def missing(file, formula):
    """The names of the coefficients and constants that a file does not have. Those for
    pressure are not missed by MF 5.2."""
    names = [name for name in CONSTANTS
             if not (formula.name == "5.2" and name in ("INFLPRES", "NOMPRES")
                     or name == "UNLOADED_RADIUS")]
    names += [coefficient.name for coefficient in used_by(formula)
              if not (coefficient.name in EXTRA
                      or formula.name == "5.2" and "p" in coefficient.needs)]
    return [name for name in names if file.find_number(name) is None]


def unknown(file):
    """The entries that nothing here uses: a dictionary of lists of names, by purpose or
    by section."""
    purposes = {name: purpose for purpose, names in OTHER.items() for name in names}
    result = {}
    for section in file.sections.values():
        for name in section.entries:
            if section.name not in SECTIONS and purposes.get(name) != DECAY:
                continue
            known = ALIASES.get(name, name)
            if known in COEFFICIENTS or known in DIMENSIONS:
                continue
            purpose = purposes.get(name, "no known purpose")
            result.setdefault(purpose, []).append(name)
    return result


def unusual(file, formula):
    """Sentences on coefficients out of their usual bounds."""
    result = []
    for coefficient in used_by(formula):
        value = file.find(coefficient.name)
        if coefficient.name == "PDY1" and value is not None:
            # files of MF 5 have the sign of F_y at positive slip angles
            value = abs(value)
        if value is not None and not coefficient.low <= value <= coefficient.high:
            result.append(f"{coefficient.name} is {value:g}, but usually lies between "
                          f"{coefficient.low:g} and {coefficient.high:g}.")
    return result


def wrong_units(file):
    """Sentences on constants that are likely to have another unit than the file says."""
    result = []
    for name, (low, high, unit) in USUAL.items():
        value = file.find_number(name)
        if value is not None and not low <= value <= high:
            result.append(f"{name} is {value:g} {unit} by the section [UNITS], but usually "
                          f"lies between {low:g} and {high:g} {unit}.")
    return result


def wrong_signs(formula, load):
    """Sentences on slopes at a load that no tire has in ISO axes."""
    result = []
    if formula.lateral(load).slope > 0:
        result.append(f"F_y rises with the slip angle at {load:g} N, but must fall in ISO "
                      "axes, those of .tir files.")
    if formula.longitudinal(load).slope < 0:
        result.append(f"F_x falls with the longitudinal slip at {load:g} N, but must rise.")
    return result


def doubtful(formula, file):
    """Sentences on curves that no tire has, within the range of loads of the file."""
    nominal = formula.p.FNOMIN
    low = max(file.find_number("FZMIN", 0.2 * nominal), 0.05 * nominal)
    high = file.find_number("FZMAX", 2 * nominal)
    if not low < high:
        return [f"FZMIN is {low:g}, but must be less than FZMAX, {high:g}."]
    loads = np.linspace(low, high, 25)
    result = []
    for what, curve in (("F_x", formula.longitudinal(loads)),
                        ("F_y", formula.lateral(loads))):
        # that of F_y may have the sign of the force, see unusual()
        wrong = loads[curve.D * (np.sign(formula.p.PDY1) if what == "F_y" else 1) <= 0]
        if wrong.size:
            result.append(f"The friction of {what} is not positive from the load "
                          f"{wrong[0]:.4g} to {wrong[-1]:.4g} N.")
    slopes = formula.longitudinal(loads).slope
    if (slopes <= 0).any():
        wrong = loads[slopes <= 0]
        result.append("The slip stiffness is not positive from the load "
                      f"{wrong[0]:.4g} to {wrong[-1]:.4g} N.")
    slopes = formula.lateral(loads).slope
    if (slopes >= 0).any():
        wrong = loads[slopes >= 0]
        result.append("The cornering stiffness has the wrong sign from the load "
                      f"{wrong[0]:.4g} to {wrong[-1]:.4g} N: F_y must fall with the slip "
                      "angle in these axes.")
    return result


def report(file):
    """What the command prints on a file: text, and whether it found anything wrong.
    Raises BifaceError where the file has no formula."""
    formula = file.formula()
    fit_type = file.find("FITTYP")
    lines = [f"{file.path}: Magic Formula {formula.name}"
             + (f", FITTYP {fit_type:g}" if fit_type in FITTYP else "")
             + f", nominal load {formula.p.FNOMIN:g} N, "
             + (f"radius {formula.p.UNLOADED_RADIUS:g} m" if formula.has_radius
                else "no radius")
             + (f", nominal pressure {formula.nominal_pressure:g} Pa"
                if formula.nominal_pressure else "") + "."]
    if "UNITS" not in file.sections:
        lines.append("There is no section [UNITS]; the values are taken as SI units.")
    for section in file.sections.values():
        content = f"{len(section.entries):4d} entries"
        if section.rows or section.columns:
            content += f", a table of {len(section.rows)} rows"
        if section.columns:
            content += f": {' '.join(section.columns)}"
        lines.append(f"  [{section.name}]".ljust(32) + content)
    if formula.mirrored:
        lines.append(f"USE_MODE is {file.find('USE_MODE'):g}: below 0 the tire is "
                     "evaluated as its mirror image, as by --mirror.")
    if not formula.has_radius:
        lines.append("UNLOADED_RADIUS is missing: moments need it, see evaluate --radius; "
                     "F_x and F_y do not.")
    if file.side() not in SIDES:
        lines.append(f"Not used (neither LEFT nor RIGHT): TYRESIDE, '{file.side()}'.")
    if file.not_numbers():
        lines.append("Not used (no number): " + ", ".join(file.not_numbers()) + ".")
    absent = missing(file, formula)
    if absent:
        lines.append(f"Missing, taken as neutral: {', '.join(absent)}.")
    for purpose, names in unknown(file).items():
        lines.append(f"Not used ({purpose}): {', '.join(names)}.")
    found = wrong_units(file) + unusual(file, formula) + doubtful(formula, file)
    try:
        forces = formula.evaluate(formula.p.FNOMIN, [-0.05, 0, 0.05], [0.02, 0, -0.02])
        if not np.isfinite(np.array(forces if formula.has_radius else forces[:2])).all():
            found.append("The forces at the nominal load are not finite.")
    except BifaceError as error:
        found.append(str(error).capitalize())
    lines += found or ["No coefficient is out of its usual bounds."]
    return "\n".join(lines) + "\n", bool(found)
