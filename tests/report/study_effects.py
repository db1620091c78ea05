# SPDX-License-Identifier: LGPL-2.1-or-later

# The main effects of a study whose outputs are known polynomials of the variables
# are exact, and samples that failed are left out of them and listed.

from itertools import product

from report_test import check, check_equal, complaint, page_of, require, scratch

require("matplotlib")
directory = scratch()
(directory / "study.prm").write_text(
    "subsection Study\n  set Outputs = force, energy @ inflation\nend\n",
    encoding="utf-8")
lines = ["sample,a,b,force,energy @ inflation,status,steps,iterations,seconds"]
for i, (a, b) in enumerate(product((1, 2, 3, 4, 5), (-1, 0, 1, 2)), start=1):
    lines.append(f'{i},{a},{b},{3 + 2 * a - b},{a * a + a * b},"ok",2,7,0.5')
lines.append('21,9,9,,,"step 2, contact, says ""no"" here",1,30,1.5')
table = directory / "study.csv"
table.write_text("\n".join(lines) + "\n", encoding="utf-8")
page = page_of(directory)


def values(head):
    """The numbers of the row of the first table that begins so."""
    return next(row[1] for row in page.rows if row[0][0] == head)


for value, expected in zip(values("force"), (8, -3, 3 + 2 * 3 - 0.5)):
    check_equal(value, expected, "the effect on the force")
# with the other variable in the middle, 0.5 and 3
for value, expected in zip(values("energy @ inflation"), (24 + 4 * 0.5, 9)):
    check(abs(value - expected) < 1e-10 * expected, f"{value} is not {expected}")
check(any(row[0][-1] == 'step 2, contact, says "no" here' for row in page.rows),
      "the reason of the failure is missing")
check("21 samples, 1 of them failed" in page.text, "the failure is not counted")
check(len(page.images) == 3, f"there are {len(page.images)} charts")

table.write_text("sample,a\n", encoding="utf-8")
check("does not name the columns of a study" in complaint(directory),
      "a damaged table was accepted")
