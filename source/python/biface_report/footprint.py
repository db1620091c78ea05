# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact zone, projected onto the plane normal to the foundation's direction.

contact-NNNN.csv has the nodes in contact and all that share a cell with them, so
that all four corners of every cell with a corner in contact are known. The edge of
the zone is somewhere between the last node in contact and the next one; the
outline is drawn halfway, which agrees with the contact area of history.csv.
"""

import matplotlib.figure
import matplotlib.tri
import numpy as np

from .foundation import plane_axes

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

    def __init__(self, contact, normal, is_closed):
        """From the table of contact-NNNN.csv with at least one node in contact.
        Lengths are those of the table."""
        self.axes, self.axis_names = plane_axes(normal)
        self.nodes = contact.positions() @ self.axes.T
        self.active = contact["active"] > 0
        self.pressure = contact["pressure"]
        cells = cells_in_contact(contact, is_closed)
        self._interpolate(cells)
        self._find_outline()
        self._find_principal_axes()
        neighbors = self.nodes[np.unique(cells)]
        self.lengths = self._extents(self.outline_points())
        self.minimum_lengths = self._extents(self.nodes[self.active])
        self.maximum_lengths = self._extents(neighbors)

    def _interpolate(self, cells):
        """Bilinear values on a fine triangulation of the cells."""
        weights, triangles = bilinear_weights()
        points = np.einsum("pc,kci->kpi", weights, self.nodes[cells])
        pressure = self.pressure[cells] @ weights.T
        contact = self.active[cells].astype(float) @ weights.T
        shift = weights.shape[0] * np.arange(len(cells))
        # cells share the points on their sides: outlines are not interrupted
        points = points.reshape(-1, 2)
        size = np.ptp(points, axis=0).max()
        _, first, which = np.unique(np.round(points / size, 9), axis=0,
                                    return_index=True, return_inverse=True)
        self.points = points[first]
        self.fine_pressure = pressure.ravel()[first]
        self.fine_contact = contact.ravel()[first]
        self.triangles = which[triangles + shift[:, None, None]].reshape(-1, 3)

    def triangulation(self):
        """The fine triangulation, for pictures."""
        return matplotlib.tri.Triangulation(*self.points.T, self.triangles)

    def _find_outline(self):
        """Polylines halfway between nodes in contact and their neighbors."""
        corners = self.points[self.triangles]
        edges = corners[:, 1:] - corners[:, :1]
        area = np.abs(edges[:, 0, 0] * edges[:, 1, 1]
                      - edges[:, 0, 1] * edges[:, 1, 0]) / 2
        values = self.fine_contact[self.triangles].mean(1)
        self.centers = corners.mean(1)
        self.weights = np.where(values > 0.5, area, 0)
        contour = matplotlib.figure.Figure().subplots().tricontour(
            self.triangulation(), self.fine_contact, levels=[0.5])
        self.outline = contour.allsegs[0]

    def outline_points(self):
        """All points of the outline, and the nodes in contact: there is no outline
        where the shell ends within the zone."""
        return np.concatenate([*self.outline, self.nodes[self.active]])

    def _find_principal_axes(self):
        """Center and principal axes of the zone, the longer one first."""
        total = self.weights.sum()
        if total > 0:
            self.center = self.weights @ self.centers / total
            distance = self.centers - self.center
            moments = (self.weights * distance.T) @ distance / total
        else:
            self.center = self.nodes[self.active].mean(0)
            moments = np.eye(2)
        values, vectors = np.linalg.eigh(moments)
        self.is_round = values[1] - values[0] <= ROUND * values[1]
        self.principal = np.eye(2) if self.is_round else vectors.T[::-1]
        # both to the right, or up
        for axis in self.principal:
            axis *= np.sign(axis[np.argmax(np.abs(axis))])

    def _extents(self, points):
        """The extent of points along the principal axes."""
        return np.ptp(points @ self.principal.T, axis=0)
