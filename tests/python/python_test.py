# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of the Python package."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/report"))

from report_test import (BUILD, PACKAGE, SOURCE, check, check_equal, read_csv, require,
                         run_command, scratch)

sys.path.insert(0, str(PACKAGE))
require("numpy")

import biface

TIRE = SOURCE / "prm/bias_tire.prm"
# A coarse mesh, and few steps
COARSE = {"Mesh/Intervals alpha_1": "-120:120:14",
          "Mesh/Intervals alpha_2": "-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
          "Stage 2/Steps": 2, "Output/Write VTU": False}
# A step that does not converge
TOO_FAR = {**COARSE, "Stage 2/Travel": 90, "Step control/Maximum cuts": 1}


def run(settings=None, output=None, **options):
    """The results of the coarse tire."""
    return biface.run(TIRE, {**COARSE, **(settings or {})}, output or scratch(),
                      **options)


def error_of(kind, function, *words, **options):
    """The error that a call raises, which must be of this kind."""
    try:
        function(*words, **options)
    except kind as error:
        check(type(error) is kind, f"this is a {type(error)}, not a {kind}")
        return error
    check(False, f"there is no {kind.__name__}")
    return None


def check_close(computed, expected, tolerance, what):
    """Checks that numbers agree up to a relative tolerance."""
    check(abs(computed - expected) <= tolerance * abs(expected),
          f"{what} is {computed}, not {expected}")
