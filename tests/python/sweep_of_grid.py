# SPDX-License-Identifier: LGPL-2.1-or-later

# A sweep has a row for each combination of the values, with the results of runs with these values.

from python_test import COARSE, TIRE, biface, check, check_close, run, scratch

output = scratch()
lines = []
study = biface.sweep(TIRE, {"p: Stage 1/Pressure, Stage 2/Pressure": [0.1, 0.2],
                            "Stage 2/Travel": [5, 7, 9]},
                     ["force", "strain_energy @ inflation"], COARSE, output,
                     ranks=2, progress=lines.append)
check(list(study["p"]) == [0.1] * 3 + [0.2] * 3
      and list(study["Stage 2/Travel"]) == [5, 7, 9] * 2, "the samples")
check(study.outputs == ["force", "strain_energy @ inflation"], f"{study.outputs}")
check(len(lines) == 6 and lines[-1].startswith("6 of 6"), f"the progress is {lines}")
results = run({"Stage 1/Pressure": 0.2, "Stage 2/Pressure": 0.2, "Stage 2/Travel": 7})
row = study.where(p=0.2).where(**{"Stage 2/Travel": 7}).row(0)
check_close(row["force"], results.last("force"), 1e-6, "the force")
check_close(row["strain_energy @ inflation"],
            results.stage("inflation").last("strain_energy"), 1e-6, "the energy")
check(study.results(5).last("force") == row["force"], "the results of the sample")
