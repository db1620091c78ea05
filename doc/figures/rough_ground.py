#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of doc/rough_ground.md from a run of prm/tire_on_rough_ground.prm:

    side_force.png   side force of the ground against its slide
    stick_slip.png   where the footprint sticks and slips in some steps
"""

import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

FRICTION = 0.5

# Half of the width of the ground in pictures of the footprint (mm)
HALF_WIDTH = 60

# Slides (mm) of the pictures of the footprint, by the stage
PICTURES = (("pressing", 0), ("slide", 4.5), ("slide", 12), ("back", 6))


def draw_side_force(results, path):
    """The force against the slide, there and back."""
    stage, slide, vertical = (results.history[name]
                              for name in ("stage", "slide_y", "force"))
    side = results.forces().where(body="foundation")["F_y"]
    figure, axes = plt.subplots(figsize=(5.2, 3.4))
    for name, label, color in (("slide", "slide", BLUE),
                               ("back", "way back", RED)):
        chosen = np.flatnonzero(stage == name)
        chosen = np.concatenate([chosen[:1] - 1, chosen])
        axes.plot(slide[chosen], side[chosen], "o-", color=color, markersize=4,
                  label=label)
        if name == "slide":
            axes.plot(slide[chosen], FRICTION * vertical[chosen], "--",
                      color=GRAY, linewidth=1.2,
                      label="0.5 times vertical force")
    axes.axhline(0, color=GRAY, linewidth=0.6)
    axes.set_xlabel("Slide of the ground, mm")
    axes.set_ylabel("Side force $F_y$ on the tire, N")
    axes.legend()
    save(figure, path)


def draw_footprint(axes, contact):
    """The nodes in contact, and the tractions of friction, from above: x points down
    from the axle of the wheel to the ground, so that y points to the left of z."""
    for slips, color, label in ((0, BLUE, "sticks"), (1, RED, "slips")):
        nodes = (contact["active"] > 0) & (contact["slipping"] == slips)
        axes.plot(contact["y"][nodes], contact["z"][nodes], "o",
                  color=color, markersize=2.8, label=label)
    nodes = contact["active"] > 0
    axes.quiver(contact["y"][nodes], contact["z"][nodes],
                contact["friction_y"][nodes], contact["friction_z"][nodes],
                color="black", angles="xy", scale=2.2, width=0.006,
                headwidth=4, headlength=5, headaxislength=4.5, zorder=3)
    axes.set_aspect("equal")
    axes.set_xlim(HALF_WIDTH, -HALF_WIDTH)


def legend_of_footprints(figure, axes):
    """Names of the colors, to the right."""
    figure.legend(*axes.get_legend_handles_labels(), loc="center right",
                  bbox_to_anchor=(1.02, 0.5))


def draw_stick_slip(results, path):
    """The nodes in contact from above, and the tractions of friction."""
    history = results.history
    figure, all_axes = plt.subplots(1, len(PICTURES), figsize=(10, 3.9),
                                    sharex=True, sharey=True)
    for axes, (stage, slide) in zip(all_axes, PICTURES):
        chosen = np.flatnonzero((history["stage"] == stage)
                                & np.isclose(history["slide_y"], slide))[-1]
        draw_footprint(axes, results.contact(history["step"][chosen]))
        axes.set_title(f"{stage}, {slide:g} mm", fontsize=9)
        axes.set_xlabel("$y$ (to the left), mm")
    all_axes[0].set_ylabel("$z$, mm")
    legend_of_footprints(figure, all_axes[0])
    save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", type=Results)
    parser.add_argument("output", type=Path)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    draw_side_force(arguments.results, arguments.output / "side_force.png")
    draw_stick_slip(arguments.results, arguments.output / "stick_slip.png")


if __name__ == "__main__":
    main()
