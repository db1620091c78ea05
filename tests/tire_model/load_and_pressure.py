# SPDX-License-Identifier: LGPL-2.1-or-later

# Derivatives by load and pressure at the nominal state are those of the formulas.

from tire_model_test import check, neutral_formula, require

require("numpy", "scipy")

from biface_tire_model import MF52, MF61

F, P = 4000.0, 2e5


def slope(function, x, h):
    return (function(x + h) - function(x - h)) / (2 * h)


def close(value, expected, what):
    check(abs(value - expected) < 1e-6 * (abs(expected) or 1),
          f"{what}: {value} is not {expected}")


for kind in (MF52, MF61):
    formula = neutral_formula(kind, PDX1=1.1, PDX2=-0.12, PKX1=21.0, PKX2=4.0, PKX3=0.3,
                              PDY1=0.9, PDY2=-0.2, PKY1=-16.0, PKY2=1.0, PPX1=-0.4,
                              PPX2=0.7, PPX3=-0.15, PPX4=0.4, PPY1=-0.3, PPY2=0.0,
                              PPY3=-0.2, PPY4=0.3, QDZ1=0.11, QDZ2=-0.02, PPZ1=-0.5)
    close(slope(lambda f: formula.longitudinal(f).D / f, F, 1), -0.12 / F, "mu_x")
    close(slope(lambda f: formula.lateral(f).D / f, F, 1), -0.2 / F, "mu_y")
    close(slope(lambda f: formula.longitudinal(f).slope / f, F, 1),
          (4 + 21 * 0.3) / F, "the slip stiffness over load")
    # the cornering stiffness has its maximum at PKY2 times the nominal load
    close(slope(lambda f: formula.lateral(f).slope, F, 1), 0, "the cornering stiffness")
    close(formula.lateral(F).slope, -16 * F, "the largest cornering stiffness")
    close(slope(lambda p: formula.longitudinal(F, pressure=p).D, P, 10),
          1.1 * F * -0.15 / P, "D_x by pressure")
    close(slope(lambda p: formula.longitudinal(F, pressure=p).slope, P, 10),
          21 * F * -0.4 / P, "the slip stiffness by pressure")
    close(slope(lambda p: formula.lateral(F, pressure=p).D, P, 10),
          0.9 * F * -0.2 / P, "D_y by pressure")
    close(slope(lambda p: formula.lateral(F, pressure=p).slope, P, 10),
          -16 * F * -0.3 / P, "the cornering stiffness by pressure")
    ratio = formula.longitudinal(F, pressure=1.5 * P).slope / formula.longitudinal(F).slope
    close(ratio, 1 - 0.4 * 0.5 + 0.7 * 0.25, "the stiffness at more pressure")

    # at small slip angles the aligning moment is minus the trail times F_y
    def trail(p):
        h = 1e-6
        return (-slope(lambda a: formula.aligning_moment(F, a, pressure=p), 0, h)
                / slope(lambda a: formula.lateral(F, a, pressure=p).value, 0, h))

    close(trail(P), 0.11 * 0.3, "the trail")
    close(slope(trail, P, 10), 0.11 * 0.3 * 0.5 / P, "the trail by pressure")
