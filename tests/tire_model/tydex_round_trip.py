# SPDX-License-Identifier: LGPL-2.1-or-later

# TYDEX files hold a table: one file for each sweep, in lines of up to 80 characters of which
# numbers have ten; they give its states again.

from tire_model_test import CHANNELS, MADE, check, require, scratch, sweeps

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_tir, read_tydex, write_tydex

data = sweeps(read_tir(MADE).formula(), (2000, 4000), (-0.05, 0.0), (2.2e5,), angles=7,
              slips=6)
folder = scratch() / "files"
paths = write_tydex(data, folder, (("TYWIDTH", "Section width", "mm", 205),))
names = [path.name for path in paths]
# at 2 loads and 2 cambers: cornering, braking, and combined slip at 4 slip angles
check(sorted(names) == sorted(
    [f"cornering_0{i}.tdx" for i in range(1, 5)] + [f"braking_0{i}.tdx" for i in range(1, 5)]
    + [f"combined_{i:02d}.tdx" for i in range(1, 17)]), f"{names}")
for path in paths:
    text = path.read_text(encoding="ascii")
    check(text.startswith("**HEADER\nRELEASE   Release of TYDEX-Format") and
          text.endswith("\n**END\n"), f"{path.name} begins or ends in another way")
    check(max(map(len, text.splitlines())) <= 80, f"{path.name} has long lines")
    rows = text.split("**MEASURDATA\n")[1].split("\n\n")[0].splitlines()
    check(all(len(row) == 80 for row in rows), f"{path.name} has other columns")
    check("TYWIDTH   Section width                 mm        205" in text, text)

again = read_tydex(folder)
slips = ("slip_ratio", "slip_angle", "inclination_angle", "F_z")


def sort(states, name):
    order = np.lexsort([np.round(states[slip], 6) for slip in slips])
    return states[name][order]


# a state without slip stands in two sweeps
check(len(again) == len(data) + 4, f"{len(again)} of {len(data)} states")
unique = np.unique(np.round(np.stack([again[slip] for slip in slips]), 6), axis=1,
                   return_index=True)[1]
again = again.where(unique)
for name in (*slips, "pressure", *CHANNELS):
    error = np.abs(sort(again, name) - sort(data, name)).max()
    check(error < 1e-4 * np.abs(data[name]).max(), f"the error of {name} is {error}")
