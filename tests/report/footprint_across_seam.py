# SPDX-License-Identifier: LGPL-2.1-or-later

# A contact zone across the seam of a closed surface is one zone.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface_report.footprint import Footprint

# a ring of radius 1, seen from -x, where its angle goes from 180 to -180; with
# and without the seam the same nodes are in contact
angle, y = (grid.ravel() for grid in np.meshgrid(
    np.radians(np.arange(-180, 180, 10)), np.arange(-3, 4) / 10))
active = ((-np.cos(angle) > 0.9) & (np.abs(y) < 0.25)).astype(float)
near = -np.cos(angle) > 0.8
columns = {"alpha_1": y, "alpha_2": np.degrees(angle), "x": -np.ones_like(y),
           "y": y, "z": np.sin(angle), "clearance": 1 - active,
           "pressure": active, "active": active}
at_seam = Table({name: values[near] for name, values in columns.items()})
columns["alpha_2"] = columns["alpha_2"] % 360
away = Table({name: values[near] for name, values in columns.items()})

normal = np.array([-1.0, 0, 0])
seam = Footprint(at_seam, normal, True)
plain = Footprint(away, normal, False)
check(np.allclose(seam.lengths, plain.lengths),
      f"lengths {seam.lengths}, without the seam {plain.lengths}")
check(len(seam.outline) == 1, f"{len(seam.outline)} outlines")
