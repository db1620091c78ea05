# SPDX-License-Identifier: LGPL-2.1-or-later

# The coefficients of MF 5.2 fitted to forces of a published set give these forces.

from tire_model_test import TRUCK, check, largest_errors, require, sweeps

require("numpy", "scipy")

from biface_tire_model import fit, read_tir

formula = read_tir(TRUCK).formula()
loads = [0.4 * formula.p.FNOMIN * part for part in (0.5, 1, 1.5, 2)]
data = sweeps(formula, loads, (-0.05, 0, 0.05), angles=10, slips=7)
result = fit(data, "5.2", formula.p.UNLOADED_RADIUS)
for channel, error in largest_errors(result.formula, data).items():
    check(error < 0.01, f"the error of {channel} is {100 * error} %")

# also between the states
other = sweeps(formula, [load * 1.2 for load in loads[:3]], (0.03,), angles=11, slips=7)
for channel, error in largest_errors(result.formula, other).items():
    check(error < 0.01, f"the error of {channel} between the states is {100 * error} %")
