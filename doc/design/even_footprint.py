# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cord angle and the radius of the profile of the bias tire for which the
pressure of its footprint is most even at a given force, without more tension in the
cords.

An example of an optimizer outside of the program: SciPy's SLSQP, sequential quadratic
programming, which obeys bounds and constraints and needs the derivatives of the
objective and of the constraint. The program writes both into sensitivities.csv.
"""

import numpy as np
from scipy.optimize import minimize

from example_page import biface

FORCE = 1900  # N
BASE = {"angle": 52., "radius": 50.}
RANGES = {"angle": (46., 60.), "radius": (44., 56.)}
OBJECTIVE, LIMITED = "weighted_pressure", "max_fiber_tension"
SAMPLES = 24  # of the study for the map; a quadratic polynomial has 6 coefficients

# How the entries of prm/bias_tire_true_pressure.prm depend on the variables
ENTRIES = ("angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
           "-Laminate/Plies[8]", "radius: Surface/Circular arc/Radius")
# The mesh has half the cell size of the base file where the tire touches the ground
SETTINGS = {
    "Mesh/Intervals alpha_1": "-120:-45:10,-45:45:36,45:120:10",
    "Mesh/Intervals alpha_2": "-180:-15:10:smooth,-15:15:30,15:180:10:smooth",
    "Stage 2/Control": "foundation force", "Stage 2/Force": FORCE,
    "Stage 2/Travel": "unchanged", "Stage 2/Steps": 2,
    "Contact/Multiplier mass": "lumped", "Newton/Residual tolerance": 1e-10,
    "Output/Write VTU": False}


def tire(program, base, scratch, derivatives):
    """The tire as a function of the variables."""
    return biface.Model(base, ENTRIES, (OBJECTIVE, LIMITED), SETTINGS, scratch,
                        derivatives=derivatives, program=program)


def optimize(model, derivatives):
    """The best values of the variables. All numbers of the optimizer are relative:
    the variables to half of their ranges, the results to those of the base."""
    center = np.mean(list(RANGES.values()), axis=1)
    size = np.diff(list(RANGES.values()))[:, 0] / 2
    base = {name: model.value(BASE.values(), name) for name in model.outputs}

    def value(x, name):
        return model.value(center + size * x, name) / base[name]

    def gradient(x, name):
        return size * model.gradient(center + size * x, name) / base[name]

    limit = {"type": "ineq", "fun": lambda x: 1 - value(x, LIMITED)}
    if derivatives:
        limit["jac"] = lambda x: -gradient(x, LIMITED)
    result = minimize(
        value, (np.array(list(BASE.values())) - center) / size, args=(OBJECTIVE,),
        jac=gradient if derivatives else None, bounds=[(-1, 1)] * len(RANGES),
        method="SLSQP", constraints=[limit], options={"ftol": 1e-5, "eps": 1e-3})
    if not result.success:
        raise RuntimeError(result.message)
    return center + size * result.x


def check(model, other):
    """Derivatives at the base, with those by central differences of runs of another
    model."""
    rows = []
    for name in (OBJECTIVE, LIMITED):
        own = model.gradient(BASE.values(), name)
        for (entry, value), derivative in zip(BASE.items(), own):
            step = 1e-4 * value
            ends = [other.value({**BASE, entry: value + side * step}.values(), name)
                    for side in (-1, 1)]
            rows.append((name, entry, derivative, (ends[1] - ends[0]) / (2 * step)))
    return rows


class Polynomial:
    """A quadratic polynomial of the variables, fitted to samples."""

    def __init__(self, samples, name):
        self.center = np.mean(list(RANGES.values()), axis=1)
        points = np.stack([samples[entry] for entry in RANGES], -1)
        self.coefficients = np.linalg.lstsq(
            np.array([self.terms(point) for point in points]), samples[name],
            rcond=None)[0]

    def terms(self, point):
        """The monomials at a point."""
        x, y = np.asarray(point) - self.center
        return [1, x, y, x * x, x * y, y * y]

    def __call__(self, point):
        return float(self.terms(point) @ self.coefficients)


def sample(program, base, directory, ranks):
    """The samples of a study of the ranges."""
    study = biface.sweep(base, dict(zip(ENTRIES, RANGES.values())),
                         (OBJECTIVE, LIMITED), SETTINGS, directory, samples=SAMPLES,
                         ranks=ranks, program=program)
    return study.where(study.is_ok)
