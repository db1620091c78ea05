# SPDX-License-Identifier: LGPL-2.1-or-later

# Pure curves of MF 5.2 have one set of coefficients only: fitted at the nominal load of the
# file, they are those of the file.

from tire_model_test import DATA, check, require, sweeps

require("numpy", "scipy")

from biface_tire_model import fit, read_tir

formula = read_tir(DATA / "opentire_pac2002.tir").formula()
data = sweeps(formula, (1500, 3500, 5500, 8000), (-0.06, 0, 0.06))
result = fit(data, "5.2", formula.p.UNLOADED_RADIUS, nominal_load=formula.p.FNOMIN)
for name in ("PCX1", "PDX1", "PDX2", "PEX1", "PKX1", "PKX2", "PKX3", "PCY1", "PDY1", "PDY2",
             "PDY3", "PKY1", "PKY2", "PKY3", "PHY3", "PVY3", "RCX1", "RCY1", "QSX2",
             "QSX3", "QSY1"):
    value, expected = result.formula.coefficients[name], formula.coefficients[name]
    check(abs(value - expected) < 0.01 * abs(expected),
          f"{name} is {value}, not {expected}")
