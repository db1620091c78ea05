# SPDX-License-Identifier: LGPL-2.1-or-later

# The charts of a frequency response show the force of the wheel with that of its rim on
# the air: if the ground shakes the tire, it is that of the ground if the wheel shakes it.

import sys

from report_test import PACKAGE, RUNS, check, page_of, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np

from biface import Results
from biface_report import response

run = Results(RUNS / "response")
table = run.response()
by_ground, by_wheel = (table.where(excitation=name)
                       for name in ("ground x", "supports x"))
wheel = response.total_forces(run, by_ground)["wheel"][:, 0]
ground = response.total_forces(run, by_wheel)["ground"][:, 0]
check(np.abs(wheel - ground).max() < 1e-6 * np.abs(ground).max(), f"{wheel - ground}")
on_air = by_ground.where(output="rim on air")["x"]
check(np.abs(on_air).max() > 0.1 * np.abs(wheel).max(), "the air does nothing")

labels = [curve.label for curve in response.force_curves(run, by_ground, 0)]
check({"ground, $F_x$", "wheel, $F_x$"} <= set(labels), f"{labels}")
moved = response.point_curves(by_ground)
check([curve.label for curve in moved] == ["crown, $u_x$"], f"{moved}")
check(np.allclose(abs(moved[0].values), 1, atol=0.02),
      "the crown does not move with the ground")
check(response.label_of(run, "ground x", "forces") == "dynamic stiffness [N/mm]",
      "the unit of a force by a motion")
check(response.label_of(run, "pressure", "displacements") == "displacement [mm/MPa]",
      "the unit of a displacement by the pressure")

# modes.csv has others above the last frequency of the response
natural = response.natural_frequencies(run, by_ground)
check(0 < len(natural) < len(run.modes())
      and (natural <= by_ground["frequency"].max()).all(), f"{natural}")

page = page_of(RUNS / "response")
for excitation in ("ground x", "supports x"):
    for what in ("forces", "displacements"):
        check(any(what in image["alt"]
                  and image["alt"].endswith(f"excitation {excitation}.")
                  for image in page.images), f"no {what} by {excitation}")
