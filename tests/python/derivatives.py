# SPDX-License-Identifier: LGPL-2.1-or-later

# Derivatives are the differences of the history between two runs.

from python_test import check, check_close, run

TIGHT = {"Newton/Residual tolerance": 1e-10}
VALUES = {"Material cord/E_L": 510.45, "Stage 2/Travel": 20}

results = run({"Sensitivities/Entries": "; ".join(VALUES),
               "Sensitivities/Outputs": ["force", "footprint_area"], **TIGHT})
derivatives = results.derivatives()
check(list(derivatives) == ["force", "footprint_area"], f"{list(derivatives)}")
for entry, value in VALUES.items():
    step = 1e-4 * value
    ends = [run({entry: value + side * step, **TIGHT}) for side in (-1, 1)]
    for output, by_entry in derivatives.items():
        difference = (ends[1].last(output) - ends[0].last(output)) / (2 * step)
        check_close(by_entry[entry], difference, 1e-4, f"{output} by {entry}")
check(run().derivatives() == {}, "there are derivatives that were not asked for")
