# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth curves through the nodes of a mesh.

Between two nodes, a curve is a cubic whose tangent at each end is that of the circle
through this node and its two neighbors on the line of the mesh, so that circles are
circles, however long the cells are. The tangent is turned from the straight side at
most by as much as the line turns at the other end: a straight side that ends at a bend
or at a fold stays straight.
"""

import numpy as np

# Pieces between two nodes
N_PIECES = 8


def curved_line(points):
    """A curve through points, one per row, with N_PIECES pieces between two."""
    at = np.arange(len(points))
    before, after = at - 1, np.append(at[1:], -1)
    sides = Sides(points, np.stack([at[:-1], at[1:]], -1), before, after)
    pieces = sides.points(N_PIECES)
    return np.concatenate([pieces[:, :-1].reshape(-1, points.shape[1]), points[-1:]])


class Sides:
    """Curved pieces of lines."""

    def __init__(self, points, ends, before, after):
        """From the nodes, the two ends of each side, and for each node the one before
        and after it on its line, -1 for none."""
        self.start, self.end = points[ends[:, 0]], points[ends[:, 1]]
        chord = self.end - self.start
        self.lengths = np.linalg.norm(chord, axis=1, keepdims=True)
        chord = normalized(chord)
        tangents, turns = at_nodes(points, before, after)
        is_inner = (before >= 0) & (after >= 0)
        self.tangents, self.angles = [], []
        for i in (0, 1):
            at, other = ends[:, i], ends[:, 1 - i]
            # at the end of a line, the tangent of the same circle as at the other end
            mirrored = (2 * (tangents[other] * chord).sum(1, keepdims=True) * chord
                        - tangents[other])
            tangent = np.where(is_inner[at, None], tangents[at],
                               np.where(is_inner[other, None], mirrored, chord))
            limit = np.where(is_inner[other], turns[other], np.pi)
            limit = np.where(is_inner[at], limit, turns[other])
            tangent, angle = turned_at_most(tangent, chord, limit)
            self.tangents.append(tangent)
            self.angles.append(angle)

    def points(self, count):
        """Points of each side, of the shape sides x (count + 1) x dimensions."""
        s = np.linspace(0, 1, count + 1)
        # the length of the tangent with which the cubic is closest to an arc
        first, last = (2 * self.lengths * tangent / (1 + np.cos(angle))[:, None]
                       for tangent, angle in zip(self.tangents, self.angles))
        weights = (1 - 3 * s**2 + 2 * s**3, s * (1 - s)**2,
                   3 * s**2 - 2 * s**3, s**2 * (s - 1))
        return sum(weight[None, :, None] * vectors[:, None] for weight, vectors in
                   zip(weights, (self.start, first, self.end, last)))


def normalized(vectors):
    """Unit vectors; 0 for 0."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0, lengths, 1)


def at_nodes(points, before, after):
    """The tangent at each node of the circle through it and its neighbors, and the
    angle by which the line turns there."""
    forward, backward = points[after] - points, points - points[before]
    squares = [(part**2).sum(1, keepdims=True) for part in (forward, backward)]
    tangents = normalized(sum(part / np.where(square > 0, square, 1)
                              for part, square in zip((forward, backward), squares)))
    cosine = (normalized(forward) * normalized(backward)).sum(1)
    return tangents, np.arccos(np.clip(cosine, -1, 1))


def turned_at_most(tangents, chords, limits):
    """Tangents turned toward the chords until the angle between both is at most a
    limit, and this angle; at most a right angle."""
    cosine = (tangents * chords).sum(1)
    angles = np.arccos(np.clip(cosine, -1, 1))
    across = normalized(tangents - cosine[:, None] * chords)
    angles = np.minimum(np.minimum(angles, limits), np.pi / 2)
    return (np.cos(angles)[:, None] * chords + np.sin(angles)[:, None] * across,
            angles)
