# SPDX-License-Identifier: LGPL-2.1-or-later

# MF 6.1 gives the forces and moments of mfeval's equations, with all coefficients, scales
# and pressures.

from tire_model_test import CHANNELS, DATA, MADE, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir
from biface_tire_model.coefficients import COEFFICIENTS, EXTRA, NEUTRAL
from biface_tire_model.table import read_table
from biface_tire_model.units import System

formula = read_tir(MADE).formula()
for name, coefficient in COEFFICIENTS.items():
    if "6.1" in coefficient.formulas and name not in EXTRA and name != "LFZO":
        check(formula.coefficients.get(name, NEUTRAL[name]) != NEUTRAL[name],
              f"{name} is neutral")
data = read_table(DATA / "made_mf61.csv", System(angle="rad"))
forces = formula.evaluate(**{**data.arguments(), "velocity": 20})
for name in CHANNELS:
    # it adds an epsilon of 1e-6 to denominators
    error = np.abs(getattr(forces, name) - data[name]).max()
    check(error < 1e-7 * np.abs(data[name]).max(), f"the error of {name} is {error}")
