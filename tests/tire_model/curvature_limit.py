# SPDX-License-Identifier: LGPL-2.1-or-later

# Curvature factors above 1, with which curves would fold, count as 1.

from tire_model_test import CHANNELS, MADE, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir

formula = read_tir(MADE).formula()
kappa, alpha = np.meshgrid(np.linspace(-0.4, 0.4, 9), np.linspace(-0.3, 0.3, 9))
for name, others, scale, changed in (
        ("PEX1", ("PEX2", "PEX3", "PEX4"), "LEX", "F_x"),
        ("PEY1", ("PEY2", "PEY3", "PEY4", "PEY5"), "LEY", "F_y"),
        ("QEZ1", ("QEZ2", "QEZ3", "QEZ4", "QEZ5"), None, "M_z"),
        ("REX1", ("REX2",), None, "F_x"), ("REY1", ("REY2",), None, "F_y")):
    forces = {}
    for value in (0.5, 1.0, 1.4, 5.0):
        changes = {**dict.fromkeys(others, 0.0), name: value}
        if scale:
            changes[scale] = 1.0
        forces[value] = formula.with_coefficients(changes).evaluate(3000, kappa, alpha)
    for value in (1.4, 5.0):
        check(all((getattr(forces[value], channel) == getattr(forces[1.0], channel)).all()
                  for channel in CHANNELS), f"{name} = {value} is not as 1")
    change = np.abs(getattr(forces[0.5], changed) - getattr(forces[1.0], changed)).max()
    check(change > 1e-3 * np.abs(getattr(forces[1.0], changed)).max(),
          f"{name} has no effect on {changed}")
