# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of biface-tire."""

import contextlib
import io
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/report"))

from report_test import PACKAGE, SOURCE, check, require, run_command, scratch

sys.path.insert(0, str(PACKAGE))
require("numpy", "scipy")


def tire(*words):
    """Runs biface-tire without the time that a new process takes; returns its exit code,
    its output, its error messages."""
    from biface_tire.program import main
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            code = main([str(word) for word in words])
        except SystemExit as end:
            code = end.code
    return code, output.getvalue(), errors.getvalue()


def output_of(*words):
    """The output of biface-tire, which must succeed."""
    code, output, errors = tire(*words)
    check(code == 0 and errors == "", f"{words}: the exit code is {code}: {errors}")
    return output


def check_refused(words, sentence):
    """Checks that words of the command line are refused with one sentence."""
    code, output, errors = tire(*words)
    check(code == 1 and output == "", f"{words}: the exit code is {code}: {output}{errors}")
    check(sentence in errors and errors.startswith("biface-tire: ")
          and errors.count("\n") == 1 and errors.endswith(".\n"),
          f"{words}: '{sentence}' is not told in one sentence: {errors}")


def check_close(computed, expected, tolerance, what):
    """Checks that numbers agree up to a relative tolerance."""
    check(abs(computed - expected) <= tolerance * abs(expected),
          f"{what} is {computed}, not {expected}")
