# SPDX-License-Identifier: LGPL-2.1-or-later

# Of a run, the entries are the numbers of its stiffness.csv and modes.csv in SI units; a
# tire with belts has all four frequencies, a bias tire no longitudinal one.

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/python"))

from structure_test import made_fit, values
from tire_model_test import SOURCE, check, scratch

import biface
from biface_tire_model.structural import Structural
from biface_tire_model.structure import read_structure

results = biface.run(SOURCE / "prm/tire_modes.prm", {
    "Mesh/Intervals alpha_1": "-120:120:14",
    "Mesh/Intervals alpha_2": "-180:-20:4:smooth, -20:20:6, 20:180:4:smooth",
    "Number of stages": 4, "Stage 1/Modes": 0, "Stage 2/Modes": 3, "Stage 3/Modes": 0,
    "Stage 3/Travel": 15, "Stage 3/Steps": 2, "Stage 4/Name": "lateral",
    "Stage 4/Contact": True, "Stage 4/Glued": True, "Stage 4/Slide": "0, 0.1, 0"},
    scratch())
stiffness = results.stiffness().where(stage="lateral").row(0)
modes = results.modes()
fit = made_fit(loads=(1000, 3000), pressures=(1.5e5,), FNOMIN=float(stiffness["force"]),
               NOMPRES=1.5e5, PKY1=-15)
result = Structural(read_structure([results.directory]), fit, True)
found = values(result)
for name, value in (("LATERAL_STIFFNESS", 1000 * stiffness["secant"]),
                    ("FREQ_LAT", modes["frequency"][0]),
                    ("FREQ_YAW", modes["frequency"][1:].mean())):
    check(abs(found[name] - value) < 1e-9 * value, f"{name} is {found}, not {value}")
check("FREQ_WINDUP" in result.left_out and "FREQ_LONG" in result.left_out,
      f"{result.left_out}")
# the yaw mode is nearly a rigid rotation of the carcass
shares = read_structure([results.directory]).modes[0].rotations
check(abs(shares[1, [0, 2]].sum() + shares[2, [0, 2]].sum() - 1.74) < 0.06, f"{shares}")

# the names by shapes are those that the waves of this tire tell, too
results = biface.run(SOURCE / "prm/belted_tire.prm", {
    "Mesh/Intervals alpha_1": "0:131.2:8, 131.2:251.2:10, 251.2:382.4:8",
    "Mesh/Intervals alpha_2": "-180:180:40", "Number of stages": 1, "Stage 1/Modes": 15,
    "Material rubber/Density": 1.1e-9, "Material carcass/Density": 1.2e-9,
    "Material belt/Density": 1.6e-9, "Output/Write ply VTU": False}, scratch())
modes = results.modes()
fit = made_fit(FNOMIN=4000, NOMPRES=2e5, PKY1=-15)
found = values(Structural(read_structure([results.directory]), fit, True))
waves, half = modes["circumferential_waves"], modes["meridional_half_waves"]
moves = sum(modes["effective_mass_" + axis] for axis in "xyz") > 0.5 * modes["total_mass"]
for name, chosen in (("FREQ_LAT", (waves == 0) & moves), ("FREQ_LONG", (waves == 1) & moves),
                     ("FREQ_YAW", (waves == 1) & (half == 1) & ~moves),
                     ("FREQ_WINDUP", (waves == 0) & (half == 1) & ~moves)):
    value = modes["frequency"][chosen].mean()
    check(abs(found[name] - value) < 1e-9 * value, f"{name} is {found}, not {value}")
