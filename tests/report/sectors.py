# SPDX-License-Identifier: LGPL-2.1-or-later

# Copies of a sector with cyclic or symmetric edges fill the turn: each shares an edge
# with the one before, in the same way or reflected.

import sys

from report_test import PACKAGE, check, require

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface_report.sectors import around, copies_of


class Run:
    """Settings of a run."""

    def __init__(self, kind, edge):
        self.entries = {"Surface/Type": kind, "Supports/alpha_2 min": edge,
                        "Supports/alpha_2 max": edge}

    def setting(self, entry, otherwise=None):
        """The value of an entry."""
        return self.entries.get(entry, otherwise)


def sector(low, high):
    """Points of its edges, one at the axle."""
    low, high = np.radians([low, high])
    return np.array([[5 * np.cos(low), 1, 5 * np.sin(low)],
                     [7 * np.cos(high), 2, 7 * np.sin(high)], [0, 3, 0]])


revolution = "surface of revolution"
for edge in ("cyclic", "symmetry"):
    points = sector(170, 200)
    copies = copies_of(Run(revolution, edge), points)
    check(len(copies) == 12, f"{edge}: {len(copies)} copies")
    turned = around(points, copies).reshape(12, 3, 3)
    check(np.allclose(turned[0], points), "the first copy is not the sector")
    angles = np.degrees(np.arctan2(turned[:, :2, 2], turned[:, :2, 0]))
    for k in range(12):
        low, high = 170 + 30 * k, 200 + 30 * k
        if edge == "symmetry" and k % 2:
            low, high = high, low
        off = (angles[k] - [low, high] + 180) % 360 - 180
        check(np.allclose(off, 0), f"copy {k} is off by {off} degrees")
    check(np.allclose(turned[:, :2, 1], [1, 2]), "heights change")
for kind, edge, low, high in ((revolution, "free", 0, 30), ("plane", "cyclic", 0, 30),
                              (revolution, "cyclic", 0, 50),
                              (revolution, "cyclic", 0, 0.002),
                              (revolution, "symmetry", 0, 120)):
    count = len(copies_of(Run(kind, edge), sector(low, high)))
    check(count == 1, f"{edge} edges at {low} and {high}: {count} copies")
