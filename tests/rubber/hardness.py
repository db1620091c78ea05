# SPDX-License-Identifier: LGPL-2.1-or-later

# The shear modulus of a hardness is a third of Young's modulus by Gent's formula, and the
# bulk modulus is the one of Poisson's ratio, or as given.

from rubber_test import check, entries_of, output_of, require

require("numpy", "scipy")

for shore, modulus in ((40, 1.690), (60, 3.605), (80, 9.351)):
    output = output_of("--shore", str(shore), "--nu", "0.49", "--name", "tread")
    found = entries_of(output)
    check("subsection Material tread\n" in output, f"another name: {output}")
    check(found["Type"] == "neo-Hooke", f"another law: {output}")
    check(abs(found["mu"][0] - modulus / 3) < 5e-4, f"mu is {found['mu']}")
    check(abs(found["K"][0] / found["mu"][0] - 2 * 1.49 / 0.06) < 0.05, f"K: {output}")
check(entries_of(output_of("--shore", "60", "--K", "1500"))["K"] == [1500], "K")
