# SPDX-License-Identifier: LGPL-2.1-or-later

# The option --step shows an earlier step, and a missing step is refused.

from report_test import (RUNS, check, check_equal, complaint, page_of, read_csv,
                         require)

require("matplotlib")
page = page_of(RUNS / "bias_tire", "--step", "3")
row = read_csv(RUNS / "bias_tire/history.csv")[2]
check_equal(page.numbers("Force on the ground")[0], float(row["force"]),
            "the force")
check_equal(page.numbers("Steps")[0], 3, "the number of steps")
check("it has the steps 1 to 5" in complaint(RUNS / "bias_tire", "--step", "9"),
      "the steps are not told")

# the first step is not in contact yet
page = page_of(RUNS / "bias_tire", "--step", "1")
check("The shell is not in contact with the ground in step 1." in page.text,
      "the footprint")
check("only one step" in page.text, "the curve")
