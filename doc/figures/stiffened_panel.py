#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the first buckling shape of prm/stiffened_panel.prm.

    build/biface prm/stiffened_panel.prm
    doc/figures/stiffened_panel.py output_stiffened_panel/buckling-0001-001.vtu \\
        doc/figures/stiffened_panel.png
"""

import argparse
from pathlib import Path

import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from rendering import corners, plt, point_values, positions, read_grid

# Height of the waves in the picture (mm)
AMPLITUDE = 15


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("vtu", type=Path)
    parser.add_argument("picture", type=Path)
    arguments = parser.parse_args()

    grid = read_grid(arguments.vtu)
    shape = point_values(grid, "mode")
    # quadrilaterals in the order of VTK, counterclockwise
    cells = corners(grid, grid.GetCell(0).GetNumberOfPoints())[:, :4]
    shape *= AMPLITUDE / np.abs(shape).max()
    points = positions(grid)
    sides = (points + shape)[cells]
    deflection = np.abs(shape).max(axis=1)[cells].mean(axis=1) / AMPLITUDE

    figure = plt.figure(figsize=(8, 4.6), dpi=100)
    axes = figure.add_axes([-0.12, -0.25, 1.24, 1.5], projection="3d")
    axes.add_collection3d(Poly3DCollection(
        sides, facecolors=plt.get_cmap("YlGnBu")(0.15 + 0.75 * deflection),
        edgecolors=(0, 0, 0, 0.25), linewidths=0.3))
    low, high = points.min(axis=0), points.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(-60, 90))
    axes.set_box_aspect((high[0] - low[0], high[1] - low[1], 150))
    axes.view_init(elev=32, azim=-58)
    axes.axis("off")
    figure.savefig(arguments.picture)


if __name__ == "__main__":
    main()
