# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constants of laws by least squares."""

from itertools import combinations

import numpy as np
from scipy.linalg import lstsq
from scipy.optimize import least_squares, nnls

from biface.errors import BifaceError
from .laws import LINEAR, Law, ogden_terms, stress

# Exponents from which fits of Ogden's law start, all combinations of them, and how
# many of the best are refined
STARTS = (-5, -3, -2, -1, 1, 1.5, 2, 3, 4, 5, 7, 9)
REFINED = 12
SMALLEST_EXPONENT, LARGEST_EXPONENT = 0.01, 30


class Problem:
    """The equations: the errors in the stresses of all points, absolute or relative
    to the measured stress."""

    def __init__(self, data, relative, stable):
        self.data, self.stable = data, stable
        self.used = data.stresses != 0 if relative else np.ones(len(data), bool)
        self.weights = np.ones(len(data))
        if relative:
            self.weights[self.used] = 1 / np.abs(data.stresses[self.used])
        self.weights[~self.used] = 0

    def __len__(self):
        return int(self.used.sum())

    def column(self, term):
        """The weighted stresses of a term with the factor 1."""
        values = np.empty(len(self.data))
        for test in self.data.measured():
            where = self.data.of(test)
            values[where] = stress(term, test, self.data.stretches[where])
        return values * self.weights

    def solve(self, terms):
        """The best factors of terms, the errors, and the number of factors that the
        points determine."""
        matrix = np.column_stack([self.column(term) for term in terms])
        scales = np.linalg.norm(matrix, axis=0)
        scales[scales == 0] = 1
        target = self.data.stresses * self.weights
        rank = np.linalg.matrix_rank(matrix / scales)
        if self.stable:
            # an energy convex in the logarithms of the stretches
            signs = np.sign([term.factor for term in terms])
            factors = signs * nnls(matrix / scales * signs, target)[0]
        else:
            factors = lstsq(matrix / scales, target)[0]
        return factors / scales, matrix @ (factors / scales) - target, rank


def fit(data, name, count=3, relative=False, stable=False):
    """The law of a name whose stresses come closest to the data; with @p count terms
    if it is Ogden's."""
    problem = Problem(data, relative, stable)
    needed = 2 * count if name == "Ogden" else len(LINEAR[name])
    if len(problem) < needed:
        raise BifaceError(f"{name} has {needed} constants, but there are only "
                          f"{len(problem)} points"
                          + (" with a stress." if relative else "."))
    if name == "Ogden":
        terms = ogden_terms(best_exponents(problem, count))
    else:
        terms = LINEAR[name].values()
    factors, _, rank = problem.solve(terms)
    if rank < len(terms):
        raise BifaceError(f"the points do not determine all constants of {name}; it "
                          "takes points at more stretches or in other tests, or "
                          "fewer constants.")
    kept = [(term, factor) for term, factor in zip(terms, factors)
            if factor != 0 or name != "Ogden"]
    law = Law(name, *zip(*kept)) if kept else Law(name, terms, factors)
    if not law.shear_modulus() > 0:
        raise BifaceError(f"the points give {name} the shear modulus "
                          f"{law.shear_modulus():.3g}, but it must be positive; a "
                          "stretch is 1 plus the strain.")
    return law


def best_exponents(problem, count):
    """The exponents of the best of several fits, whose factors are eliminated. The
    starts are always the same."""
    def errors(alphas):
        return problem.solve(ogden_terms(allowed(alphas)))[1]

    def size(alphas):
        return np.linalg.norm(errors(alphas))

    starts = sorted(combinations(STARTS, count), key=size)[:REFINED]
    results = [least_squares(errors, start, jac="3-point", x_scale=1,
                             bounds=(-LARGEST_EXPONENT, LARGEST_EXPONENT),
                             xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=300)
               for start in starts]
    return allowed(min(results, key=lambda result: result.cost).x)


def allowed(alphas):
    """Exponents of which none is 0, where the energy is not defined."""
    return np.where(np.abs(alphas) < SMALLEST_EXPONENT, SMALLEST_EXPONENT, alphas)
