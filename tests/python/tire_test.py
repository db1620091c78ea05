# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of tire tests."""

from python_test import SOURCE, biface, check, require, run_command, scratch

TIRE_TEST = SOURCE / "prm/tire_test.prm"
# A coarse mesh, and no points
COARSE = {"Mesh/Intervals alpha_1": "-120:120:8",
          "Mesh/Intervals alpha_2": "-180:-30:3, -30:30:9, 30:180:3",
          "Tire test/Inclination angles": 0, "Tire test/Slip angles": "",
          "Tire test/Slip ratios": "", "Tire test/Slip": "pure", "Output/Write VTU": False}


def run(settings, **options):
    """The results of a tire test on a coarse mesh."""
    return biface.run(TIRE_TEST, {**COARSE, **settings}, options.pop("output", None) or
                      scratch(), **options)
