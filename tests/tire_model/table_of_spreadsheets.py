# SPDX-License-Identifier: LGPL-2.1-or-later

# Tables as spreadsheets and test rigs export them give the states of a plain table: other
# encodings, separators of thousands, titles, empty cells and rows, and words for names.

from tire_model_test import check, require, scratch

require("numpy", "scipy")

import numpy as np
from biface_tire_model import read_table

NAMES = ("slip_angle", "slip_ratio", "inclination_angle", "pressure [kPa]", "F_z", "F_y",
         "M_z")
ROWS = ("-2.5,0,1,220,4000,1800.5,-31.25", "2.5,0,-1,220,4000,-1900.25,30.5")
PLAIN = "\n".join([",".join(NAMES), *ROWS]) + "\n"
GERMAN = PLAIN.replace(",", ";").replace(".", ",")
WORDS = PLAIN.replace(",".join(NAMES), "Slip angle [°],Longitudinal slip [-],gamma [°],"
                      "Inflation pressure [kPa],Vertical load [N],Side force [N],"
                      "Aligning torque [Nm]")

path = scratch() / "table.csv"


def read(text, encoding="utf-8"):
    """The states of a table with a text."""
    path.write_bytes(text.encode(encoding))
    return read_table(path)


reference = read(PLAIN)
for what, text, encoding in [
        ("UTF-16", GERMAN.replace(";", "\t"), "utf-16"),
        ("a degree sign of Windows", WORDS.replace(",", ";"), "cp1252"),
        ("a degree sign of UTF-8", WORDS, "utf-8-sig"),
        ("thousands", GERMAN.replace("4000", "4\u202f000").replace("-1900", "-1\u00a0900"),
         "utf-8"),
        ("thousands with points", GERMAN.replace("4000", "4.000,00"), "utf-8"),
        ("thousands with commas", PLAIN.replace(",", ";").replace("4000", "4,000.0"),
         "utf-8"),
        ("a minus sign", GERMAN.replace("-", "\N{MINUS SIGN}"), "utf-8"),
        ("a line for the separator", "sep=;\n" + GERMAN, "utf-8"),
        ("empty cells", GERMAN.replace("\n", ";;\n") + ";;;;\n;;;\n", "utf-8"),
        ("ends of lines", GERMAN.replace("\n", "\r"), "utf-8"),
        ("titles", "Tire: 205/55 R 16\nOperator: N\nPressure [kPa],220\nDate,2019\n" + PLAIN,
         "utf-8"),
        ("daN", PLAIN.replace("F_y", "F_y [daN]").replace("1800.5", "180.05")
         .replace("1900.25", "190.025"), "utf-8"),
        ("units with an empty one", PLAIN.replace(
            "\n", "\ndeg,,deg,kPa,N,N,N-m\n", 1).replace(" [kPa]", ""), "utf-8")]:
    data = read(text, encoding)
    check(set(data.columns) == set(reference.columns), f"{what}: other columns")
    for name, values in reference.columns.items():
        check(np.allclose(data[name], values, rtol=1e-12, atol=1e-12),
              f"{what}: {name} is {data[name]}, not {values}")
check(read(PLAIN.replace("M_z", "load")).unused == ["load"], "no column is left out")
