# SPDX-License-Identifier: LGPL-2.1-or-later

# The program is the one given, or $BIFACE, or the one on PATH; what is not a program is refused.

import os
from pathlib import Path

from python_test import biface, check, error_of, scratch

program = Path(os.environ.pop("BIFACE"))
check(biface.find_program(program) == program.absolute(), "the one given")
os.environ["BIFACE"] = str(program)
check(biface.find_program() == program.absolute(), "$BIFACE")
os.environ["BIFACE"] = str(scratch() / "missing")
message = str(error_of(biface.BifaceError, biface.find_program))
check("missing is not a program" in message, message)
