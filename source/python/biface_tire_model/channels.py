# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a table of a tire test. All names are here."""

from collections import namedtuple

# Of each column: its kind of quantity, its channel and its unit in TYDEX files, None if
# it is not written there, and what it is
Channel = namedtuple("Channel", "name kind tydex tydex_unit meaning")

CHANNELS = {channel.name: channel for channel in (
    Channel("slip_ratio", "slip", "LONGSLIP", "%", "longitudinal slip"),
    Channel("slip_angle", "angle", "SLIPANGL", "deg", "slip angle"),
    Channel("inclination_angle", "angle", "INCLANGL", "deg", "inclination angle"),
    Channel("pressure", "pressure", "INFLPRES", "bar", "inflation pressure"),
    Channel("velocity", "velocity", "TRAJVELW", "m/s", "velocity"),
    Channel("loaded_radius", "length", None, None, "loaded radius"),
    Channel("F_x", "force", "FX", "N", "longitudinal force"),
    Channel("F_y", "force", "FYW", "N", "lateral force"),
    Channel("F_z", "force", "FZW", "N", "vertical force"),
    Channel("M_x", "moment", "MXW", "Nm", "overturning moment"),
    Channel("M_y", "moment", "MYW", "Nm", "rolling resistance moment"),
    Channel("M_z", "moment", "MZW", "Nm", "aligning moment"))}

# What a tire model takes, and what it gives
INPUTS = ("slip_ratio", "slip_angle", "inclination_angle", "pressure", "velocity",
          "F_z")
OUTPUTS = ("F_x", "F_y", "M_x", "M_y", "M_z")
