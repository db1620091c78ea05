# SPDX-License-Identifier: LGPL-2.1-or-later

# Rigid bodies are drawn where the clearances of the nodes near them say that they
# are, and not at all where these contradict the shape.

import sys

from report_test import PACKAGE, check, require, scratch

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Results
from biface_report.bodies import bodies_of

COLUMNS = ("alpha_1", "alpha_2", "x", "y", "z", "clearance", "pressure", "active")
INPUT = """
set Bodies = stop, rod, tank
subsection Body stop
  set Shape = plane
  set Point = 0, 0, 5
  set Direction = 0, 0, 1
  set Axis = 0, 1, 0
  set Motions = push: 1 0 -2
end
subsection Body rod
  set Shape = cylinder
  set Point = 20, 0, 30
  set Direction = 1, 0, 0
  set Axis = 0, 1, 0
  set Radius = 8
  set Motions = pass: -3 0 0
end
subsection Body tank
  set Shape = sphere
  set Point = 0, 0, 0
  set Direction = 1, 0, 0
  set Axis = 0, 1, 0
  set Radius = -40
  set Motions =
end
"""

directory = scratch()
(directory / "parameters.prm").write_text(INPUT, encoding="utf-8")
(directory / "history.csv").write_text(
    "step,stage,approach,force,contact_nodes,contact_area,max_pressure,iterations,"
    "seconds,pressure,load_factor\n"
    + "".join(f"{step},push,0,0,0,0,0,3,1,0,1\n" for step in (1, 2)), encoding="utf-8")
points = np.random.default_rng(1).uniform(-6, 6, (30, 3)) + [0, 0, 15]


def write(name, step, clearances):
    """The nodes near a body."""
    rows = [[0, 0, *point, clearance, 0, 0]
            for point, clearance in zip(points, clearances)]
    (directory / f"contact-{name}-{step:04d}.csv").write_text(
        "\n".join([",".join(COLUMNS)] + [",".join(map(repr, map(float, row)))
                                         for row in rows]) + "\n", encoding="utf-8")


def cylinder(center):
    """Distances from the rod with its center there."""
    return np.hypot(points[:, 0] - center[0], points[:, 2] - center[2]) - 8


# the plane has moved by -6 along its normal, the cylinder into the midst of the
# nodes, the hollow sphere not at all; in step 2, all have moved as they cannot
write("stop", 1, -1 - points[:, 2])
write("rod", 1, cylinder([1, 0, 30]))
write("tank", 1, 40 - np.linalg.norm(points, axis=1))
write("stop", 2, -1 - points[:, 0])
write("rod", 2, cylinder([1, 0, 40]))
write("tank", 2, 41 - np.linalg.norm(points, axis=1))

drawn, left_out = bodies_of(Results(directory), {1: "one", 2: "two"}, points)
check(len(drawn) == 3 and not left_out, f"{len(drawn)} bodies, without {left_out}")
for body, expected in zip(drawn, ([0, 0, -6], [-19, 0, 0], [0, 0, 0])):
    check(list(body["places"]) == ["one"], f"places in {list(body['places'])}")
    place = body["places"]["one"]
    check(np.allclose(place, expected, atol=1e-9), f"moved by {place}")
