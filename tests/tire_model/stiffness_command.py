# SPDX-License-Identifier: LGPL-2.1-or-later

# The command stiffness writes tables in the units of the results or in SI units.

import csv
import io

from structure_test import Run
from tire_model_test import check, output_of, scratch

run = Run()
run.press("load", 2e5, (2000, 4000), lambda load: load / 2e5)
run.move("lateral", 4000, 2e5, 1.5e5)
run.move("longitudinal", 4000, 2e5, 4e5, "friction")
run.move("turn", 4000, 2e5, 5000)
run.vibrate("inflated without load", 2e5, [(40, 0, 1, 0, 0.8, 0), (60, 0, 3, 0, 0, 0)])
directory = run.write()


def tables(text):
    """The tables of the output, as lists of dictionaries."""
    return [list(csv.DictReader(io.StringIO("\n".join(part.splitlines()[1:]))))
            for part in text.split("\n\n")]


def agree(row, expected):
    """Checks fields of a row."""
    for name, value in expected.items():
        found = row[name]
        check(found == value if isinstance(value, str) else
              abs(float(found) - value) < 1e-9 * abs(value), f"{name} is {found}: {row}")


text = output_of("stiffness", directory)
radial, footprint, lateral, longitudinal, torsional, modes = tables(text)
agree(radial[1], {"stage": "load", "pressure [MPa]": 0.2, "load [N]": 4000,
                  "deflection [mm]": 20, "loaded_radius [mm]": 280, "secant [N/mm]": 200,
                  "tangent [N/mm]": 200})
agree(footprint[1], {"load [N]": 4000, "length [mm]": 4, "width [mm]": 2,
                     "area [mm^2]": 200})
agree(lateral[0], {"footprint": "glued", "motion [mm]": 0.2, "first_secant [N/mm]": 150,
                   "secant [N/mm]": 135, "tangent [N/mm]": 108})
agree(longitudinal[0], {"footprint": "with friction", "first_secant [N/mm]": 400})
degree = 3.14159265358979 / 180
agree(torsional[0], {"motion [degree]": 0.2,
                     "first_secant [N mm/degree]": 5e6 * degree})
agree(modes[0], {"stage": "inflated without load", "pressure [MPa]": 0.2, "mode": "1",
                 "frequency [Hz]": 40, "name": "lateral", "mass_y [%]": 80})
agree(modes[1], {"frequency [Hz]": 60, "name": "", "meridional_half_waves": "3"})

si = tables(output_of("stiffness", "--si", directory))
agree(si[0][1], {"pressure [Pa]": 2e5, "deflection [m]": 0.02, "tangent [N/m]": 2e5})
agree(si[4][0], {"motion [rad]": 0.2 * degree, "first_secant [N m/rad]": 5000})
folder = scratch() / "tables"
names = output_of("stiffness", directory, "-o", folder).split()
check([name.rsplit("/", 1)[1] for name in names] == [
    "radial_stiffness.csv", "footprint.csv", "lateral_stiffness.csv",
    "longitudinal_stiffness.csv", "torsional_stiffness.csv", "frequencies.csv"], f"{names}")
check("\n".join((folder / name).read_text(encoding="utf-8")
                for name in (name.rsplit("/", 1)[1] for name in names)) == text,
      "the files are not the text")

# several directories, of which one has a table of its own kind alone
other = Run("m, N, s")
other.move("lateral", 4000, 2e5, 1.5e5)
both = tables(output_of("stiffness", "--si", directory, other.write()))
check([float(row["secant [N/m]"]) for row in both[2]] == [135000, 135000], f"{both[2]}")
