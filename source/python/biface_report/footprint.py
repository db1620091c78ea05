# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact zone, projected onto the plane normal to the ground's direction.

contact-NNNN.csv has the nodes in contact and all that share a cell with them, so
that all four corners of every cell with a corner in contact are known.
"""

import matplotlib.tri
import numpy as np
from matplotlib.path import Path

from .ground import plane_axes
from .zone import Zone

# Pieces into which the side of a cell is cut
SUBDIVISIONS = 8

# If the moments of the zone differ by less, its principal axes are not unique
ROUND = 0.02


def normal_of_nodes(contact):
    """The normal of the plane through nodes in contact, if no file gives it."""
    chosen = contact["active"] > 0
    points = contact.positions()[chosen]
    if len(points) < 3:
        return None
    _, _, axes = np.linalg.svd(points - points.mean(0))
    return axes[2] * np.sign(axes[2][np.argmax(np.abs(axes[2]))])


def cells_in_contact(contact, is_closed):
    """The four corners of each cell with a corner in contact, as row numbers of the
    table. Cells lie between adjacent grid lines of the table."""
    lines, places = zip(*(np.unique(contact[name], return_inverse=True)
                          for name in ("alpha_1", "alpha_2")))
    rows = np.full((len(lines[0]), len(lines[1])), -1)
    rows[places[0], places[1]] = np.arange(len(contact))
    if is_closed and len(lines[1]) > 2:
        rows = np.concatenate([rows, rows[:, :1]], 1)
    corners = np.stack([rows[:-1, :-1], rows[1:, :-1], rows[1:, 1:],
                        rows[:-1, 1:]], -1).reshape(-1, 4)
    corners = corners[(corners >= 0).all(1)]
    return corners[(contact["active"][corners] > 0).any(1)]


def bilinear_weights():
    """Weights of a cell's corners at the points of a grid in it, and the triangles
    of this grid."""
    n = SUBDIVISIONS
    s, t = (grid.ravel() for grid in
            np.meshgrid(*2 * [np.linspace(0, 1, n + 1)], indexing="ij"))
    weights = np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], -1)
    index = np.arange((n + 1)**2).reshape(n + 1, n + 1)
    a, b, c, d = (part.ravel() for part in
                  (index[:-1, :-1], index[1:, :-1], index[1:, 1:],
                   index[:-1, 1:]))
    return weights, np.concatenate([np.stack([a, b, c], -1),
                                    np.stack([a, c, d], -1)])


class Footprint:
    """Pressures between nodes, outline, principal axes and lengths."""

    def __init__(self, contact, normal, is_closed, zone=None):
        """From the table of contact-NNNN.csv with at least one node in contact, and
        the zone of the whole shell if that is known. Lengths are those of the
        table."""
        self.axes, self.axis_names = plane_axes(normal)
        self.nodes = contact.positions() @ self.axes.T
        self.active = contact["active"] > 0
        self.pressure = contact["pressure"]
        cells = cells_in_contact(contact, is_closed)
        self._interpolate(cells)
        self.is_estimated = zone is None
        if zone is None:
            zone = Zone(contact.positions(), cells, contact["clearance"],
                        self.pressure, self.active, is_whole=False)
        self.outline = oriented([line @ self.axes.T for line in zone.outline()])
        self._measure()
        self.minimum_lengths = self._extents(self.nodes[self.active])
        self.maximum_lengths = self._extents(self.nodes[np.unique(cells)])

    def scale_to(self, length, width):
        """Stretches the outline to a length normal to the y axis and a width along
        it, about its middle: those that the program measured."""
        across = self.axes[:, 1] / np.linalg.norm(self.axes[:, 1])
        turned = np.array([across[::-1] * [1, -1], across])
        points = np.concatenate(self.outline) @ turned.T
        low, high = points.min(0), points.max(0)
        factors = np.array([length, width]) / np.maximum(high - low, 1e-300)
        middle = (low + high) / 2
        self.outline = [((line @ turned.T - middle) * factors + middle) @ turned
                        for line in self.outline]
        self._measure()

    def _interpolate(self, cells):
        """Bilinear values on a fine triangulation of the cells."""
        weights, triangles = bilinear_weights()
        points = np.einsum("pc,kci->kpi", weights, self.nodes[cells])
        pressure = self.pressure[cells] @ weights.T
        shift = weights.shape[0] * np.arange(len(cells))
        # cells share the points on their sides: outlines are not interrupted
        points = points.reshape(-1, 2)
        size = np.ptp(points, axis=0).max()
        _, first, which = np.unique(np.round(points / size, 9), axis=0,
                                    return_index=True, return_inverse=True)
        self.points = points[first]
        self.fine_pressure = pressure.ravel()[first]
        self.triangles = which[triangles + shift[:, None, None]].reshape(-1, 3)

    def triangulation(self):
        """The fine triangulation, for pictures."""
        return matplotlib.tri.Triangulation(*self.points.T, self.triangles)

    def _measure(self):
        """Center and principal axes of the zone, the longer one first, and the
        lengths along them."""
        area, self.center, moments = moments_within(self.outline)
        if area <= 0:
            self.center, moments = self.nodes[self.active].mean(0), np.eye(2)
        values, vectors = np.linalg.eigh(moments)
        self.is_round = values[1] - values[0] <= ROUND * values[1]
        self.principal = np.eye(2) if self.is_round else vectors.T[::-1]
        # both to the right, or up
        for axis in self.principal:
            axis *= np.sign(axis[np.argmax(np.abs(axis))])
        self.lengths = self._extents(np.concatenate(self.outline))

    def _extents(self, points):
        """The extent of points along the principal axes."""
        return np.ptp(points @ self.principal.T, axis=0)


def oriented(lines):
    """Closed lines, those around a zone counterclockwise and those around a hole in
    it clockwise."""
    result = []
    for line in lines:
        is_hole = sum(Path(other).contains_point(line[0]) for other in lines
                      if other is not line) % 2
        is_clockwise = np.sum(cross_of(line)) < 0
        result.append(line[::-1] if is_hole != is_clockwise else line)
    return result


def cross_of(line):
    """Twice the areas of the triangles from the origin to the pieces of a line."""
    return line[:-1, 0] * line[1:, 1] - line[1:, 0] * line[:-1, 1]


def moments_within(lines):
    """Area, center and central second moments over the area, of what oriented lines
    enclose."""
    area, first, second = 0, np.zeros(2), np.zeros((2, 2))
    for line in lines:
        a, b, cross = line[:-1], line[1:], cross_of(line)
        area += cross.sum() / 2
        first += cross @ (a + b) / 6
        second += (np.einsum("k,ki,kj->ij", cross, a + b, a + b)
                   + np.einsum("k,ki,kj->ij", cross, a, a)
                   + np.einsum("k,ki,kj->ij", cross, b, b)) / 24
    if area <= 0:
        return 0, first, second
    center = first / area
    return area, center, second / area - np.outer(center, center)
