# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of biface-tire."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/report"))

from report_test import (PACKAGE, SOURCE, check, check_refused_by, require, run_command,
                         run_here, scratch)

sys.path.insert(0, str(PACKAGE))
require("numpy", "scipy")


def tire(*words):
    """Runs biface-tire, see run_here()."""
    from biface_tire.program import main
    return run_here(main, *words)


def output_of(*words):
    """The output of biface-tire, which must succeed."""
    code, output, errors = tire(*words)
    check(code == 0 and errors == "", f"{words}: the exit code is {code}: {errors}")
    return output


def check_refused(words, sentence):
    """Checks that words of the command line are refused with one sentence."""
    check_refused_by("biface-tire", tire(*words), sentence, words)


def check_close(computed, expected, tolerance, what):
    """Checks that numbers agree up to a relative tolerance."""
    check(abs(computed - expected) <= tolerance * abs(expected),
          f"{what} is {computed}, not {expected}")
