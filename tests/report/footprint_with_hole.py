# SPDX-License-Identifier: LGPL-2.1-or-later

# A zone with a hole has two edges; its area, center and axes are those of what lies
# between them, also where the zone ends at the edge of the shell.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface_report.footprint import Footprint, moments_within

OUTER, INNER, CELL = 5.0, 2.0, 0.25


def footprint(is_active, limit):
    """That of a plane shell whose nodes are in contact where a function says so."""
    y, z = (grid.ravel() for grid in np.meshgrid(
        np.arange(-limit, limit + CELL / 2, CELL),
        np.arange(-6, 6 + CELL / 2, CELL)))
    active = is_active(y, z).astype(float)
    return Footprint(Table({
        "alpha_1": y, "alpha_2": z, "x": np.full_like(y, 7), "y": y, "z": z,
        "clearance": 1 - active, "pressure": active, "active": active}),
        np.array([1.0, 0, 0]), False)


def ring(y, z):
    """Between two circles."""
    return (y**2 + z**2 < OUTER**2) & (y**2 + z**2 > INNER**2)


found = footprint(ring, 6)
check(len(found.outline) == 2, f"{len(found.outline)} edges")
area, center, _ = moments_within(found.outline)
exact = np.pi * (OUTER**2 - INNER**2)
check(abs(area / exact - 1) < 0.05, f"the area is {area}, not {exact}")
check(np.abs(center).max() < 1e-9, f"the center is {center}")
check(found.is_round, "the ring has axes")

# a strip across the whole shell, 4 wide, and as long as the nodes
found = footprint(lambda y, z: np.abs(z) < 2, 3)
check(len(found.outline) == 1, f"{len(found.outline)} edges of the strip")
area, center, _ = moments_within(found.outline)
check(abs(area - 6 * 4) < 6 * 2 * CELL, f"the area of the strip is {area}")
check(np.allclose(np.abs(found.principal), np.eye(2)), f"{found.principal}")
