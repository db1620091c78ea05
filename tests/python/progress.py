# SPDX-License-Identifier: LGPL-2.1-or-later

# The function for progress is called once for each step while the program runs.

from python_test import check, run

lines = []
run(progress=lines.append)
check([line.split(":")[0] for line in lines]
      == ["step 1 of 3", "step 2 of 3", "step 3 of 3"], f"the lines are {lines}")
check("force" in lines[-1], f"the last line is {lines[-1]}")
