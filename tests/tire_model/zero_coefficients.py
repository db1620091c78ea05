# SPDX-License-Identifier: LGPL-2.1-or-later

# Any coefficient may be zero, also without a load: forces and moments are finite, without
# warnings of NumPy.

from tire_model_test import MADE, TRUCK, check, require

require("numpy", "scipy")

import warnings

import numpy as np
from biface.errors import BifaceError
from biface_tire_model import read_tir
from biface_tire_model.coefficients import COEFFICIENTS

warnings.simplefilter("error")
load = np.array([[0.0], [1000], [9000]])
for path in (MADE, TRUCK):
    formula = read_tir(path).formula()
    for name in COEFFICIENTS:
        if name == "LFZO":
            continue
        forces = formula.with_coefficients({name: 0.0}).evaluate(
            load, [-0.1, 0, 0.1], [0, 0.05, 0.1], [0.02, 0, -0.03], velocity=10)
        check(np.isfinite(np.array(forces)).all(), f"{path.name}, {name}: {forces}")
    # zero is the limit of small numbers
    zero, small = (formula.with_coefficients({"PKY2": value}).lateral(4000).slope
                   for value in (0.0, 1e-12))
    check(abs(zero - small) < 1e-6 * formula.p.FNOMIN, f"the slopes are {zero} and {small}")
    for change, sentence in (({"LFZO": 0.0}, "LFZO is 0, but must be positive."),
                             ({"LONGVL": 0.0}, "LONGVL is 0, but must be positive where a "
                                               "velocity is given.")):
        try:
            formula.with_coefficients(change).evaluate(4000, velocity=10)
            check(False, f"{change} is accepted")
        except BifaceError as error:
            check(str(error) == sentence, str(error))
