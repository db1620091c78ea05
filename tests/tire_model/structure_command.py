# SPDX-License-Identifier: LGPL-2.1-or-later

# The command fit adds what results tell to the file and to its text; the vertical
# stiffness is that of the approaching ground if the table has no loaded radii.

from structure_test import Run
from tire_model_test import check, neutral_formula, output_of, scratch, sweeps, write

import numpy as np
from biface_tire_model import read_tir
from biface_tire_model.magic_formula import MF61
from biface_tire_model.table import write_table
from biface_tire_model.units import System

formula = neutral_formula(MF61, PKY1=-18, PCY1=1.3, PKX1=20, PCX1=1.6)
data = sweeps(formula, (4000,), pressures=(2e5,))
pure = data.where(data.is_lateral | data.is_longitudinal)
columns = {name: pure[name] for name in ("F_z", "slip_ratio", "slip_angle", "pressure",
                                         "F_x", "F_y")}
run = Run()
# the tangent stiffness at 4000 N is that of deflections a F + b F^2
run.press("load", 2e5, range(500, 7001, 100), lambda load: 5e-6 * load + 1e-11 * load ** 2)
run.move("lateral", 4000, 2e5, 1.5e5)
run.move("longitudinal", 4000, 2e5, 4e5)
run.vibrate("inflated", 2e5, [(40, 0, 1, 0, 0.8, 0)])
path = scratch() / "fitted.tir"
words = ("--format", "6.1", "--radius", "0.3", "--output", path, "--without-combined",
         "neutral", "--structure", run.write())
system = System()
text = output_of("fit", write("table.csv", write_table(columns, system)), *words)
file = read_tir(path)
vertical = 1 / (5e-6 + 2e-11 * 4000)
for name, value in (("VERTICAL_STIFFNESS", vertical), ("LATERAL_STIFFNESS", 1.5e5),
                    ("LONGITUDINAL_STIFFNESS", 4e5), ("FREQ_LAT", 40)):
    check(abs(file.find(name, 0) - value) < 1e-4 * value, f"{name} is {file.find(name)}")
lengths = [abs(float(getattr(file.formula(), motion)(4000).slope)) / stiffness
           for motion, stiffness in (("lateral", 1.5e5), ("longitudinal", 4e5))]
row = [line.split() for line in text.splitlines() if line.split()[0] == "4000"]
check(len(row) == 1 and np.allclose([float(word) for word in row[0][2:]], lengths,
                                    rtol=1e-4), f"{row}: not {lengths}")
check("Left out: FREQ_LONG: no pair with one wave" in text
      and "LATERAL_STIFFNESS" in text and "footprint glued" in text, text)
check("Left out: YAW_STIFFNESS: no stage moves the ground so from a loaded state." in text,
      text)
