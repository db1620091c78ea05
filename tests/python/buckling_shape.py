# SPDX-License-Identifier: LGPL-2.1-or-later

# The file of a buckling shape of a hinged column contains a sine wave, which as an
# imperfection bends the column as the formula of a sine does; a table with few points
# is linear between them.

import numpy as np

from python_test import SOURCE, biface, check, check_close, read_csv, scratch

COLUMN = SOURCE / "tests/data/imperfect_column.prm"
FORMULA = "Surface/Imperfection/Formula"
TABLES = "Surface/Imperfection/Tables"


def deflection(settings):
    """In the middle, at each end of a stage: 1, 2 and 5 times the imperfection."""
    probes = biface.run(COLUMN, settings, scratch()).probes().where(face="middle")
    return np.abs(probes["u_z"])


perfect = scratch()
biface.run(COLUMN, {FORMULA: "0", "Number of stages": 1, "Stage 1/Load factor": 0.1,
                    "Stage 1/Buckling": 1}, perfect)
shape = perfect / "buckling-0001-001.csv"
points = read_csv(shape)
x = np.array([float(point["alpha_1"]) for point in points])
value = np.array([float(point["value"]) for point in points])
check(len(x) == 2 * 101, f"there are {len(x)} points")
check(abs(np.abs(value).max() - 1) < 1e-9, "the largest value is not 1")
difference = np.abs(np.abs(value) - np.sin(np.pi * x / 200)).max()
check(difference < 1e-4, f"the shape differs from a sine wave by {difference}")

by_formula = deflection({})
by_shape = deflection({TABLES: f"shape: {shape}", FORMULA: "0.02*shape"})
for one, other, stage in zip(by_shape, by_formula, ("no load", "half", "most")):
    check_close(one, other, 2e-3, f"the deflection in '{stage}'")

coarse = scratch() / "triangle.csv"
coarse.write_text("alpha_1,alpha_2,value\n" + "".join(
    f"{a},{b},{w}\n" for a, w in ((0, 0), (100, 1), (200, 0)) for b in (0, 10)),
    encoding="utf-8")
by_table = deflection({TABLES: f"t: {coarse}", FORMULA: "0.02*t"})
by_lines = deflection({FORMULA: "0.02*(1 - abs(alpha_1 - 100)/100)"})
for one, other in zip(by_table, by_lines):
    check_close(one, other, 1e-9, "the deflection of the triangle")
