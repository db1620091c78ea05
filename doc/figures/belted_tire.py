#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the plies of the belted tire, cut open in steps.

Reads a plies-NNNN.vtu of prm/belted_tire.prm and writes a PNG. Needs VTK and a
display; a virtual one (xvfb-run) is sufficient.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from rendering import (
    add_color_bar, corners, figure_of, fixed_camera, merge_points, point_values,
    positions, read_grid, render, to_vtk_points, use_colors)

# Size of the picture in pixels
WIDTH, HEIGHT = 1000, 860

# The angle around the axle (degrees) at which each ply is cut off, so that the
# ply below is visible
CUTS = {1: -48, 2: -36, 3: -24, 4: -6, 5: 12, 6: 30}
# Name of each ply, its place in the picture, and that of a point of the ply where it
# is uncovered, as fractions of width and height
NAMES = {6: ("tread", (0.15, 0.92), (0.30, 0.86)),
         5: ("outer belt", (0.13, 0.76), (0.235, 0.72)),
         4: ("inner belt", (0.13, 0.57), (0.25, 0.53)),
         3: ("outer\ncarcass ply", (0.13, 0.385), (0.24, 0.34)),
         2: ("inner\ncarcass ply", (0.13, 0.23), (0.26, 0.18)),
         1: ("inner rubber", (0.17, 0.07), (0.29, 0.075))}
# Colors of the rubber plies, which have no cords
RUBBER_PLIES = {1: (0.80, 0.81, 0.83), 6: (0.50, 0.53, 0.57)}
STRESS_RANGE = (-40, 40)
COLORS = plt.get_cmap("coolwarm")


class Plies:
    """All hexahedra: their deformed points, the stress along the cords at these,
    the number of the ply, and the angle around the axle."""

    def __init__(self, path):
        """Reads a VTU file."""
        grid = read_grid(path)
        cells = corners(grid, 8)
        self.points = positions(grid)[cells]
        self.stress = point_values(grid, "s_L")[cells]
        self.number = point_values(grid, "ply")[cells][:, 0]
        displacement = point_values(grid, "displacement")[cells]
        center = (self.points - displacement).mean(1)
        self.angle = np.degrees(np.arctan2(center[:, 2], center[:, 0]))

    def surface(self, number):
        """A ply from its cut onward, as a smooth surface. The file has separate
        points for each cell: they are merged, and their stresses averaged."""
        chosen = (self.number == number) & (self.angle > CUTS[number])
        points = self.points[chosen].reshape(-1, 3)
        first, which = merge_points(points, 2)
        stress = np.bincount(which, self.stress[chosen].ravel())
        stress /= np.bincount(which)

        grid = vtk.vtkUnstructuredGrid()
        grid.SetPoints(to_vtk_points(points[first]))
        grid.GetPointData().SetScalars(numpy_to_vtk(stress, deep=True))
        for hexahedron in which.reshape(-1, 8):
            grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, hexahedron)

        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(grid)
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputConnection(surface.GetOutputPort())
        normals.SetFeatureAngle(40)
        normals.Update()
        return normals.GetOutput()


def ply_actor(plies, number):
    """A ply, colored by the stress along its cords if it has any."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(plies.surface(number))
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if number in RUBBER_PLIES:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(RUBBER_PLIES[number])
    else:
        use_colors(mapper, COLORS, STRESS_RANGE)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.65)
    return actor


def main():
    """Draw the plies of one VTU file."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("plies", type=Path, help="plies-NNNN.vtu")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()
    plies = Plies(arguments.plies)
    actors = [ply_actor(plies, number) for number in CUTS]
    camera = fixed_camera((1000, 470, -150), (60, 20, 35), 31)
    figure = figure_of(render(actors, (WIDTH, HEIGHT), camera))
    add_color_bar(figure, [0.86, 0.25, 0.024, 0.5], COLORS, STRESS_RANGE,
                  "stress along the cords (MPa)", "both")
    for name, place, point in NAMES.values():
        figure.text(*place, name, fontsize=13, ha="right", va="center")
        start = (place[0] + 0.008, place[1])
        figure.add_artist(plt.Line2D(*zip(start, point), color="0.2", linewidth=1))
        figure.add_artist(plt.Line2D([point[0]], [point[1]], color="0.2", marker="o",
                                     markersize=3.5))
    figure.savefig(arguments.picture)


if __name__ == "__main__":
    main()
