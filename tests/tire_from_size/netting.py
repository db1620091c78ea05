# SPDX-License-Identifier: LGPL-2.1-or-later

# Bias tires by the rules: the middle of the carcass passes through crown, widest point and
# flange, and the cords at the crown carry the axial load p pi (r_c^2 - r_w^2) of one side.

import math

from tire_from_size_test import check, check_close

from biface_tire.bias import BURST, BiasTire, Netting

tire = BiasTire(416.6, 104.6, 117.6, 63.5, 0.386)
curve = tire.curve
check_close(curve.width_at(curve.widest), tire.half_width, 1e-6, "the half width")
check_close(curve.width_at(tire.end), tire.end_half_width, 1e-6, "the half width at the end")
check_close(math.cos(math.radians(curve.angle_at(150))) / 150,
            math.cos(math.radians(curve.degrees)) / curve.crown, 1e-12, "the lift")

# n plies of cords at the pitch c: axial force n T sin^2(b)/c around the crown
force = curve.cord_force(0.386, 1, 2)
check_close(2 * math.pi * curve.crown * 2 * force * curve.sine**2,
            0.386 * math.pi * (curve.crown**2 - curve.widest**2), 1e-12, "the balance")
check(force * BURST <= 125 and tire.plies == 2, f"{tire.plies} plies, {force} N")
strong = BiasTire(416.6, 104.6, 117.6, 63.5, 1.5)
check(strong.plies > 2 and strong.burst_factor >= BURST, f"{strong.plies} plies")

# a slender torus is a circle whatever the angle: its radius of curvature is the half width
slender = Netting.with_angle(10000, 10, 45)
check_close(slender.crown - slender.widest, 10, 2e-3, "the radius of the circle")
