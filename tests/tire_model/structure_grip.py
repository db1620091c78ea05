# SPDX-License-Identifier: LGPL-2.1-or-later

# A glued footprint counts before one with friction, one without friction not at all, and
# the first step of a stage counts.

from structure_test import Run, structural, values
from tire_model_test import check

run = Run()
run.move("lateral", 4000, 2e5, 8e4, "friction")
run.move("lateral", 4000, 2e5, 1e5, "glued")
run.move("lateral", 4000, 2e5, 1.0, "none")
run.move("longitudinal", 4000, 2e5, 3e5, "friction")
run.move("turn", 4000, 2e5, 4000, "none")
result = structural(run)
comments = {entry.name: entry.comment for entry in result.known}
for name, stiffness, grip in (("LATERAL_STIFFNESS", 1e5, "glued"),
                              ("LONGITUDINAL_STIFFNESS", 3e5, "with friction")):
    check(abs(values(result)[name] - stiffness) < 1e-6 * stiffness, f"{values(result)}")
    check(comments[name].startswith(f"footprint {grip}, "), comments[name])
check("YAW_STIFFNESS" in result.left_out, f"{result.known}")
