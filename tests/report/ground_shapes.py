# SPDX-License-Identifier: LGPL-2.1-or-later

# Patches and section lines of a ground lie on it, and clearances tell how far
# it has traveled.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface_report.ground import Ground
from biface_report.section import SectionPlane

DIRECTION, POINT, TRAVEL = np.array([2.0, 0.3, -1]), np.array([4.0, -7, 2]), 3.5
UNIT = DIRECTION / np.linalg.norm(DIRECTION)


def center(ground, normal):
    """Of a drum or a sphere that has traveled."""
    return POINT - TRAVEL * UNIT + ground.radius * normal


def exact_clearance(ground, points):
    """From the definition of the shape."""
    if ground.shape == "plane":
        return (POINT - points) @ UNIT - TRAVEL
    if ground.shape == "sphere":
        distance = np.linalg.norm(points - center(ground, UNIT), axis=-1)
    else:
        # the distance from a line
        axis = ground.axis
        normal = UNIT - (UNIT @ axis) * axis
        normal /= np.linalg.norm(normal)
        distance = np.linalg.norm(
            np.cross(points - center(ground, normal), axis), axis=-1)
    return np.sign(ground.radius) * distance - ground.radius


# a section in the plane y = -7, in which the traveling point starts
u, v = (grid.ravel() for grid in np.meshgrid(*2 * [np.linspace(-20, 20, 21)]))
flat = Table({f"{face}_{axis}": values
              for face, shift in (("outer", 1.0), ("inner", 0.0))
              for axis, values in zip("xyz", (u + shift, np.full_like(u, -7), v))})
plane = SectionPlane([flat], UNIT)

rng = np.random.default_rng(1)
for shape, radius in (("plane", 1), ("drum", 60), ("drum", -60), ("sphere", 45),
                      ("sphere", -45)):
    name = f"the {shape} of radius {radius}"
    start, moved = (Ground(shape, DIRECTION, POINT, radius, [0.2, 1, 0.1], travel)
                    for travel in (0, TRAVEL))
    # points on the side of the shell
    points = POINT - TRAVEL * UNIT - 2 * UNIT + rng.uniform(-5, 5, (20, 3))
    found = start.at_clearances(points, exact_clearance(moved, points))
    check(abs(found.travel - TRAVEL) < 1e-9, f"{name} traveled {found.travel}")
    check(np.allclose(found.clearance(points), exact_clearance(found, points),
                      atol=1e-9), f"clearances of {name}")

    patch = found.patch([-20, -15], [30, 25]).reshape(-1, 3)
    error = np.abs(exact_clearance(found, patch)).max()
    check(error < 1e-9, f"the patch of {name} is off by {error}")

    lines = plane.trace(found, [-200, -200], [200, 200])
    check(lines, f"{name} has no trace")
    for x, y in np.concatenate(lines):
        at = x * plane.right + y * plane.up + [0, -7, 0]
        error = abs(exact_clearance(found, at[None])[0])
        # linear between the points of a grid
        check(error < 5e-3, f"the trace of {name} is off by {error}")
