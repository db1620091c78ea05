# SPDX-License-Identifier: LGPL-2.1-or-later

# USE_MODE below 0 gives the mirror image of the tire in all functions, --mirror turns it
# back, and check names it.

from tire_model_test import MADE, check, output_of, require, tire_model, write

require("numpy", "scipy")

import numpy as np
from biface_tire_model import mirror, read_tir

STATE = {"slip_ratio": np.array([-0.1, 0, 0.03]), "slip_angle": np.array([0.03, -0.1, 0.15]),
         "inclination_angle": np.array([0.04, 0.02, -0.05])}

source = MADE.read_text(encoding="utf-8")
path = write("mirrored.tir", source.replace("[MODEL]\n", "[MODEL]\nUSE_MODE = -14\n"))
there, here = read_tir(path).formula(), read_tir(MADE).formula()
image = mirror(STATE)


def check_same(what, value, expected):
    """Checks that two values are the same but for round-off."""
    check(np.allclose(value, expected, rtol=1e-12, atol=1e-9),
          f"{what}: {value}, {expected}")


forces = mirror(here.evaluate(4000, *image.values())._asdict())
for name, value in there.evaluate(4000, *STATE.values())._asdict().items():
    check_same(name, value, forces[name])
check_same("lateral_force", there.lateral_force(4000, *STATE.values()), forces["F_y"])
check_same("longitudinal_force", there.longitudinal_force(4000, *STATE.values()),
           forces["F_x"])
check_same("M_x", there.overturning_moment(4000, forces["F_y"], STATE["inclination_angle"]),
           forces["M_x"])
alpha, gamma = STATE["slip_angle"], STATE["inclination_angle"]
one, other = there.lateral(4000, alpha, gamma), here.lateral(4000, -alpha, -gamma)
check_same("F_y of pure slip", one.value, -other.value)
check_same("slope", one.slope, other.slope)
check_same("shifts", [one.S_H, one.S_V], [-other.S_H, -other.S_V])
check_same("M_z of pure slip", there.aligning_moment(4000, alpha, gamma),
           -here.aligning_moment(4000, -alpha, -gamma))

words = ["--fz", "4000", "--alpha", "-3,4", "--gamma", "2"]
check(output_of("evaluate", path, *words) == output_of("evaluate", MADE, *words, "--mirror"),
      "USE_MODE is not --mirror")
check(output_of("evaluate", path, *words, "--mirror") == output_of("evaluate", MADE, *words),
      "the mirror image of the mirror image is another tire")
quoted = write("quoted.tir", source.replace("[MODEL]\n", "[MODEL]\nUSE_MODE = '-14'\n"))
check(output_of("evaluate", quoted, *words) == output_of("evaluate", path, *words),
      "USE_MODE in quotes is another one")
check("USE_MODE is -14: below 0 the tire is evaluated as its mirror image"
      in tire_model("check", path)[1], "check does not name USE_MODE")
