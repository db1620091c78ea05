# SPDX-License-Identifier: LGPL-2.1-or-later

# The four frequencies of a rigid ring are those of the modes that move as one; a mode
# without waves that is radial is not the rotation about the axle.

from structure_test import Run, structural, values
from tire_model_test import check

import numpy as np


def turning(axis):
    """A rotation."""
    return lambda points: np.cross(axis, points)


def radial(points):
    """Away from the axle."""
    return points * (1, 0, 1)


def tilting(axis, bend):
    """A rotation with bending of the belt, which is no part of it."""
    def motion(points):
        angle = np.arctan2(points[:, 2], points[:, 0])
        result = np.cross(axis, points)
        result[:, 1] += bend * np.cos(3 * angle)
        return result
    return motion


def modes(radial_share=0.0, tilt=0.5):
    """A run with all modes: lateral, radial, yaw, wind-up, longitudinal."""
    run = Run()
    step = run.vibrate("inflated", 2e5, [
        (40, 0, 1, 0, 0.8, 0), (50, 1, 2, 0.001, 0, 0), (50.001, 1, 2, 0, 0, 0.001),
        (60, 0, 3, radial_share, 0, 0), (70, 0, 1, 0, 0, 0), (90, 1, 3, 0.7, 0, 0),
        (90.2, 1, 3, 0, 0, 0.6), (95, 2, 3, 0, 0, 0)])
    for mode, motion in ((1, lambda points: 0 * points + (0, 1, 0)),
                         (2, tilting((1, 0, 0), tilt)), (3, tilting((0, 0, 1), tilt)),
                         (4, radial), (5, turning((0, 1, 0))),
                         (6, lambda points: 0 * points + (1, 0, 0)),
                         (7, lambda points: 0 * points + (0, 0, 1))):
        run.shape(step, mode, motion)
    return run


result = structural(modes())
found = {name: value for name, value in values(result).items() if name[:4] == "FREQ"}
for name, frequency in (("FREQ_LAT", 40), ("FREQ_YAW", 50.0005), ("FREQ_WINDUP", 70),
                        ("FREQ_LONG", 90.1)):
    check(abs(found[name] - frequency) < 1e-9, f"{name} is {found.get(name)}")

# a pair that bends more than it tilts is no yaw mode
result = structural(modes(tilt=2))
check("FREQ_YAW" not in values(result) and "the largest has" in
      result.left_out["FREQ_YAW"], f"{result.left_out}")
