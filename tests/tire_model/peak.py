# SPDX-License-Identifier: LGPL-2.1-or-later

# D is the largest force of pure slip less the vertical shift.

from tire_model_test import MADE, TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir

slips = np.linspace(0, 1.4, 40001)
for path in (TRUCK, MADE):
    formula = read_tir(path).formula()
    for gamma in (0, -0.04):
        for load in (0.3, 1, 1.6):
            load *= formula.p.FNOMIN * formula.p.LFZO
            for curve in (formula.longitudinal, formula.lateral):
                values = curve(load, slips, gamma)
                largest = np.abs(values.value - values.S_V).max()
                check(abs(largest / values.D.max() - 1) < 1e-5,
                      f"the largest force is {largest}, but D is {values.D.max()}")
