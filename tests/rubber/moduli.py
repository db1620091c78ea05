# SPDX-License-Identifier: LGPL-2.1-or-later

# The moduli of the check of stability are the derivatives of the stresses: in equibiaxial
# tension of the Kirchhoff stress, stretch times nominal stress, by the logarithmic strain.

from rubber_test import OGDEN, check, require

require("numpy", "scipy")

import numpy as np
from biface_rubber.laws import LINEAR, Law, ogden_terms

l, step = np.array([1, 1.1, 2, 4]), 1e-5
for law in (Law("Mooney-Rivlin", LINEAR["Mooney-Rivlin"].values(), (0.2, -0.01)),
            Law("Yeoh", LINEAR["Yeoh"].values(), (0.2, -0.01, 1e-3)),
            Law("Ogden", ogden_terms(OGDEN["alpha_i"]), OGDEN["mu_i"])):
    up, down = l * np.exp(step), l * np.exp(-step)
    slopes = (up * law.stress("equibiaxial", up)
              - down * law.stress("equibiaxial", down)) / (2 * step)
    moduli = law.moduli("equibiaxial", l)
    error = np.abs(moduli[:, 0].sum(axis=1) - slopes) / np.abs(slopes).max()
    check(error.max() < 1e-8, f"{law.name}: {error}")
    check(np.array_equal(moduli[:, 0, 1], moduli[:, 1, 0]), "the moduli are not symmetric")
