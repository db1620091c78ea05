#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""No change makes the library slower unnoticed: the instructions that it takes in
some short runs, counted by callgrind, are those of the table instructions.csv.

    instructions.py --program count_instructions --build "GCC 12.2 ..."
    instructions.py ... --write     # writes the table anew

Only the library's own instructions count: those of BLAS, MUMPS, Trilinos and the loader
depend on the processor. They do not depend on the load of the machine, but on the
compiler and its options, which the first line of the table names. With others, or
without valgrind, the exit code is 77: skipped.
"""

import argparse
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
TABLE = os.path.join(HERE, "instructions.csv")
TOLERANCE = 0.02
SKIPPED = 77

COARSE = ["Mesh/Intervals alpha_1=-120:120:8",
          "Mesh/Intervals alpha_2=-180:-20:2:smooth,-20:20:4,20:180:2:smooth"]

# a parameter file, and the entries that differ
RUNS = {
    "tire": ["bias_tire.prm", *COARSE, "Stage 2/Steps=2"],
    # a sample of study_of_footprint.prm
    "footprint": ["bias_tire_true_pressure.prm", *COARSE, "Stage 2/Steps=1",
                  "Contact/Multiplier mass=lumped", "Newton/Residual tolerance=1e-10"],
    # rolls freely
    "rolling": ["rolling_tire.prm", *COARSE, "Number of stages=3"],
    "layers": ["sandwich_plate.prm", "Mesh/Intervals alpha_1=0:5:5",
               "Mesh/Intervals alpha_2=0:5:5"],
    "rubber": ["rubber_balloon.prm", "Mesh/Intervals alpha_1=0:80:8",
               "Number of stages=1", "Stage 1/Control value=10", "Stage 1/Steps=4"],
    "modes": ["tire_modes.prm", *COARSE, "Number of stages=2", "Stage 1/Modes=0",
              "Stage 2/Modes=4"],
}


def read_table():
    """The build of the table, and its counts by the names of the runs."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        build = file.readline().removeprefix("#").strip()
        return build, {row["run"]: int(row["instructions"])
                       for row in csv.DictReader(file)}


def write_table(build, counts):
    """Write the table."""
    with open(TABLE, "w", encoding="utf-8") as file:
        file.write(f"# {build}\nrun,instructions\n")
        file.writelines(f"{name},{counts[name]}\n" for name in RUNS)


def own_instructions(profile):
    """The instructions in libbiface of a file of callgrind, without those that it
    calls elsewhere."""
    names = {}
    total = 0
    own = False
    called = False
    with open(profile, encoding="utf-8", errors="replace") as file:
        for line in file:
            if line.startswith("ob="):
                number, name = re.match(r"ob=(\(\d+\))(?: (.*))?", line).groups()
                name = names.setdefault(number, name)
                own = os.path.basename(name).startswith("libbiface.")
            elif line.startswith("cob="):
                number, name = re.match(r"cob=(\(\d+\))(?: (.*))?", line).groups()
                names.setdefault(number, name)
            elif line.startswith("calls="):
                # the next line is the cost of what is called
                called = True
            elif re.match(r"[\d+*-]", line):
                if own and not called:
                    total += int(line.split()[1])
                called = False
    return total


def count(program):
    """The library's own instructions in each run."""
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", HWLOC_HIDE_ERRORS="2",
                       # the same rounding, and so iterations, on any processor
                       OPENBLAS_CORETYPE="Nehalem",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    with tempfile.TemporaryDirectory() as scratch:
        profile = os.path.join(scratch, "profile")
        command = ["valgrind", "--tool=callgrind", "--instr-atstart=no",
                   "--dump-line=no", f"--callgrind-out-file={profile}", program]
        for name, (file, *entries) in RUNS.items():
            command += ["--run", os.path.join(ROOT, "prm", file),
                        "--output", os.path.join(scratch, name)]
            # checkpoints are written by the clock
            for entry in [*entries, "Checkpoint/Write=false", "Output/Write VTU=false"]:
                command += ["--set", entry]
        run = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            sys.exit(f"A run failed:\n{run.stderr}")
        return {name: own_instructions(f"{profile}.{number}")
                for number, name in enumerate(RUNS, 1)}


def compare(name, expected, found):
    """Whether the count agrees with that of the table."""
    change = found / expected - 1
    print(f"{name}: {found:,} instructions, {100 * change:+.2f} % of {expected:,}")
    if change > TOLERANCE:
        print("The library has become slower. If there is a reason, give it in the "
              "commit that updates the table (target 'instructions').")
    elif change < -TOLERANCE:
        print("The library has become faster: update the table (target "
              "'instructions'), so that it stays so.")
    return abs(change) <= TOLERANCE


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", help="count_instructions")
    parser.add_argument("--build", required=True, help="compiler and options")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()

    build, expected = read_table()
    if not shutil.which("valgrind"):
        print("valgrind is missing")
        return SKIPPED
    if build != arguments.build and not arguments.write:
        print(f"The table is that of {build}; this build is {arguments.build}")
        return SKIPPED

    counts = count(arguments.program)
    if arguments.write:
        write_table(arguments.build, counts)
        return 0
    agree = [compare(name, expected[name], counts[name]) for name in RUNS]
    return 0 if all(agree) else 1


if __name__ == "__main__":
    sys.exit(main())
