# SPDX-License-Identifier: LGPL-2.1-or-later

# Without three.js the page has no view and no script, and a sentence names the Debian
# package.

import subprocess
import sys

from report_test import PACKAGE, RUNS, Page, check, require, scratch

require("matplotlib")

target = scratch() / "page.html"
program = f"""
import sys
from pathlib import Path
from biface_report import __main__, view
view.LIBRARY = Path("missing")
sys.argv = ["biface-report", {str(RUNS / "shell")!r}, "-o", {str(target)!r}]
sys.exit(__main__.main())
"""
subprocess.run([sys.executable, "-B", "-c", program], check=True,
               env={"PYTHONPATH": str(PACKAGE)})
page = Page(target.read_text(encoding="utf-8"))
check("Deformed shell: three.js is missing (Debian: libjs-three)." in page.text,
      "the reason is not given")
check("<script" not in page.source, "the page has a script")
