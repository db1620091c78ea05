#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of three deformed shells of doc/any_mesh.md on random meshes.

    doc/figures/any_mesh.py build/doc/any_mesh/runs doc/figures/any_mesh.png

The first argument is where the target any_mesh has written its runs."""

import argparse
from pathlib import Path

import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from rendering import corners, plt, point_values, positions, read_grid

# Run, file, factor of displacements beyond those of the file, mirrored, elevation,
# azimuth and zoom of the view
SHELLS = (("hook_random_56", "shell-0001.vtu", 9, False, (55, -80, 1.1)),
          ("annulus_random_10", "shell-0001.vtu", 0, False, (22, 35, 1.25)),
          ("open_cylinder_random_28", None, 0, True, (24, -52, 1.1)))


def mirrored(sides):
    """The eighth of a cylinder and its mirror images in the planes of coordinates."""
    for axis in range(3):
        factor = np.ones(3)
        factor[axis] = -1
        sides = np.concatenate([sides, sides * factor])
    return sides


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=Path)
    parser.add_argument("picture", type=Path)
    arguments = parser.parse_args()

    figure = plt.figure(figsize=(9, 3.4), dpi=100)
    for i, (run, file, more, mirror, view) in enumerate(SHELLS):
        directory = arguments.runs / run
        grid = read_grid(directory / file if file
                         else sorted(directory.glob("shell-*.vtu"))[-1])
        motion = point_values(grid, "displacement")
        points = positions(grid) + more * motion
        # one face is enough
        cells = corners(grid, grid.GetCell(0).GetNumberOfPoints())[:, :4]
        cells = cells[point_values(grid, "outer_face")[cells].min(axis=1) > 0]
        sides, size = points[cells], np.linalg.norm(motion, axis=1)[cells].mean(axis=1)
        if mirror:
            sides, size = mirrored(sides), np.tile(size, 8)
        axes = figure.add_axes([i / 3, 0, 1 / 3, 1], projection="3d")
        axes.add_collection3d(Poly3DCollection(
            sides, facecolors=plt.get_cmap("YlGnBu")(0.1 + 0.7 * size / size.max()),
            edgecolors=(0, 0, 0, 0.35), linewidths=0.3))
        low, high = sides.min(axis=(0, 1)), sides.max(axis=(0, 1))
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect(high - low, zoom=view[2])
        axes.view_init(elev=view[0], azim=view[1])
        axes.axis("off")
    figure.savefig(arguments.picture)


if __name__ == "__main__":
    main()
