# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves over the steps of a run."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from .buckling import kinds_of_steps
from .drawing import BLUE, DISTINCT, GRAY, RED, headroom
from .loading import counted_steps, rows_before, varying_load
from .page import ROUND_OFF

# More curves in one chart would be hard to tell apart
MAXIMUM_CURVES = len(DISTINCT)
# Names of more stages would cover each other
MAXIMUM_STAGES = 10


def contact_curves(run):
    """Approaches and forces of the steps after first contact, from 0: a curve,
    and another one for each branch."""
    chosen = (run.history["approach"] != 0) | run.in_contact
    before = rows_before(run)
    curves = []
    for row in np.flatnonzero(chosen):
        start = before[row] if before[row] >= 0 and chosen[before[row]] else -1
        if not curves or curves[-1][-1] != start:
            curves.append([start])
        curves[-1].append(row)
    # the row -1 is the origin
    approach, force = (np.append(run.history[column], 0)
                       for column in ("approach", "force"))
    return [(approach[rows], force[rows]) for rows in curves]


def stiffness(run):
    """Change of force over change of approach in the last step, or None."""
    curves = contact_curves(run)
    if not curves:
        return None
    approach, force = curves[-1]
    if approach[-1] == approach[-2]:
        return None
    return (force[-1] - force[-2]) / (approach[-1] - approach[-2])


def draw_contact_curve(run):
    """The force on the foundation against its approach."""
    figure, axes = plt.subplots(figsize=(5.6, 3.8))
    for approach, force in contact_curves(run):
        axes.plot(approach, force, "o-", color=BLUE, markersize=4, clip_on=False)
    here = run.in_contact & np.isin(run.steps, list(kinds_of_steps(run)))
    mark_critical(axes, run.history["approach"][here], run.history["force"][here])
    axes.set(xlabel="approach [length]", ylabel="force on the foundation [force]")
    headroom(axes)
    return figure


def mark_critical(axes, x, y):
    """Rings around the ends of steps with critical points."""
    axes.plot(x, y, "o", markersize=10, markerfacecolor="none", markeredgecolor=RED,
              markeredgewidth=1.5, clip_on=False, zorder=5)


# ---------------------------------------------------------------- without contact


class ProbeCurves:
    """A load against the displacements of the named points: of each the component
    that changes most."""

    def __init__(self, run, probes):
        """Points of the middle surface, see Run.probes()."""
        self.load_name, loads = varying_load(run)
        load_of = dict(zip(run.steps, loads))
        steps = counted_steps(run)
        starts_at_zero = steps[0] == run.steps[0]
        self.curves, self.at_rest, self.critical = {}, [], {}
        critical = list(kinds_of_steps(run))
        largest = max(np.abs(probes["u_" + i]).max() for i in "xyz")
        for name in dict.fromkeys(probes["name"]):
            rows = probes.where((probes["name"] == name)
                                & np.isin(probes["step"], steps))
            if len(rows) == 0:
                continue
            moves = {i: np.abs(rows["u_" + i]).max() for i in "xyz"}
            direction = max(moves, key=moves.get)
            if moves[direction] <= ROUND_OFF * largest:
                self.at_rest.append(name)
                continue
            origin = [0] if starts_at_zero else []
            self.curves[name, direction] = (
                np.append(origin, rows["u_" + direction]),
                np.append(origin, [load_of[step] for step in rows["step"]]))
            self.critical[name, direction] = np.append(
                np.zeros(len(origin), bool), np.isin(rows["step"], critical))

    def draw(self):
        """The chart, with MAXIMUM_CURVES curves at most."""
        figure, axes = plt.subplots(figsize=(5.6, 3.8))
        curves = list(self.curves.items())[:MAXIMUM_CURVES]
        for ((name, direction), (moved, load)), color in zip(curves, DISTINCT):
            axes.plot(moved, load, "o-", color=color, markersize=4,
                      label=f"{name}, $u_{direction}$", clip_on=False)
            here = self.critical[name, direction]
            mark_critical(axes, moved[here], load[here])
        headroom(axes)
        axes.axhline(0, color="0.6", linewidth=0.8, zorder=1)
        axes.axvline(0, color="0.6", linewidth=0.8, zorder=1)
        axes.set(xlabel="displacement [length]", ylabel=self.load_name)
        axes.legend(fontsize=10)
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
        axes.annotate(names[i], (run.steps[i] - 0.45, 1), (1, 2),
                      xycoords=("data", "axes fraction"),
                      textcoords="offset points", fontsize=9, color="0.3",
                      va="bottom", rotation=25)
