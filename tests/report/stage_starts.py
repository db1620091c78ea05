# SPDX-License-Identifier: LGPL-2.1-or-later

# The steps of a stage that branches start from the end of the stage that it names,
# so do the curve of the contact force and the stiffness in the summary.

import sys

from report_test import PACKAGE, RUNS, check, check_equal, read_csv, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report import charts
from biface_report.loading import rows_before

run = Results(RUNS / "tire_stiffness")
history = read_csv(RUNS / "tire_stiffness/history.csv")
stages = [row["stage"] for row in history]
last = {stage: i for i, stage in enumerate(stages)}


def expected_start(i):
    """The step before, by the names of the stages."""
    stage = stages[i]
    if i == 0 or stages[i - 1] == stage:
        return i - 1
    if ": " in stage:
        return last[stage.partition(": ")[0]]
    if stage.startswith("2000 N"):
        return last[stage.replace("2000", "1000")]
    return 0 if stage.startswith("inflation") else i - 1


before = rows_before(run)
for i, stage in enumerate(stages):
    check(before[i] == expected_start(i),
          f"step {i + 1} starts from step {before[i] + 1}")

# two loads at two pressures; from each eight branches, the first of which goes on
# with the curve of its load
curves = charts.contact_curves(run)
check(len(curves) == 32, f"there are {len(curves)} curves")
loaded = last["1000 N at 0.12 MPa"]
for approach, force in curves[1:8]:
    check_equal(approach[0], float(history[loaded]["approach"]), "start of a branch")
    check_equal(force[0], float(history[loaded]["force"]), "its force")

end = last["1000 N at 0.12 MPa: less load"]
change = [float(history[end][name]) - float(history[loaded][name])
          for name in ("force", "approach")]
check_equal(charts.stiffness(Results(RUNS / "tire_stiffness", end + 1)),
            change[0] / change[1], "the stiffness of less load")
