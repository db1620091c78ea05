# SPDX-License-Identifier: LGPL-2.1-or-later

# Radial carcasses of all kinds lead from the belts through the widest point to the flange,
# also where the sidewall does not leave the belts smoothly, and their cords have the force
# that balances the pressure on the ring between two circles.

import math

import numpy as np

from tire_from_size_test import check_close

from biface_tire.design import Design

for text in ("155/80R13 79T", "195/65R15 91V", "225/45R17 91W", "245/35R19 93Y",
             "LT235/85R16 LRE", "11R22.5", "385/65R22.5 160K", "380/85R28 133A8"):
    design = Design(text)
    tire = design.tire
    points, _ = tire.profile()
    check_close(points[-1, 0], tire.end, 1e-6, f"{text}: the end")
    check_close(points[-1, 1], tire.end_half_width, 1e-6, f"{text}: the end's half width")
    check_close(points[:, 1].max(), tire.half_width, 1e-3, f"{text}: the half width")
    check_close(points[:, 0].max(), tire.crown, 1e-6, f"{text}: the crown")
    # axial balance between the widest circle and a circle above it
    place = len(points) * 3 // 4
    below, above = points[place], points[place - 1]
    radius = (below[0] + above[0]) / 2
    axial = (below[1] - above[1]) / math.dist(below, above)
    force = design.pressure * np.pi * (radius**2 - tire.widest**2) / axial
    cords = (tire.carcass_plies * tire.carcass_density / 100 * 2 * np.pi * tire.rim_radius)
    if abs(axial) > 0.1:
        check_close(tire.cord_tension(design.pressure), force / cords, 0.02,
                    f"{text}: the cord's force")
