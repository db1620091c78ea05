# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drucker's condition: more strain takes more stress."""

import numpy as np

from .laws import TESTS


def unstable_ranges(law, test, end):
    """The ranges of stretches between 1 and an end in which a law is unstable in a
    test: its moduli are not positive definite, so that some small further strain
    would lower its stress. Compression needs no check of its own, since uniaxial
    compression is equibiaxial tension under a pressure, and so on."""
    def lowest(stretches):
        return np.linalg.eigvalsh(law.moduli(test, np.atleast_1d(stretches)))[:, 0]

    stretches = np.geomspace(1, end, 4001)
    bad = lowest(stretches) <= 0
    changes = np.flatnonzero(bad[1:] != bad[:-1])
    borders = [_root(lowest, stretches[i], stretches[i + 1]) for i in changes]
    if bad[0]:
        borders.insert(0, 1.0)
    if bad[-1]:
        borders.append(None)
    return list(zip(borders[::2], borders[1::2]))


def _root(function, low, high):
    from scipy.optimize import brentq
    return brentq(lambda stretch: function(stretch)[0], low, high)


def instabilities(law, end):
    """The tests in which a law is unstable, with the ranges of stretches; of a range
    without an end the second number is None."""
    ranges = {test: unstable_ranges(law, test, end) for test in TESTS}
    return {test: found for test, found in ranges.items() if found}
