# SPDX-License-Identifier: LGPL-2.1-or-later

# The table of modes has the part of the air in the kinetic energy, but only of a tire
# whose air moves.

from report_test import RUNS, check, page_of, read_csv, require

require("matplotlib")
lines = read_csv(RUNS / "response/modes.csv")
page = page_of(RUNS / "response")
check(any("Part of the air" in cells for cells, _ in page.rows), "no column")
parts = [float(line["part_of_air"]) for line in lines]
check(max(parts) > 0.5, f"no mode of the air: {parts}")
for line, part in zip(lines, parts):
    cells = next(cells for cells, _ in page.rows
                 if cells[:2] == [line["stage"], line["mode"]])
    check(f"{100 * part:.1f}\u00a0%" in cells, f"mode {line['mode']}: {cells}")
check("Part of the air" not in page_of(RUNS / "tire_modes").text,
      "there is a column without air")
