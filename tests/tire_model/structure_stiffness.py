# SPDX-License-Identifier: LGPL-2.1-or-later

# Stiffnesses that follow MF 6.1 over load and pressure give its coefficients, in the file
# in SI units.

from structure_test import Run, made_fit, structural, values
from tire_model_test import check

from biface_tire_model import make_tir

# the nominal state, 4000 N and 200000 Pa, is none of them
TRUTH = {"longitudinal": (3.9e5, 0.14, -0.16, 0.22), "lateral": (1.9e5, -0.23, 0.07, 0.7),
         "turn": (5000.0, 0.8, 0.1, -0.3)}
NAMES = {"longitudinal": ("LONGITUDINAL_STIFFNESS", "PCFX1", "PCFX2", "PCFX3"),
         "lateral": ("LATERAL_STIFFNESS", "PCFY1", "PCFY2", "PCFY3"),
         "turn": ("YAW_STIFFNESS",)}

run = Run()
for motion, (value, p1, p2, p3) in TRUTH.items():
    for load in (2000, 3000, 5000, 6000):
        for pressure in (1.8e5, 2.2e5):
            df, dp = load / 4000 - 1, pressure / 2e5 - 1
            run.move(motion, load, pressure,
                     value * (1 + p1 * df + p2 * df ** 2) * (1 + p3 * dp))
result = structural(run)
file = make_tir(made_fit(), structural=result)
for motion, names in NAMES.items():
    for name, truth in zip(names, TRUTH[motion]):
        for found in (values(result)[name], file.sections["STRUCTURAL"].entries[name]):
            check(abs(found - truth) < 1e-7 * max(abs(truth), 1),
                  f"{name} is {found}, not {truth}")
comment = file.sections["STRUCTURAL"].comments["YAW_STIFFNESS"]
check(comment == "footprint glued, 2000 to 6000 N, 180000 to 220000 Pa", comment)
