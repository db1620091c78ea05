# SPDX-License-Identifier: LGPL-2.1-or-later

# A study file gives the table that a sweep with the same variables gives.

from python_test import COARSE, TIRE, biface, check, scratch

file = scratch() / "study.prm"
biface.write_parameters(file, {
    "Study/Base file": TIRE, "Study/Variables": "Stage 2/Travel",
    "Study/Values": "Stage 2/Travel: 5, 8", "Study/Outputs": "force"})
study = biface.run_study(file, COARSE, scratch())
sweep = biface.sweep(TIRE, {"Stage 2/Travel": [5, 8]}, ["force"], COARSE, scratch())
check(list(study) == list(sweep), f"the columns are {list(study)}")
for name in ("Stage 2/Travel", "force", "status"):
    check((study[name] == sweep[name]).all(), f"the column {name} differs")
