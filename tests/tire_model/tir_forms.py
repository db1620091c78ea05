# SPDX-License-Identifier: LGPL-2.1-or-later

# Entries may have all forms that programs write: lower case, quotes, comments behind $ or !,
# exponents with E and D, ends of lines of any system, a mark of byte order, comments of
# other programs, sections in two parts.

from tire_model_test import check, require, scratch

require("numpy", "scipy")

from biface_tire_model import read_tir
from biface_tire_model.tir_file import parse

TEXT = """$ a remark
! another
[Model]   $ comment
fittyp=6
longvl =1.67D+01   $speed
tyreside = "Right" ! with ! and $
file_name = 'a $ in ! quotes'  $ comment
[dimension]
unloaded_radius  =  3.13E-01!no blank
[VERTICAL]
Fnomin = '4.0e+3'
[scaling_coefficients]
LFZ0 = +1.
[LATERAL_COEFFICIENTS]
\tPDY1\t=\t.9 $ with tabs
PKY1 = -1.5d1
"""
for ending in ("\n", "\r\n", "\r"):
    for mark in (b"", b"\xef\xbb\xbf"):
        path = scratch() / "forms.tir"
        path.write_bytes(mark + TEXT.replace("\n", ending).encode())
        file = read_tir(path)
        found = {name: file.find(name) for name in (
            "FITTYP", "LONGVL", "TYRESIDE", "FILE_NAME", "UNLOADED_RADIUS", "FNOMIN",
            "LFZO", "PDY1", "PKY1")}
        check(found == {"FITTYP": 6, "LONGVL": 16.7, "TYRESIDE": "Right",
                        "FILE_NAME": "a $ in ! quotes", "UNLOADED_RADIUS": 0.313,
                        "FNOMIN": 4000, "LFZO": 1, "PDY1": 0.9, "PKY1": -15}, f"{found}")
        check(file.side() == "RIGHT", file.side())
        check(file.remarks == ["a remark", "another"], f"{file.remarks}")
        check(file.sections["MODEL"].comments["LONGVL"] == "speed", "no comment")
        check(file.formula().name == "5.2", "another formula")

for text in (TEXT.replace("$ a remark", "# a remark").replace("! another", "// another"),
             TEXT.replace("\nPKY1 = -1.5d1", "\nPKY1 = -1.5d1  # = 15\n; x\n% y = 3\n** z"),
             TEXT.replace("= +1.", "= +1. // one").replace("[Model]", "Title, 1\n[Model]"),
             TEXT + "[MODEL]\nVXLOW = 1\nFITTYP = 6\n",
             TEXT + "[SHAPE]\n 1.00  0.00 $ middle\n 0.9 1\n"):
    path.write_text(text, encoding="utf-16")
    check(parse(read_tir(path).text()) == read_tir(path), "written otherwise")
    check(read_tir(path).coefficients() == file.coefficients(), "other coefficients")

# a degree sign of Windows
path.write_bytes(TEXT.replace("speed", "speed at 20 °C").encode("cp1252"))
check(read_tir(path).sections["MODEL"].comments["LONGVL"] == "speed at 20 °C", "no sign")
