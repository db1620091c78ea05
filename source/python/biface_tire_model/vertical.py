# SPDX-License-Identifier: LGPL-2.1-or-later
"""The vertical stiffness of a tire that rolls straight ahead."""

from collections import namedtuple

import numpy as np

from .table import ANGLE_STEP

# A line through the loaded radii over the loads: the stiffness [N/m], the radius without
# load [m], and the range of the loads [N]
Vertical = namedtuple("Vertical", "stiffness radius lowest highest")

# A decrease of the loaded radius over all loads, relative to the radius without load, up to
# which it is constant
LEAST_DECREASE = 1e-6


def vertical(data, pressure: float | None = None) -> Vertical | None:
    """The Vertical of Measurements, by least squares over their states without slip and
    inclination.

    pressure  [Pa]; the states at the level next to it count, by default those at the level
              with most states

    None if there are no loaded radii at two loads, or if they do not decrease."""
    if data["loaded_radius"] is None:
        return None
    chosen = (data.is_lateral & data.is_longitudinal
              & (np.abs(data["inclination_angle"]) < ANGLE_STEP))
    if data["pressure"] is not None and len(data):
        values, numbers = data.levels("pressure")
        level = (np.bincount(numbers).argmax() if pressure is None
                 else np.abs(values - pressure).argmin())
        chosen &= numbers == level
    straight = data.where(chosen)
    if len(straight) == 0 or len(straight.levels("F_z")[0]) < 2:
        return None
    load = straight["F_z"]
    slope, radius = np.polyfit(load, straight["loaded_radius"], 1)
    # a constant radius has a slope of round-off
    if not -slope * np.ptp(load) > LEAST_DECREASE * radius:
        return None
    return Vertical(-1 / slope, radius, load.min(), load.max())
