#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the wheel axes of ISO 8855 for doc/report.md."""

import argparse
import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.patches import Arc, Circle, FancyBboxPatch

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/report"))

from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

# Radius and half width of the wheel, loaded radius
RADIUS, HALF_WIDTH, LOADED = 1, 0.34, 0.9


def arrow(axes, vector, name, place):
    """An axis with its force, from the contact center."""
    axes.annotate("", vector, (0, 0), arrowprops={
        "arrowstyle": "-|>", "color": RED, "linewidth": 2, "shrinkA": 0})
    axes.annotate(name, place, color=RED, ha="center", va="center")


def across(axes, is_outward, name, place):
    """An axis out of the paper, or into it."""
    axes.add_patch(Circle((0, 0), 0.06, facecolor="white", edgecolor=RED,
                          linewidth=1.5, zorder=3))
    axes.plot(0, 0, "o" if is_outward else "x", color=RED,
              markersize=3 if is_outward else 5, zorder=4)
    axes.annotate(name, place, color=RED, ha="center", va="center")


def moment(axes, is_counterclockwise, name, place):
    """The sense of a moment about the axis across the paper."""
    axes.add_patch(Arc((0, 0), 0.66, 0.66, theta1=20, theta2=75, color=BLUE,
                       linewidth=1.8))
    end, start = (75, 70) if is_counterclockwise else (20, 25)
    axes.annotate("", on_circle(0.33, end), on_circle(0.33, start), arrowprops={
        "arrowstyle": "-|>", "color": BLUE, "linewidth": 1.8, "shrinkA": 0,
        "shrinkB": 0})
    axes.annotate(name, place, color=BLUE, ha="center", va="center")


def on_circle(radius, degrees):
    """A point of a circle about the contact center."""
    return (radius * math.cos(math.radians(degrees)),
            radius * math.sin(math.radians(degrees)))


def ground(axes, title):
    """The ground, and the looks of a view."""
    axes.axhline(0, color="black", linewidth=1.2, zorder=0)
    axes.set(xlim=(-1.25, 1.25), ylim=(-0.35, 2), title=title)
    axes.set_aspect("equal")
    axes.axis("off")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    figure, (side, behind) = plt.subplots(1, 2, figsize=(8.4, 4.2))

    ground(side, "from the right")
    side.add_patch(Circle((0, LOADED), RADIUS, facecolor="0.93", edgecolor=GRAY,
                          linewidth=1.5, zorder=-1))
    side.add_patch(plt.Rectangle((-1.25, -0.35), 2.5, 0.35, facecolor="white",
                                 zorder=-1))
    side.plot(0, LOADED, "+", color="black", markersize=10)
    arrow(side, (0.95, 0), "$x$, forward: $F_x$", (0.86, -0.17))
    arrow(side, (0, 0.75), "$z$, up: $F_z$", (-0.32, 0.66))
    across(side, False, "$y$, left: $F_y$", (-0.42, -0.17))
    moment(side, False, "$M_y$", (0.42, 0.3))

    ground(behind, "from behind")
    behind.add_patch(FancyBboxPatch(
        (-HALF_WIDTH + 0.2, 0.2), 2 * HALF_WIDTH - 0.4, 1.5,
        boxstyle="round,pad=0.2", facecolor="0.93", edgecolor=GRAY,
        linewidth=1.5, zorder=-1))
    behind.plot([-0.6, 0.6], 2 * [LOADED], "-.", color="black", linewidth=0.8)
    behind.annotate("axle", (0.72, LOADED), ha="center", va="center")
    arrow(behind, (-0.95, 0), "$y$, left: $F_y$", (-0.86, -0.17))
    arrow(behind, (0, 0.75), "$z$, up: $F_z$", (-0.36, 0.66))
    across(behind, False, "$x$, forward: $F_x$", (0.5, -0.17))
    moment(behind, False, "$M_x$", (0.46, 0.3))
    save(figure, arguments.output)


if __name__ == "__main__":
    main()
