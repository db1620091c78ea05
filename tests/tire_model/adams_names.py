# SPDX-License-Identifier: LGPL-2.1-or-later

# Names of Adams's PAC2002 and older names mean the same coefficients.

from tire_model_test import TRUCK, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir
from biface_tire_model.tir_file import parse

text = TRUCK.read_text(encoding="utf-8").replace("LFZO ", "LFZ0 ")
for name, value in (("QPZ1", "0.4"), ("QPZ2", "-0.3"), ("QPX1", "0.2"), ("LKG", "0.8"),
                    ("QSX2", "1.1"), ("QDZ8", "-0.1")):
    lines = [line for line in text.splitlines() if line.startswith(name + " ")]
    check(len(lines) == 1, f"{name} occurs {len(lines)} times")
    text = text.replace(lines[0], f"{name} = {value}")
formula = parse(text).formula()
for name, value in (("LFZO", 0.580904846), ("PPZ1", 0.4), ("PPZ2", -0.3), ("PPMX1", 0.2),
                    ("LKYC", 0.8), ("NOMPRES", 800000)):
    check(formula.coefficients[name] == value, f"{name} is {formula.coefficients[name]}")
at = {"alpha": 0.05, "gamma": 0.04}
for pressure in (6e5, 9e5):
    changed = np.array(formula.evaluate(20000, pressure=pressure, **at))
    same = np.array(formula.evaluate(20000, **at))
    moved = np.abs(changed - same) > 1e-6 * np.abs(same)
    check(list(moved) == [False, False, True, False, True], f"by pressure: {moved}")
check(read_tir(TRUCK).find("LKYC") == 1, "LKG is not found")
