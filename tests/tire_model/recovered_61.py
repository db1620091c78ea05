# SPDX-License-Identifier: LGPL-2.1-or-later

# The coefficients of MF 6.1, with pressures, fitted to forces of a set with all of them
# give these forces.

from tire_model_test import MADE, check, largest_errors, require, sweeps

require("numpy", "scipy")

from biface_tire_model import fit, read_tir

formula = read_tir(MADE).formula()
data = sweeps(formula, (1500, 3000, 4500, 6500), (-0.06, 0, 0.06), (1.8e5, 2.2e5, 2.6e5),
              angles=10, slips=7)
result = fit(data, "6.1", formula.p.UNLOADED_RADIUS)
for channel, error in largest_errors(result.formula, data).items():
    check(error < 0.01, f"the error of {channel} is {100 * error} %")
other = sweeps(formula, (2200, 5500), (0.03,), (2e5, 2.4e5), angles=11, slips=8)
for channel, error in largest_errors(result.formula, other).items():
    check(error < 0.01, f"the error of {channel} between the states is {100 * error} %")
