# SPDX-License-Identifier: LGPL-2.1-or-later

# Settings of all types reach the program.

from python_test import check, check_equal, run

results = run({"Stage 2/Travel": 7.5, "Stage 2/Steps": 1, "Output/Write VTU": True,
               "Contact/Direction": [0.8, 0, 0.6]})
check_equal(results.last("approach"), 7.5, "the approach")
check(len(results.steps) == 2 and results.vtu() is not None, "the steps or the VTU")
force = results.forces().where(body="foundation").row(-1)
check_equal(force["F_x"] * 0.6, force["F_z"] * 0.8, "the direction of the force")
