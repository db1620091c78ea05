# SPDX-License-Identifier: LGPL-2.1-or-later

# Load indices have the masses of the table of UN R30 and R54, speed symbols its speeds.

from tire_from_size_test import check

from biface_tire.service import SPEEDS, load_of, mass_of

TABLE = {0: 45, 1: 46.2, 41: 145, 61: 257, 71: 345, 75: 387, 80: 450, 81: 462, 88: 560,
         89: 580, 91: 615, 94: 670, 100: 800, 101: 825, 109: 1030, 121: 1450, 133: 2060,
         141: 2575, 148: 3150, 156: 4000, 160: 4500, 173: 6500, 240: 45000}
for index, mass in TABLE.items():
    found = mass_of(index)
    check(found == mass, f"the mass of {index} is {found}, not {mass}")
check(abs(load_of(91) - 615 * 9.80665) < 1e-9, f"the load of 91 is {load_of(91)}")
check((SPEEDS["A8"], SPEEDS["T"], SPEEDS["H"], SPEEDS["V"]) == (40, 190, 210, 240),
      f"{SPEEDS}")
