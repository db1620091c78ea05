# SPDX-License-Identifier: LGPL-2.1-or-later

# The rolling resistance moment is against forward rolling and by default in proportion to
# the load; MF 6.1 has an exponent of the load where MF 5.2 has it beside 1.

from tire_model_test import check, neutral_formula, require

require("numpy", "scipy")

from biface_tire_model import MF52, MF61


def moment(kind, load, pressure=2e5, velocity=20, **coefficients):
    formula = neutral_formula(kind, LONGVL=20.0, QSY1=0.01, **coefficients)
    return float(formula.evaluate(load, pressure=pressure, velocity=velocity).M_y)


def close(value, expected):
    check(abs(value - expected) < 1e-12 * abs(expected), f"{value} is not {expected}")


for kind in (MF52, MF61):
    for load in (2000, 4000, 6000):
        close(moment(kind, load), -0.01 * load * 0.3)
    close(moment(kind, 4000, QSY3=0.004, QSY4=0.0003, velocity=30),
          -(0.01 + 0.004 * 1.5 + 0.0003 * 1.5 ** 4) * 4000 * 0.3)
    close(moment(kind, 4000, QSY8=-0.4, pressure=2.4e5), -12 * 1.2 ** -0.4)
close(moment(MF61, 6000, QSY7=0.85), -12 * 1.5 ** 0.85)
close(moment(MF52, 6000, QSY7=-0.15), -12 * 1.5 ** 0.85)
