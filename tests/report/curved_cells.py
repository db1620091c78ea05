# SPDX-License-Identifier: LGPL-2.1-or-later

# Between nodes, lines and cells are smooth: a circle and a torus with long, unequal
# cells are round, and straight parts stay straight up to a fold.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface_report.curved import CurvedCells, curved_line

angles = np.radians([0, 4, 15, 40, 85, 150, 170, 230, 300])
circle = curved_line(np.stack([np.cos(angles), np.sin(angles)], -1))
error = np.abs(np.linalg.norm(circle, axis=1) - 1).max()
check(error < 2e-4, f"a circle is off by {error}")

fold = curved_line(np.array([[0, 0], [1, 0], [3, 0], [3, 1], [3, 4.0]]))
check(np.allclose(fold.min(1), np.where(fold[:, 1] > 0, np.minimum(fold[:, 1], 3), 0)),
      "a fold is rounded")

# half of a torus, with the radius 3 of its middle line and 1 of its section
phi, psi = np.meshgrid(np.radians([0, 20, 60, 110, 180]),
                       np.radians([0, 30, 75, 120, 180]), indexing="ij")
radius = 3 + np.cos(psi)
points = np.stack([radius * np.cos(phi), np.sin(psi), radius * np.sin(phi)],
                  -1).reshape(-1, 3)
number = np.arange(25).reshape(5, 5)
cells = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:],
                  number[:-1, 1:]], -1).reshape(-1, 4)
curved = CurvedCells(points, cells)
fine = curved.points().reshape(-1, 3)
across = np.hypot(np.hypot(fine[:, 0], fine[:, 2]) - 3, fine[:, 1])
straight = np.hypot(np.hypot(*points[cells].mean(1)[:, [0, 2]].T) - 3,
                    points[cells].mean(1)[:, 1])
check(np.abs(across - 1).max() < 0.03 < np.abs(straight - 1).max(),
      f"the torus is off by {np.abs(across - 1).max()}")
check(np.allclose(fine[0], points[cells[0, 0]])
      and np.allclose(fine[-1], points[cells[-1, 2]]), "the corners moved")
values = curved.values(points[:, 1])
check(np.allclose(values[:, 0, 0], points[cells[:, 0], 1])
      and np.allclose(values[:, -1, -1], points[cells[:, 2], 1]), "other values")
check(len(curved.lines()) == 2 * 20, f"{len(curved.lines())} sides")
