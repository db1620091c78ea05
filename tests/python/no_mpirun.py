# SPDX-License-Identifier: LGPL-2.1-or-later

# Without mpirun, several ranks are refused with a sentence that names the package.

import os

from python_test import biface, check, error_of, run, scratch

os.environ["PATH"] = str(scratch())
message = str(error_of(biface.BifaceError, run, ranks=2))
check("openmpi-bin" in message, message)
