# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge of the contact zone: the line of zero clearance between the nodes, as the
program measures it for footprint_length and footprint_width of history.csv (theory.md,
section 6).

On each line of the mesh, a node in contact covers the line up to halfway to its
neighbors. The edge lies in the part of the last node in contact, at a fraction of it
that follows from the pressures of this node and the one before, and from the clearances
of the next two.
"""

from collections import defaultdict

import numpy as np

from biface import read_vtu
from biface.vtu import corners

from .view_data import CLOSE, join

# The precision of files for ParaView, relative to the shell
NEAR = 1e-6
# The sides of a cell along each coordinate
SIDES = (([0, 1], [3, 2]), ([0, 3], [1, 2]))


class Zone:
    """Nodes and cells of a face, of which some nodes are in contact."""

    def __init__(self, points, cells, clearance, pressure, active, is_whole=True):
        """From the nodes, one per row, the four nodes of each cell in the order around
        it, and the clearance, pressure and state of each node. Unless the face
        is_whole, there are only the cells with a node in contact, and the clearances
        beyond them are taken to be those of a string under a constant load."""
        self.points, self.cells, self.is_whole = points, cells, is_whole
        self.clearance = np.maximum(clearance, 0)
        self.pressure, self.active = pressure, active
        self.neighbors = neighbors(cells, len(points))

    def outline(self):
        """The edge as closed lines, each an array of points; also along the edge of
        the shell where the zone reaches it."""
        ends = np.array([self._parts(*both) for both in self.neighbors])
        place = {}
        for i, both in enumerate(self.neighbors):
            # on a line of the mesh at the middle of the part across it
            shift = ends[1 - i].mean(0) - self.points
            for side, ahead in enumerate(both):
                nodes = np.flatnonzero(self.active & (ahead >= 0))
                nodes = nodes[~self.active[ahead[nodes]]]
                place.update(zip(zip(nodes, ahead[nodes]),
                                 ends[i, side, nodes] + shift[nodes]))
        links = defaultdict(list)
        for first, second in self._segments():
            links[first].append(second)
            links[second].append(first)
        # an item is a node on the edge of the shell, or a pair of nodes with the edge
        # of the zone between them
        return [np.array([place.get(item, self.points[item[0]]) for item in loop])
                for loop in loops(links)]

    def _parts(self, before, after):
        """The two ends of the part of a line that each node in contact covers."""
        ends = np.array([self._ends(after, before), self._ends(before, after)])
        # they must not pass each other
        way = (np.where(after >= 0, self.points.T[:, after], self.points.T)
               - np.where(before >= 0, self.points.T[:, before], self.points.T)).T
        passed = ((ends[1] - ends[0]) * way).sum(1) < 0
        ends[:, passed] = ends[:, passed].mean(0)
        return ends

    def _ends(self, back, ahead):
        """The ends on the sides to the nodes ahead; elsewhere the nodes."""
        result = self.points.copy()
        has_next = self.active & (ahead >= 0)
        result[has_next] = (self.points[has_next] + self.points[ahead[has_next]]) / 2
        nodes = np.flatnonzero(has_next)
        nodes = nodes[~self.active[ahead[nodes]]]
        at, following = self.points[nodes], ahead[nodes]
        beyond, previous = ahead[following], back[nodes]
        has_beyond, has_previous = beyond >= 0, previous >= 0
        step = self.points[following] - at
        end = at + step / 2
        h_1 = np.linalg.norm(step, axis=1)
        h_2 = np.where(has_beyond, np.linalg.norm(
            self.points[beyond] - self.points[following], axis=1), h_1)
        h_0 = np.where(has_previous, np.linalg.norm(
            at - self.points[previous], axis=1), h_1)
        ratio = 1 + h_2 * (h_0 + 2 * h_1 + h_2) / (h_1 * (h_0 + h_1))

        carries = has_previous & (self.pressure[previous] > 0)
        p = np.where(carries, self.pressure[nodes]
                     / np.where(carries, self.pressure[previous], 1),
                     ratio * h_0 * h_1 / (h_1 + h_2)**2)
        near, far = self.clearance[following], self.clearance[beyond]
        free = 1 - np.clip(p, 0, 1)
        g = ratio * (near / np.maximum(np.maximum(near, far), 1e-300)
                     if self.is_whole else free / (1 + 2 * free))
        fraction = np.where(p + g > 0, p / np.where(p + g > 0, p + g, 1), 0.5)
        start = np.where(has_previous[:, None], (at + self.points[previous]) / 2, at)
        # no clearances beyond, or a single node between nodes in contact
        is_between = self.active[beyond] if self.is_whole else False
        fraction = np.where(has_beyond & is_between
                            | ~has_beyond & self.is_whole, 1, fraction)
        result[nodes] = start + fraction[:, None] * (end - start)
        return result

    def _segments(self):
        """Pieces of the edge: pairs of items, see outline()."""
        border = defaultdict(int)
        for cell in self.cells[self.active[self.cells].any(1)]:
            sides = list(zip(cell, np.roll(cell, -1)))
            for a, b in sides:
                border[min(a, b), max(a, b)] += 1
            crossed = [(a, b) if self.active[a] else (b, a) for a, b in sides
                       if self.active[a] != self.active[b]]
            if len(crossed) == 2:
                yield tuple(crossed)
            elif len(crossed) == 4:
                # two nodes in opposite corners: an edge around each
                for node in {a for a, _ in crossed}:
                    yield tuple(item for item in crossed if item[0] == node)
        for (a, b), count in border.items():
            if count == 1 and (self.active[a] or self.active[b]):
                items = ([(a,), (b,)] if self.active[a] and self.active[b] else
                         [(a,), (a, b)] if self.active[a] else [(b,), (b, a)])
                yield tuple(items)


def neighbors(cells, count):
    """For each coordinate the nodes before and after each of a count of nodes on its
    line of the mesh, -1 for none; from the nodes of each cell in the order around it,
    which starts along the same coordinate in all cells."""
    result = np.full((2, 2, count), -1)
    for (before, after), sides in zip(result, SIDES):
        for first, last in sides:
            after[cells[:, first]] = cells[:, last]
            before[cells[:, last]] = cells[:, first]
    return result


def joined(points, cells):
    """The cells of a file in which each has points of its own, with each point once:
    the numbers of the points that are kept, and the cells by places among these."""
    used, which = np.unique(cells, return_inverse=True)
    size = np.ptp(points[used], axis=0).max()
    first, same = join(points[used], CLOSE * size)
    return used[first], same[which].reshape(cells.shape)


def loops(links):
    """Closed lines through items that are linked in pairs; an item is in one only."""
    result, left = [], set(links)
    while left:
        item = next(iter(left))
        loop = []
        while item is not None:
            left.discard(item)
            loop.append(item)
            item = next((other for other in links[item] if other in left), None)
        result.append(loop + loop[:1])
    return result


def zone_of_shell(run, ground, contact):
    """The zone from shell-NNNN.vtu, or None if this file is missing or does not have
    the nodes in contact of contact-NNNN.csv."""
    path = run.path("shell", ending="vtu")
    if (ground is None or not path.exists()
            or run.setting("Output/Write VTU") == "false"):
        return None
    data = read_vtu(path)
    cells = corners(data)
    cells = cells[data["outer_face"][cells[:, 0]] > 0.5]
    kept, cells = joined(data["Points"], cells)
    points = data["Points"][kept].astype(float)
    clearance = ground.clearance(points)
    # the others touch bodies, or are around points in contact
    largest = (contact["clearance"][contact["active"] > 0].max()
               + NEAR * np.ptp(points, axis=0).max())
    active = (data["active"][kept] > 0.5) & (clearance <= largest)
    if active.sum() != (contact["active"] > 0).sum():
        return None
    return Zone(points, cells, clearance, data["contact_pressure"][kept], active)
