# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of tire tests."""

from python_test import SOURCE, biface, check, require, run_command, scratch

TIRE_TEST = SOURCE / "prm/tire_test.prm"
# A coarse mesh, and no points
COARSE = {"Mesh/Intervals alpha_1": "-120:120:12",
          "Mesh/Intervals alpha_2": "-180:-30:4, -30:30:15, 30:180:4",
          "Tire test/Inclination angles": 0, "Tire test/Slip angles": "",
          "Tire test/Slip ratios": "", "Tire test/Slip": "pure"}


def run(settings, **options):
    """The results of a tire test on a coarse mesh."""
    return biface.run(TIRE_TEST, {**COARSE, **settings}, options.pop("output", None) or
                      scratch(), **options)
