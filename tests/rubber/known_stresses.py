# SPDX-License-Identifier: LGPL-2.1-or-later

# The stresses of the laws are the formulas of textbooks, and their shear moduli are those
# of biface.

from rubber_test import check, require

require("numpy", "scipy")

import numpy as np
from biface_rubber.laws import LINEAR, Law, ogden_terms

l = np.array([0.4, 0.9, 1, 1.3, 3, 7])


def linear(name, *constants):
    return Law(name, LINEAR[name].values(), constants)


def i_1(s):
    return s ** 2 + 2 / s - 3


CASES = [
    (linear("neo-Hooke", 0.4), 0.4,
     {"uniaxial": 0.4 * (l - l ** -2.), "equibiaxial": 0.4 * (l - l ** -5.),
      "planar": 0.4 * (l - l ** -3.)}),
    (linear("Mooney-Rivlin", 0.2, 0.03), 0.46,
     {"uniaxial": 2 * (0.2 + 0.03 / l) * (l - l ** -2.),
      "equibiaxial": 2 * (0.2 + 0.03 * l ** 2) * (l - l ** -5.),
      "planar": 2 * (0.2 + 0.03) * (l - l ** -3.)}),
    (linear("Yeoh", 0.2, -0.01, 1e-4), 0.4,
     {"uniaxial": 2 * (l - l ** -2.) * (0.2 - 0.02 * i_1(l) + 3e-4 * i_1(l) ** 2)}),
    (Law("Ogden", ogden_terms((3, -2)), (0.1, -0.05)), 0.2,
     {"uniaxial": 0.1 * (l ** 2 - l ** -2.5) - 0.05 * (l ** -3. - 1),
      "equibiaxial": 0.1 * (l ** 2 - l ** -7.) - 0.05 * (l ** -3. - l ** 3)}),
]
for law, shear_modulus, stresses in CASES:
    check(abs(law.shear_modulus() - shear_modulus) < 1e-14 * shear_modulus,
          f"{law.name}: the shear modulus is {law.shear_modulus()}")
    for test, expected in stresses.items():
        error = np.abs(law.stress(test, l) - expected).max()
        check(error < 1e-13 * np.abs(expected).max(), f"{law.name}, {test}: {error}")
