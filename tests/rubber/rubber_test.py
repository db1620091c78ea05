# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of biface-rubber."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/report"))

from report_test import (PACKAGE, SOURCE, check, check_refused_by, require, run_alone_here,
                         run_command, scratch)

sys.path.insert(0, str(PACKAGE))

# Ogden's constants for Treloar's rubber, in MPa: Proceedings of the Royal Society of
# London A 326, 1972
OGDEN = {"mu_i": (0.63, 0.0012, -0.01), "alpha_i": (1.3, 5, -2)}

TRELOAR = SOURCE / "prm/rubber_treloar.csv"


def rubber(*words):
    """Runs biface-rubber; returns its exit code, its output, its error messages."""
    return run_command("biface-rubber", *words)


def rubber_here(*words):
    """The same without the time that a new process takes."""
    from biface_rubber.program import main
    return run_alone_here(main, "biface-rubber", *words)


def output_of(*words):
    """The output of biface-rubber, which must succeed."""
    code, output, errors = rubber_here(*words)
    check(code == 0 and errors == "", f"the exit code is {code}: {errors}")
    return output


def entries_of(output):
    """The entries of the section: lists of numbers, but for `Type`."""
    lines = [line.split("=") for line in output.splitlines()
             if line.startswith("  set ")]
    return {entry.split()[1]: value.strip() if "Type" in entry
            else [float(number) for number in value.split(",")]
            for entry, value in lines}


def write(path, points):
    """Writes points: test, stretch, stress."""
    path.write_text("test, stretch, stress\n" + "".join(
        f"{test}, {stretch!r}, {stress!r}\n" for test, stretch, stress in points),
        encoding="utf-8")
    return path


def curves(law, tests=("uniaxial", "equibiaxial", "planar")):
    """Points of a law up to the stretches of Treloar's tests."""
    import numpy as np
    ends = {"uniaxial": 7.6, "equibiaxial": 4.45, "planar": 4.97}
    return [(test, float(stretch), float(stress)) for test in tests
            for stretches in [np.linspace(1.05, ends[test], 20)]
            for stretch, stress in zip(stretches, law.stress(test, stretches))]
