# SPDX-License-Identifier: LGPL-2.1-or-later

# A relaxation length is the slope of the force over the slip, divided by the stiffness, at
# the nominal load and at each other load at which both are known.

from structure_test import Run, made_fit, structural
from tire_model_test import check

from biface_tire_model import make_tir

LATERAL, LONGITUDINAL = 2e5, 4e5
COEFFICIENTS = {"PKY1": -18, "PKY2": 1.8, "PKX1": 22, "PKX2": -3, "PPY1": 0.3}

run = Run()
# 7000 N is out of the range of the forces
for load in (2000, 4000, 5000, 7000):
    run.move("lateral", load, 2e5, LATERAL)
run.move("lateral", 5000, 2.2e5, LATERAL)
run.move("longitudinal", 3600, 2e5, LONGITUDINAL)
fit = made_fit(**COEFFICIENTS)
result = structural(run, fit=fit)
rows = {(round(row.load), round(row.pressure)): row for row in result.lengths}
check(list(rows) == [(2000, 200000), (3600, 200000), (4000, 200000), (5000, 200000),
                     (5000, 220000)], f"{list(rows)}")
for (load, pressure), row in rows.items():
    slopes = [abs(float(getattr(fit.formula, motion)(load, pressure=pressure).slope))
              for motion in ("lateral", "longitudinal")]
    check((row.lateral is None) == (load == 3600)
          and (row.longitudinal is None) == (load != 3600), f"{row}")
    for length, slope, stiffness in zip((row.lateral, row.longitudinal), slopes,
                                        (LATERAL, LONGITUDINAL)):
        check(length is None or abs(length - slope / stiffness) < 1e-9, f"{row}")

# the nominal load has a row of its own if no state has it
run = Run()
for load in (3000, 5000):
    run.move("lateral", load, 2e5, LATERAL)
rows = structural(run, fit=fit).lengths
check([round(row.load) for row in rows] == [3000, 4000, 5000], f"{rows}")
check(abs(rows[1].lateral * LATERAL
          / abs(float(fit.formula.lateral(4000, pressure=2e5).slope)) - 1) < 1e-9, f"{rows}")

# forces that the table does not determine have none
fit = made_fit(reasons={"PKY1": "no F_y"}, **COEFFICIENTS)
check(structural(run, fit=fit).lengths == [], "there are lengths without slopes")
check("PTX1" not in make_tir(fit, structural=structural(run, fit=fit)).text(),
      "MF 6.1 has PTX1")
