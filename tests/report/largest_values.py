# SPDX-License-Identifier: LGPL-2.1-or-later

# The largest failure index and displacement are those of the whole shell with their
# places; where only named points are known, the summary says so.

import sys

from report_test import (PACKAGE, RUNS, check, check_equal, copy_of, page_of,
                         read_csv, require)

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import read_vtu


def remark(page, head):
    """The last cell of a row of the summary."""
    return next(cells[-1] for cells, _ in page.rows if cells[0] == head)


directory = copy_of("composite_panel")
last = read_csv(directory / "history.csv")[-1]
index = float(last["maximum_stress_index"])
plies = read_csv(directory / f"plies-{int(last['step']):04d}.csv")
at_points = max(float(row["maximum_stress_index"]) for row in plies)
check(index > 1.01 * at_points, "the named points have the largest index")
page = page_of(directory)
head = "Largest failure index, maximum stress"
check_equal(page.numbers(head)[0], index, head)
check(f"ply {last['maximum_stress_ply']};" in remark(page, head),
      f"the place: {remark(page, head)}")

# the same without these columns
path = directory / "history.csv"
lines = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()]
kept = [i for i, name in enumerate(lines[0])
        if not name.startswith(("maximum_stress", "tsai_wu"))]
path.write_text("".join(",".join(line[i] for i in kept) + "\n" for line in lines),
                encoding="utf-8")
page = page_of(directory)
check_equal(page.numbers(head + ", of the named points")[0], at_points, head)
check("It may be larger elsewhere" in remark(page, head + ", of the named points"),
      "the summary does not say that it may be larger elsewhere")

# the free end of a column moves most
data = read_vtu(max((RUNS / "buckling").glob("shell-*.vtu")))
largest = np.linalg.norm(data["displacement"], axis=1).max()
page = page_of(RUNS / "buckling")
check_equal(page.numbers("Largest displacement")[0], float(largest), "displacement")
check("of the whole shell" in remark(page, "Largest displacement"), "no place")
