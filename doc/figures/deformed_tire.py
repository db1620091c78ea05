#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the deformed bias tire with its footprint.

Reads a shell-NNNN.vtu of prm/bias_tire.prm and writes a PNG. Needs VTK and a
display; a virtual one (xvfb-run) is sufficient.

The file contains the displacements of the nodes only. Between the nodes the
elements follow the torus exactly, and their displacements are bilinear in the
local basis. The picture does the same.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from rendering import (
    add_color_bar, figure_of, fixed_camera, line_actor, line_data, lit_actor,
    point_values, positions, read_grid, render, to_vtk_points, zone_actor)

# Distance of the meridian's center from the axle (mm)
CENTER_RADIUS = 200

# Minimum number of pieces per element side in the picture
SUBDIVISIONS = 6

# Size of the picture in pixels
WIDTH, HEIGHT = 1000, 920

RUBBER = (0.62, 0.66, 0.71)
INSIDE = (0.80, 0.81, 0.83)
PRESSURE_RANGE = (0, 0.35)
COLORS = plt.get_cmap("plasma")


# ---------------------------------------------------------------- geometry


def read_shell(path):
    """Undeformed positions, displacements, pressures and faces of all points."""
    grid = read_grid(path)
    data = {name: point_values(grid, name)
            for name in ("displacement", "contact_pressure", "outer_face",
                         "active")}
    return positions(grid) - data["displacement"], data


def chart(points):
    """Angles psi, phi (rad) and radius of the meridian, of undeformed points."""
    distance = np.hypot(points[:, 0], points[:, 2]) - CENTER_RADIUS
    psi = np.arctan2(points[:, 1], distance)
    phi = np.arctan2(points[:, 2], points[:, 0])
    phi[phi > np.pi - 1e-3] -= 2 * np.pi
    return psi, phi, np.hypot(distance, points[:, 1])


def grid_lines(angles):
    """The distinct values of many angles (rad), sorted, and for each angle the
    index of its value. The file is in single precision, so angles that are
    nearly equal are equal."""
    order = np.argsort(angles)
    is_new = np.diff(angles[order], prepend=-np.inf) > 1e-4
    index = np.empty(len(angles), dtype=int)
    index[order] = np.cumsum(is_new) - 1
    return angles[order][is_new], index


def local_basis(psi, phi):
    """Unit vectors along the meridian, around the axle, and outward."""
    zero = np.zeros_like(psi)
    radial = np.stack([np.cos(phi), zero, np.sin(phi)], -1)
    around = np.stack([-np.sin(phi), zero, np.cos(phi)], -1)
    axial = np.stack([zero, zero + 1, zero], -1)
    sine, cosine = np.sin(psi)[..., None], np.cos(psi)[..., None]
    return np.stack([cosine * axial - sine * radial, around,
                     cosine * radial + sine * axial], -2)


class Face:
    """The nodes of one face as a grid in psi and phi, periodic in phi."""

    def __init__(self, path, outer):
        """Reads the outer or the inner face from a VTU file."""
        points, data = read_shell(path)
        chosen = data["outer_face"] == outer
        psi, phi, radius = chart(points[chosen])
        self.radius = radius.mean()
        self.psi, rows = grid_lines(psi)
        self.phi, columns = grid_lines(phi)

        displacement = np.einsum("nij,nj->ni", local_basis(psi, phi),
                                 data["displacement"][chosen])
        shape = len(self.psi), len(self.phi)
        self.displacement = np.zeros(shape + (3,))
        self.displacement[rows, columns] = displacement
        self.pressure = np.zeros(shape)
        self.pressure[rows, columns] = data["contact_pressure"][chosen]
        self.active = np.zeros(shape, dtype=bool)
        self.active[rows, columns] = data["active"][chosen] > 0

    def interpolate(self, values, psi, phi):
        """Bilinear in psi and phi, on the grid of two lists of angles."""
        along = np.array([np.interp(psi, self.psi, column) for column
                          in values.reshape(len(self.psi), -1).T]).T
        along = along.reshape((len(psi),) + values.shape[1:])
        along = np.moveaxis(along, 1, 0).reshape(len(self.phi), -1)
        around = np.array([np.interp(phi, self.phi, column, period=2 * np.pi)
                           for column in along.T]).T
        around = around.reshape((len(phi), len(psi)) + values.shape[2:])
        return np.moveaxis(around, 0, 1)

    def positions(self, psi, phi):
        """Deformed positions on the grid of two lists of angles."""
        basis = local_basis(*np.meshgrid(psi, phi, indexing="ij"))
        displacement = self.interpolate(self.displacement, psi, phi)
        outward = self.radius * basis[..., 2, :]
        center = np.stack([CENTER_RADIUS * np.cos(phi), 0 * phi,
                           CENTER_RADIUS * np.sin(phi)], -1)
        return center + outward + np.einsum("...ij,...i->...j", basis,
                                            displacement)


def zone(face):
    """A field at the nodes that is positive within the footprint and vanishes at the
    line of zero clearance. Beside the footprint the clearance from the plane grows
    nearly with the square of the distance: its root, with a minus, is extrapolated
    from two nodes beside the footprint to the nodes in contact next to them."""
    x = face.positions(face.psi, face.phi)[..., 0]
    root = np.sqrt(np.maximum(x[face.active].max() - x, 0))
    root[face.active] = np.nan
    inside = np.full(root.shape, np.nan)
    for axis in (0, 1):
        for step in (1, -1):
            first, second = np.roll(root, step, axis), np.roll(root, 2 * step, axis)
            inside = np.fmax(inside, 2 * first - second)
    depth = np.nanmean(np.abs(inside[face.active]))
    inside = np.where(np.isnan(inside), -depth, np.minimum(inside, 0))
    return -np.where(face.active, inside, root)


def subdivide(angles, spacing):
    """A list of angles (rad) and further ones in between, at most a spacing
    apart."""
    pieces = [np.linspace(a, b, max(SUBDIVISIONS,
                                    int(np.ceil((b - a) / spacing))),
                          endpoint=False)
              for a, b in zip(angles[:-1], angles[1:])]
    return np.append(np.concatenate(pieces), angles[-1])


def fine_angles(face):
    """Lists of angles psi, phi to draw a face with."""
    return (subdivide(face.psi, np.radians(1)),
            subdivide(np.append(face.phi, face.phi[0] + 2 * np.pi),
                      np.radians(1)))


# ---------------------------------------------------------------- VTK


def surface(points, pressure=None):
    """Points on a two-dimensional grid as a smooth VTK surface."""
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(points.shape[1], points.shape[0], 1)
    grid.SetPoints(to_vtk_points(points.reshape(-1, 3)))
    if pressure is not None:
        grid.GetPointData().SetScalars(
            numpy_to_vtk(pressure.ravel(), deep=True))
    polygons = vtk.vtkGeometryFilter()
    polygons.SetInputData(grid)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(polygons.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def mesh_lines(face):
    """The sides of the elements on a face, with their curvature."""
    psi, phi = fine_angles(face)
    along = face.positions(psi, face.phi)
    around = face.positions(face.psi, phi)
    return list(np.moveaxis(along, 1, 0)) + list(around)


def wall_actors(path):
    """The tire: both faces, the edges between them, and the mesh."""
    outer, inner = Face(path, 1), Face(path, 0)
    psi, phi = fine_angles(outer)
    outside, inside = outer.positions(psi, phi), inner.positions(psi, phi)
    pressure = outer.interpolate(outer.pressure, psi, phi)
    actors = [lit_actor(surface(outside), RUBBER),
              lit_actor(surface(inside), INSIDE),
              footprint_actor(surface(outside, pressure),
                              outer.interpolate(zone(outer), psi, phi))]
    for end in (0, -1):
        edge = np.stack([outside[end], inside[end]])
        actors.append(lit_actor(surface(edge), INSIDE))
    actors.append(line_actor(line_data(mesh_lines(outer)), (0, 0, 0), 0.6, 0.35))
    return actors


def footprint_actor(data, inside):
    """The part of a surface where a field is positive, in the colors of its
    scalars."""
    data.GetPointData().GetScalars().SetName("pressure")
    field = numpy_to_vtk(inside.ravel(), deep=True)
    field.SetName("inside")
    data.GetPointData().AddArray(field)
    data.GetPointData().SetActiveScalars("inside")
    actor = zone_actor(data, 0, COLORS, PRESSURE_RANGE)
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("pressure")
    return actor


def ground_actors(path):
    """The ground: a transparent pane with an outline, slightly behind the
    footprint so that it does not change its colors."""
    outer = Face(path, 1)
    x = outer.positions(outer.psi, outer.phi)[..., 0].max() - 0.3
    y, z = 90, 150
    corners = np.array([[[x, -y, -z], [x, y, -z]], [[x, -y, z], [x, y, z]]])
    pane = lit_actor(surface(corners), (0.55, 0.7, 0.85))
    pane.GetProperty().SetOpacity(0.12)
    outline = corners[[0, 0, 1, 1, 0], [0, 1, 1, 0, 0]]
    return [pane, line_actor(line_data([outline]), (0.35, 0.45, 0.55), 1.2)]


# ---------------------------------------------------------------- program


def main():
    """Draw the tire of one VTU file."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("shell", type=Path, help="shell-NNNN.vtu")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()
    actors = wall_actors(arguments.shell) + ground_actors(arguments.shell)
    camera = fixed_camera((1000, 460, 330), (0, 52, 4), 27.5)
    figure = figure_of(render(actors, (WIDTH, HEIGHT), camera))
    add_color_bar(figure, [0.79, 0.25, 0.024, 0.5], COLORS, PRESSURE_RANGE,
                  "contact pressure (MPa)", "max")
    figure.savefig(arguments.picture)


if __name__ == "__main__":
    main()
