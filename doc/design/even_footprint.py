# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cord angle and the radius of the profile of the bias tire for which the
pressure of its footprint is most even at a given force.

An example of an optimizer outside of the program: SciPy chooses the samples of a
study from its table. The nodes enter and leave the footprint one by one, so that the
unevenness has kinks at small distances, between which its derivatives say nothing
about the trend: they hold the nodes in contact fixed, as do differences over short
distances. So the optimizer takes a quadratic polynomial, fitted to a study of the
whole range and then to one of half the range around its minimum, and the derivatives
of the polynomial.
"""

import csv
import math
import subprocess

import numpy as np
from scipy.optimize import minimize

FORCE = 1900  # N
CENTER_RADIUS, HALF_THICKNESS = 200, 2.4  # mm, of prm/bias_tire.prm
RANGES = {"angle": (46., 60.), "radius": (44., 56.)}
SAMPLES = 24  # of each study; the polynomial has 6 coefficients

# The mesh has half the cell size of the base file where the tire touches the ground
STUDY = """subsection Study
  set Base file = {base}
  set Settings  = Mesh/Intervals alpha_1=-120:-45:10,-45:45:36,45:120:10; \\
                  Mesh/Intervals alpha_2=-180:-15:10:smooth,-15:15:30,15:180:10:smooth; \\
                  Stage 2/Control=foundation force; Stage 2/Force={force}; \\
                  Stage 2/Travel=unchanged; Stage 2/Steps=2; \\
                  Contact/Multiplier mass=lumped; Output/Write VTU=false
  set Variables = angle: Laminate/Plies[2], -Laminate/Plies[4], \\
                         Laminate/Plies[6], -Laminate/Plies[8]; \\
                  radius: Surface/Circular arc/Radius
  set Sampling  = {sampling}
  set Values    = {values}
  set Number of samples = {samples}
  set Seed      = {seed}
  set Outputs   = force, approach, mean_pressure
end
"""


def read(path):
    """The lines of a CSV file as dictionaries."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def weights(coordinates):
    """The lengths that belong to nodes at ascending coordinates."""
    halves = np.diff(coordinates) / 2
    return np.append(halves, 0) + np.insert(halves, 0, 0)


def unevenness(directory, radius, step):
    """The standard deviation of the pressure over the force, that is, weighted by
    the part of the force that it carries, relative to its mean: 0 if all of the
    ground that carries is under the same pressure."""
    nodes = read(directory / f"contact-{step:04d}.csv")
    lines = [sorted({float(node[f"alpha_{a}"]) for node in nodes}) for a in (1, 2)]
    pressure = np.zeros([len(line) for line in lines])
    for node in nodes:
        at = tuple(line.index(float(node[f"alpha_{a}"]))
                   for a, line in zip((1, 2), lines))
        pressure[at] = float(node["pressure"])
    psi, phi = map(np.radians, lines)
    # the pressure is per area of the middle surface
    middle = radius + HALF_THICKNESS
    area = np.outer(weights(psi) * middle
                    * (CENTER_RADIUS + middle * np.cos(psi)), weights(phi))
    first, second, third = ((pressure**k * area).sum() for k in (1, 2, 3))
    return math.sqrt(third * first / second**2 - 1)


def run_study(program, base, directory, values, samples, seed, ranks):
    """Runs a study; returns its lines, with the unevenness, without failed ones."""
    directory.mkdir(parents=True, exist_ok=True)
    is_one = samples == 1
    text = STUDY.format(
        base=base, force=FORCE, samples=samples, seed=seed,
        sampling="list" if is_one else "Latin hypercube",
        values="; ".join(f"{name}: {low:.6g}" + ("" if is_one else f":{high:.6g}")
                         for name, (low, high) in values.items()))
    file = directory / "even.prm"
    file.write_text(text, encoding="utf-8")
    subprocess.run([*ranks, program, "--study", "--quiet", "--output", directory,
                    file], check=True)
    lines = [line for line in read(directory / "study.csv")
             if line["status"] == "ok"]
    for line in lines:
        line["unevenness"] = unevenness(
            directory / f"sample-{int(line['sample']):04d}", float(line["radius"]),
            int(line["steps"]))
    return lines


class Polynomial:
    """A quadratic polynomial of two variables, fitted by least squares."""

    def __init__(self, lines, ranges):
        self.center = np.mean(list(ranges.values()), axis=1)
        self.size = np.diff(list(ranges.values()))[:, 0] / 2
        points = np.array([[float(line[name]) for name in ranges] for line in lines])
        values = np.array([line["unevenness"] for line in lines])
        terms = np.array([self.terms(point) for point in points])
        self.coefficients = np.linalg.lstsq(terms, values, rcond=None)[0]
        self.deviation = np.sqrt(((values - terms @ self.coefficients)**2).sum()
                                 / (len(values) - terms.shape[1]))

    def terms(self, point):
        """The monomials at a point."""
        x, y = (np.asarray(point) - self.center) / self.size
        return np.array([1, x, y, x * x, x * y, y * y])

    def __call__(self, point):
        return float(self.terms(point) @ self.coefficients)

    def derivatives(self, point):
        """By the two variables."""
        x, y = (np.asarray(point) - self.center) / self.size
        return np.array([[0, 1, 0, 2 * x, y, 0], [0, 0, 1, 0, x, 2 * y]]) \
            @ self.coefficients / self.size

    def minimum(self, ranges):
        """Its lowest point in the ranges."""
        starts = [(a, b) for a in ranges["angle"] for b in ranges["radius"]]
        found = [minimize(self, start, jac=self.derivatives, method="L-BFGS-B",
                          bounds=list(ranges.values())) for start in starts]
        return min(found, key=lambda result: result.fun).x


def optimize(program, base, scratch, ranks=()):
    """The two studies, the polynomials fitted to them, their minima; and single
    runs of the base design and of the best one."""
    ranges, rounds = RANGES, []
    for seed in (1, 2):
        lines = run_study(program, base, scratch / f"even_{seed}", ranges, SAMPLES,
                          seed, ranks)
        fit = Polynomial(lines, ranges)
        best = fit.minimum(ranges)
        rounds.append((ranges, lines, fit, best))
        ranges = {}
        for (name, (low, high)), value in zip(RANGES.items(), best):
            quarter = (high - low) / 4
            middle = min(max(value, low + quarter), high - quarter)
            ranges[name] = (middle - quarter, middle + quarter)
    single = {}
    for name, (angle, radius) in (("base", (52, 50)), ("best", rounds[-1][3])):
        single[name] = run_study(
            program, base, scratch / f"even_{name}",
            {"angle": (angle, angle), "radius": (radius, radius)}, 1, 1, ())[0]
    return rounds, single
