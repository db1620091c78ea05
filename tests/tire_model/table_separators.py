# SPDX-License-Identifier: LGPL-2.1-or-later

# Semicolons, tabs, blanks, decimal commas, short names, a title and a line of units give
# the same states as commas.

from tire_model_test import check, require, write

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_table
from biface_tire_model.units import System

NAMES = ("slip_angle [deg]", "inclination_angle [deg]", "slip_ratio", "pressure [kPa]",
         "velocity [km/h]", "loaded_radius [cm]", "F_x [N]", "F_y [N]", "F_z [N]",
         "M_x [Nm]", "M_z [Nm]")
SHORT = "SA,IA,SL,P,V,RL,FX,FY,FZ,MX,MZ"
UNITS = "deg,deg,-,kPa,kph,cm,N,N,N,N-m,N-m"
ROWS = ("-12.5,0,-.05,97,40.2,24.1,3.25,780.137,700,0,-0.7649", "2,1.5,0.1,97,40,24,5,-500,"
        "1100,1e1,5.0")


def comma(row):
    """A row with decimal commas, separated by semicolons."""
    return row.replace("-.", "-0.").replace(",", ";").replace(".", ",")


reference = read_table(write("table.csv", "\n".join([",".join(NAMES), *ROWS])))
texts = {
    "semicolons": [";".join(NAMES), *(row.replace(",", ";") for row in ROWS)],
    "decimal commas": [";".join(NAMES), *map(comma, ROWS)],
    "tabs": ["\t".join(NAMES), *(row.replace(",", "\t") for row in ROWS)],
    "tabs and decimal commas": ["\t".join(NAMES),
                                *(comma(row).replace(";", "\t") for row in ROWS)],
    "blanks": [" ".join(NAMES), *(row.replace(",", "  ") for row in ROWS)],
    "blanks and decimal commas": [" ".join(NAMES),
                                  *(comma(row).replace(";", " ") for row in ROWS)],
    "raw": ["tire A run 1", SHORT, UNITS, *ROWS],
    "raw with tabs": ["run\t1", SHORT.replace(",", "\t"), UNITS.replace(",", "\t"),
                      *(row.replace(",", "\t") for row in ROWS)],
    "units in brackets": ["% title", ",".join(f"{name} ({unit})" for name, unit in zip(
        SHORT.split(","), UNITS.split(","))), *ROWS],
    "a short name beside a long one": [",".join(NAMES) + ",P,V",
                                       *(row + ",1,2" for row in ROWS)]}
for what, lines in texts.items():
    data = read_table(write("table.csv", "\n".join(lines)), System("mm, N, s")
                      if "raw" in what else None)
    check(list(data.columns) == list(reference.columns) or "raw" in what
          or set(data.columns) == set(reference.columns), f"{what}: other columns")
    for name, values in reference.columns.items():
        check(np.allclose(data[name], values, rtol=1e-12, atol=1e-12),
              f"{what}: {name} is {data[name]}, not {values}")
