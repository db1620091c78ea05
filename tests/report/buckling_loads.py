# SPDX-License-Identifier: LGPL-2.1-or-later

# Of a column that is compressed beyond its critical load, the page has the loads of
# buckling.csv with pictures of the shapes, and the bifurcation on its path.

import sys

from report_test import (PACKAGE, check, check_equal, copy_of, page_of, read_csv,
                         require)

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.charts import ProbeCurves

directory = copy_of("buckling")
for path in directory.glob("shell-*.vtu"):
    path.unlink()
page = page_of(directory)
loads = read_csv(directory / "buckling.csv")
check(len(loads) == 2, f"{len(loads)} buckling loads")
for line in loads:
    found = [row for row in page.rows if row[0][:2] == ["buckling", line["mode"]]]
    check(len(found) == 1, f"load {line['mode']} is there {len(found)} times")
    for value, column in zip(found[0][1], ("factor", "load_factor", "reaction", "load_work")):
        check_equal(value, float(line[column]), column)
    check(found[0][0][-1] == "≈ 0", "the load works on the shape of buckling")
check(any(image["alt"].startswith("Shapes of the first buckling loads")
          and image["src"].startswith("data:image/png") for image in page.images),
      "no pictures")

# the first load is Euler's, of the load factor 1
critical, = read_csv(directory / "critical_points.csv")
cells, values = next(row for row in page.rows if "bifurcation" in row[0])
check(cells[:5] == [f"Step {critical['step']}", "push", "bifurcation", "located",
                    "0 → 1"], f"the critical point is {cells}")
check(abs(values[1] - 1) < 0.01, f"the column bifurcates at {values[1]}")
check(f"Rings: critical points, bifurcation in step {critical['step']}." in page.text,
      "the caption does not tell of the critical point")
run = Results(directory)
rings = [line for line in ProbeCurves(run, run.probes()).draw().axes[0].lines
         if line.get_markerfacecolor() == "none"]
check([len(line.get_xdata()) for line in rings] == [1], "not one ring on the curve")
check_equal(rings[0].get_ydata()[0], values[1], "the load of the ring")

for path in directory.glob("buckling-*.vtu"):
    path.unlink()
(directory / "critical_points.csv").unlink()
page = page_of(directory)
check("Buckling loads" in page.headings, "no loads without shapes")
check(not any(image["alt"].startswith("Shapes") for image in page.images),
      "pictures without shapes")
check("Critical points: No stage has" in page.text, "the reason is not told")
check("Rings" not in page.text, "rings without critical points")
