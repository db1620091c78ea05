# SPDX-License-Identifier: LGPL-2.1-or-later

# The numbers of the summary are those of the last line of history.csv; the remarks on
# mean pressures name the areas.

from report_test import RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
page = page_of(RUNS / "bias_tire")
history = read_csv(RUNS / "bias_tire/history.csv")
last = {name: float(value) for name, value in history[-1].items()
        if name != "stage"}
before = {name: float(history[-2][name]) for name in ("force", "approach")}

for head, expected in (
        ("Force on the ground", last["force"]),
        ("Approach of the ground", last["approach"]),
        ("Stiffness", (last["force"] - before["force"])
         / (last["approach"] - before["approach"])),
        ("Contact area", last["contact_area"]),
        ("Length of the footprint", last["footprint_length"]),
        ("Width of the footprint", last["footprint_width"]),
        ("Mean contact pressure", last["force"] / last["footprint_area"]),
        ("Loaded radius", last["loaded_radius"]),
        ("Maximum fiber tension", last["max_fiber_tension"]),
        ("Maximum contact pressure", last["max_pressure"]),
        ("Pressure on the shell", last["pressure"]),
        ("Steps", len(history)),
        ("Newton iterations", sum(int(row["iterations"]) for row in history))):
    check_equal(page.numbers(head)[0], expected, head)

for head, area in (("Mean contact pressure", "deformed area"),
                   ("Mean contact pressure by force", "undeformed middle surface")):
    remark = next(cells[-1] for cells, _ in page.rows if cells[0] == head)
    check(area in remark, f"{head}: {remark}")
