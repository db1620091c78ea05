# SPDX-License-Identifier: LGPL-2.1-or-later

# Plies of a CSV file are those of the entry 'Plies': the results are the same, the
# written parameters contain them, and sweeps change their numbers.

import numpy as np

from python_test import COARSE, TIRE, biface, check, check_close, run, scratch

file = scratch() / "plies.csv"
file.write_text("""# inner ply first
material, thickness, angle, from, to
cord, "1.2 + 0*max(1, 2)", +-52
cord, 1.2, +-(50 + 2), ,
cord, 0.3, 0, -120, 120
""", encoding="utf-8")
ENTRY = "cord: 1.2 @ +-52, cord: 1.2 @ +-52, cord: 0.3 @ 0 from -120 to 120"

by_file = run({"Laminate/Plies file": file})
by_entry = run({"Laminate/Plies": ENTRY})
check(np.array_equal(by_file.history["force"], by_entry.history["force"]),
      "the forces differ")
check(by_file.setting("Laminate/Plies file") in ("", None), "the file is named again")
check(by_file.setting("Laminate/Plies").startswith("cord: 1.2 + 0*max(1, 2) @ +-52"),
      by_file.setting("Laminate/Plies"))

# the last entry counts
thick = run({"Laminate/Plies file": file, "Laminate/Plies": "cord: 5 @ +-52"})
check(thick.last("force") > 1.2 * by_file.last("force"), "the later entry is ignored")

# numbers of the file vary
file.write_text("cord, 1.2, 52\ncord, 1.2, -52\n", encoding="utf-8")
forces = biface.sweep(TIRE, {"angle: Laminate/Plies[2], -Laminate/Plies[4]": [52, 40]},
                      "force", {**COARSE, "Laminate/Plies file": file}, scratch())["force"]
for force, angle in zip(forces, (52, 40)):
    expected = run({"Laminate/Plies": f"cord: 1.2 @ {angle}, cord: 1.2 @ -{angle}"})
    check_close(force, expected.last("force"), 1e-6, f"the force with {angle} degrees")
