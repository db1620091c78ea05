# SPDX-License-Identifier: LGPL-2.1-or-later

# Forces in wheel axes are those of forces.csv in the axes of ISO 8855, with moments
# about the contact center; the vertical one is the force of history.csv.

import sys

from report_test import PACKAGE, RUNS, check, check_equal, page_of, read_csv, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface_report.ground import Ground
from biface_report.wheel import WheelAxes

# forces of a ground at some points of it, upright and inclined, flat and round
rng = np.random.default_rng(3)
for direction in ([2.0, 0, 0], [1, 0, -0.4], [1, 0.5, 0.2]):
    for shape in ("plane", "sphere"):
        ground = Ground(shape, direction, [230, 4, 30], 400.0, travel=7.0)
        wheel = WheelAxes(direction)
        forward, left, up = wheel.axes
        check(np.allclose(wheel.axes @ wheel.axes.T, np.eye(3)), "not orthonormal")
        check(np.allclose(np.cross(forward, left), up), "not right-handed")
        check(abs(forward[1]) < 1e-12 and left[1] > 0, "left is not along the axle")
        check(np.allclose(up, -ground.direction), "up is not away from the ground")

        center = wheel.contact_center(ground)
        check(abs(ground.clearance(center)) < 1e-9, "the center is above the ground")
        check(abs(center[1]) < 1e-12, "the center is beside the wheel")
        check(abs(center @ forward) < 1e-9, "the center is not below the axle")

        points, forces = rng.uniform(-1, 1, (2, 9, 3))
        about = rng.uniform(-300, 300, 3)
        force, moment = wheel.resultant(
            forces.sum(0), np.cross(points - about, forces).sum(0), about, center)
        local = (points - center) @ wheel.axes.T
        expected = np.cross(local, forces @ wheel.axes.T).sum(0)
        check(np.allclose(force, (forces @ wheel.axes.T).sum(0)), "another force")
        check(np.allclose(moment, expected, atol=1e-9), "another moment")

# the ground of the shipped tire is below it along x: forward is z
page = page_of(RUNS / "rough")
history = read_csv(RUNS / "rough/history.csv")
forces = {line["step"]: line for line in read_csv(RUNS / "rough/forces.csv")
          if line["body"] == "foundation"}
line = forces[history[-1]["step"]]
f_x, f_y, f_z, m_x, m_y, m_z, radius = page.numbers(f"Step {line['step']}")
check_equal(f_z, float(history[-1]["force"]), "vertical force")
check_equal(f_y, float(line["F_y"]), "lateral force")
check_equal(f_x, float(line["F_z"]), "longitudinal force")
check_equal(m_z, -float(line["M_x"]), "aligning moment")
check(abs(m_x - (float(line["M_z"]) - radius * f_y)) < 1e-6 * abs(m_x),
      f"overturning moment {m_x}")
check(abs(m_y - (float(line["M_y"]) + radius * f_x)) < 1e-6 * abs(m_x),
      f"rolling moment {m_y}")
check(m_x > 0, "the tire overturns to the right although the ground moved left")
check("Stick and slip" in page.headings, "no picture of stick and slip")
check("Stick and slip" not in page_of(RUNS / "bias_tire").headings,
      "stick and slip without friction")
check("Forces in wheel axes" not in page_of(RUNS / "composite_panel").headings,
      "a panel is no wheel")
