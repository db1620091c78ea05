# SPDX-License-Identifier: LGPL-2.1-or-later

# B C D is the slope of F_x and of F_y at zero slip, and the stiffnesses are those of their
# formulas.

from tire_model_test import MADE, TRUCK, check, neutral_formula, require

require("numpy", "scipy")

import math

import numpy as np
from biface_tire_model import MF52, MF61, read_tir

loads, h = np.array([1500.0, 4000, 7000]), 1e-6
for path in (TRUCK, MADE):
    formula = read_tir(path).formula()
    for curve, slip in ((formula.longitudinal, "kappa"), (formula.lateral, "alpha")):
        for gamma in (0, 0.05):
            at = curve(loads, gamma=gamma)
            check(np.allclose(at.B * at.C * at.D, at.slope, rtol=1e-12), "B C D")
            # where the curve is steepest, the shift is undone
            slope = (curve(loads, -at.S_H + h, gamma).value
                     - curve(loads, -at.S_H - h, gamma).value) / (2 * h)
            check(np.allclose(slope, at.slope, rtol=1e-5),
                  f"{path.name}: the slope over {slip} is {slope}, not {at.slope}")

for kind in (MF52, MF61):
    formula = neutral_formula(kind, PKX1=22.0, PKX2=3.0, PKX3=-0.2, PKY1=-18.0, PKY2=1.6)
    df = (loads - 4000) / 4000
    expected = loads * (22 + 3 * df) * np.exp(-0.2 * df)
    check(np.allclose(formula.longitudinal(loads).slope, expected, rtol=1e-14),
          "the slip stiffness is another")
    expected = [-18 * 4000 * math.sin(2 * math.atan(load / 6400)) for load in loads]
    check(np.allclose(formula.lateral(loads).slope, expected, rtol=1e-14),
          "the cornering stiffness is another")
