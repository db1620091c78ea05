# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forces on a rolling wheel over the slip angle and over the longitudinal slip, in
the axes of ISO 8855."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from .drawing import DISTINCT, embed, plain
from .loading import TESTED, rows_before
from .page import LeftOut, Section, details, figure, number, paragraph, table
from .units import units_of

# A wheel rolls freely if its axle has less than this part of the moment of friction
FREE = 1e-6


def rolling(run):
    """Charts and a table of rolling.csv."""
    name = "Rolling"
    found = run.rolling()
    if found is None or len(found) == 0:
        return LeftOut(name, "In no step does a wheel roll.")
    is_tested = np.array([stage.startswith(TESTED) for stage in found["stage"]])
    found = found.where(~is_tested)
    if len(found) == 0:
        return LeftOut(name, "The wheel only rolls in its tire test.")
    parts, units = [], units_of(run)
    cornering = curves(run, found, is_cornering)
    if cornering:
        parts.append(figure(
            embed(draw_cornering(found, cornering, units)),
            "Charts of the lateral force and the aligning moment against the slip "
            "angle.",
            "Lateral force F<sub>y</sub> and aligning moment M<sub>z</sub> against the "
            "slip angle, in stages in which it changes."))
    braking = curves(run, found, is_braking)
    if braking:
        slips = slips_of(run, found, braking)
        against = ("angular velocity" if slips is None else
                   "longitudinal slip κ = (ω − ω<sub>0</sub>)/ω<sub>0</sub>, "
                   "where ω<sub>0</sub> is the angular velocity of the freely "
                   "rolling wheel from which the stage starts; −100 % is a locked "
                   "wheel")
        parts.append(figure(
            embed(draw_braking(found, braking, slips, units)),
            "Chart of the longitudinal force against the "
            + ("angular velocity." if slips is None else "longitudinal slip."),
            f"Longitudinal force F<sub>x</sub> against the {against}."))
    text = paragraph(
        "Forces of the ground on the rolling wheel, and moments about the contact "
        "center, in the axes of ISO 8855: x forward, y to the left, z up from the "
        "ground. A positive slip angle, when the wheel moves to the left, gives a "
        "negative F<sub>y</sub>; drag is a negative F<sub>x</sub>.")
    return Section("rolling", name, "\n".join(parts + [text]) + details(
        "All steps of the rolling wheel", table_of(found), not parts), True)


def table_of(found):
    """All steps of rolling.csv."""
    columns = {"angular_velocity": "Angular velocity",
               "ground_velocity": "Ground velocity", "slip_angle": "Slip angle [°]",
               "F_x": "F<sub>x</sub>", "F_y": "F<sub>y</sub>", "F_z": "F<sub>z</sub>",
               "M_x": "M<sub>x</sub>", "M_y": "M<sub>y</sub>", "M_z": "M<sub>z</sub>",
               "axle_moment": "Axle moment"}
    if "rolling_resistance" in found:
        columns["rolling_resistance"] = "Rolling resistance"
    # forces and moments, also that of the axle, against which others are round-off
    force = np.abs(found["F_z"]).max()
    moment = force * radius_scale(found)
    scales = {column: force if column[0] == "F" else moment
              for column in columns if column[1] == "_" or column == "axle_moment"}
    rows = []
    for i in range(len(found)):
        rows.append([f"Step {int(found['step'][i])}", escape(found["stage"][i])]
                    + [number(found[column][i], scale=scales.get(column, 0))
                       for column in columns])
    return table("Steps of the rolling wheel, from rolling.csv",
                 ["", "Stage"] + list(columns.values()), rows)


# ---------------------------------------------------------------- curves


def is_cornering(at, start):
    """Whether the slip angle changes between two rows."""
    return at("slip_angle") != start("slip_angle")


def is_braking(at, start):
    """Whether only the angular velocity changes between two rows."""
    return (at("angular_velocity") != start("angular_velocity")
            and all(at(column) == start(column)
                    for column in ("slip_angle", "ground_velocity")))


def starts(run, found):
    """For each row the row of the step from which it started; -1 if the wheel did
    not roll in it."""
    row_of = {step: row for row, step in enumerate(found["step"].astype(int))}
    before = dict(zip(run.steps, rows_before(run)))
    return [row_of.get(run.steps[before[step]], -1) if before[step] >= 0 else -1
            for step in row_of]


def curves(run, found, is_wanted):
    """Rows of consecutive steps in which something changes, each curve from the row
    where it starts."""
    result = []
    for row, start in enumerate(starts(run, found)):
        if start < 0 or not is_wanted(lambda column, i=row: found[column][i],
                                      lambda column, i=start: found[column][i]):
            continue
        if not result or result[-1][-1] != start:
            result.append([start])
        result[-1].append(row)
    return result


def slips_of(run, found, chosen):
    """The longitudinal slip in percent in the rows of each curve; None unless each
    comes from a wheel that rolls freely straight on."""
    before = starts(run, found)
    moments = np.abs(found["F_z"]).max() * FREE * radius_scale(found)
    result = []
    for rows in chosen:
        row = rows[0]
        while row >= 0 and not (abs(found["axle_moment"][row]) <= moments
                                and found["slip_angle"][row] == 0
                                and found["angular_velocity"][row] != 0):
            row = before[row]
        if row < 0 or (found["ground_velocity"][row]
                       != found["ground_velocity"][rows[0]]):
            return None
        free = found["angular_velocity"][row]
        result.append(100 * (found["angular_velocity"][rows] / free - 1))
    return result


def radius_scale(found):
    """A length as large as the wheel, for what counts as no moment."""
    turning = found["angular_velocity"] != 0
    radii = np.abs(found["ground_velocity"][turning]
                   / found["angular_velocity"][turning])
    return radii.max() if len(radii) else 1.


# ---------------------------------------------------------------- charts


def draw_cornering(found, chosen, units):
    """Lateral force and aligning moment against the slip angle."""
    drawing, panels = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    angles = [found["slip_angle"][rows] for rows in chosen]
    draw_curves(panels[0], found, chosen, angles, "F_y")
    draw_curves(panels[1], found, chosen, angles, "M_z")
    panels[0].set_ylabel(units.label("$F_y$", "force"))
    panels[1].set_ylabel(units.label("$M_z$", "moment"))
    for axes in panels:
        axes.set_xlabel("slip angle [degrees]")
    legend(panels[0], chosen)
    return drawing


def draw_braking(found, chosen, slips, units):
    """The longitudinal force against the slip, or the angular velocity."""
    drawing, axes = plt.subplots(figsize=(5.6, 3.4))
    draw_curves(axes, found, chosen, slips or [found["angular_velocity"][rows]
                                               for rows in chosen], "F_x")
    axes.set(ylabel=units.label("$F_x$", "force"),
             xlabel=f"angular velocity [radians/{units['time']}]"
             if slips is None else "longitudinal slip κ [%]")
    legend(axes, chosen)
    return drawing


def draw_curves(axes, found, chosen, x, column):
    """Curves of a column, with axes through 0."""
    for i, rows in enumerate(chosen):
        stages = dict.fromkeys(found["stage"][rows[1:]])
        axes.plot(x[i], found[column][rows], "o-", markersize=4,
                  color=DISTINCT[i % len(DISTINCT)], label=plain(", ".join(stages)))
    axes.axhline(0, color="0.6", linewidth=0.8, zorder=1)
    axes.axvline(0, color="0.6", linewidth=0.8, zorder=1)


def legend(axes, chosen):
    """Names of stages, if there are several curves."""
    if len(chosen) > 1:
        axes.legend(fontsize=10)
