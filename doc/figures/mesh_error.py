#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh error of the force on the bias tire at 20 mm.

Reads the results of prm/bias_tire.prm on three meshes with each mortar matrix,
and writes

    mesh_error.png        the force against the square of the element size

and the table of doc/bias_tire.md. The extrapolation takes the error as C h^p.
"""

import argparse
import math
import sys
from collections import namedtuple
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from bias_tire import STYLE, force_at, replace_table
from biface_report.drawing import BLUE, GRAY, RED, save

MESHES = ("42x40", "84x80", "168x160")
MASSES = ("consistent", "lumped")

# The forces on the three meshes, the order p, and the limit
Forces = namedtuple("Forces", "values order limit")


def read_forces(results, mass):
    """The force (N) at 20 mm on each mesh, and Richardson's extrapolation."""
    values = [force_at(results / f"mesh_{mass}_{mesh}", 20) for mesh in MESHES]
    ratio = (values[1] - values[0]) / (values[2] - values[1])
    if ratio <= 1:
        sys.exit(f"{mass}: the forces {values} do not approach a limit")
    return Forces(values, math.log2(ratio),
                  values[2] + (values[2] - values[1]) / (ratio - 1))


def write_table(page, forces):
    """The table of the page: meshes, order, limit, error of the first mesh."""
    rows = [[mass, *(f"{value:.1f}" for value in result.values),
             f"{result.order:.2f}", f"{result.limit:.1f}",
             f"{result.values[0] - result.limit:.1f} "
             f"({100 * (result.values[0] / result.limit - 1):.1f} %)"]
            for mass, result in forces.items()]
    replace_table(page, "mesh error",
                  ["Multiplier mass", *(f"P on {mesh.replace('x', ' × ')} (N)"
                                        for mesh in MESHES), "Order", "Limit (N)",
                   f"Mesh error on {MESHES[0].replace('x', ' × ')} (N)"], rows)


def draw(forces, output):
    """The force against the square of the size of the elements."""
    figure, axes = plt.subplots(figsize=(7, 4.2))
    size = np.array([1, 1 / 2, 1 / 4])
    h = np.linspace(0, 1, 100)
    for (mass, result), color in zip(forces.items(), (BLUE, RED)):
        axes.plot(h**2, result.limit + (result.values[0] - result.limit)
                  * h**result.order, color=color, linewidth=1.2)
        axes.plot(size**2, result.values, "o", color=color,
                  label=f"{mass} mortar matrix, order {result.order:.2f}")
        axes.plot(0, result.limit, "o", color=color, markersize=8,
                  markerfacecolor="white", markeredgewidth=1.6, clip_on=False,
                  zorder=4)
    for i, mesh in enumerate(MESHES):
        axes.annotate(mesh.replace("x", " × "), (size[i]**2,
                                                 forces[MASSES[0]].values[i]),
                      (8, -11) if i == 2 else (-6, 7), color=GRAY,
                      textcoords="offset points",
                      ha="left" if i == 2 else "right")
    limits = [result.limit for result in forces.values()]
    axes.annotate(f"limits {min(limits):.0f} and {max(limits):.0f} N",
                  (0, np.mean(limits)), (14, -27), textcoords="offset points",
                  color="0.25")
    axes.set(xlabel="square of the element size, over that of the first mesh",
             ylabel="force at 20 mm (N)", xlim=(0, 1.04), ylim=(1860, 1960))
    axes.legend(loc="lower right", fontsize=10)
    save(figure, output / "mesh_error.png", dpi=110)


def main():
    """Write the table, draw the figure."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name, text in (("results", "directory with the results of each run"),
                       ("page", "doc/bias_tire.md, whose table is rewritten"),
                       ("output", "directory the figure is written to")):
        parser.add_argument(f"--{name}", type=Path, required=True, help=text)
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    forces = {mass: read_forces(arguments.results, mass) for mass in MASSES}
    write_table(arguments.page, forces)
    draw(forces, arguments.output)


if __name__ == "__main__":
    main()
