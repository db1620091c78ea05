# SPDX-License-Identifier: LGPL-2.1-or-later

# An unknown entry raises a RunError with the sentence of the program, on one rank or two.

from python_test import biface, check, error_of, run

for ranks in (1, 2):
    error = error_of(biface.RunError, run, {"Stage 2/Travle": 1}, ranks=ranks)
    check(error.code == 1 and error.results is None, f"the exit code is {error.code}")
    check("there is no entry 'Stage 2/Travle'" in str(error), f"it says: {error}")
    check(not str(error).startswith("biface") and "mpirun" not in str(error),
          f"this is not one sentence of the program: {error}")
