# SPDX-License-Identifier: LGPL-2.1-or-later

# The table of all steps contains every number of history.csv.

from report_test import RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib")
page = page_of(RUNS / "bias_tire")
for row in read_csv(RUNS / "bias_tire/history.csv"):
    found = [values for cells, values in page.rows
             if cells[:2] == [row["step"], row["stage"]]]
    check(len(found) == 1, f"step {row['step']} is there {len(found)} times")
    names = ("approach", "force", "contact_area", "max_pressure", "pressure",
             "load_factor", "iterations", "seconds")
    check(len(found[0]) == len(names), "numbers are missing")
    for name, value in zip(names, found[0]):
        check_equal(value, float(row[name]), name)
