# SPDX-License-Identifier: LGPL-2.1-or-later
"""The laws of incompressible rubber, in principal stretches."""

import numpy as np

# The principal stretches of each test by the one that is measured; the third
# direction is free of stress
TESTS = {
    "uniaxial": lambda s: np.array([s, s ** -0.5, s ** -0.5]),
    "equibiaxial": lambda s: np.array([s, s, s ** -2.0]),
    "planar": lambda s: np.array([s, np.ones_like(s), 1 / s]),
}


class Term:
    """A term of the energy, factor (l_1^alpha + l_2^alpha + l_3^alpha - 3)^power,
    and its derivatives by the logarithms of the stretches."""

    def __init__(self, alpha, factor=1, power=1):
        self.alpha, self.factor, self.power = alpha, factor, power

    def _parts(self, stretches):
        powers = stretches ** self.alpha
        return (self.alpha * powers, powers.sum(axis=0) - 3,
                self.factor * self.power)

    def gradient(self, stretches):
        """The principal Kirchhoff stresses less a pressure."""
        slopes, base, factor = self._parts(stretches)
        return factor * base ** (self.power - 1) * slopes

    def hessian(self, stretches):
        """The second derivatives, in the first two axes of the array."""
        slopes, base, factor = self._parts(stretches)
        matrix = (base ** (self.power - 1) * self.alpha
                  * slopes * np.eye(3)[:, :, None])
        if self.power > 1:
            matrix = matrix + ((self.power - 1) * base ** (self.power - 2)
                               * slopes[:, None] * slopes[None, :])
        return factor * matrix


# The entries of `Material` for the laws that are linear in their constants
LINEAR = {
    "neo-Hooke": {"mu": Term(2, 1 / 2)},
    "Mooney-Rivlin": {"c10": Term(2), "c01": Term(-2)},
    "Yeoh": {"c10": Term(2), "c20": Term(2, power=2), "c30": Term(2, power=3)},
}
NAMES = (*LINEAR, "Ogden")


def ogden_terms(alphas):
    """The terms of Ogden's law, whose factors are mu_i."""
    return [Term(alpha, 1 / alpha) for alpha in alphas]


def stress(term, test, stretches):
    """The nominal stress of a term of the energy with the factor 1 in a test."""
    gradient = term.gradient(TESTS[test](stretches))
    return (gradient[0] - gradient[2]) / stretches


class Law:
    """A law with its constants: terms of the energy and their factors."""

    def __init__(self, name, terms, constants):
        self.name, self.terms = name, list(terms)
        self.constants = np.array(constants, dtype=float)

    def stress(self, test, stretches):
        """The nominal stress in a test."""
        return sum(constant * stress(term, test, stretches)
                   for constant, term in zip(self.constants, self.terms))

    def _hessian(self, stretches):
        return sum(constant * term.hessian(stretches)
                   for constant, term in zip(self.constants, self.terms))

    def moduli(self, test, stretches):
        """The derivatives of the first two principal Kirchhoff stresses by the
        first two logarithmic strains, where the third direction is free of stress
        and the volume is constant: a 2 x 2 matrix for each stretch."""
        allowed = np.array([[1, 0], [0, 1], [-1, -1]])
        return np.einsum("ia,ijn,jb->nab", allowed,
                         self._hessian(TESTS[test](stretches)), allowed)

    def shear_modulus(self):
        """The shear modulus of small strains."""
        hessian = self._hessian(np.ones((3, 1)))[:, :, 0]
        return (hessian[0, 0] - hessian[0, 1]) / 2

    def entries(self):
        """The entries of `Material` and their values."""
        if self.name == "Ogden":
            lists = (self.constants, [term.alpha for term in self.terms])
            return [(entry, ", ".join(f"{value:.8g}" for value in values))
                    for entry, values in zip(("mu_i", "alpha_i"), lists)]
        return [(entry, f"{value:.8g}")
                for entry, value in zip(LINEAR[self.name], self.constants)]
