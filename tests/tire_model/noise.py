# SPDX-License-Identifier: LGPL-2.1-or-later

# A fit to noisy forces is much closer to the true ones than the noise, and its residuals
# are those of the noise.

from tire_model_test import CHANNELS, MADE, check, require, sweeps

require("numpy", "scipy")

import numpy as np
from biface_tire_model import Measurements, fit, read_tir

NOISE = 0.01

formula = read_tir(MADE).formula()
true = sweeps(formula, (2000, 4000, 6000), (-0.05, 0, 0.05))
random = np.random.default_rng(7)
columns = dict(true.columns)
for name in CHANNELS:
    columns[name] = true[name] + NOISE * np.abs(true[name]).max() \
        * random.standard_normal(len(true))
result = fit(Measurements(columns), "6.1", formula.p.UNLOADED_RADIUS)
forces = result.formula.evaluate(**true.arguments())
for name in CHANNELS:
    peak = np.abs(true[name]).max()
    error = np.sqrt(np.mean((getattr(forces, name) - true[name]) ** 2)) / peak
    check(error < 0.4 * NOISE, f"the error of {name} is {100 * error} %")
    residual = result.residuals[name].rms / peak
    check(0.9 * NOISE < residual < 1.1 * NOISE,
          f"the residual of {name} is {100 * residual} %")
