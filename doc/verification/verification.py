#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Benchmarks on three meshes each, against published values.

Runs every parameter file of tests/verification as it is, with half and with
double the cells, and writes

    verification.md      the page: problems, values, deviations, orders
    verification/*.png   load against displacement, where a path is published

The published values are the comments '# expect:' of the parameter files, see
tests/verification/verify.cc; the published paths are tests/data/sze_*.csv. A
run is repeated only when the program or its parameter file has changed.
"""

import argparse
import csv
import math
import re
import subprocess
import textwrap
from collections import namedtuple
from fractions import Fraction
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt

# Cells in each direction, over those of the parameter file
FACTORS = (Fraction(1, 2), Fraction(1), Fraction(2))

# Headings that do not follow from the names of the files
HEADINGS = {
    "cantilever_end_shear": "Cantilever under end shear",
    "clamped_semicylinder": "Clamped semi-cylinder",
    "hemisphere": "Hemisphere, small load",
    "hemisphere_large": "Hemisphere, large load",
    "patch_bending": "Patch test, bending",
    "patch_membrane": "Patch test, membrane",
    "scordelis_lo": "Scordelis-Lo roof",
    "slit_annulus": "Slit annular plate",
    "strip_on_flat": "Strip on a rigid flat",
    "torus_membrane": "Torus under pressure",
}

# Runs besides those on three meshes: settings, by what the tables call them
FURTHER_RUNS = {"slit_annulus": {"in 20 steps": ["Stage 1/Steps=20"]}}

# Values without a published one, so that all meshes can be compared
FURTHER_VALUES = {"hemisphere_large": ["pull middle u_x at 200",
                                       "push middle u_z at 200"]}

# A curve of a path: column of the published file, name of the point, column of
# probes.csv, sign, symbol
Curve = namedtuple("Curve", "published point column sign symbol")

PATHS = {
    "cantilever_end_shear": [
        Curve("minus_U_tip", "tip", "u_x", -1, "$-u_x$ of the tip"),
        Curve("W_tip", "tip", "u_z", 1, "$u_z$ of the tip")],
    "clamped_semicylinder": [
        Curve("minus_W", "crown", "u_x", -1, "$-u_x$ of the crown")],
    "hinged_roof": [
        Curve("minus_W_centre", "center", "u_x", -1, "$-u_x$ of the center")],
    "slit_annulus": [
        Curve("W_inner", "inner", "u_y", 1, "$u_y$, inner radius"),
        Curve("W_outer", "outer", "u_y", 1, "$u_y$, outer radius")],
}

# What the tables do not say by themselves. {0}, {1} ... are the values on the
# finest mesh, in the order of the parameter file, {d[0]} ... their deviations.
REMARKS = {
    "clamped_semicylinder":
        "The displacements still grow a little from mesh to mesh. On the finest "
        "one the deviation at load factor 0.25 is {d[0]:+.1f} %, more than on "
        "the mesh of the parameter file. There the path is flat, so that small "
        "changes of the load are large ones of the displacement.",
    "hemisphere":
        "The reference is the middle of the range of published values, which "
        "spans 1.7 %.",
    "hemisphere_large":
        "The parameter file has no published displacement, only a bound on the "
        "iterations of the single step. The displacements show what the mesh "
        "does.",
    "hinged_roof":
        "A limit load is the turning point of the parabola through three steps "
        "of the path. **Here the results deviate from the reference**: with "
        "finer meshes the upper limit load settles at {0:.4f}, a "
        "deviation of {d[0]:+.1f} %, and not at the reference. The lower one "
        "passes the reference and comes to {1:.4f} on the finest mesh, a "
        "deviation of {d[1]:+.1f} %. No order is given, since these values also "
        "depend a little on where the steps lie.",
    "pinched_cylinder":
        "The reference is that of a thin shell without transverse shear strain. "
        "Here there is such strain, which makes the displacement greater; under "
        "a point force it has, in theory, no bound as the mesh gets finer. So "
        "the limit is only that of these three meshes. How much of the deviation "
        "comes from this has not been examined.",
    "scordelis_lo":
        "Other published values go down to 0.3006.",
    "slit_annulus":
        "The parameter file takes the whole load in one step. The path of the "
        "picture is a run in 20 steps.",
    "squeezed_cylinder":
        "The reference leaves out that the cylinder stretches, by 0.01 %. The "
        "contact area is that of the nodes in contact and jumps by a cell's, "
        "so that its order means little.",
    "strip_on_flat":
        "The contact area is that of the nodes in contact and jumps by a "
        "cell's, here to the next one beyond the exact edge.",
}

STYLE = {
    "font.size": 11,
    "axes.labelsize": 12,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.8,
    "axes.grid": True,
    "grid.color": "0.9",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "savefig.facecolor": "white",
    "savefig.dpi": 160,
}

BLUE, RED = "#1f5fa8", "#c0392b"

# A published value: quantity as in the parameter file, reference as written
# there (None without one)
Expected = namedtuple("Expected", "quantity reference")

# A run: cells over those of the file (None for a further run), name in tables,
# rows of history.csv and probes.csv, whether it came to the end
Run = namedtuple("Run", "factor name history probes complete")

# A parameter file with its runs
Benchmark = namedtuple("Benchmark", "name problem expected runs")


# ---------------------------------------------------------------- parameter files


def read_problem(prm):
    """The comment at the head of a parameter file, without published values."""
    lines = []
    for line in prm.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#") or line.startswith("# expect:"):
            break
        lines.append(line[1:].strip())
    return " ".join(lines)


def read_expected(prm):
    """The published values of a parameter file, then those without one."""
    text = prm.read_text(encoding="utf-8")
    expected = []
    for line in re.findall(r"^# expect: (.*)$", text, re.MULTILINE):
        match = re.fullmatch(r"(.*) is (\S+) within \S+", line)
        expected.append(Expected(*match.groups()) if match else
                        Expected("iterations", line.rsplit(" ", 1)[0]))
    return expected + [Expected(quantity, None)
                       for quantity in FURTHER_VALUES.get(prm.stem, [])]


def read_intervals(prm, direction):
    """The entry 'Mesh/Intervals alpha_1' (or 2): 'begin:end:cells' and so on."""
    pattern = rf"^\s*set\s+Intervals alpha_{direction}\s*=\s*(.*?)\s*$"
    entry = re.search(pattern, prm.read_text(encoding="utf-8"), re.MULTILINE)
    return [interval.strip().split(":") for interval in entry[1].split(",")]


def count_cells(intervals):
    """The number of cells of all intervals of a direction."""
    return sum(int(interval[2]) for interval in intervals)


def refine(intervals, factor):
    """The intervals with that many times the cells; a single cell stays."""
    if count_cells(intervals) == 1:
        return intervals
    return [[begin, end, str(max(1, int(int(cells) * factor))), *grading]
            for begin, end, cells, *grading in intervals]


def mesh_of(prm, factor):
    """Settings for a mesh with that many times the cells, and its name."""
    settings, cells = [], []
    for direction in (1, 2):
        intervals = refine(read_intervals(prm, direction), factor)
        entry = ", ".join(":".join(interval) for interval in intervals)
        settings.append(f"Mesh/Intervals alpha_{direction}={entry}")
        cells.append(str(count_cells(intervals)))
    return ([] if factor == 1 else settings), " × ".join(cells)


# ---------------------------------------------------------------- runs


def read_csv(path):
    """The rows of a CSV file, each by column; comments are left out."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if line[0] != "#"))


def run_program(program, prm, settings, directory):
    """Run the program, unless its results are there, and return its exit code."""
    command = [str(program), "--output", str(directory)]
    for setting in settings:
        command += ["--set", setting]
    command.append(str(prm))

    done = directory.with_suffix(".done")
    newest = max(program.stat().st_mtime, prm.stat().st_mtime)
    if done.exists() and done.stat().st_mtime > newest:
        *words, code = done.read_text(encoding="utf-8").splitlines()
        if words == command:
            return int(code)

    print(f"Running {prm.name} {' '.join(settings)}", flush=True)
    with open(directory.with_suffix(".log"), "w", encoding="utf-8") as log:
        code = subprocess.run(command, stdout=log, stderr=log,
                              check=False).returncode
    # no convergence is a result as well: what was reached is kept
    if code not in (0, 2):
        raise SystemExit(f"{prm.name} failed with exit code {code}; see {log.name}")
    done.write_text("\n".join([*command, str(code)]), encoding="utf-8")
    return code


def make_run(arguments, prm, factor, name, settings):
    """Run the program with these settings and read the results."""
    directory = arguments.scratch / re.sub(r"\W+", "_", f"{prm.stem} {name}")
    code = run_program(arguments.program, prm, settings, directory)
    probes = directory / "probes.csv"
    return Run(factor, name, read_csv(directory / "history.csv"),
               read_csv(probes) if probes.exists() else [], code == 0)


def make_benchmark(arguments, prm):
    """All runs of a parameter file: three meshes, then the further ones."""
    runs = []
    for factor in FACTORS:
        settings, mesh = mesh_of(prm, factor)
        runs.append(make_run(arguments, prm, factor, mesh, settings))
    _, mesh = mesh_of(prm, 1)
    for name, settings in FURTHER_RUNS.get(prm.stem, {}).items():
        runs.append(make_run(arguments, prm, None, f"{mesh}, {name}", settings))
    return Benchmark(prm.stem, read_problem(prm), read_expected(prm), runs)


# ---------------------------------------------------------------- values


def turning_value(y, i):
    """The turning point of y by a parabola through the values around i."""
    slope = (y[i + 1] - y[i - 1]) / 2
    curvature = y[i + 1] - 2 * y[i] + y[i - 1]
    return y[i] - slope ** 2 / (2 * curvature)


def limit_load(run, sign):
    """The first maximum (sign 1) or minimum (-1) of the load factor."""
    y = [0] + [float(row["load_factor"]) for row in run.history]
    for i in range(1, len(y) - 1):
        if sign * y[i] > sign * y[i - 1] and sign * y[i] >= sign * y[i + 1]:
            return turning_value(y, i)
    return None


def find_step(run, when):
    """The last row of history.csv of a stage ('end of STAGE') or with a load
    factor, None if it was not reached."""
    stage = re.fullmatch("end of (.*)", when)
    # the last stage of a run that stopped early may not have come to its end
    if stage and not run.complete and run.history[-1]["stage"] == stage[1]:
        return None
    rows = [row for row in run.history
            if (row["stage"] == stage[1] if stage else
                math.isclose(float(row["load_factor"]), float(when),
                             abs_tol=1e-9))]
    return rows[-1] if rows else None


def find_value(run, words, when):
    """A column of history.csv ('history COLUMN') or of probes.csv ('NAME FACE
    COLUMN') at the end of a stage or a load factor, None if not reached."""
    step = find_step(run, when)
    if step is None:
        return None
    if words[0] == "history":
        return float(step[words[1]])
    for row in run.probes:
        if [row["step"], row["name"], row["face"]] == [step["step"], *words[:2]]:
            return float(row[words[2]])
    return None


def count_iterations(run):
    """The Newton iterations of all converged steps together."""
    return sum(int(row["iterations"]) for row in run.history)


def evaluate(run, quantity):
    """What a run has for a quantity of the parameter file, None if nothing."""
    if quantity == "iterations":
        return count_iterations(run)
    if quantity.endswith("load factor"):
        return limit_load(run, 1 if quantity.startswith("greatest") else -1)
    what, when = quantity.split(" at ")
    return find_value(run, what.split(), when)


def is_column(expected):
    """Whether the quantity is a column of results at some step."""
    return " at " in expected.quantity


def deviation(computed, reference):
    """The deviation from a published value in percent, None without either."""
    try:
        return 100 * (computed / float(reference) - 1)
    except (TypeError, ValueError):
        return None


def convergence(benchmark, quantity):
    """Order and limit by Richardson's extrapolation from three meshes.

    The values are those for cells of size 4 h, 2 h, h; the error is taken as
    C h^p. None where the values do not approach a limit from one side, and
    where p < 1: that is not an order, the meshes are too coarse for the formula.
    None, too, where the values differ by little more than round-off.
    """
    values = [evaluate(run, quantity) for run in benchmark.runs if run.factor]
    if None in values:
        return None
    coarse, middle, fine = values
    if (abs(fine - middle) <= 1e-8 * abs(fine) or
            (middle - coarse) / (fine - middle) < 2):
        return None
    ratio = (middle - coarse) / (fine - middle)
    return math.log2(ratio), fine + (fine - middle) / (ratio - 1)


# ---------------------------------------------------------------- pictures


def path_run(benchmark):
    """The run whose path is shown: the mesh of the file, in most steps."""
    return max((run for run in benchmark.runs if run.factor in (1, None)),
               key=lambda run: len(run.history))


def plot_computed(axes, run, curve, color):
    """The path of a run, from the origin on."""
    rows = [row for row in run.probes
            if (row["name"], row["face"]) == (curve.point, "middle")]
    axes.plot([0] + [curve.sign * float(row[curve.column]) for row in rows],
              [0] + [float(row["load_factor"]) for row in rows], color=color,
              label=f"{curve.symbol}, computed")


def plot_published(axes, rows, curve, name):
    """The published path, as circles."""
    axes.plot([float(row[curve.published]) for row in rows],
              [float(row["P_over_Pmax"]) for row in rows], "o", color="black",
              markersize=5, markerfacecolor="none", zorder=3, label=name)


def draw_path(benchmark, data, output):
    """The load factor against displacements, computed and published."""
    curves = PATHS[benchmark.name]
    run = path_run(benchmark)
    rows = read_csv(data / f"sze_{benchmark.name}.csv")
    figure, axes = plt.subplots(figsize=(7, 4.6))
    for curve, color in zip(curves, (BLUE, RED)):
        plot_computed(axes, run, curve, color)
    for curve in curves:
        plot_published(axes, rows, curve, "Sze, Liu, Lo (2004)"
                       if curve is curves[-1] else None)
    axes.set(xlabel="displacement", ylabel="load factor",
             xlim=(0, None), ylim=(0, None))
    axes.legend(loc="best", fontsize=11)
    figure.savefig(output / f"{benchmark.name}.png", bbox_inches="tight",
                   pad_inches=0.08)
    plt.close(figure)


# ---------------------------------------------------------------- page

INTRODUCTION = """\
# Verification

Problems with published solutions or exact ones in closed form, as tests run
them, and what comes out on coarser and finer meshes. The parameter files are in
`tests/verification`, and this page is written by a program from runs of them:

```sh
cmake --build build --target verification
```

It takes a few minutes and needs Python with matplotlib (on Debian
`python3-matplotlib`; run cmake again after installing it). Runs are repeated
only when the program or their parameter file has changed.

Lengths, forces and moduli have no units here: any consistent set does.
Displacements are those of points named in the parameter file, on the middle
surface (the mean of both faces) unless a face is named; the load factor is the
part of the load that acts. Other quantities are columns of `history.csv`, see
[output.md](output.md). The mesh is the number of cells along `alpha_1` and
`alpha_2`. The mesh of the parameter file is in bold, the others have half and
double its cells in each direction that has more than one. The deviation is
computed less reference, in percent of the reference.

The order is that of the quantity, by Richardson's extrapolation from the three
meshes: if the error goes as a power $`p`$ of the size of the cells,
$`p = \\log_2 \\bigl((u_{\\mathrm{middle}} - u_{\\mathrm{coarse}}) / (u_{\\mathrm{fine}} - u_{\\mathrm{middle}})\\bigr)`$.
The limit is what the meshes converge to by the same formula. Both are left out
where the values do not approach a limit from one side, or so slowly that the
order would be below 1: there the meshes are too coarse for the formula; and
where they differ by little more than round-off. Under a point force the order
is not that of a smooth problem.

Newton iterations are those of the converged steps, all together.

The reference of the four problems with pictures is K. Y. Sze, X. H. Liu,
S. H. Lo, Popular benchmark problems for geometric nonlinear analysis of shells,
Finite Elements in Analysis and Design 40 (2004) 1551-1569. Its values are
computed as well, with another shell element and meshes of its own, so a small
deviation need not be an error of either.
"""


def heading(name):
    """The heading of a benchmark."""
    return HEADINGS.get(name, name.replace("_", " ").capitalize())


def fill(text):
    """A paragraph in lines of the width of the other pages."""
    return textwrap.fill(text, 80, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def percent(value):
    """A deviation in percent, or a dash where there is none."""
    return "–" if value is None else f"{round(value, 2) + 0:+.2f}"


def digits(value):
    """A computed value with five digits; counts as they are."""
    return str(value) if isinstance(value, int) else f"{value:#.5g}"


def label(quantity):
    """A quantity as the tables name it."""
    if " at " not in quantity:
        return {"iterations": "Newton iterations"}.get(quantity, quantity)
    what, when = quantity.split(" at ")
    stage = re.fullmatch("end of (.*)", when)
    when = f"the end of `{stage[1]}`" if stage else f"load factor {when}"
    words = what.split()
    if words[0] == "history":
        return f"`{words[1]}` at {when}"
    face = "" if words[1] == "middle" else f", {words[1]} face,"
    return f"`{words[2]}` of `{words[0]}`{face} at {when}"


def table(header, rows, n_words):
    """A table in Markdown; the columns after the first n_words are numbers."""
    ruler = ["---" if i < n_words else "---:" for i in range(len(header))]
    return "".join("| " + " | ".join(row) + " |\n"
                   for row in [header, ruler, *rows])


def run_name(run):
    """A run in tables: the mesh of the parameter file is in bold."""
    return f"**{run.name}**" if run.factor == 1 else run.name


def value_rows(benchmark):
    """Each published value beside those of all runs."""
    rows = []
    for expected in benchmark.expected:
        for run in benchmark.runs:
            # a bound on the iterations of one step is not one on those of many
            if expected.quantity == "iterations" and run.factor is None:
                continue
            value = evaluate(run, expected.quantity)
            rows.append([run_name(run), label(expected.quantity),
                         expected.reference or "–",
                         "not reached" if value is None else digits(value),
                         percent(deviation(value, expected.reference))])
    return rows


def step_rows(benchmark):
    """Steps and iterations of all runs."""
    return [[run_name(run),
             "yes" if run.complete else
             f"no, up to load factor {float(run.history[-1]['load_factor']):.4f}",
             str(len(run.history)), str(count_iterations(run))]
            for run in benchmark.runs]


def order_rows(benchmark):
    """Order and limit of columns of results, where there are any."""
    rows = []
    for expected in filter(is_column, benchmark.expected):
        result = convergence(benchmark, expected.quantity)
        if result:
            order, limit = result
            rows.append([label(expected.quantity),
                         f"{order:.1f}", digits(limit),
                         percent(deviation(limit, expected.reference))])
    return rows


def remark(benchmark):
    """What is to be said about a benchmark, with its values filled in."""
    finest = benchmark.runs[len(FACTORS) - 1]
    values = [evaluate(finest, expected.quantity)
              for expected in benchmark.expected]
    deviations = [deviation(value, expected.reference)
                  for value, expected in zip(values, benchmark.expected)]
    return REMARKS[benchmark.name].format(*values, d=deviations)


def section(benchmark):
    """The part of the page about one benchmark."""
    parts = [f"## {heading(benchmark.name)}\n", fill(benchmark.problem),
             fill(f"Parameter file: `tests/verification/{benchmark.name}.prm`.")]
    if benchmark.name in PATHS:
        parts.append(f"![{heading(benchmark.name)}: load factor against "
                     f"displacement](verification/{benchmark.name}.png)\n")
        parts.append(f"*The computed path is that on the mesh "
                     f"{path_run(benchmark).name}.*\n")
    parts.append(table(["Mesh", "Quantity", "Reference", "Computed",
                        "Deviation (%)"], value_rows(benchmark), 2))
    orders = order_rows(benchmark)
    if orders:
        parts.append(table(["Quantity", "Order", "Limit",
                            "Deviation of limit (%)"], orders, 1))
    parts.append(table(["Mesh", "Whole load", "Steps", "Newton iterations"],
                       step_rows(benchmark), 2))
    if not all(run.complete for run in benchmark.runs):
        parts.append(fill("Where the whole load is not reached, Newton's method "
                          "no longer converges, even in much smaller steps."))
    if benchmark.name in REMARKS:
        parts.append(fill(remark(benchmark)))
    return "\n".join(parts)


def summary(benchmarks):
    """The greatest deviation of each benchmark, by mesh."""
    rows = []
    for benchmark in benchmarks:
        row = [heading(benchmark.name)]
        for run in (run for run in benchmark.runs if run.factor):
            deviations = [deviation(evaluate(run, expected.quantity),
                                    expected.reference)
                          for expected in benchmark.expected]
            found = [d for d in deviations if d is not None]
            row.append(percent(max(found, key=abs, default=None)) +
                       ("" if run.complete else " (part of the load)"))
        if row[1:] != ["–"] * len(FACTORS):
            rows.append(row)
    return ("## Greatest deviations\n\nIn percent of the reference.\n\n" +
            table(["Problem", "Half the cells", "As in the file",
                   "Double the cells"], rows, 1))


# ---------------------------------------------------------------- program


def parse_arguments():
    """The program, its parameter files, and where the results go."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name, text in (("program", "the program biface"),
                       ("parameters", "directory of the parameter files"),
                       ("data", "directory of the published paths, sze_*.csv"),
                       ("scratch", "directory for the results of the runs"),
                       ("output", "directory of the page, doc/")):
        parser.add_argument(f"--{name}", type=Path, required=True, help=text)
    return parser.parse_args()


def main():
    """Run all benchmarks, draw the pictures, write the page."""
    arguments = parse_arguments()
    arguments.scratch.mkdir(parents=True, exist_ok=True)
    pictures = arguments.output / "verification"
    pictures.mkdir(parents=True, exist_ok=True)
    plt.rcParams.update(STYLE)
    benchmarks = [make_benchmark(arguments, prm)
                  for prm in sorted(arguments.parameters.glob("*.prm"))]
    for benchmark in benchmarks:
        if benchmark.name in PATHS:
            draw_path(benchmark, arguments.data, pictures)
    page = "\n".join([INTRODUCTION, summary(benchmarks),
                      *map(section, benchmarks)])
    (arguments.output / "verification.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
