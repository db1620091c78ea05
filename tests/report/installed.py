# SPDX-License-Identifier: LGPL-2.1-or-later

# An installed biface-report needs neither the sources nor the build directory.

import os
import subprocess

from report_test import BUILD, RUNS, check, page_of, require, scratch

require("matplotlib")
prefix = scratch() / "a prefix"
subprocess.run([os.environ["CMAKE"], "--install", BUILD / "source/python",
                "--prefix", prefix], check=True, capture_output=True)
launcher = prefix / "bin/biface-report"
check(str(BUILD) not in launcher.read_text(), "the launcher names the build")
page = page_of(RUNS / "bias_tire", launcher=launcher)
check("Summary" in page.headings, "there is no summary")
