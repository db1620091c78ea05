# SPDX-License-Identifier: LGPL-2.1-or-later
"""The copies of a sector of a surface of revolution that fill the full turn."""

import numpy as np

# What is closer to the axle than this share of the radius has no angle
AT_AXLE = 1e-3
# Sectors thinner than a part of the turn are slices of long shells, not wheels
MAXIMUM_COPIES = 360


def copies_of(run, points):
    """How x and z of the sector turn into those of each copy: matrices as rows of
    four numbers; only the sector itself unless both of its edges repeat.

    points: those of the undeformed shell."""
    edge = run.setting("Supports/alpha_2 min")
    if (run.setting("Surface/Type") != "surface of revolution"
            or edge not in ("cyclic", "symmetry")
            or edge != run.setting("Supports/alpha_2 max")):
        return [[1, 0, 0, 1]]
    flat = points[:, 0] + 1j * points[:, 2]
    flat = flat[np.abs(flat) > AT_AXLE * np.abs(flat).max()]
    middle = flat.sum()
    angles = np.angle(flat / middle)
    width = np.ptp(angles)
    count = round(2 * np.pi / width)
    step = 2 * np.pi / count
    if (count > MAXIMUM_COPIES or abs(width - step) > 1e-3 * step
            or (edge == "symmetry" and count % 2)):
        return [[1, 0, 0, 1]]
    # about the middle of the sector, every other one is reflected by symmetry
    center = np.angle(middle) + (angles.min() + angles.max()) / 2
    return [matrix(k * step, center if edge == "symmetry" and k % 2 else None)
            for k in range(count)]


def around(points, copies):
    """The points of all copies."""
    turned = np.reshape(copies, (-1, 2, 2))
    flat = np.einsum("kij,pj->kpi", turned, points[:, [0, 2]]).reshape(-1, 2)
    heights = np.tile(points[:, 1], len(copies))
    return np.stack([flat[:, 0], heights, flat[:, 1]], -1)


def matrix(angle, center):
    """A turn, of what is reflected about the direction of the center, if any."""
    if center is None:
        return [np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)]
    both = angle + 2 * center
    return [np.cos(both), np.sin(both), np.sin(both), -np.cos(both)]
