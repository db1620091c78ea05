# SPDX-License-Identifier: LGPL-2.1-or-later

# The table of modes has the frequencies and wave numbers of modes.csv, and there
# are pictures of the modes if their files are there.

from report_test import RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
page = page_of(RUNS / "tire_modes")
lines = read_csv(RUNS / "tire_modes/modes.csv")
check(len(lines) == 6, f"{len(lines)} modes")
for line in lines:
    found = [row for row in page.rows
             if row[0][:2] == [line["stage"], line["mode"]]]
    check(len(found) == 1, f"mode {line['mode']} is there {len(found)} times")
    cells, values = found[0]
    check_equal(values[0], float(line["frequency"]), "frequency")
    check(cells[3] == line["circumferential_waves"], f"waves: {cells[3]}")
check(any(image["alt"].startswith("Shapes of the first modes")
          for image in page.images), "no pictures")
