# SPDX-License-Identifier: LGPL-2.1-or-later

# Where the other slip is zero, combined slip gives the forces and the aligning moment of
# pure slip.

from tire_model_test import MADE, TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir

slips = np.linspace(-0.3, 0.3, 61)
for path in (TRUCK, MADE):
    # the arm of F_x is no part of pure slip
    formula = read_tir(path).formula().with_coefficients(
        dict.fromkeys(("SSZ1", "SSZ2", "SSZ3", "SSZ4"), 0))
    load = formula.p.FNOMIN * formula.p.LFZO
    for gamma in (0, 0.06):
        braking = formula.evaluate(load, kappa=slips, gamma=gamma).F_x
        cornering = formula.evaluate(load, alpha=slips, gamma=gamma)
        pure = formula.longitudinal(load, slips, gamma).value
        check(np.abs(braking - pure).max() < 1e-12 * load, "F_x differs")
        pure = formula.lateral(load, slips, gamma).value
        check(np.abs(cornering.F_y - pure).max() < 1e-12 * load, "F_y differs")
        # MF 6.1 takes F_y without camber, at the same place
        if gamma == 0 or formula.name == "5.2":
            curve = formula.aligning_moment(load, slips, gamma)
            check(np.abs(cornering.M_z - curve).max() < 1e-13 * load, "M_z differs")
