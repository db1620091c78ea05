# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts biface-tire if it has what it needs."""

import sys

from biface_report.command_line import complain, missing_module

# Required modules, and the Debian packages that provide them; SciPy brings NumPy
missing = missing_module({"scipy": "python3-scipy"})
if missing:
    sys.exit(complain("biface-tire", missing))

from .program import main

sys.exit(main())
