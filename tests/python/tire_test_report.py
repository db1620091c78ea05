# SPDX-License-Identifier: LGPL-2.1-or-later

# The report of a tire test has a section with all its points, which are neither curves of
# rolling nor forces in the axes of an upright wheel.

import re

from tire_test import check, require, run, run_command, scratch

require("matplotlib")

output = scratch()
table = run({"Tire test/Loads": "1000, 1500", "Tire test/Inclination angles": "0, 3",
             "Tire test/Slip angles": "-2, 2", "Tire test/Slip ratios": -0.03}, output=output).tire_test()
code, _, errors = run_command("biface-report", output)
check(code == 0, errors)
page = (output / "report.html").read_text(encoding="utf-8")
section = page[page.index('id="tire-test"'):]
section = section[:section.index("</section>")]
rows = re.findall(r"<tr>.*?</tr>", section, re.S)
check(len(rows) == 1 + len(table) == 17, f"there are {len(rows)} rows")
for point in (2, 11):
    cells = re.sub("<[^>]*>", " ", rows[point]).split()
    check(cells[:3] == ["Point", str(point), "ok"], f"the cells are {cells}")
    shown = [float(cell.replace("\N{MINUS SIGN}", "-")) for cell in cells[3:]
             if re.fullmatch(r"[-\N{MINUS SIGN}]?[\d.]+", cell)]
    wanted = table["F_x"][point - 1]
    check(any(abs(value - wanted) < 1e-3 * abs(wanted) for value in shown),
          f"{wanted} is not among {shown}")
check("<img" in section or "<svg" in section, "the section has no chart")
check('id="wheel"' not in page or "tire test: point" not in
      page[page.index('id="wheel"'):].split("</section>")[0],
      "forces in wheel axes are those of points")
check("only rolls in its tire test" in page, "the points are curves of rolling")
