#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the wheel axes of ISO 8855 for doc/report.md."""

import argparse
import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.patches import Arc, Circle, FancyBboxPatch
from matplotlib.transforms import Affine2D

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

# Radius and half width of the wheel, loaded radius
RADIUS, HALF_WIDTH, LOADED = 1, 0.34, 0.9

# Slip angle and camber (degrees), larger than usual
SLIP, CAMBER = 20, 9


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


def slip_angle(axes):
    """The direction in which the wheel moves, to the left of its plane."""
    tip = (-1.3 * math.sin(math.radians(SLIP)), 1.3 * math.cos(math.radians(SLIP)))
    axes.annotate("", tip, (0, 0), arrowprops={
        "arrowstyle": "-|>", "color": "black", "linewidth": 1.5, "shrinkA": 0})
    axes.annotate("velocity", (tip[0] - 0.08, tip[1]), ha="right", va="center")
    axes.add_patch(Arc((0, 0), 1.9, 1.9, theta1=90, theta2=90 + SLIP,
                       color="black", linewidth=1.2))
    axes.annotate(r"slip angle $\alpha$", on_circle(0.95, 90 + SLIP / 2),
                  (-0.47, 0.72), ha="right", va="center",
                  arrowprops={"arrowstyle": "-", "linewidth": 0.8})


def camber(axes):
    """The outline of a wheel that leans to the right, and the angle."""
    turned = Affine2D().rotate_deg(-CAMBER) + axes.transData
    outline = wheel_section(fill=False, linestyle="--")
    outline.set_transform(turned)
    axes.add_patch(outline)
    axes.plot([0, 0], [0.78, 2], ":", color=GRAY, linewidth=1)
    axes.plot([0, 2 * math.sin(math.radians(CAMBER))],
              [0, 2 * math.cos(math.radians(CAMBER))], ":", color=GRAY, linewidth=1)
    axes.add_patch(Arc((0, 0), 3.8, 3.8, theta1=90 - CAMBER, theta2=90,
                       color="black", linewidth=1.2))
    axes.annotate(r"camber $\gamma$", (0.17, 1.9), (0.95, 1.95), ha="center",
                  va="center", arrowprops={"arrowstyle": "-", "linewidth": 0.8})


def wheel_section(**style):
    """The wheel from behind."""
    return FancyBboxPatch(
        (-HALF_WIDTH + 0.2, 0.2), 2 * HALF_WIDTH - 0.4, 1.5,
        boxstyle="round,pad=0.2", edgecolor=GRAY, linewidth=1.5, zorder=-1, **style)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    figure, (side, behind, above) = plt.subplots(1, 3, figsize=(12.2, 4.2))

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
    side.add_patch(Arc((0, LOADED), 1.3, 1.3, theta1=50, theta2=130, color="black",
                       linewidth=1.5))
    side.annotate("", (0.65 * math.cos(math.radians(50)),
                       LOADED + 0.65 * math.sin(math.radians(50))),
                  (0.65 * math.cos(math.radians(55)),
                   LOADED + 0.65 * math.sin(math.radians(55))),
                  arrowprops={"arrowstyle": "-|>", "color": "black",
                              "linewidth": 1.5, "shrinkA": 0, "shrinkB": 0})
    side.annotate(r"$\Omega$", (0, LOADED + 0.5), ha="center", va="center")

    ground(behind, "from behind")
    behind.add_patch(wheel_section(facecolor="0.93"))
    behind.plot([-0.6, 0.6], 2 * [LOADED], "-.", color="black", linewidth=0.8)
    behind.annotate("axle", (-0.75, LOADED), ha="center", va="center")
    camber(behind)
    behind.add_patch(plt.Rectangle((-1.25, -0.35), 2.5, 0.34, facecolor="white",
                                   zorder=-0.5))
    arrow(behind, (-0.95, 0), "$y$, left: $F_y$", (-0.86, -0.17))
    arrow(behind, (0, 0.75), "$z$, up: $F_z$", (-0.36, 0.6))
    across(behind, False, "$x$, forward: $F_x$", (0.5, -0.17))
    moment(behind, False, "$M_x$", (0.52, 0.36))

    above.set(xlim=(-1.4, 1.1), ylim=(-0.95, 1.4), title="from above")
    above.set_aspect("equal")
    above.axis("off")
    above.add_patch(FancyBboxPatch(
        (-HALF_WIDTH + 0.12, -0.75), 2 * HALF_WIDTH - 0.24, 1.5, boxstyle="round,pad=0.12", facecolor="0.93",
        edgecolor=GRAY, linewidth=1.5, zorder=-1))
    slip_angle(above)
    arrow(above, (0, 1.25), "$x$: $F_x$", (0.32, 1.15))
    arrow(above, (-0.95, 0), "$y$: $F_y$", (-0.9, -0.17))
    across(above, True, "$z$: $F_z$", (0, -0.2))
    moment(above, True, "$M_z$", (0.5, 0.3))
    save(figure, arguments.output)


if __name__ == "__main__":
    main()
