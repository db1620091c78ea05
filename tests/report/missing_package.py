# SPDX-License-Identifier: LGPL-2.1-or-later

# Without matplotlib, one sentence names the Debian package that contains it.

import os
import subprocess
import sys

from report_test import PACKAGE, RUNS, check

# without the folders of installed packages
done = subprocess.run(
    [sys.executable, "-S", "-B", "-m", "biface_report", RUNS / "bias_tire"],
    env=dict(os.environ, PYTHONPATH=str(PACKAGE)), capture_output=True,
    text=True, check=False)
check(done.returncode == 1, f"the exit code is {done.returncode}")
check(done.stderr == "biface-report: numpy for Python is missing (Debian: "
      "python3-matplotlib).\n", done.stderr)
