# SPDX-License-Identifier: LGPL-2.1-or-later

# Length, width and direction of an oblique elliptical zone are those of the ellipse.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface_report.footprint import Footprint

LENGTH, WIDTH, ANGLE, CELL = 9.0, 4.0, np.radians(25), 0.25

# a grid in the plane x = 7: the ellipse's long axis is turned from y toward z
y, z = (grid.ravel() for grid in np.meshgrid(*2 * [np.arange(-6, 6, CELL)]))
along = y * np.cos(ANGLE) + z * np.sin(ANGLE)
across = z * np.cos(ANGLE) - y * np.sin(ANGLE)
level = (2 * along / LENGTH)**2 + (2 * across / WIDTH)**2
active = (level < 1).astype(float)
contact = Table({"alpha_1": y, "alpha_2": z, "x": np.full_like(y, 7), "y": y,
                 "z": z, "clearance": 1 - active, "pressure": 3 * active,
                 "active": active})
footprint = Footprint(contact, np.array([1.0, 0, 0]), False)

check(footprint.axis_names == ["y", "z"], f"axes: {footprint.axis_names}")
found = np.degrees(np.arctan2(*footprint.principal[0][::-1]))
check(abs(found - 25) < 1, f"the direction is {found} degrees")
for i, exact in enumerate((LENGTH, WIDTH)):
    check(abs(footprint.lengths[i] - exact) < CELL,
          f"length {i} is {footprint.lengths[i]}, not {exact}")
    check(footprint.minimum_lengths[i] <= exact <= footprint.maximum_lengths[i],
          f"length {i} is not between its bounds")
