#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of doc/tire_test.md from a run of prm/tire_test.prm:

    tire_test.png        forces and moments over slip angle and slip ratio, as in the report
    tire_test_axes.png   the signs of the three kinds of axes
"""

import argparse
import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.patches import Arc, FancyBboxPatch

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save
from biface_report.tire_test import draw
from biface_report.units import units_of

# A slip angle to the left, in degrees, larger in the picture than in the test
SLIP, DRAWN = 3.5, 25
# The axes: the place of y, out of the paper or into it, and the sign of the slip angle
AXES = {"ISO": (-1, True, 1), "SAE": (1, False, -1), "adapted ISO": (-1, True, -1)}


def arrow(axes, tip, start, color):
    """An arrow of the picture of the axes."""
    axes.annotate("", tip, start, arrowprops={
        "arrowstyle": "-|>", "color": color, "linewidth": 2, "shrinkA": 0,
        "shrinkB": 0})


def draw_axes(table, path):
    """The wheel from above, moving to its left, with its axes and the side force."""
    point = table.where(load=table["load"].max(), inclination_angle=0, slip_ratio=0,
                        slip_angle=SLIP).row(0)
    figure, plots = plt.subplots(1, 3, figsize=(9, 3.2))
    for axes, (name, (side, is_up, sign)) in zip(plots, AXES.items()):
        axes.add_patch(FancyBboxPatch(
            (-0.14, -0.45), 0.28, 0.9, boxstyle="round,pad=0.05", facecolor="0.88",
            edgecolor=GRAY))
        arrow(axes, (0, 1), (0, 0), RED)
        axes.annotate("x", (0.1, 0.95), color=RED)
        arrow(axes, (side * 0.75, 0), (0, 0), RED)
        axes.annotate("y", (side * 0.8, 0.07), color=RED, ha="center")
        axes.plot(0, 0, "o" if is_up else "x", color=RED, markersize=6)
        axes.annotate("z up" if is_up else "z down", (0.05 * side, -0.14), color=RED,
                      ha="left" if side > 0 else "right")
        along = math.radians(90 + DRAWN)
        arrow(axes, (1.15 * math.cos(along), 1.15 * math.sin(along)), (0, 0), "black")
        axes.add_patch(Arc((0, 0), 1.5, 1.5, theta1=90, theta2=90 + DRAWN))
        axes.annotate(rf"$\alpha$ = {sign * DRAWN:+d}°", (-0.62, 0.95), ha="right")
        # the force of the ground, to the side where the run has it
        force = point["F_y"]
        in_axes = force if is_up else -force
        arrow(axes, (-0.9 * math.copysign(1, force), -0.3), (0, -0.3), BLUE)
        axes.annotate(f"$F_y$ {'>' if in_axes > 0 else '<'} 0",
                      (-0.6 * math.copysign(1, force), -0.5), color=BLUE, ha="center")
        axes.set(xlim=(-1.2, 1.2), ylim=(-0.7, 1.25), title=name)
        axes.set_aspect("equal")
        axes.axis("off")
    save(figure, path)


def main():
    """Draws the figures."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("results", type=Path)
    parser.add_argument("output", type=Path)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    run = Results(arguments.results)
    table = run.tire_test()
    save(draw(table, units_of(run)), arguments.output / "tire_test.png")
    draw_axes(table, arguments.output / "tire_test_axes.png")


if __name__ == "__main__":
    main()
