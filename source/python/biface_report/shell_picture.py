# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the deformed shell, and the foundation if there is one, to a PNG file.
Prints the direction to the camera. Needs VTK and a display."""

import argparse
import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                    vtk_to_numpy)

from . import rendering
from .curved import CurvedCells, joined
from .foundation import Foundation

WIDTH, HEIGHT = 1000, 760
OUTSIDE, INSIDE = (0.62, 0.66, 0.71), (0.80, 0.81, 0.83)


def view_of_contact(normal):
    """Direction from the shell to the camera, and which way is up. The camera looks
    through the foundation, slightly from the side."""
    # the Cartesian axes that are most nearly in the plane
    order = np.argsort(np.abs(normal), kind="stable")
    aside, up = (np.eye(3)[i] for i in sorted(order[:2]))
    direction = normal + 0.44 * aside + 0.32 * up
    return direction / np.linalg.norm(direction), up


def view_of_shell(points, area):
    """The same without contact. points are those of both faces; area is the mean
    normal of the outer face. An open shell lies with its outer face up; for a
    closed one, y is up."""
    share = np.linalg.norm(area)
    if share < 0.3:
        return np.array([0.52, 0.45, 0.72]) / np.linalg.norm([0.52, 0.45, 0.72]), \
            np.array([0, 1.0, 0])
    up = area / share
    flat = points - points.mean(0)
    flat = flat - np.outer(flat @ up, up)
    _, _, axes = np.linalg.svd(flat[::max(1, len(flat) // 2000)],
                               full_matrices=False)
    # the Cartesian axes, unless the shell lies obliquely
    long = np.eye(3)[np.argmax(np.abs(axes[0]))]
    long = long - (long @ up) * up
    long /= np.linalg.norm(long)
    short = np.cross(up, long)
    direction = 0.55 * long - 0.8 * short + 0.75 * up
    return direction / np.linalg.norm(direction), up


def face_surface(grid, outer, name):
    """A face as a smooth surface, with the values of a field, or magnitudes of
    vectors, as scalars; and the sides of its cells as arrays of points."""
    cells = rendering.corners(grid, 4)
    is_outer = rendering.point_values(grid, "outer_face")
    cells = cells[is_outer[cells[:, 0]] == outer]
    points = rendering.positions(grid)
    values = rendering.point_values(grid, name)
    values = np.linalg.norm(values, axis=1) if values.ndim > 1 else values
    kept, cells = joined(points, cells)
    curved = CurvedCells(points[kept], cells)
    points, values = curved.points(), curved.values(values[kept])
    at = np.arange(values.size).reshape(values.shape)
    pieces = np.stack([at[:, :-1, :-1], at[:, 1:, :-1], at[:, 1:, 1:],
                       at[:, :-1, 1:]], -1).reshape(-1, 4)
    points = points.reshape(-1, 3)
    kept, pieces = joined(points, pieces)

    data, polygons = vtk.vtkPolyData(), vtk.vtkCellArray()
    polygons.SetData(4, numpy_to_vtkIdTypeArray(
        np.ascontiguousarray(pieces, dtype=np.int64).ravel(), deep=True))
    data.SetPoints(rendering.to_vtk_points(points[kept]))
    data.SetPolys(polygons)
    data.GetPointData().SetScalars(numpy_to_vtk(values.ravel()[kept], deep=True))
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput(), curved.lines()


def area_vector(surface):
    """The mean normal of a surface: its integral divided by the area."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(
        surface.GetPolys().GetConnectivityArray()).reshape(-1, 4)]
    areas = np.cross(corners[:, 2] - corners[:, 0],
                     corners[:, 3] - corners[:, 1]) / 2
    return areas.sum(0) / np.linalg.norm(areas, axis=1).sum()


def colored_actor(surface, colors, limits):
    """A slightly lit surface, colored by its scalars."""
    actor = rendering.lit_actor(surface, OUTSIDE)
    actor.GetMapper().ScalarVisibilityOn()
    rendering.use_colors(actor.GetMapper(), colors, limits)
    actor.GetProperty().SetAmbient(0.45)
    actor.GetProperty().SetDiffuse(0.55)
    return actor


def foundation_patch(surface, foundation):
    """The part of a foundation around the zone with pressure."""
    points = rendering.positions(surface)
    pressure = vtk_to_numpy(surface.GetPointData().GetScalars())
    axes = foundation.patch_axes()
    zone = points[pressure > 0] @ axes.T
    size = np.ptp(points @ axes.T, axis=0)
    # a curved one is large enough for its shape to be seen
    reach = (0.25 if foundation.shape == "plane" else 0.4) * size
    margin = 0.12 * size.max()
    low = np.minimum(zone.min(0) - margin, zone.mean(0) - reach)
    high = np.maximum(zone.max(0) + margin, zone.mean(0) + reach)
    # slightly behind the zone as seen by the camera, so that its colors are exact
    return foundation.patch(low, high) - 0.002 * size.max() * foundation.direction


def foundation_actors(foundation, patch):
    """A patch of a foundation as glass, with lines that show its shape."""
    pane = vtk.vtkStructuredGrid()
    pane.SetDimensions(patch.shape[1], patch.shape[0], 1)
    pane.SetPoints(rendering.to_vtk_points(patch.reshape(-1, 3)))
    surface = vtk.vtkStructuredGridGeometryFilter()
    surface.SetInputData(pane)
    surface.Update()
    actor = rendering.lit_actor(surface.GetOutput(), (0.55, 0.7, 0.85))
    actor.GetProperty().SetOpacity(0.12)
    lines = rendering.line_data(foundation.patch_lines(patch))
    return [actor, rendering.line_actor(lines, (0.35, 0.45, 0.55), 1.2)]


def add_directions(figure, direction, up):
    """The Cartesian axes as the camera sees them, in a corner."""
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    above = np.cross(direction, right)
    axes = figure.add_axes([0.01, 0.01, 0.15, 0.15 * WIDTH / HEIGHT])
    axes.set(xlim=(-1.35, 1.35), ylim=(-1.35, 1.35))
    axes.axis("off")
    for name, axis in zip("xyz", np.eye(3)):
        tip = np.array([axis @ right, axis @ above])
        if np.linalg.norm(tip) < 0.05:
            continue
        axes.annotate("", tip, (0, 0), arrowprops={
            "arrowstyle": "-|>", "color": "0.25", "shrinkA": 0, "shrinkB": 0})
        axes.text(*(tip + 0.26 * tip / np.linalg.norm(tip)), name, fontsize=17,
                  ha="center", va="center")


def main():
    """Draws one file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shell", type=Path, help="shell-NNNN.vtu")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    parser.add_argument("--foundation", type=json.loads,
                        help="the arguments of Foundation: color by pressure")
    parser.add_argument("--label", default="", help="of the color bar")
    arguments = parser.parse_args()

    grid = rendering.read_grid(arguments.shell)
    foundation = arguments.foundation and Foundation(**arguments.foundation)
    name = "contact_pressure" if foundation else "displacement"
    (outer, sides), (inner, _) = (face_surface(grid, face, name)
                                  for face in (1, 0))
    limits = (0, max(outer.GetScalarRange()[1], inner.GetScalarRange()[1]))
    shown = np.concatenate([rendering.positions(face)
                            for face in (outer, inner)])
    if foundation:
        patch = foundation_patch(outer, foundation)
        colors = plt.get_cmap("plasma")
        threshold = 0.01 * limits[1]
        actors = [rendering.lit_actor(rendering.below(outer, threshold), OUTSIDE),
                  rendering.lit_actor(inner, INSIDE),
                  rendering.zone_actor(outer, threshold, colors, limits),
                  *foundation_actors(foundation, patch)]
        direction, up = view_of_contact(foundation.direction)
        shown = np.concatenate([shown, patch.reshape(-1, 3)])
    else:
        colors = plt.get_cmap("viridis")
        actors = [colored_actor(face, colors, limits)
                  for face in (outer, inner)]
        direction, up = view_of_shell(shown, area_vector(outer))
    actors.append(rendering.line_actor(rendering.line_data(sides), (0, 0, 0), 0.6,
                                       0.3))
    camera = rendering.fitted_camera(shown, direction, up, WIDTH / HEIGHT,
                                     right_margin=0.17)
    figure = rendering.figure_of(
        rendering.render(actors, (WIDTH, HEIGHT), camera))
    rendering.add_color_bar(figure, [0.86, 0.2, 0.024, 0.6], colors, limits,
                            arguments.label)
    add_directions(figure, direction, up)
    figure.savefig(arguments.picture)
    print(*direction)


if __name__ == "__main__":
    main()
