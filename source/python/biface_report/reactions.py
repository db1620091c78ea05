# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forces of supports that move, over their displacements."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from .buckling import critical_range, kinds_of_steps
from .charts import mark_critical
from .drawing import BLUE, DISTINCT, GRAY, embed, headroom, legend_below, plain
from .loading import branch_name, branches, counted_steps
from .page import LeftOut, Section, figure, number, paragraph, table
from .units import units_of

# More curves in one chart would be hard to tell apart
MAXIMUM_CURVES = len(DISTINCT)


class Reaction:
    """A support that moves: its displacements and the forces along them, in the
    direction in which the force is mostly positive.

    name                  the support, as in forces.csv
    displacement, force   by row of the history
    is_turn               whether they are angle and moment
    is_reversed           whether the direction is against that of the motion at the
                          load factor 1
    """

    def __init__(self, run, name, columns):
        self.name = name.replace("_", " ").replace("alpha ", "alpha_")
        self.is_turn = columns[0].endswith("angle")
        displacement, force = (run.history[column] for column in columns)
        # the sum of squares of either sign: one that rests at zero has none
        self.is_reversed = bool(np.sum(force * np.abs(force)) < 0)
        sign = -1 if self.is_reversed else 1
        # no negative zeros
        self.displacement, self.force = sign * displacement + 0., sign * force + 0.

    def labels(self, units):
        """The labels of both axes of a chart."""
        if self.is_turn:
            return "angle [°]", units.label("moment of the support", "moment")
        return (units.label("displacement", "length"),
                units.label("force of the support", "force"))


def reactions_of(run):
    """The supports that move in any step shown."""
    found = [Reaction(run, name, columns)
             for name, columns in run.support_motions.items()]
    return [reaction for reaction in found if np.ptp(reaction.displacement) > 0
            or reaction.displacement.any()]


def draw_reaction(run, reaction):
    """The force against the displacement, a curve for each branch; the longest ones
    have colors and names."""
    picture, axes = plt.subplots(figsize=(5.6, 3.8))
    counted = np.isin(run.steps, counted_steps(run))
    # a run without a prestress starts from the shell without loads, the row -1
    x, y = (np.append(values, 0) for values in (reaction.displacement, reaction.force))
    curves = branches(run, counted)
    skipped = 0 if counted[0] else 1
    lines = [rows[skipped if rows[0] < 0 else 0:] for rows in curves]
    # a branch on which the support rests is a vertical line: it is drawn, too
    longest = sorted(range(len(lines)), key=lambda i: -np.ptp(x[lines[i]]))
    colors = dict(zip(sorted(longest[:MAXIMUM_CURVES]),
                      DISTINCT if len(lines) > 1 else [BLUE]))
    for i, rows in enumerate(lines):
        axes.plot(x[rows], y[rows], "o-", color=colors.get(i, GRAY), markersize=4,
                  clip_on=False,
                  label=plain(branch_name(run, curves[i])) if i in colors else None,
                  zorder=2.5 if i in colors else 2)
    here = np.flatnonzero(counted & np.isin(run.steps, list(kinds_of_steps(run))))
    mark_critical(axes, x[here], y[here])
    xlabel, ylabel = reaction.labels(units_of(run))
    axes.set(xlabel=xlabel, ylabel=ylabel)
    headroom(axes)
    if len(lines) > 1:
        legend_below(axes)
    return picture


def table_of(found, units):
    """The table of the forces, or of the moments, of supports."""
    if not found:
        return ""
    is_turn = found[0].is_turn
    rows = []
    for reaction in found:
        top = int(np.argmax(reaction.force))
        rows.append([escape(reaction.name), number(reaction.displacement[-1]),
                     number(reaction.force[-1]), number(reaction.force[top]),
                     number(reaction.displacement[top])])
    moved, force = ("Angle", "moment") if is_turn else ("Displacement", "force")
    unit = "°" if is_turn else units["length"]
    return table(f"{force.capitalize()}s of supports, from history.csv",
                 ["Support", f"{moved} [{unit}]", units.label(force.capitalize(), force),
                  units.label(f"Largest {force}", force), f"{moved} there [{unit}]"],
                 rows)


def reactions(run):
    """A chart for each support that moves."""
    name = "Forces of supports that move"
    found = reactions_of(run)
    if not found:
        return LeftOut(name, "No support moves.")
    html = ""
    for reaction in found:
        if len(run.steps) > 1:
            html += figure(
                embed(draw_reaction(run, reaction)),
                f"Chart of the {'moment' if reaction.is_turn else 'force'} of the "
                f"support {reaction.name} against its displacement.",
                f"The support {escape(reaction.name)}, "
                + ("against its motion at the load factor 1."
                   if reaction.is_reversed else
                   "along its motion at the load factor 1.")
                + critical_range(run, counted_steps(run))) + "\n"
    for is_turn in (False, True):
        html += table_of([reaction for reaction in found
                          if reaction.is_turn == is_turn], units_of(run))
    html += paragraph(
        "The force of the support on the shell and its displacement, or moment and "
        "angle in degrees, in the last step and where the force is largest. Where a "
        "sector or a half is modeled, forces are those of the whole turn.")
    return Section("reactions", name, html, True)
