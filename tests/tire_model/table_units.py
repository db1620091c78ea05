# SPDX-License-Identifier: LGPL-2.1-or-later

# A unit behind the name of a column, options for all columns and the axes give the same
# states.

from tire_model_test import check, require, write

require("numpy", "scipy")

import math

import numpy as np
from biface_tire_model import read_table
from biface_tire_model.units import System

STATE = {"slip_ratio": -0.05, "slip_angle": math.radians(2),
         "inclination_angle": math.radians(-1.5), "pressure": 2.2e5, "velocity": 20.0,
         "F_x": -1000.0, "F_y": -1500.0, "F_z": 4000.0, "M_x": -30.0, "M_z": 25.0}
for text, system, axes in [
        ("slip_ratio,slip_angle,inclination_angle,pressure,velocity,F_x,F_y,F_z,M_x,"
         "M_z,remark\n-.05,2,-1.5,220000,20,-1000,-1500,4000,-30,25,none\n", None, "iso"),
        ("# a comment\nF_z [kN], F_y [kN], F_x[N], M_z [kNm], M_x [Nmm], pressure [bar], "
         "velocity [km/h], slip_angle [rad], inclination_angle [deg], "
         "slip_ratio [%]\n4,-1.5,-1000,.025,-30000,2.2,72,"
         f"{math.radians(2)!r},-1.5,-5\n", None, "iso"),
        ("slip_angle,inclination_angle,slip_ratio,pressure,velocity,F_x,F_y,F_z,M_x,"
         f"M_z\n{-math.radians(2)!r},{-math.radians(1.5)!r},-.05,.22,20000,-1000,1500,-4000,"
         "-30000,-25000\n", System("mm, N, s", "rad"), "sae"),
        ("\ufeffslip_angle,inclination_angle,slip_ratio,pressure,velocity,F_x,F_y,"
         "F_z,M_x,M_z\r\n-2,1.5,-.05,220000,20,-1000,-1500,4000,-30,25\r\n", None,
         "adapted-iso")]:
    data = read_table(write("table.csv", text), system, axes)
    for name, value in STATE.items():
        check(np.allclose(data[name], [value], rtol=1e-12),
              f"{name} is {data[name]}, not {value}, of {text}")
    check(np.isnan(data["M_y"]).all(), "M_y was not measured")
