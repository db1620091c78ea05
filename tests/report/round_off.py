# SPDX-License-Identifier: LGPL-2.1-or-later

# What is only round-off is not drawn but named: derivatives of a force that is zero,
# an output of a study that a control holds, and modes that are rigid motions.

import sys

from report_test import (PACKAGE, check, copy_of, page_of, read_csv, require,
                         scratch)

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.modes import rigid_motions

# the lateral force of the tire
directory = copy_of("sensitivities")
step = read_csv(directory / "sensitivities.csv")[0]["step"]
with open(directory / "sensitivities.csv", "a", encoding="utf-8") as file:
    for output, value in (("foundation F_y", 1e-12), ("foundation F_x", -700)):
        file.write(f"{step},contact,E,510.45,{output},{value},-6e-11,-31590\n")
page = page_of(directory)
check("zero within round-off: foundation F_y." in page.text, "it is not named")
words = next(image["alt"] for image in page.images if "logarithmic" in image["alt"])
check("foundation F_y" not in words, "round-off is drawn")
check("foundation F_x" in words, "a force is not drawn")

# a controlled force and a length that varies
directory = scratch()
(directory / "study.prm").write_text(
    "subsection Study\n  set Outputs = force, length\nend\n", encoding="utf-8")
lines = ["sample,a,force,length,status,steps,iterations,seconds"]
for i in range(8):
    lines.append(f'{i + 1},{i},{1000 + 1e-6 * (-1)**i},{3 + i},"ok",2,7,0.5')
(directory / "study.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
page = page_of(directory)
check("they do not vary beyond the tolerance of the iteration: force." in page.text,
      "the output is not named")
effects = [cells[0] for cells, _ in page.rows if cells[0] in ("force", "length")]
check(effects == ["length"], f"the effects of {effects}")

# a mode without a frequency
directory = copy_of("tire_modes")
path = directory / "modes.csv"
lines = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()]
column = lines[0].index("frequency")
last = [line for line in lines if line[0] == lines[-1][0]]
last[0][column] = "1e-5"
path.write_text("".join(",".join(line) + "\n" for line in lines), encoding="utf-8")
found = Results(directory).modes()
check(list(rigid_motions(found)) == [line is last[0] for line in lines[1:]],
      "other modes are rigid motions")
page = page_of(directory)
check("Not drawn: 1 rigid motion of the stage pressed, with" in page.text,
      "the rigid motion is not named")
check(any(cells[2] == "≈ 0, rigid motion" for cells, _ in page.rows
          if len(cells) > 2), "it is not marked in the table")
