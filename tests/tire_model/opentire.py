# SPDX-License-Identifier: LGPL-2.1-or-later

# MF 5.2 gives the forces and moments of OpenTire's PAC2002.

from tire_model_test import CHANNELS, DATA, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir
from biface_tire_model.table import read_table
from biface_tire_model.units import System

formula = read_tir(DATA / "opentire_pac2002.tir").formula()
check(formula.name == "5.2", f"the formula is {formula.name}")
data = read_table(DATA / "opentire_pac2002.csv", System(angle="rad"))
forces = formula.evaluate(**data.arguments())
for name in CHANNELS:
    error = np.abs(getattr(forces, name) - data[name]).max()
    check(error < 1e-12 * np.abs(data[name]).max(), f"the error of {name} is {error}")
