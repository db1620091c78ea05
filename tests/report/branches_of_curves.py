# SPDX-License-Identifier: LGPL-2.1-or-later

# The curves of load and deflection have all branches, each with its color and name:
# without contact against the displacements of named points, with contact against the
# approach.

import sys

from report_test import PACKAGE, RUNS, check, read_csv, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.charts import ProbeCurves, draw_contact_curve

run = Results(RUNS / "branches")
axes = ProbeCurves(run, run.probes()).draw().axes[0]
lines = [line for line in axes.lines if line.get_marker() == "o"
         and line.get_markersize() == 4]
center = lines[:2]
history = read_csv(RUNS / "branches/history.csv")
loads = [float(row["pressure"]) for row in history]
for line, rows in zip(center, ([0, 1, 2, 3], [1, 4, 5])):
    expected = ([0] if rows[0] == 0 else []) + [loads[row] for row in rows]
    check(list(line.get_ydata()) == expected, f"the loads {line.get_ydata()}")
names = [text.get_text() for text in axes.get_legend().get_texts()]
check(names[:2] == ["pressure test, up", "back"], f"the names {names}")
colors = [line.get_color() for line in center]
check(colors[0] != colors[1], "the branches have the same color")
check([line.get_color() for line in axes.get_legend().get_lines()[:2]] == colors,
      "other colors in the legend")

# the longest branches of a run with many
axes = draw_contact_curve(Results(RUNS / "tire_stiffness")).axes[0]
names = [text.get_text() for text in axes.get_legend().get_texts()]
check(any(name.startswith("2000 N at 0.12 MPa") for name in names), f"{names}")
check(names[-1] == f"{32 - len(names) + 1} other branches", f"{names[-1]}")
named = axes.get_legend().get_lines()[:-1]
check(len({line.get_color() for line in named}) == len(named), "colors are repeated")

# a single branch needs no name
axes = draw_contact_curve(Results(RUNS / "bias_tire")).axes[0]
check(axes.get_legend() is None, "a legend of one branch")
