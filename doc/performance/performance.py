#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run times of the bias tire against the size of the mesh.

Runs the shipped parameter file as it is and on meshes with two, four, eight and
sixteen times the cells in each direction, on one rank and on two, and writes

    performance.md   times by phase, memory, ratios, growth

Times are those of the program's own timing table. Compare ratios within one set of
runs, since machines and their load differ. A run is repeated only if the program
has changed.
"""

import argparse
import csv
import json
import math
import os
import re
import shutil
import subprocess
from collections import namedtuple
from pathlib import Path

# Refinement, number of steps of the contact stage, ranks, name, further settings
Case = namedtuple("Case", "refinement steps ranks name settings")

LUMPED = ["Contact/Multiplier mass=lumped", "Formulation=standard"]
SLACK = LUMPED + ["Material cord/E_L compression=5.1045"]
MULTIGRID = ["Linear solver/Type=iterative"]

CASES = [
    Case(1, 20, 1, "as shipped", []),
    Case(1, 20, 2, "as shipped", []),
    Case(1, 1, 1, "refined", []),
    Case(1, 1, 2, "refined", []),
    Case(2, 1, 1, "refined", []),
    Case(2, 1, 2, "refined", []),
    Case(4, 1, 1, "refined", []),
    Case(4, 1, 2, "refined", []),
    Case(8, 1, 1, "refined", []),
    Case(8, 1, 2, "refined", []),
    Case(1, 1, 1, "lumped", LUMPED),
    Case(4, 1, 1, "lumped", LUMPED),
    Case(4, 1, 2, "lumped", LUMPED),
    Case(8, 1, 2, "lumped", LUMPED),
    Case(10, 1, 2, "lumped", LUMPED),
    Case(4, 1, 2, "slack", SLACK),
    Case(10, 1, 2, "slack", SLACK),
    Case(16, 1, 2, "slack", SLACK),
    Case(1, 1, 1, "lumped, multigrid", LUMPED + MULTIGRID),
    Case(2, 1, 1, "lumped, multigrid", LUMPED + MULTIGRID),
    Case(4, 1, 1, "lumped, multigrid", LUMPED + MULTIGRID),
    Case(4, 1, 2, "lumped, multigrid", LUMPED + MULTIGRID),
    Case(4, 1, 2, "slack, multigrid", SLACK + MULTIGRID),
    Case(10, 1, 2, "slack, multigrid", SLACK + MULTIGRID),
    Case(16, 1, 2, "slack, multigrid", SLACK + MULTIGRID),
]

# Cells outside the footprint and in it, in alpha_1 and alpha_2, of the meshes with
# a million and three million unknowns. The first has slightly larger cells in the
# footprint than with ten times as many, where the tire would not converge.
CELLS = {10: ((112, 160), (136, 160)), 16: ((192, 288), (224, 304))}

# The sections of the timing table that belong to the linear solver
LINEAR = ("Linear solver: factorization", "Linear solver: solution",
          "Linear solver: multigrid set-up",
          "Linear solver: multigrid iterations")
ANALYSIS = "Linear solver: analysis"
COARSER = "Coarser meshes"


def mesh(refinement):
    """Settings for the refined mesh."""
    n = refinement
    (far_1, near_1), (far_2, near_2) = CELLS.get(
        n, ((12 * n, 18 * n), (11 * n, 18 * n)))
    return [
        f"Mesh/Intervals alpha_1=-120:-45:{far_1}, -45:45:{near_1}, "
        f"45:120:{far_1}",
        f"Mesh/Intervals alpha_2=-180:-15:{far_2}:smooth, "
        f"-15:15:{near_2}, 15:180:{far_2}:smooth",
        f"Mesh/Coarse meshes={round(math.log2(n))}"]


def run(arguments, case):
    """Run a case, and return the sections in seconds and some figures."""
    directory = arguments.scratch / (f"{case.name.replace(' ', '_')}-"
                                     f"{case.refinement}-{case.ranks}")
    result_file = directory / "result.json"
    if (result_file.exists() and result_file.stat().st_mtime >
            arguments.program.stat().st_mtime):
        return json.loads(result_file.read_text(encoding="utf-8"))
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)

    settings = [f"Stage 2/Steps={case.steps}", *case.settings]
    if case.refinement > 1:
        settings += mesh(case.refinement) + ["Output/Write VTU=false"]
    command = [str(arguments.program), "--output", str(directory / "output")]
    for setting in settings:
        command += ["--set", setting]
    command.append(str(arguments.parameters))
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    if case.ranks > 1:
        command = ["mpirun", "-n", str(case.ranks)] + command
        if os.getuid() == 0:
            environment.update(OMPI_ALLOW_RUN_AS_ROOT="1",
                               OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    print(f"{case.name}, refinement {case.refinement}, ranks {case.ranks} ...",
          flush=True)
    done = subprocess.run(command, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    (directory / "screen.txt").write_text(done.stdout, encoding="utf-8")

    sections = {
        name.strip(): (int(calls), float(seconds))
        for name, calls, seconds in re.findall(
            r"^\| (.*?) *\| *(\d+) \| *([0-9.e+-]+)s \|", done.stdout,
            re.MULTILINE)}
    total = re.search(r"Total wallclock time elapsed since start *\| *"
                      r"([0-9.e+-]+)s", done.stdout)
    with open(directory / "output" / "history.csv", encoding="utf-8") as file:
        history = list(csv.DictReader(file))
    coarse = re.search(r"solutions on coarser meshes: ([0-9.e+-]+) s",
                       done.stdout)
    result = {
        "coarse_linear": float(coarse[1]) if coarse else 0,
        "complete": done.returncode == 0,
        "unknowns": int(re.search(r"(\d+) unknowns", done.stdout)[1]),
        "cells": int(re.search(r"(\d+) cells", done.stdout)[1]),
        "iterations": sum(int(row["iterations"]) for row in history),
        "force": float(history[-1]["force"]),
        "memory": float(re.search(r"Peak memory: ([0-9.]+) GiB",
                                  done.stdout)[1]),
        "total": float(total[1]) if total else math.nan,
        "sections": sections}
    result_file.write_text(json.dumps(result, indent=1), encoding="utf-8")
    return result


def linear_time(result):
    """Seconds spent in factorizations and solutions, on all meshes."""
    return result["coarse_linear"] + sum(
        result["sections"].get(name, (0, 0))[1] for name in LINEAR)


def own_time(result):
    """Seconds of the run except those on coarser meshes."""
    return result["total"] - result["sections"].get(COARSER, (0, 0))[1]


def table(header, rows):
    """A Markdown table."""
    lines = ["| " + " | ".join(header) + " |",
             "|" + " --- |" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def number(value):
    """A number with three significant digits, without an exponent."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{digits}f}"


def times_row(case, result):
    """A row of the table of times."""
    def calls(*names):
        return max(1, sum(result["sections"].get(name, (0, 0))[0]
                          for name in names))

    def seconds(*names):
        return sum(result["sections"].get(name, (0, 0))[1] for name in names)

    iterations = calls(LINEAR[1], LINEAR[3])
    factorizations = calls(LINEAR[0], LINEAR[2])
    rest = own_time(result) - seconds("Assembly", ANALYSIS, *LINEAR)
    return [case.name, f"{result['unknowns']:,}", str(case.ranks),
            f"{result['iterations']}" + ("" if result["complete"] else
                                         " (not converged)"),
            str(factorizations),
            number(seconds("Assembly") / iterations),
            number(seconds(ANALYSIS)),
            number(seconds(LINEAR[0], LINEAR[2]) / factorizations),
            number(seconds(LINEAR[1], LINEAR[3]) / iterations),
            number(rest / iterations), number(seconds(COARSER)),
            number(result["total"]),
            f"{result['total'] / linear_time(result):.2f}",
            f"{result['memory']:.2f}"]


def exponent(small, large, key):
    """The exponent with which a quantity grows with the number of unknowns."""
    return (math.log(key(large) / key(small))
            / math.log(large["unknowns"] / small["unknowns"]))


def per_newton_iteration(result):
    """Seconds per iteration on the finest mesh of the run."""
    calls = sum(result["sections"].get(name, (0, 0))[0]
                for name in (LINEAR[1], LINEAR[3]))
    return own_time(result) / max(1, calls)


def kernel_section(arguments):
    """Times and instructions of the element kernel."""
    if not arguments.kernel:
        return ("Not measured: Google's benchmark library was not installed.\n")
    done = subprocess.run(
        [arguments.kernel, "--benchmark_format=json",
         "--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"],
        stdout=subprocess.PIPE, text=True, check=True)
    rows = [[entry["run_name"].replace("_", " "),
             number(entry["cpu_time"] / 1000)]
            for entry in json.loads(done.stdout)["benchmarks"]
            if entry["aggregate_name"] == "median"]
    text = table(["per cell", "microseconds"], rows) + "\n"

    if shutil.which("valgrind"):
        counts = []
        for n in (100, 1100):
            done = subprocess.run(
                ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                 arguments.kernel, "count", str(n)],
                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                check=True)
            counts.append(int(re.search(r"Collected : (\d+)", done.stderr)[1]))
        text += (f"\nAll three together take "
                 f"**{(counts[1] - counts[0]) // 1000:,} instructions** per cell "
                 "(callgrind; compiled with the flags of the build). "
                 "This number does not depend on the load of the machine.\n")
    return text


def write_page(arguments, results):
    """Write the page from all runs."""
    by_key = {(c.name, c.refinement, c.ranks): r for c, r in results}
    page = arguments.template.read_text(encoding="utf-8")

    left_out = sorted({case.refinement for case in CASES}
                      - {case.refinement for case, _ in results})
    missing = "".join(
        f"\nThe mesh with {n} times the cells in each direction was left "
        "out.\n" for n in left_out)
    rows = [times_row(case, result) for case, result in results]
    header = ["case", "unknowns", "ranks", "iterations", "factorizations",
              "assembly", "analysis", "factorization", "solution", "rest", "coarser", "total", "ratio", "memory"]
    values = {"TIMES": table(header, rows) + missing.rstrip("\n"),
              "KERNEL": kernel_section(arguments).rstrip()}

    growth = []
    for name, ranks, n_small, n_large in (
            ("refined", 1, 1, 8), ("refined", 2, 1, 8), ("slack", 2, 4, 16),
            ("slack, multigrid", 2, 4, 16)):
        small, large = (by_key.get((name, n, ranks))
                        for n in (n_small, n_large))
        if small and large:
            growth.append(
                [name, f"{small['unknowns']:,} to {large['unknowns']:,}",
                 str(ranks),
                 f"{exponent(small, large, per_newton_iteration):.2f}",
                 f"{exponent(small, large, lambda r: r['memory']):.2f}"])
    values["GROWTH"] = table(
        ["case", "unknowns", "ranks", "time per iteration", "memory"], growth)
    speed_up = []
    for name, n in (("as shipped", 1), ("refined", 2), ("refined", 4),
                    ("refined", 8), ("lumped", 4)):
        single, double = by_key.get((name, n, 1)), by_key.get((name, n, 2))
        if single and double:
            speed_up.append([name, f"{single['unknowns']:,}",
                             number(single["total"]), number(double["total"]),
                             f"{single['total'] / double['total']:.2f}"])
    values["RANKS"] = table(
        ["case", "unknowns", "1 rank", "2 ranks", "1 rank / 2 ranks"], speed_up)

    for key, value in values.items():
        page = page.replace("@" + key + "@", value)
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "performance.md").write_text(page, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--parameters", type=Path, required=True)
    parser.add_argument("--kernel")
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--max-refinement", type=int, default=16,
                        help="skip finer meshes")
    arguments = parser.parse_args()
    arguments.template = Path(__file__).with_name("performance.md.in")
    results = [(case, run(arguments, case)) for case in CASES
               if case.refinement <= arguments.max_refinement]
    write_page(arguments, results)


if __name__ == "__main__":
    main()
