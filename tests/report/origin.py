# SPDX-License-Identifier: LGPL-2.1-or-later

# The page names the parameter file, the version, and entries set on the command line.

import subprocess

from report_test import BUILD, RUNS, check, page_of, require

require("matplotlib")
page = page_of(RUNS / "bias_tire")
program = next(path for path in (BUILD / "biface", BUILD / "biface.debug")
               if path.exists())
version = subprocess.run([program, "--version"], capture_output=True, text=True,
                         check=True).stdout.strip()
check(page.headings[0] == "biface: bias_tire.prm", f"{page.headings[0]}")
check(f"{version}," in page.text, f"the page does not name {version}")
rows = [cells for cells, _ in page.rows]
check(["Stage 2/Steps", "4", "1"] in rows, "Stage 2/Steps is not listed")
check(not any(cells[0] == "Newton/Residual tolerance" for cells in rows),
      "1e-8 is listed as other than the default 1e-08")
