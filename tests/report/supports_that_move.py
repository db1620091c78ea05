# SPDX-License-Identifier: LGPL-2.1-or-later

# The report has the force of a support that moves as in history.csv, in the direction in which
# it is positive, over the displacement, on both branches from the inflated air spring.

import sys

from report_test import PACKAGE, RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.reactions import draw_reaction, reactions_of

directory = RUNS / "air_spring"
history = read_csv(directory / "history.csv")
moved, force = ([-float(row[f"alpha_1_max_{what}"]) for row in history]
                for what in ("displacement", "force"))
check(min(force) > 0, f"the forces {force}")
cells, values = next(row for row in page_of(directory).rows
                     if row[0][0] == "alpha_1 max")
top = force.index(max(force))
for value, expected in zip(values, (moved[-1], force[-1], force[top], moved[top])):
    check_equal(value, expected, "a number of the table")

reaction, = reactions_of(Results(directory))
lines = [line for line in draw_reaction(Results(directory), reaction).axes[0].lines
         if line.get_markersize() == 4]
# the first one starts from the shell without loads
rows = {name: [i for i, row in enumerate(history) if row["stage"] == name]
        for name in ("inflation", "compression", "rebound")}
check(list(lines[0].get_ydata()) == [0] + [force[i] for i in rows["inflation"]
                                           + rows["compression"]],
      f"the forces of compression {lines[0].get_ydata()}")
check(list(lines[1].get_ydata()) == [force[i] for i in rows["inflation"][-1:]
                                     + rows["rebound"]],
      f"the forces of rebound {lines[1].get_ydata()}")
