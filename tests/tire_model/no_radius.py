# SPDX-License-Identifier: LGPL-2.1-or-later

# Without UNLOADED_RADIUS forces are evaluated, moments need it, and --radius gives it.

from tire_model_test import MADE, check, output_of, require, tire_model, write

require("numpy", "scipy")

import numpy as np
from biface.errors import BifaceError
from biface_tire_model import read_tir

source = MADE.read_text(encoding="utf-8")
check(source.count("UNLOADED_RADIUS = 0.32\n") == 1, "there is no radius")
path = write("no_radius.tir", source.replace("UNLOADED_RADIUS = 0.32\n", ""))
words = ["--fz", "4000", "--alpha", "-3,4", "--kappa", "0.1"]
code, text, errors = tire_model("evaluate", path, *words)
check(code == 0 and "has no UNLOADED_RADIUS, which moments need" in errors, errors)
rows = output_of("evaluate", MADE, *words).splitlines()
check([row.split(",")[:6] for row in rows[1:]]
      == [row.split(",") for row in text.splitlines()[1:]], text)
check(output_of("evaluate", path, *words, "--radius", "0.32").splitlines() == rows,
      "another table with --radius")
check(output_of("evaluate", path, "--units", "mm, N, s", "--radius", "320", *words)
      == output_of("evaluate", MADE, "--units", "mm, N, s", *words), "another unit")

empty = write("empty.tir", source.replace("UNLOADED_RADIUS = 0.32\n",
                                          "UNLOADED_RADIUS = $ none\n"))
check(tire_model("evaluate", empty, *words)[:2] == (code, text), "an empty radius is one")

text = tire_model("check", path)[1]
check("no radius" in text and "UNLOADED_RADIUS is missing: moments need it" in text, text)

formula = read_tir(path).formula()
forces = formula.evaluate(4000, alpha=0.1)
check(np.isfinite([forces.F_x, forces.F_y]).all() and np.isnan(forces.M_z), f"{forces}")
for moment in (formula.aligning_moment, formula.rolling_resistance_moment,
               lambda load: formula.overturning_moment(load, 100)):
    try:
        moment(4000)
        check(False, "a moment without a radius")
    except BifaceError as error:
        check("UNLOADED_RADIUS is missing, which moments need." == str(error), str(error))
