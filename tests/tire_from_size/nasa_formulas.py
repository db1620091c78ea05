# SPDX-License-Identifier: LGPL-2.1-or-later

# The formulas of NASA TR R-64: the deflection is the inverse of the force, and a 49x17 at
# its rated deflection has 1.096 of its rated load and a footprint 574 mm long.

from tire_from_size_test import check_close

from biface_tire import nasa

force = nasa.force(1224.9, 427.4, 100.6, 1.172)
check_close(force / 176.1, 1.096, 1e-3, "the force over the rated load")
check_close(nasa.deflection(1224.9, 427.4, force, 1.172), 100.6, 1e-12, "the deflection")
check_close(nasa.footprint_length(1224.9, 100.6), 1.7 * (100.6 * 1124.3)**0.5, 1e-12,
            "the length")
check_close(nasa.rolling_radius(1224.9, 100.6), 612.45 - 100.6 / 3, 1e-12, "the radius")


def power(deflection):
    """Cornering power of a tire of 1000 mm."""
    return nasa.cornering_power(1000, 200, deflection, 1)


# both branches of the law meet at 0.0875 D, up to its digits, with the same slope
check_close(power(87.5 + 1e-6), power(87.5 - 1e-6), 1e-3, "the law at its seam")
slopes = [(power(87.5 + side * 2e-3) - power(87.5 + side * 1e-3)) / (side * 1e-3)
          for side in (1, -1)]
check_close(slopes[0], slopes[1], 1e-3, "the slope at the seam")
