# SPDX-License-Identifier: LGPL-2.1-or-later

# The command evaluate prints what evaluate() gives, in the units and axes that are asked
# for, and tells which rows are out of the ranges of the file.

from tire_model_test import (CHANNELS, MADE, check, output_of, require, scratch,
                             tire_model)

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir, table
from biface_tire_model.units import System

formula = read_tir(MADE).formula()
for units, angles, axes, fz, alpha, pressure in (
        ("m, N, s", "deg", "iso", "2000:6000:2000", "-6:6:1.5", "2e5"),
        ("mm, kN, s", "rad", "sae", "-2,-4,-6", "-.1,0,.1", "2e-4"),
        ("mm, N, s", "deg", "adapted-iso", "2000", "-6.5,3", "0.2")):
    text = output_of("evaluate", MADE, "--fz", fz, "--alpha", alpha, "--kappa", "-.1,0",
                     "--gamma", "2" if angles == "deg" else "0.03", "--pressure", pressure,
                     "--units", units, "--angles", angles, "--axes", axes)
    path = scratch() / "table.csv"
    path.write_text(text, encoding="utf-8")
    data = table.read_table(path, System(units, angles), axes)
    check(np.allclose(data["pressure"], 2e5), f"{data['pressure']}")
    forces = formula.evaluate(**data.arguments())
    for name in CHANNELS:
        check(np.allclose(data[name], getattr(forces, name), rtol=1e-7, atol=1e-6),
              f"{name} differs in {units}, {axes}")
check(len(data) == 4, f"there are {len(data)} rows")

to_file = scratch() / "to_file.csv"
words = ("evaluate", MADE, "--fz", "4000", "--alpha", "-3:3:1")
check(output_of(*words, "-o", to_file) == "", "it prints a table")
check(to_file.read_text(encoding="utf-8") == output_of(*words), "another table")

# on the other side: minus the slip angle gives minus the force
right = output_of("evaluate", MADE, "--fz", "4000", "--alpha=4", "--mirror")
left = output_of("evaluate", MADE, "--fz", "4000", "--alpha=-4")
right, left = ([float(word) for word in text.splitlines()[-1].split(",")]
               for text in (right, left))
check(left[4] == -right[4] and left[3] == right[3] and left[8] == -right[8]
      and left[6] == -right[6], f"{left}, {right}")

code, output, errors = tire_model("evaluate", MADE, "--fz", "4000,20000", "--alpha",
                                  "-30,0,30")
check(code == 0 and output.count("\n") == 8, f"{code}: {output}")
check(errors == "biface-tire-model: warning: 4 of 6 rows have a slip_angle out of the "
      "range of the file, ALPMIN to ALPMAX.\nbiface-tire-model: warning: 3 of 6 rows have "
      "a F_z out of the range of the file, FZMIN to FZMAX.\n", errors)
