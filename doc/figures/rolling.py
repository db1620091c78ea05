#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of doc/rolling.md from a run of prm/rolling_tire.prm, with more steps of
the slip angle:

    cornering.png      side force and aligning moment against the slip angle
    braking.png        drag against the slip ratio
    rolling_slip.png   where the footprint sticks and slips in some steps
"""

import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from rough_ground import draw_footprint, legend_of_footprints

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

FRICTION = 0.5

# Pictures of the footprint: the stage, a column of rolling.csv with its value, or the
# position of the step in the stage, and the title
PICTURES = (("free", -1, "free rolling"), ("left", ("slip_angle", 1), "slip angle 1°"),
            ("left", ("slip_angle", 3), "slip angle 3°"),
            ("braking", 0, "1 % of slip"))


def step_of(rolling, stage, which):
    """The row of a step of PICTURES."""
    rows = np.flatnonzero(rolling["stage"] == stage)
    if isinstance(which, int):
        return rows[which]
    column, value = which
    return rows[np.argmin(np.abs(rolling[column][rows] - value))]


def draw_cornering(rolling, path):
    """Side force and aligning moment against the slip angle."""
    stages = rolling["stage"]
    chosen = np.concatenate([
        np.flatnonzero(stages == "right")[::-1],
        np.flatnonzero(stages == "free")[-1:], np.flatnonzero(stages == "left")])
    angle = rolling["slip_angle"][chosen]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2),
                                         gridspec_kw={"wspace": 0.3})
    left.plot(angle, rolling["F_y"][chosen], "o-", color=BLUE, markersize=2.5)
    for sign in (-1, 1):
        left.plot(angle, sign * FRICTION * rolling["F_z"][chosen], "--", color=GRAY,
                  linewidth=1.2)
    right.plot(angle, rolling["M_z"][chosen] / 1000, "o-", color=RED, markersize=2.5)
    left.set_ylabel("Side force $F_y$, N")
    right.set_ylabel("Aligning moment $M_z$, N m")
    for axes in (left, right):
        axes.axhline(0, color=GRAY, linewidth=0.6)
        axes.axvline(0, color=GRAY, linewidth=0.6)
        axes.set_xlabel("Slip angle, degrees")
        axes.set_xticks(range(-6, 7, 2))
    save(figure, path)


def draw_braking(rolling, path):
    """The drag against the slip ratio, with the limit of friction."""
    stages = rolling["stage"]
    free = np.flatnonzero(stages == "free")[-1]
    chosen = np.concatenate([[free], np.flatnonzero(stages == "braking"),
                             np.flatnonzero(stages == "locked")])
    ratio = 1 - (rolling["angular_velocity"][chosen]
                 / rolling["angular_velocity"][free])
    figure, axes = plt.subplots(figsize=(5.2, 3.2))
    axes.plot(100 * ratio, -rolling["F_x"][chosen], "o-", color=BLUE, markersize=4)
    axes.plot(100 * ratio, FRICTION * rolling["F_z"][chosen], "--", color=GRAY,
              linewidth=1.2, label="0.5 times vertical force")
    axes.set_xlabel("Slip, % of the angular velocity of free rolling")
    axes.set_ylabel("Drag $-F_x$, N")
    axes.legend()
    save(figure, path)


def draw_slip(results, rolling, path):
    """The nodes in contact from above, and the tractions of friction."""
    figure, all_axes = plt.subplots(1, len(PICTURES), figsize=(10, 3.9),
                                    sharex=True, sharey=True)
    for axes, (stage, which, title) in zip(all_axes, PICTURES):
        row = step_of(rolling, stage, which)
        draw_footprint(axes, results.contact(rolling["step"][row]))
        axes.set_title(title, fontsize=9)
        axes.set_xlabel("$y$ (to the left), mm")
    all_axes[0].set_ylabel("forward ($z$), mm")
    legend_of_footprints(figure, all_axes[0])
    save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", type=Results)
    parser.add_argument("output", type=Path)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    rolling = arguments.results.rolling()
    draw_cornering(rolling, arguments.output / "cornering.png")
    draw_braking(rolling, arguments.output / "braking.png")
    draw_slip(arguments.results, rolling, arguments.output / "rolling_slip.png")


if __name__ == "__main__":
    main()
