# SPDX-License-Identifier: LGPL-2.1-or-later

# The vertical stiffness and the radius without load are those of the loaded radii of
# upright wheels that roll straight ahead; the radius must be given where there are none
# or where they do not decrease.

from tire_model_test import (TRUCK, check, check_refused, output_of, require, scratch,
                             sweeps, write)

require("scipy")

from biface_tire_model import Measurements, read_tir
from biface_tire_model.table import write_table
from biface_tire_model.units import System

STIFFNESS, RADIUS = 2.5e5, 0.47

data = sweeps(read_tir(TRUCK).formula(), (4000, 8000, 12000), cambers=(0, 0.05))
# one force is enough
data = Measurements({name: data[name] for name in ("F_z", "slip_ratio", "slip_angle",
                                                   "inclination_angle", "F_y")})
radii = RADIUS - data["F_z"] / STIFFNESS
# of other states they do not count
radii[data["inclination_angle"] > 0] += 0.01
radii[abs(data["slip_angle"]) > 0.01] -= 0.02
system = System("mm, N, s")
table = write("table.csv", write_table({**data.columns, "loaded_radius": radii}, system))
output = scratch() / "fitted.tir"
words = ("--format", "5.2", "--units", "mm, N, s", "--without-combined", "neutral",
         "--output", output)
text = output_of("fit", table, *words)
check("Vertical stiffness 2.5e+05 N/m, radius without load 0.47 m." in text, text)
file = read_tir(output)
for name, value in (("VERTICAL_STIFFNESS", STIFFNESS), ("UNLOADED_RADIUS", RADIUS)):
    check(abs(file.find(name, 0) - value) < 1e-6 * value,
          f"{name} is {file.find(name, 0)}")

given = output_of("fit", table, *words, "--radius", "480")
check(abs(read_tir(output).find("UNLOADED_RADIUS", 0) - 0.48) < 1e-9, given)
without = write("without.csv", write_table(data.columns, system))
check_refused(("fit", without, *words), "--radius is missing")

constant = write("constant.csv",
                 write_table({**data.columns, "loaded_radius": 0 * radii + 0.241}, system))
check_refused(("fit", constant, *words), "--radius is missing")
given = output_of("fit", constant, *words, "--radius", "480")
check("Vertical stiffness" not in given, given)
check(read_tir(output).find("VERTICAL_STIFFNESS") is None, "a constant radius is soft")
