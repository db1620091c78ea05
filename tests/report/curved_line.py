# SPDX-License-Identifier: LGPL-2.1-or-later

# Between nodes, lines are smooth: a circle with long, unequal cells is round, and
# straight parts stay straight up to a fold.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface_report.curved import curved_line

angles = np.radians([0, 4, 15, 40, 85, 150, 170, 230, 300])
circle = curved_line(np.stack([np.cos(angles), np.sin(angles)], -1))
error = np.abs(np.linalg.norm(circle, axis=1) - 1).max()
check(error < 2e-4, f"a circle is off by {error}")

fold = curved_line(np.array([[0, 0], [1, 0], [3, 0], [3, 1], [3, 4.0]]))
check(np.allclose(fold.min(1), np.where(fold[:, 1] > 0, np.minimum(fold[:, 1], 3), 0)),
      "a fold is rounded")
