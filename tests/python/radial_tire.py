# SPDX-License-Identifier: LGPL-2.1-or-later

# The files of prm/radial_tire.prm are those of its design, whose carcass passes through
# the widest point and the flange, and carries the pressure between belts and rim: the
# axial part of its direction, over r^2 less that of the widest point, is constant.

import sys

from python_test import SOURCE, check, check_close, require, scratch

require("numpy", "scipy")

import numpy as np

sys.path.insert(0, str(SOURCE / "doc/measured_tires"))

from radial_tire import RadialTire, write

tire = RadialTire()
folder = scratch()
write(tire, folder)
for name in ("radial_tire_profile.csv", "radial_tire_plies.csv"):
    check((folder / name).read_text(encoding="utf-8")
          == (SOURCE / "prm" / name).read_text(encoding="utf-8"), f"{name} differs")

points, _ = tire.profile()
check_close(points[:, 1].max(), tire.half_width, 3e-4, "the widest point")
check_close(points[-1, 1], tire.end_half_width, 1e-9, "the half width at the flange")
side = points[len(points) * 3 // 4:]
chords = np.diff(side, axis=0)
radius = (side[1:, 0] + side[:-1, 0]) / 2
axial = chords[:, 1] / np.linalg.norm(chords, axis=1)
far = np.abs(radius - tire.widest) > 10
ratio = axial[far] / (radius[far]**2 - tire.widest**2)
check(np.ptp(ratio) < 2e-3 * abs(ratio.mean()), f"the ratio is {ratio}")
