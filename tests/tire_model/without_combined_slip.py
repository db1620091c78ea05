# SPDX-License-Identifier: LGPL-2.1-or-later

# Without combined slip in the table, a file has typical reductions of F_x and F_y by each
# other and says so, and both together stay near the limit of friction; by request it has
# none, or is refused.

from tire_model_test import (MADE, check, check_refused, require, scratch,
                             tire_model_here)

require("numpy", "scipy")

import numpy as np
from biface_tire_model import fit, read_tir
from biface_tire_model.coefficients import TYPICAL
from biface_tire_model.table import Measurements, write_table
from biface_tire_model.units import System

formula = read_tir(MADE).formula().with_coefficients({"RBX1": 0, "RBY1": 0})
alphas, kappas = np.radians(np.linspace(-12, 12, 13)), np.linspace(-0.3, 0.3, 13)
alpha = np.concatenate([alphas, np.zeros(13)])
kappa = np.concatenate([np.zeros(13), kappas])
forces = formula.evaluate(4000, kappa, alpha)
columns = {"F_z": np.full(26, 4000.0), "slip_angle": alpha, "slip_ratio": kappa,
           "loaded_radius": np.full(26, 0.3), "F_x": forces.F_x, "F_y": forces.F_y}
table = scratch() / "pure.csv"
table.write_text(write_table(columns, System("m, N, s")), encoding="utf-8")


def largest(result):
    """The largest resultant of combined slip over the larger of both peaks."""
    x, y = np.meshgrid(np.linspace(-0.3, 0.3, 31), np.radians(np.linspace(-12, 12, 31)))
    found = result.formula.evaluate(4000, x, y)
    return np.hypot(found.F_x, found.F_y).max() / max(
        np.abs(forces.F_x).max(), np.abs(forces.F_y).max())


words = ["fit", table, "--radius", "0.32", "--output", table.with_suffix(".tir")]
for version in ("5.2", "6.1"):
    data = Measurements(columns)
    result = fit(data, version, 0.32)
    check(largest(result) < 1.1, f"the resultant is {largest(result)} of the peak")
    neutral = fit(data, version, 0.32, without_combined="neutral")
    check(largest(neutral) > 1.25, f"the resultant is only {largest(neutral)} of the peak")
    code, output, errors = tire_model_here(*words, "--format", version)
    check(code == 0 and "combined slip is not measured: RBX1, RBX2, RBY1" in errors
          and "a 205/60 R15 of TNO, not of this tire" in errors, f"{code}: {errors}")
    file = read_tir(table.with_suffix(".tir"))
    check(all(file.find(name) == value for name, value in TYPICAL.items()),
          "the coefficients are others")
    check("\n! combined slip is not measured: " in table.with_suffix(".tir").read_text(
        encoding="utf-8"), "the file does not say so")
    if version == "5.2":
        check(file.find("FE_METHOD") == "NO", "the ellipse acts on top of the coefficients")
check_refused([*words, "--format", "6.1", "--without-combined", "refuse"],
              "no state has both a slip angle and a longitudinal slip")
