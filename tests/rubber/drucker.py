# SPDX-License-Identifier: LGPL-2.1-or-later

# The check of stability finds the stretch in equibiaxial tension beyond which a law of
# Mooney-Rivlin with a negative c01 violates Drucker's condition.

# Equibiaxial stretches l have a + 2 b as the lowest eigenvalue of the moduli, with
# a = 4 (c10 l^2 + c01 / l^2) and b = 4 (c10 / l^4 + c01 l^4).

from rubber_test import check, require

require("numpy", "scipy")

from biface_rubber.laws import LINEAR, Law
from biface_rubber.stability import instabilities

for onset in (1.2, 2, 5):
    c_01 = -(onset ** 2 + 2 / onset ** 4) / (1 / onset ** 2 + 2 * onset ** 4)
    law = Law("Mooney-Rivlin", LINEAR["Mooney-Rivlin"].values(), (1, c_01))
    (low, high), = instabilities(law, 8)["equibiaxial"]
    check(abs(low - onset) < 1e-9 and high is None, f"from {low} to {high}, not {onset}")
    check("equibiaxial" not in instabilities(law, 0.99 * onset), "unstable before")

stable = Law("Mooney-Rivlin", LINEAR["Mooney-Rivlin"].values(), (1, 0.1))
check(instabilities(stable, 100) == {}, "positive constants are unstable")
