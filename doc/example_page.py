# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of pages about examples have in common: arguments, runs of
an example with entries changed, and tables."""

import argparse
import csv
import math
import subprocess
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[1] / "prm"


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
        """The directory of the results."""
        directory = self.scratch / name
        command = [self.program, "--quiet", EXAMPLES / example,
                   "--output", directory, "--set", "Output/Write VTU=false"]
        for entry, value in entries.items():
            command += ["--set", f"{entry}={value}"]
        subprocess.run(command, check=not may_stop, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL if may_stop else None)
        return directory


def lines_of(path):
    """The lines of a CSV file as dictionaries."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def last_step(directory, stage):
    """The number of the last step of a stage."""
    return max(int(line["step"])
               for line in lines_of(directory / "history.csv")
               if line["stage"] == stage)


def section(directory, step, face):
    """Axial coordinate and distance from the axis of a face along its profile
    after a step."""
    points = lines_of(directory / f"profile-{step:04d}.csv")
    return ([float(p[f"{face}_y"]) for p in points],
            [math.hypot(float(p[f"{face}_x"]), float(p[f"{face}_z"]))
             for p in points])


def table(header, rows):
    """A table in Markdown, with numbers from the second column on."""
    lines = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
