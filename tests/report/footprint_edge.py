# SPDX-License-Identifier: LGPL-2.1-or-later

# The drawn edge of the footprint is as long and as wide as history.csv says, within
# five percent of a cell; without the file of the whole shell it is stretched to this
# size, and the page says so. The same holds if points in the cells make contact.

import sys

from report_test import PACKAGE, RUNS, check, page_of, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Results
from biface_report.content import find_footprint

for name, share in (("shell", 0.05), ("drum", 0.05), ("tire_modes", 0.05),
                    ("points", 0.05), ("bias_tire", 1e-6)):
    run = Results(RUNS / name)
    footprint = find_footprint(run)
    check(footprint.is_estimated == (name == "bias_tire"), f"{name} is estimated")
    points = np.concatenate(footprint.outline)
    # the axes y and z of the ground
    check(footprint.axis_names == ["y", "z"], f"the axes {footprint.axis_names}")
    sizes = dict(zip(("width", "length"), np.ptp(points, axis=0)))
    for i, (which, size) in enumerate(sizes.items()):
        exact = run.last(f"footprint_{which}")
        lines = np.unique(np.round(run.contact()[f"alpha_{i + 1}"], 6))
        cell = np.ptp(footprint.nodes[:, i]) / (len(lines) - 1)
        check(abs(size - exact) < share * cell,
              f"{name}: the {which} is {size}, not {exact}, with cells of {cell}")
check("estimated from the nodes of the zone alone" in page_of(RUNS / "bias_tire").text,
      "not told")
check("estimated from the nodes" not in page_of(RUNS / "drum").text,
      "told without a reason")
