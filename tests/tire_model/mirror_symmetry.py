# SPDX-License-Identifier: LGPL-2.1-or-later

# Without shifts and asymmetric coefficients a tire is its own mirror image, and mirror()
# gives the tire on the other side.

from tire_model_test import CHANNELS, MADE, TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import mirror, read_tir

ASYMMETRIC = ("PHY1", "PHY2", "PVY1", "PVY2", "PEY3", "RBY3", "RVY1", "RVY2", "RHX1",
              "QBZ4", "QDZ3", "QDZ6", "QDZ7", "QEZ4", "QHZ1", "QHZ2", "SSZ1", "QSX1")

load = np.array([[3000.0], [5000]])
state = {"slip_ratio": np.array([-0.1, 0, 0.03, 0.2]),
         "slip_angle": np.array([0.03, -0.1, 0.15, -0.02]),
         "inclination_angle": np.array([0.04, 0.02, -0.05, 0])}
image = mirror(state)
for path in (TRUCK, MADE):
    formula = read_tir(path).formula()

    def forces(state):
        return formula.evaluate(load, *state.values())._asdict()

    for symmetric in (True, False):
        if symmetric:
            formula = formula.with_coefficients(dict.fromkeys(ASYMMETRIC, 0.0))
        here, there = forces(state), mirror(forces(image))
        differences = [np.abs(here[name] - there[name]).max()
                       / max(np.abs(here[name]).max(), 1e-9) for name in CHANNELS]
        check((max(differences) < 1e-12) == symmetric,
              f"{path.name}: {dict(zip(CHANNELS, differences))}")
        formula = read_tir(path).formula()
