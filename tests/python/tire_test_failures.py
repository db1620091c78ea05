# SPDX-License-Identifier: LGPL-2.1-or-later

# Points of a tire test that do not converge are rows that say so, as are those that
# start from them; the others are computed, and the same after a restart.

import numpy as np

from tire_test import COARSE, TIRE_TEST, biface, check, run, scratch

from biface.program import execute
from biface.running import overrides

# the second load tears the tire apart
SETTINGS = {"Tire test/Loads": "1000, 1e6", "Tire test/Slip angles": 1,
            "Tire test/Inclination angles": "0, 2", "Step control/Maximum cuts": 0,
            "Newton/Maximum iterations": 12}

results = run(SETTINGS)
table = results.tire_test()
failed = table["status"] != "ok"
check(len(table) == 8, f"there are {len(table)} points")
check(list(failed) == [False, False, True, True] * 2, f"failed: {failed}")
check("did not converge" in table["status"][2], table["status"][2])
check(table["status"][3] == "the stage from which it starts failed: tire test: point 3",
      table["status"][3])
check(list(table["load"][2:4]) == [1e6] * 2 and
      list(table["slip_angle"][2:4]) == [0, 1], "the values of failed points")
check(np.isnan(table["F_y"][failed]).all(), "a failed point has a force")
check(np.isfinite(table["F_y"][~failed]).all(), "a point has no force")

# ended after the first failure, and continued twice
output = scratch()
words = [TIRE_TEST, "--output", output, *overrides({**COARSE, **SETTINGS})]
for options in (["--stages", "1-5"], ["--restart", "--stages", "1-7"], ["--restart"]):
    code, message = execute(words + options)
    check(code == 0, message)
continued = biface.Results(output).tire_test()
check(list(continued["status"] != "ok") == list(failed), "the status after a restart")
difference = np.nanmax(abs(continued["F_y"] - table["F_y"]))
check(difference < 1e-7 * 1000, f"the forces differ by {difference} after a restart")
