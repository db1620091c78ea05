# SPDX-License-Identifier: LGPL-2.1-or-later

# The page of a study has the outputs of its samples in the units of its base file, also of variables with dollars in their names.

from python_test import COARSE, TIRE, biface, check, require, scratch
from report_test import page_of

require("matplotlib")
output = scratch()
study = biface.sweep(TIRE, {r"$\alpa$: Stage 1/Pressure, Stage 2/Pressure": [0.1, 0.2]},
                     ["force"], COARSE, output)
page = page_of(output)
check("2 samples" in page.text, "the samples are not counted")
numbers = [number for row in page.rows for number in row[1]]
for force in study["force"]:
    check(any(abs(number - force) < 1e-6 * force for number in numbers),
          f"the force {force} is missing")
