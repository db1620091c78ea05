# SPDX-License-Identifier: LGPL-2.1-or-later

# Without contact, the page contains the displacements and ply stresses of the files.

import math

from report_test import RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
run = RUNS / "composite_panel"
page = page_of(run)
check("Footprint" not in page.headings, "there is a footprint")
check("Load and deflection" in page.headings, "there is no curve")

all_heads = [cells for cells, _ in page.rows if cells[:2] == ["Step", "Stage"]]
check(all_heads and "Force" not in all_heads[0], "there is a column of forces")

step = read_csv(run / "history.csv")[-1]["step"]
for row in read_csv(run / "probes.csv"):
    if row["step"] == step and row["face"] == "middle":
        for value, column in zip(page.numbers(row["name"]), ("u_x", "u_y", "u_z")):
            check_equal(value, float(row[column]), f"{column} of {row['name']}")

# the largest failure index of the shell is in the summary, and the largest
# displacement of the named points, since there is no file of the whole shell
rows = [row for row in read_csv(run / "probes.csv")
        if row["step"] == step and row["face"] == "middle"]
check_equal(page.numbers("Largest displacement of a named point")[0],
            max(math.hypot(*(float(row[f"u_{i}"]) for i in "xyz"))
                for row in rows), "the largest displacement")
last = read_csv(run / "history.csv")[-1]
check_equal(page.numbers("Largest failure index, maximum stress")[0],
            float(last["maximum_stress_index"]), "the largest failure index")

plies = read_csv(run / f"plies-{int(step):04d}.csv")
# of the first point and its first ply: angle, tension, then from minimum to
# maximum the stresses along and across the fibers
plies = [row for row in plies if row["name"] == "center" and row["ply"] == "1"]
check(len(plies) == 2, "the ply has not two lines")
values = next(values for cells, values in page.rows
              if cells[:2] == ["1", "carbon"])
expected = [float(plies[0]["angle"]), float(plies[0]["fiber_tension"])]
for column in ("s_L", "s_T"):
    expected += sorted(float(row[column]) for row in plies)
for value, exact in zip(values, expected):
    check_equal(value, exact, "a number of the ply")
