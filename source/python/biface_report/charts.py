# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves over the steps of a run."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from .buckling import kinds_of_steps
from .drawing import BLUE, DISTINCT, GRAY, RED, headroom, legend_below, plain
from .loading import branch_name, branches, counted_steps, varying_load
from .page import ROUND_OFF, TOLERANCE, count
from .units import units_of

# More curves in one chart would be hard to tell apart
MAXIMUM_CURVES = len(DISTINCT)
# Lines of different points on the same branch
LINES = ("-", "--", ":", "-.")
# Names of more stages would cover each other
MAXIMUM_STAGES = 10


def contact_branches(run):
    """The rows of the steps after first contact, see loading.branches()."""
    return branches(run, (run.history["approach"] != 0) | run.in_contact)


def contact_curves(run):
    """Approaches and forces of the steps after first contact, from 0: a curve,
    and another one for each branch."""
    # the row -1 is the origin
    approach, force = (np.append(run.history[column], 0)
                       for column in ("approach", "force"))
    return [(approach[rows], force[rows]) for rows in contact_branches(run)]


def stiffness(run):
    """Change of force over change of approach in the last step, or None."""
    curves = contact_curves(run)
    if not curves:
        return None
    approach, force = curves[-1]
    change = force[-1] - force[-2]
    # a force that the stage holds changes within the tolerance of the iteration
    if approach[-1] == approach[-2] or abs(change) <= TOLERANCE * abs(force[-1]):
        return None
    return change / (approach[-1] - approach[-2])


def draw_contact_curve(run):
    """The force on the ground against its approach. Where there are several
    branches, the longest ones have colors and names."""
    figure, axes = plt.subplots(figsize=(5.6, 3.8))
    curves = contact_curves(run)
    names = [branch_name(run, rows) for rows in contact_branches(run)]
    longest = sorted(range(len(curves)), key=lambda i: -np.ptp(curves[i][0]))
    colors = dict(zip(sorted(longest[:MAXIMUM_CURVES - 1]),
                      DISTINCT if len(curves) > 1 else [BLUE]))
    for i, (approach, force) in enumerate(curves):
        axes.plot(approach, force, "o-", color=colors.get(i, GRAY), markersize=4,
                  clip_on=False, label=plain(names[i]) if i in colors else None,
                  zorder=2.5 if i in colors else 2)
    others = len(curves) - len(colors)
    if others:
        axes.plot([], [], "o-", color=GRAY, markersize=4,
                  label=count(others, "other branch", "other branches"))
    here = run.in_contact & np.isin(run.steps, list(kinds_of_steps(run)))
    mark_critical(axes, run.history["approach"][here], run.history["force"][here])
    label_contact_curve(axes, units_of(run))
    headroom(axes)
    if len(curves) > 1:
        legend_below(axes)
    return figure


def label_contact_curve(axes, units):
    """The labels of a chart of the force on the ground."""
    axes.set(xlabel=units.label("approach", "length"),
             ylabel=units.label("force on the ground", "force"))


def mark_critical(axes, x, y):
    """Rings around the ends of steps with critical points."""
    axes.plot(x, y, "o", markersize=10, markerfacecolor="none", markeredgecolor=RED,
              markeredgewidth=1.5, clip_on=False, zorder=5)


# ---------------------------------------------------------------- without contact


class ProbeCurves:
    """A load against the displacements of the named points: of each the component
    that changes most, on each branch."""

    def __init__(self, run, probes):
        """Points of the middle surface, see Run.probes()."""
        self.units = units_of(run)
        self.load_name, loads = varying_load(run)
        loads = np.append(loads, 0)
        is_counted = np.isin(run.steps, counted_steps(run))
        self.curves, self.at_rest = {}, []
        critical = np.append(np.isin(run.steps, list(kinds_of_steps(run))), False)
        # without a prestress, a curve starts at 0, the row -1
        skipped = 0 if is_counted[0] else 1
        chains = [rows[skipped if rows[0] < 0 else 0:]
                  for rows in branches(run, is_counted)]
        self.names = [branch_name(run, rows) for rows in branches(run, is_counted)]
        moved = {name: self._displacements(run, probes, name)
                 for name in dict.fromkeys(probes["name"])}
        moved = {name: values for name, values in moved.items()
                 if np.isfinite(values[:-1][is_counted]).any()}
        largest = max((np.nanmax(np.abs(values)) for values in moved.values()),
                      default=0)
        for name, values in moved.items():
            moves = np.nanmax(np.abs(values[:-1][is_counted]), axis=0)
            if np.max(moves) <= ROUND_OFF * largest:
                self.at_rest.append(name)
                continue
            i = int(np.argmax(moves))
            self.curves[name, "xyz"[i]] = [
                (values[rows, i], loads[rows], critical[rows]) for rows in chains]

    @staticmethod
    def _displacements(run, probes, name):
        """Those of a point in all steps, NaN where they are missing, and 0."""
        result = np.full((len(run.steps) + 1, 3), np.nan)
        rows = probes.where(probes["name"] == name)
        result[np.searchsorted(run.steps, rows["step"])] = rows.positions("u_")
        result[-1] = 0
        return result

    def maximum(self):
        """How many points are drawn at most."""
        return MAXIMUM_CURVES if len(self.names) == 1 else len(LINES)

    def draw(self):
        """The chart: a color for each point or, where there are several branches,
        for each of these."""
        figure, axes = plt.subplots(figsize=(5.6, 3.8))
        curves = list(self.curves.items())[:self.maximum()]
        one = len(self.names) == 1
        for i, ((name, direction), parts) in enumerate(curves):
            for k, (moved, load, is_critical) in enumerate(parts):
                axes.plot(moved, load, "o", linestyle=LINES[0 if one else i],
                          color=DISTINCT[(i if one else k) % len(DISTINCT)],
                          markersize=4, clip_on=False)
                mark_critical(axes, moved[is_critical], load[is_critical])
        headroom(axes)
        axes.axhline(0, color="0.6", linewidth=0.8, zorder=1)
        axes.axvline(0, color="0.6", linewidth=0.8, zorder=1)
        for k, name in enumerate([] if one else self.names):
            axes.plot([], [], color=DISTINCT[k % len(DISTINCT)],
                      label=plain(name))
        for i, ((name, direction), _) in enumerate(curves):
            axes.plot([], [], color=DISTINCT[i] if one else GRAY,
                      linestyle=LINES[0 if one else i],
                      label=plain(name) + f", $u_{direction}$")
        axes.set(xlabel=self.units.label("displacement", "length"),
                 ylabel=self.load_name)
        legend_below(axes)
        return figure


# ---------------------------------------------------------------- iterations


def draw_iterations(run):
    """Iterations and seconds per step."""
    figure, (above, below) = plt.subplots(2, 1, figsize=(5.6, 4.2), sharex=True,
                                          layout="constrained")
    for axes, column, label, color in (
            (above, "iterations", "iterations", BLUE),
            (below, "seconds", "seconds", GRAY)):
        axes.bar(run.steps, run.history[column], color=color, width=0.7)
        axes.set(ylabel=label, ylim=(0, None))
        axes.grid(axis="x", visible=False)
    above.yaxis.set_major_locator(MaxNLocator(integer=True, nbins=5))
    below.xaxis.set_major_locator(MaxNLocator(integer=True))
    below.set(xlabel="step", xlim=(run.steps[0] - 0.6, run.steps[-1] + 0.6))
    mark_stages(above, run)
    return figure


def mark_stages(axes, run):
    """Marks where stages start, with their names if there is room."""
    names = run.history["stage"]
    starts = [i for i in range(1, len(names)) if names[i] != names[i - 1]]
    for i in starts:
        for each in axes.figure.axes:
            each.axvline(run.steps[i] - 0.5, color="0.3", linewidth=0.8,
                         linestyle="--")
    for i in [0] + starts if 0 < len(starts) < MAXIMUM_STAGES else []:
        axes.annotate(plain(names[i]), (run.steps[i] - 0.45, 1), (1, 2),
                      xycoords=("data", "axes fraction"),
                      textcoords="offset points", fontsize=9, color="0.3",
                      va="bottom", rotation=25)
