# SPDX-License-Identifier: LGPL-2.1-or-later

# Without a load there are no forces and no moments.

from tire_model_test import MADE, TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir

for path in (TRUCK, MADE):
    formula = read_tir(path).formula()
    forces = np.array(formula.evaluate(0, [-0.1, 0, 0.2], [0.1, 0, -0.2], 0.03))
    check((forces == 0).all(), f"{path.name}: {forces}")
    # and they go there
    small = np.array(formula.evaluate(1e-3, [-0.1, 0, 0.2], [0.1, 0, -0.2], 0.03))
    check(np.abs(small).max() < 0.1, f"{path.name}: {small}")
