# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of pages about examples have in common: arguments, runs of
an example with entries changed, and tables."""

import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "source/python"))
import biface

EXAMPLES = ROOT / "prm"


def parse_arguments(page, description):
    """The arguments of a script that writes a page; its directories exist."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--scratch", type=Path, default=Path(f"{page}_runs"),
                        help="where the runs write their results")
    parser.add_argument("--output", type=Path, required=True,
                        help=f"where to write {page}.md and its pictures")
    arguments = parser.parse_args()
    arguments.scratch.mkdir(parents=True, exist_ok=True)
    (arguments.output / "figures").mkdir(parents=True, exist_ok=True)
    return arguments


class Runs:
    """Runs of examples with entries changed."""

    def __init__(self, arguments):
        self.program, self.scratch = arguments.program, arguments.scratch

    def run(self, name, example, entries, may_stop=False):
        """The results."""
        return biface.run(EXAMPLES / example, {"Output/Write VTU": False, **entries},
                          self.scratch / name, program=self.program,
                          may_stop=may_stop)


def section(results, step, face):
    """Axial coordinate and distance from the axis of a face along its profile
    after a step."""
    profile = results.profile(step)
    return (profile[f"{face}_y"],
            np.hypot(profile[f"{face}_x"], profile[f"{face}_z"]))


def table(header, rows):
    """A table in Markdown, with numbers from the second column on."""
    lines = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
