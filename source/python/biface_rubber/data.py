# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured curves of rubber."""

import math
from itertools import zip_longest

import numpy as np

from biface.delimited import read_delimited, separators
from biface.errors import BifaceError
from .laws import TESTS

# no rubber stretches as far; percents would
LARGEST_STRETCH = 100

COLUMNS = ("test", "stretch", "stress")


class Data:
    """Points of measured curves: for each the name of its test, the stretch and the
    nominal stress, the force over the undeformed area."""

    def __init__(self, tests, stretches, stresses):
        self.tests = np.array(tests)
        self.stretches = np.array(stretches, dtype=float)
        self.stresses = np.array(stresses, dtype=float)

    def __len__(self):
        return len(self.tests)

    def of(self, test):
        """Where the points of a test are."""
        return self.tests == test

    def measured(self):
        """The tests of which there are points."""
        return [test for test in TESTS if self.of(test).any()]

    def only(self, tests):
        """The points of some tests."""
        where = np.isin(self.tests, tests)
        return Data(self.tests[where], self.stretches[where], self.stresses[where])

    def largest_stretch(self):
        """The largest principal stretch of all points."""
        return max(TESTS[test](self.stretches[self.of(test)]).max()
                   for test in self.measured())


def number(line, column, place):
    """A finite number of a line of the file."""
    try:
        value = float(line[column])
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise BifaceError(f"{place}: the {column} is '{line[column] or ''}', but must "
                          "be a number.")
    return value


def read(path):
    """The points of a CSV file with the columns of COLUMNS, see biface.delimited."""
    names, rows, _ = read_delimited(path, lambda cell: cell in COLUMNS)
    for column in COLUMNS:
        if column not in names:
            raise BifaceError(f"{path} has no column '{column}' among columns separated by "
                              f"{separators()}.")
    points = []
    for place, row in rows:
        place = f"{path}, line {place}"
        line = dict(zip_longest(names, row[:len(names)]))
        test = (line["test"] or "").strip()
        if test not in TESTS:
            raise BifaceError(f"{place}: the test is '{test}', but must be "
                              "uniaxial, equibiaxial or planar.")
        stretch = number(line, "stretch", place)
        if not 1 / LARGEST_STRETCH <= stretch <= LARGEST_STRETCH:
            raise BifaceError(f"{place}: the stretch is {stretch:g}, but must lie "
                              f"between {1 / LARGEST_STRETCH:g} and "
                              f"{LARGEST_STRETCH}.")
        points.append((test, stretch, number(line, "stress", place)))
    if not points:
        raise BifaceError(f"{path} has no points.")
    return Data(*zip(*points))
