# SPDX-License-Identifier: LGPL-2.1-or-later

# A .tir file that was read is the same after it is written and read again.

from tire_model_test import DATA, check, require, scratch

require("numpy", "scipy")

from biface_tire_model import read_tir
from biface_tire_model.tir_file import parse

SHAPE = """[MODEL]
FITTYP = 52
FUNCTION_NAME = 'TYR815'
[UNITS]
LENGTH = 'mm'
FORCE = 'kN'
TIME = 'ms'
ANGLE = 'deg'
MASS = 'gram'
[DIMENSION]
UNLOADED_RADIUS = 317.13 $ free radius
[SHAPE]
{radial width}
1.0 0.0
0.9 1.0
[DEFLECTION_LOAD_CURVE]
{pen fz}
0 0.0
10 2.1 $ a comment
[MY_SECTION]
MY_ENTRY = 3.3333333333333333E-07 ! mine
MY_TEXT = two words
"""
files = [read_tir(path) for path in sorted(DATA.glob("*.tir"))] + [parse(SHAPE)]
check(len(files) >= 4, "there are too few files")
for file in files:
    path = scratch() / "again.tir"
    file.write(path)
    again = read_tir(path)
    check(again == file, f"{file.path} changed")
    check(again.text() == file.text(), f"{file.path} is written in another way")
    check([section.remarks for section in again.sections.values()]
          == [section.remarks for section in file.sections.values()]
          and again.remarks == file.remarks, f"{file.path} lost remarks")
last = files[-1]
check(last.find("UNLOADED_RADIUS") == 0.31713, f"{last.find('UNLOADED_RADIUS')}")
check(last.sections["SHAPE"].rows == [(1, 0), (0.9, 1)], "the shape changed")
check(last.sections["DEFLECTION_LOAD_CURVE"].rows == [(0, 0), (0.01, 2100)],
      f"{last.sections['DEFLECTION_LOAD_CURVE'].rows}")
check(last.find("MY_ENTRY") == 3.3333333333333333e-07 and last.find("MY_TEXT")
      == "two words", "entries of a section of one's own are lost")
check(last.sections["MY_SECTION"].comments["MY_ENTRY"] == "mine", "a comment is lost")
