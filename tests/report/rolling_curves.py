# SPDX-License-Identifier: LGPL-2.1-or-later

# A wheel that corners to both sides and brakes gives two curves over the slip angle
# and one over the longitudinal slip, all from free rolling, and a table of forces
# with the rolling resistance.

import sys

from report_test import (PACKAGE, RUNS, check, check_equal, copy_of, page_of,
                         read_csv, require)

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report import rolling
from biface_report.units import Units

run = Results(RUNS / "rolling_tire")
found = run.rolling()
stages = found["stage"]
cornering = rolling.curves(run, found, rolling.is_cornering)
check([list(stages[rows]) for rows in cornering]
      == [["free", "right", "right"], ["free", "left", "left"]], f"{cornering}")
braking = rolling.curves(run, found, rolling.is_braking)
check([list(stages[rows]) for rows in braking]
      == [["free", "braking", "braking", "locked", "locked"]], f"{braking}")

# from free rolling, where the slip is 0, to the locked wheel
slip, = rolling.slips_of(run, found, braking)
check_equal(slip[0], 0, "slip of the free wheel")
check_equal(slip[-1], -100, "slip of the locked wheel")
check(all(slip[1:] < slip[:-1]), f"the slip {slip}")

# ISO 8855: a wheel that moves to the left is pushed to the right, a braked one back
sides, aligning = (axes.lines for axes in
                   rolling.draw_cornering(found, cornering, Units()).axes)
check(sides[0].get_xdata()[-1] < 0 < sides[1].get_xdata()[-1], "the slip angles")
check(sides[0].get_ydata()[-1] > 0 > sides[1].get_ydata()[-1], "the side forces")
check(aligning[0].get_ydata()[-1] < 0 < aligning[1].get_ydata()[-1],
      "the aligning moments")
chart = rolling.draw_braking(found, braking, [slip], Units())
drag = chart.axes[0].lines[0].get_ydata()
check(drag[-1] < drag[0] <= 0, f"the drag {drag}")

page = page_of(RUNS / "rolling_tire")
check("Rolling" in page.headings, "no section")
for words in ("lateral force and the aligning moment against the slip angle",
              "longitudinal force against the longitudinal slip"):
    check(any(words in image["alt"] for image in page.images), f"no {words}")
for line in read_csv(RUNS / "rolling_tire/rolling.csv"):
    # the first table of steps is that of all stages, not only of those that roll
    rows = [row for row in page.rows if row[0][0] == f"Step {line['step']}"
            and len(row[1]) == 11]
    check(len(rows) == 1, f"step {line['step']} is there {len(rows)} times")
    for value, column in zip(rows[0][1], ("angular_velocity", "ground_velocity",
                                          "slip_angle", "F_x", "F_y", "F_z")):
        check_equal(value, float(line[column]), column)
    check_equal(rows[0][1][-1], float(line["rolling_resistance"]), "resistance")

# without a free wheel before it, the angular velocity is all there is
directory = copy_of("rolling_tire")
path = directory / "rolling.csv"
lines = path.read_text(encoding="utf-8").split("\n")
at = lines[0].split(",").index("axle_moment")
for i, line in enumerate(lines[1:-1], start=1):
    fields = line.split(",")
    fields[at] = "1e5"
    lines[i] = ",".join(fields)
path.write_text("\n".join(lines), encoding="utf-8")
check(any("longitudinal force against the angular velocity" in image["alt"]
          for image in page_of(directory).images), "no chart without a free wheel")
path.unlink()
check("Rolling: In no step does a wheel roll." in page_of(directory).text,
      "the reason is not told")
