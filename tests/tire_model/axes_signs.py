# SPDX-License-Identifier: LGPL-2.1-or-later

# Conversions between axes turn the vectors of forces and moments, go back, and give the
# adapted axes positive slip stiffnesses.

from tire_model_test import MADE, check, require

require("numpy", "scipy")

import itertools

import numpy as np
from biface.errors import BifaceError
from biface_tire_model import convert, read_tir
from biface_tire_model.axes import SIGNS

random = np.random.default_rng(3)
names = ("slip_ratio", "slip_angle", "inclination_angle", "F_x", "F_y", "F_z", "M_x",
         "M_y", "M_z", "pressure")
values = {name: random.standard_normal(4) for name in names}
for source, middle, target in itertools.product(SIGNS, repeat=3):
    there = convert(convert(values, source, middle), middle, target)
    direct = convert(values, source, target)
    check(all((there[name] == direct[name]).all() for name in names),
          f"{source} to {middle} to {target} is another way")
    back = convert(direct, target, source)
    check(all((back[name] == values[name]).all() for name in names), "no way back")

# SAE: x forward, y to the right, z down, which is a half turn about x
turn = np.diag([1, -1, -1])
other = convert(values, "iso", "sae")
for kind in "FM":
    vector = np.array([values[f"{kind}_{i}"] for i in "xyz"])
    check(np.allclose(turn @ vector, [other[f"{kind}_{i}"] for i in "xyz"]),
          f"{kind} is not turned")
# the slip angle is that of the velocity in each; the inclination is a turn about x
check((other["slip_angle"] == -values["slip_angle"]).all()
      and (other["inclination_angle"] == values["inclination_angle"]).all(), "angles")

# stiffnesses: F_y over slip angle and inclination
formula = read_tir(MADE).formula()
h = 1e-5
for axes, sign in (("iso", -1), ("sae", -1), ("adapted-iso", 1), ("adapted-sae", 1)):
    for angle in ("slip_angle", "inclination_angle"):
        forces = []
        for value in (-h, h):
            state = convert({"slip_angle": 0.0, "inclination_angle": 0.0, angle: value,
                             "F_z": 4000.0 * SIGNS[axes].get("F_z", 1)}, axes, "iso")
            result = formula.evaluate(state["F_z"], 0, state["slip_angle"],
                                      state["inclination_angle"])
            forces.append(convert(result._asdict(), "iso", axes)["F_y"])
        stiffness = (forces[1] - forces[0]) / (2 * h)
        expected = 1 if axes == "sae" and angle == "inclination_angle" else sign
        check(stiffness * expected > 1000,
              f"{axes}: F_y over {angle} is {stiffness}")
try:
    convert(values, "iso", "din")
    check(False, "unknown axes are accepted")
except BifaceError as error:
    check(str(error) == "the axes are 'din', but must be iso, sae, adapted-iso or "
                        "adapted-sae.",
          str(error))
