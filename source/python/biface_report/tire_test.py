# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a tire test: forces and moments over slip angle, slip ratio and load, in
the axes of the test."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from .drawing import DISTINCT, embed, shades
from .page import Section, details, figure, number, paragraph, table
from .units import units_of

# Line styles of inclination angles
STYLES = ("-", "--", ":", "-.")

# The largest number of curves in a chart; further loads or inclinations are left out
MOST_LEVELS = len(DISTINCT)

AXES = {"ISO": "ISO 8855: x forward, y to the left, z up; the slip angle is positive if the "
               "wheel moves to the left of its plane",
        "SAE": "SAE J670e: x forward, y to the right, z down; the slip angle is positive if "
               "the wheel moves to the right of its plane",
        "adapted ISO": "ISO 8855, but with slip angle and inclination angle of the sign of "
                       "the lateral force that they cause"}


def tire_test(run):
    """Charts and a table of tire_test.csv; None without a test."""
    found = run.tire_test()
    if found is None:
        return None
    units = units_of(run)
    succeeded = found.where(status="ok")
    pressures, counts = np.unique(succeeded["pressure"], return_counts=True)
    parts = []
    if len(succeeded):
        pressure = pressures[counts.argmax()]
        at = succeeded.where(pressure=pressure)
        parts.append(figure(
            embed(draw(at, units)),
            "Charts of the lateral force and the aligning moment against the slip angle, "
            "of the longitudinal force against the slip ratio, and of the lateral against "
            "the longitudinal force.",
            "Lateral force and aligning moment of the freely rolling wheel, longitudinal "
            "force at zero slip angle, and both forces at the middle load and the smallest "
            "inclination"
            + (f", at the pressure {number(pressure)}, which has most points."
               if len(pressures) > 1 else ".")))
    n_failed = len(found) - len(succeeded)
    axes = found["axes"][0] if len(found) else "ISO"
    parts.append(paragraph(
        f"{len(found)} points"
        + (f", of which {n_failed} have failed" if n_failed else "")
        + f". Forces of the ground on the wheel in the axes of {AXES.get(axes, axes)}."))
    return Section("tire-test", "Tire test", "\n".join(parts) + details(
        "All points of the test", table_of(found), False), True)


def table_of(found):
    """All points of tire_test.csv."""
    columns = {"load": "Load", "pressure": "Pressure",
               "inclination_angle": "Inclination [°]", "slip_angle": "Slip angle [°]",
               "slip_ratio": "Slip ratio", "F_x": "F<sub>x</sub>", "F_y": "F<sub>y</sub>",
               "M_x": "M<sub>x</sub>", "M_y": "M<sub>y</sub>", "M_z": "M<sub>z</sub>",
               "loaded_radius": "Loaded radius", "rolling_radius": "Rolling radius"}
    force = np.abs(found["load"]).max(initial=0)
    moment = force * np.nanmax(found["loaded_radius"], initial=0)
    scales = {column: force if column[0] == "F" else moment
              for column in columns if column[1] == "_"}
    rows = [[f"Point {int(found['point'][i])}", escape(found["status"][i])]
            + [number(found[column][i], scale=scales.get(column, 0))
               if np.isfinite(found[column][i]) else "" for column in columns]
            for i in range(len(found))]
    return table("Points of the tire test, from tire_test.csv",
                 ["", "Status", *columns.values()], rows)


# ---------------------------------------------------------------- charts


def levels(found, column):
    """The different values of a column, at most as many as there are colors."""
    values = np.unique(found[column])
    if len(values) <= MOST_LEVELS:
        return values
    return values[np.linspace(0, len(values) - 1, MOST_LEVELS).round().astype(int)]


def draw(found, units):
    """Curves at pure slip, and forces at combined slip, of the slips that there are."""
    curves = [(over, zero, column) for over, zero, column in (
        ("slip_angle", "slip_ratio", "F_y"), ("slip_angle", "slip_ratio", "M_z"),
        ("slip_ratio", "slip_angle", "F_x")) if found[over].any()]
    is_combined = (found["slip_ratio"] * found["slip_angle"]).any()
    # free rolling alone is drawn as forces
    count = max(1, len(curves) + is_combined)
    rows, columns = -(-count // 2), min(count, 2)
    drawing, panels = plt.subplots(rows, columns, figsize=(4.5 * columns, 3.4 * rows),
                                   layout="constrained", squeeze=False)
    panels = list(panels.flat)
    for axes, (over, zero, column) in zip(panels, curves):
        draw_pure(axes, found.where(**{zero: 0}), over, column, units)
        axes.set_xlabel("slip angle [degrees]" if over == "slip_angle" else "slip ratio")
        quantity = "force" if column[0] == "F" else "moment"
        axes.set_ylabel(units.label(f"${column}$", quantity))
    if curves:
        panels[0].legend(fontsize=8)
    if is_combined or not curves:
        draw_combined(panels[len(curves)], found, units)
    for axes in panels[count:]:
        axes.set_visible(False)
    return drawing


def draw_pure(axes, found, over, column, units):
    """A column against a slip: a color for each load, a line style for each
    inclination."""
    inclinations = sorted(np.unique(found["inclination_angle"]), key=abs)[:len(STYLES)]
    for inclination, style in zip(inclinations, STYLES):
        for load, color in zip(levels(found, "load"), DISTINCT):
            curve = found.where(load=load, inclination_angle=inclination)
            order = np.argsort(curve[over], kind="stable")
            label = units.label(f"{load:g}", "force")
            axes.plot(curve[over][order], curve[column][order], "o" + style, color=color,
                      markersize=3, linewidth=1.4,
                      label=label + (f", {inclination:g}°" if len(inclinations) > 1
                                     else ""))
    cross(axes)


def draw_combined(axes, found, units):
    """Lateral against longitudinal force at each slip angle, of the middle load."""
    loads = np.unique(found["load"])
    load = loads[len(loads) // 2]
    inclination = min(np.unique(found["inclination_angle"]), key=abs)
    chosen = found.where(load=load, inclination_angle=inclination)
    angles = np.unique(chosen["slip_angle"])
    for angle, color in zip(angles, shades(len(angles))):
        curve = chosen.where(slip_angle=angle)
        order = np.argsort(curve["slip_ratio"], kind="stable")
        axes.plot(curve["F_x"][order], curve["F_y"][order], "o-", color=color,
                  markersize=3, linewidth=1.4, label=f"{angle:g}°")
    axes.set(xlabel=units.label("$F_x$", "force"), ylabel=units.label("$F_y$", "force"))
    cross(axes)
    if len(angles) <= 12:
        axes.legend(fontsize=8, title="slip angle", title_fontsize=8, loc="upper left",
                    bbox_to_anchor=(1, 1))


def cross(axes):
    """Axes through 0."""
    axes.axhline(0, color="0.6", linewidth=0.8, zorder=1)
    axes.axvline(0, color="0.6", linewidth=0.8, zorder=1)
