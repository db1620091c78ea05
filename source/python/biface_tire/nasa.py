# SPDX-License-Identifier: LGPL-2.1-or-later
"""The empirical formulas of NASA TR R-64 for bias tires @cite SmileyHorne1958, at the
rated pressure. Lengths in mm, pressures in MPa.

All functions take the outer diameter D and the section width W of the inflated tire,
the vertical deflection and the pressure, as far as they depend on them."""

import math


def force(diameter, width, deflection, pressure):
    """Vertical force in kN; negative below a deflection of 0.03 W, where the formula
    does not hold."""
    return (2.4 * 1.08 * pressure * width * math.sqrt(width * diameter)
            * (deflection / width - 0.03) / 1000)


def deflection(diameter, width, load, pressure):
    """The deflection in mm under a force in kN: the inverse of force()."""
    return width * (0.03 + 1000 * load / (2.4 * 1.08 * pressure * width
                                          * math.sqrt(width * diameter)))


def footprint_length(diameter, deflection):
    """Length of the footprint in mm."""
    return 1.7 * math.sqrt(deflection * (diameter - deflection))


def footprint_width(width, deflection):
    """Width of the footprint in mm."""
    return 1.7 * math.sqrt(deflection * (width - deflection))


def rolling_radius(diameter, deflection):
    """Rolling radius in mm."""
    return diameter / 2 - deflection / 3


def lateral_stiffness(width, deflection, pressure):
    """Of the standing tire, kN/mm."""
    return 2 * width * 1.24 * pressure * (1 - 0.7 * deflection / width) / 1000


def longitudinal_stiffness(diameter, deflection, pressure):
    """Of the standing tire, fore and aft, kN/mm."""
    return 0.6 * diameter * 5 * pressure * (deflection / diameter)**(1 / 3) / 1000


def torsional_stiffness(diameter, width, deflection, pressure):
    """Of the standing tire about the vertical axis, kN m per degree."""
    relative = deflection / diameter
    turn = 250 * relative**2 if relative <= 0.03 else 15 * (relative - 0.015)
    return 1.8 * pressure * width**3 * turn * math.pi / 180 / 1e6


def cornering_power(diameter, width, deflection, pressure):
    """Side force per slip angle, kN per degree. Beyond a deflection of 0.0875 D the
    law goes on along its tangent."""
    relative = deflection / diameter
    shape = (1.2 * relative - 8.8 * relative**2 if relative <= 0.0875
             else 0.0674 - 0.34 * relative)
    return 57 * 1.44 * pressure * width**2 * shape * math.pi / 180 / 1000
