# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cord angle and the radius of the profile of the bias tire for which the
pressure of its footprint is most even at a given force, without more tension in the
cords.

An example of an optimizer outside of the program: SciPy's SLSQP, sequential quadratic
programming, which obeys bounds and constraints and needs the derivatives of the
objective and of the constraint. The program writes both into sensitivities.csv.
"""

import csv
import resource
import subprocess

import numpy as np
from scipy.optimize import minimize

FORCE = 1900  # N
BASE = {"angle": 52., "radius": 50.}
RANGES = {"angle": (46., 60.), "radius": (44., 56.)}
OBJECTIVE, LIMITED = "weighted_pressure", "max_fiber_tension"
SAMPLES = 24  # of the study for the map; a quadratic polynomial has 6 coefficients

# How the entries of prm/bias_tire_true_pressure.prm depend on the variables
ENTRIES = ("angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
           "-Laminate/Plies[8]; radius: Surface/Circular arc/Radius")
# The mesh has half the cell size of the base file where the tire touches the ground
SETTINGS = (
    "Mesh/Intervals alpha_1=-120:-45:10,-45:45:36,45:120:10",
    "Mesh/Intervals alpha_2=-180:-15:10:smooth,-15:15:30,15:180:10:smooth",
    "Stage 2/Control=foundation force", f"Stage 2/Force={FORCE}",
    "Stage 2/Travel=unchanged", "Stage 2/Steps=2",
    "Contact/Multiplier mass=lumped", "Newton/Residual tolerance=1e-10",
    "Output/Write VTU=false")

STUDY = """subsection Study
  set Base file = {base}
  set Settings  = {settings}
  set Variables = {entries}
  set Sampling  = Latin hypercube
  set Values    = {values}
  set Number of samples = {samples}
  set Outputs   = {outputs}
end
"""


def read(path):
    """The lines of a CSV file as dictionaries."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def cpu_seconds():
    """The CPU time of all runs so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Tire:
    """Runs the tire with other values of the variables, each once."""

    def __init__(self, program, base, scratch, derivatives):
        self.program, self.base, self.scratch = program, base, scratch
        self.derivatives = derivatives
        self.points, self.results = [], []
        self.seconds = 0.

    def __call__(self, point):
        """The last line of history.csv as numbers, and the gradients of the
        objective and of what is limited."""
        point = [float(value) for value in point]
        if point not in self.points:
            self.results.append(self.run(*point))
            self.points.append(point)
        return self.results[self.points.index(point)]

    def run(self, angle, radius):
        """Runs the program."""
        directory = self.scratch / f"run-{len(self.points) + 1}"
        plies = ", ".join(f"cord: 1.2 @ {sign}{angle!r}" for sign in ("", "-") * 2)
        settings = [*SETTINGS, f"Laminate/Plies={plies}",
                    f"Surface/Circular arc/Radius={radius!r}"]
        if self.derivatives:
            settings += [f"Sensitivities/Entries={ENTRIES}",
                         f"Sensitivities/Outputs={OBJECTIVE}, {LIMITED}"]
        words = [word for setting in settings for word in ("--set", setting)]
        start = cpu_seconds()
        subprocess.run([self.program, "--quiet", "--output", directory, *words,
                        self.base], check=True)
        self.seconds += cpu_seconds() - start
        last = {name: float(value)
                for name, value in read(directory / "history.csv")[-1].items()
                if name != "stage" and value}
        gradients = {OBJECTIVE: {}, LIMITED: {}}
        if self.derivatives:
            for line in read(directory / "sensitivities.csv"):
                gradients[line["output"]][line["entry"]] = float(line["derivative"])
        return last, gradients


def optimize(tire):
    """The best values of the variables. All numbers of the optimizer are relative:
    the variables to half of their ranges, the results to those of the base."""
    center = np.mean(list(RANGES.values()), axis=1)
    size = np.diff(list(RANGES.values()))[:, 0] / 2
    base = tire(BASE.values())[0]

    def value(name):
        return lambda x: tire(center + size * x)[0][name] / base[name]

    def gradient(name):
        def function(x):
            derivatives = tire(center + size * x)[1][name]
            return size * [derivatives[entry] for entry in RANGES] / base[name]
        return function if tire.derivatives else None

    limit = {"type": "ineq", "fun": lambda x: 1 - value(LIMITED)(x)}
    if tire.derivatives:
        limit["jac"] = lambda x: -gradient(LIMITED)(x)
    result = minimize(
        value(OBJECTIVE), (np.array(list(BASE.values())) - center) / size,
        jac=gradient(OBJECTIVE), bounds=[(-1, 1)] * len(RANGES), method="SLSQP",
        constraints=[limit], options={"ftol": 1e-5, "eps": 1e-3})
    if not result.success:
        raise RuntimeError(result.message)
    return center + size * result.x


def check(tire, other):
    """Derivatives at the base, with those by central differences of runs of another
    tire."""
    gradients = tire(BASE.values())[1]
    rows = []
    for name in (OBJECTIVE, LIMITED):
        for entry, value in BASE.items():
            step = 1e-4 * value
            ends = [other({**BASE, entry: value + side * step}.values())[0][name]
                    for side in (-1, 1)]
            rows.append((name, entry, gradients[name][entry],
                         (ends[1] - ends[0]) / (2 * step)))
    return rows


class Polynomial:
    """A quadratic polynomial of the variables, fitted to samples."""

    def __init__(self, lines, name):
        self.center = np.mean(list(RANGES.values()), axis=1)
        terms = [self.terms([float(line[entry]) for entry in RANGES])
                 for line in lines]
        self.coefficients = np.linalg.lstsq(
            np.array(terms), [float(line[name]) for line in lines], rcond=None)[0]

    def terms(self, point):
        """The monomials at a point."""
        x, y = np.asarray(point) - self.center
        return [1, x, y, x * x, x * y, y * y]

    def __call__(self, point):
        return float(self.terms(point) @ self.coefficients)


def sample(program, base, directory, ranks):
    """The lines of a study of the ranges."""
    directory.mkdir(parents=True, exist_ok=True)
    file = directory / "even.prm"
    file.write_text(STUDY.format(
        base=base, settings="; ".join(SETTINGS), entries=ENTRIES, samples=SAMPLES,
        values="; ".join(f"{name}: {low}:{high}"
                         for name, (low, high) in RANGES.items()),
        outputs=f"{OBJECTIVE}, {LIMITED}"), encoding="utf-8")
    subprocess.run([*ranks, program, "--study", "--quiet", "--output", directory,
                    file], check=True)
    return [line for line in read(directory / "study.csv")
            if line["status"] == "ok"]
