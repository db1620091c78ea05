# SPDX-License-Identifier: LGPL-2.1-or-later

# Without SciPy, one sentence names the Debian package that contains it.

import os
import subprocess
import sys

from tire_model_test import MADE, PACKAGE, check

# without the folders of installed packages
done = subprocess.run(
    [sys.executable, "-S", "-B", "-m", "biface_tire_model", "check", MADE],
    env=dict(os.environ, PYTHONPATH=str(PACKAGE)), capture_output=True,
    text=True, check=False)
check(done.returncode == 1, f"the exit code is {done.returncode}")
check(done.stderr == "biface-tire-model: scipy for Python is missing (Debian: "
      "python3-scipy).\n", done.stderr)
