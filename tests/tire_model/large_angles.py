# SPDX-License-Identifier: LGPL-2.1-or-later

# By default slip and inclination angles enter as they are, and on request as tan(alpha) and
# sin(gamma) of the book.

from tire_model_test import MADE, TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir

alpha, gamma = np.array([-0.6, -0.2, 0.3, 1.0]), 0.1
for path in (TRUCK, MADE):
    file = read_tir(path)
    plain, starred = file.formula(), file.formula(starred=True)
    value = starred.lateral(5000, alpha, gamma).value
    expected = plain.lateral(5000, np.tan(alpha), np.sin(gamma)).value
    check(np.allclose(value, expected, rtol=1e-13), f"{value} is not {expected}")
    change = np.abs(plain.lateral(5000, alpha, gamma).value - value).max()
    check(change > 10, f"F_y only changes by {change}")
    for gamma in (0, 0.1):
        small = np.array(starred.evaluate(5000, 0, 1e-4, gamma * 1e-3))
        check(np.allclose(small, np.array(plain.evaluate(5000, 0, 1e-4, gamma * 1e-3)),
                          rtol=1e-5), "they differ at small angles")
