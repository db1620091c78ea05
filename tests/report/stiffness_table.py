# SPDX-License-Identifier: LGPL-2.1-or-later

# The table of stiffnesses has a row for each stage of stiffness.csv, with its
# secant, its first and last tangent, and the name of the motion for a wheel.

from report_test import RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
page = page_of(RUNS / "tire_stiffness")
lines = read_csv(RUNS / "tire_stiffness/stiffness.csv")
names = {"more load": "vertical", "less load": "vertical",
         "lateral": "lateral", "longitudinal": "longitudinal", "turn": "turn"}
seen = set()
for stage in dict.fromkeys(line["stage"] for line in lines):
    own = [line for line in lines if line["stage"] == stage]
    found = [row for row in page.rows if row[0][0] == stage]
    check(len(found) == 1, f"the stage {stage} is there {len(found)} times")
    cells, values = found[0]
    motion = stage.partition(": ")[2].split(" glued")[0].split(" rough")[0]
    check(cells[4] == names.get(motion, "vertical"), f"{stage} is {cells[4]}")
    seen.add(cells[4])
    expected = [own[-1]["pressure"], own[-1]["force"], own[-1]["approach"],
                own[-1]["amount"], own[-1]["secant"], own[0]["tangent"],
                own[-1]["tangent"]]
    for value, text in zip(values, expected):
        check_equal(value, float(text), stage)
    # across the motion: about the normal of the ground, x
    if cells[4] == "lateral":
        check_equal(values[7], float(own[-1]["secant_F_z"]), "force along")
    if cells[4] == "longitudinal":
        check_equal(values[7], -float(own[-1]["secant_F_y"]), "force across")
check(seen == {"vertical", "lateral", "longitudinal", "turn"}, f"only {seen}")
