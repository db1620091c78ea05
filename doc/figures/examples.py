#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The roof of prm/snap_through_roof.prm: the path of its center, and the line along
its crown at some points of the path."""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results
from biface_report.drawing import BLUE, GRAY, STYLE, save

# The force (N) for a load factor of 1, and the radius of the roof (mm)
FORCE, RADIUS = 1000, 2540


def center_path(results):
    """Steps, deflection and force of the center."""
    center = results.probes().where(name="center")
    return center["step"], -center["u_x"], FORCE * center["load_factor"]


def points_of_interest(deflection, force):
    """Indices of the upper limit point, of the two turning points of the
    deflection, of the lower limit point, and of the end."""
    top = int(np.argmax(force[:len(force) // 2]))
    low = int(np.argmin(force))
    right = top + int(np.argmax(deflection[top:low]))
    left = right + int(np.argmin(deflection[right:low]))
    return [top, right, left, low, len(force) - 1]


def crown_line(results, step):
    """Distance along the axis and height above the undeformed crown, on both sides
    of the plane of symmetry."""
    profile = results.profile(step)
    along, height = ((profile["outer_" + axis] + profile["inner_" + axis]) / 2
                     for axis in "yx")
    height -= RADIUS
    return (np.concatenate([-along[::-1], along]),
            np.concatenate([height[::-1], height]))


def main():
    """Draw the results of one run."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("roof", type=Results, help="a directory of results")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)

    steps, deflection, force = center_path(arguments.roof)
    figure, (path, shape) = plt.subplots(1, 2, figsize=(10, 4),
                                         gridspec_kw={"wspace": 0.28})
    path.plot(np.append(0, deflection), np.append(0, force), "-", color=BLUE)
    path.axhline(0, color=GRAY, linewidth=0.8)
    path.set(xlabel="deflection of the center (mm)", ylabel="force (N)")
    points = points_of_interest(deflection, force)
    colors = plt.get_cmap("viridis")(np.linspace(0, 0.85, len(points)))
    for number, (i, color) in enumerate(zip(points, colors), 1):
        path.plot(deflection[i], force[i], "o", color=color, markersize=7)
        path.annotate(str(number), (deflection[i], force[i]),
                      (-15, -4) if number in (3, 5) else (7, 5),
                      textcoords="offset points")
        along, height = crown_line(arguments.roof, steps[i])
        shape.plot(along, height, color=color)
        shape.annotate(str(number), (0, height[len(height) // 2]), (0, 3),
                       textcoords="offset points", ha="center", color=color)
    shape.axhline(0, color=GRAY, linewidth=0.8)
    shape.set(xlabel="distance along the crown (mm)",
              ylabel="height (mm)")
    save(figure, arguments.picture)


if __name__ == "__main__":
    main()
