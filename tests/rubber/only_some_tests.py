# SPDX-License-Identifier: LGPL-2.1-or-later

# With --only, the other tests do not change the constants, but have their errors shown.

from rubber_test import (TRELOAR, check, entries_of, output_of, require, rubber, scratch)

require("numpy", "scipy")

output = output_of(TRELOAR, "--law", "Yeoh", "--only", "uniaxial")
check(output.count("(not fitted)") == 2, output)
path = scratch() / "uniaxial.csv"
path.write_text("".join(
    line for line in TRELOAR.read_text(encoding="utf-8").splitlines(keepends=True)
    if line.startswith(("test", "uniaxial"))), encoding="utf-8")
alone = output_of(path, "--law", "Yeoh")
check(entries_of(alone) == entries_of(output), "other constants")
check("No points: equibiaxial, planar." in alone, alone)
code, _, errors = rubber(path, "--only", "planar")
check(code == 1 and "--only names 'planar'" in errors, errors)
