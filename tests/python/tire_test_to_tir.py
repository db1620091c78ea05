# SPDX-License-Identifier: LGPL-2.1-or-later

# A .tir file fitted to a tire test gives the forces of its points, whichever axes the
# table has.

from tire_test import check, require, run, run_command, scratch

require("scipy")

from biface_tire_model import read_tir

POINTS = {"Tire test/Loads": "1000, 1500, 2000", "Tire test/Slip angles": "-4, -2, 2, 4",
          "Tire test/Slip ratios": "-0.06, -0.03, 0.03, 0.06"}

files, tables = [], []
for axes in ("ISO", "SAE"):
    output = scratch()
    tables.append(run({**POINTS, "Tire test/Axes": axes}, output=output).tire_test())
    files.append(output / "tire.tir")
    code, _, errors = run_command("biface-tire-model", "fit", output, "--format", "5.2",
                                  "--radius", "256", "--output", files[-1])
    check(code == 0, errors)
formulas = [read_tir(file).formula() for file in files]
points = tables[0]
forces = [formula.evaluate(points["F_z"], points["slip_ratio"],
                           points["slip_angle"] * 3.14159265358979 / 180,
                           pressure=points["pressure"] * 1e6) for formula in formulas]
for name, largest in (("F_x", 0.05), ("F_y", 0.05)):
    scale = abs(points[name]).max()
    first, second = (getattr(force, name) for force in forces)
    error = abs(first - points[name]).max() / scale
    check(error < largest, f"{name} of the file differs by {error:.1%}")
    check(abs(first - second).max() < 1e-3 * scale, f"{name} depends on the axes")
