# SPDX-License-Identifier: LGPL-2.1-or-later

# A file in other units is the same tire.

from tire_model_test import MADE, check, require

require("numpy", "scipy")

import math
import re

import numpy as np
from biface_tire_model import read_tir
from biface_tire_model.tir_file import parse

SI = {"LENGTH": "meter", "FORCE": "newton", "ANGLE": "radians", "MASS": "kg",
      "TIME": "second"}
ENTRIES = {"UNLOADED_RADIUS": 0.32, "FNOMIN": 4200, "LONGVL": 16.7, "INFLPRES": 220000,
           "NOMPRES": 220000, "PRESMIN": 150000, "PRESMAX": 300000, "FZMIN": 400,
           "FZMAX": 9000, "ALPMIN": -0.5, "ALPMAX": 0.5, "CAMMIN": -0.12, "CAMMAX": 0.12}
DEGREE = math.pi / 180
SYSTEMS = [
    # units, and the sizes of length, force, velocity, pressure and angle
    ({"LENGTH": "mm", "FORCE": "KN", "ANGLE": "deg", "TIME": "s", "PRESSURE": "bar"},
     (1e-3, 1e3, 1e-3, 1e5, DEGREE)),
    ({"LENGTH": "INCH", "FORCE": "pound_force", "ANGLE": "Degrees", "TIME": "min",
      "PRESSURE": "psi", "MASS": "slug"},
     (0.0254, 4.4482216152605, 0.0254 / 60, 6894.757293168, DEGREE)),
    # without a unit of pressure it is that of force and length
    ({"LENGTH": "cm", "FORCE": "kgf", "TIME": "hour"},
     (1e-2, 9.80665, 1e-2 / 3600, 9.80665e4, 1)),
]

original = read_tir(MADE)
source = MADE.read_text(encoding="utf-8")
for system, (length, force, velocity, pressure, angle) in SYSTEMS:
    sizes = {"UNLOADED_RADIUS": length, "FNOMIN": force, "FZMIN": force, "FZMAX": force,
             "LONGVL": velocity, **dict.fromkeys(("INFLPRES", "NOMPRES", "PRESMIN",
                                                  "PRESMAX"), pressure),
             **dict.fromkeys(("ALPMIN", "ALPMAX", "CAMMIN", "CAMMAX"), angle)}
    text = source
    for name, value in ENTRIES.items():
        text, count = re.subn(rf"^{name} = .*$", f"{name} = {value / sizes[name]!r}", text,
                              flags=re.MULTILINE)
        check(count == 1, f"{name} is not there")
    for name, value in SI.items():
        text = text.replace(f"{name} = '{value}'\n", "")
    text = text.replace("[UNITS]\n", "[UNITS]\n" + "".join(
        f"{name} = '{value}'\n" for name, value in system.items()))
    file = parse(text)
    for name, value in ENTRIES.items():
        check(abs(file.find(name) / value - 1) < 1e-12,
              f"{name} is {file.find(name)}, not {value}")
    state = (5000, -0.05, 0.08, 0.03, 2e5, 20)
    check(np.allclose(file.formula().evaluate(*state), original.formula().evaluate(*state),
                      rtol=1e-11), "other forces")
