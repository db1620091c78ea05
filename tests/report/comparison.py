# SPDX-License-Identifier: LGPL-2.1-or-later

# The comparison of two runs has the numbers of both, their differences, and the entries
# that differ, also for different meshes; what cannot be compared is refused.

import subprocess

from report_test import (BUILD, RUNS, check, check_equal, complaint, copy_of, page_of,
                         read_csv, require, scratch)

require("matplotlib")
page = page_of(RUNS / "bias_tire", RUNS / "shell")
forces = [float(read_csv(RUNS / name / "history.csv")[-1]["force"])
          for name in ("bias_tire", "shell")]
values = page.numbers("Force on the ground [N]")
change = forces[1] - forces[0]
for value, expected in zip(values, (*forces, change, 100 * change / forces[0])):
    check_equal(value, expected, "the force")
for heading in ("Load and deflection", "Contact pressure along the section",
                "Footprint of bias_tire", "Footprint of shell", "Deformed sections"):
    check(heading in page.headings, f"there is no '{heading}'")
differing = [cells[0] for cells, _ in page.rows
             if cells[0].startswith(("Stage", "Output", "Mesh"))]
check("Stage 2/Steps" in differing and "Stage 2/Travel" in differing
      and "Output/Directory" not in differing, f"the entries {differing}")

# with and without contact, without the input
other = copy_of("composite_panel")
(other / "parameters.prm").unlink()
page = page_of(RUNS / "shell", other)
check("Load and deflection: Only one of the runs has contact." in page.text,
      "the reason is not told")

page = page_of(RUNS / "shell", RUNS / "seal")
check("Footprint of seal" in page.headings and "Deformed sections" in page.headings,
      "other meshes are not compared")

panel = page_of(RUNS / "composite_panel", RUNS / "branches")
check("Load and deflection" in panel.headings, "no curve of a named point")

study = scratch()
(study / "study.csv").write_text("", encoding="utf-8")
check("holds a study" in complaint(RUNS / "shell", study), "a study was accepted")
check("Two directories at most" in complaint(*3 * [RUNS / "shell"]),
      "three directories were accepted")
copies = [copy_of("bias_tire"), copy_of("bias_tire")]
for directory, units in zip(copies, ("mm, N, s", "m, N, s")):
    with open(directory / "parameters.prm", "a", encoding="utf-8") as file:
        file.write(f"set Units = {units}\n")
check("different units" in complaint(*copies), "different units were accepted")

# the page is written to the first directory
directory = copy_of("bias_tire")
subprocess.run([BUILD / "biface-report", directory, RUNS / "shell"], check=True)
check((directory / "comparison.html").exists(), "there is no comparison.html")
