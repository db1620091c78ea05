# SPDX-License-Identifier: LGPL-2.1-or-later

# TYDEX files of others are read: comments, other channels and units, factors and offsets,
# constants in place of channels, lines of data with blanks.

from tire_model_test import check, output_of, require, scratch, write

require("numpy", "scipy")

import math

import numpy as np
from biface_tire_model import read_tydex

TEXT = """!# a file of another program
**HEADER
!-------!-------------------------------!---------!---------!
RELEASE  Release of TYDEX-Format                   1.3
SUPPLIER Data supplier                             DEMO
**COMMENTS
! New tire
**CONSTANTS
MANUFACT  Manufacturer of the tire                DEMO
INFLPRES  Inflation pressure            bar       2.1
INCLANGL  Inclination angle             deg       -1.5
**MEASURCHANNELS
RUNTIME   Running time                  s         1         0         0
SLIPANGL  Slip angle                    deg       0.1       0         0.5
FYW       Lateral force                 kN        0.002     10        0
FZW       Vertical force                N
TRCKTEMP  Track temperature             deg C     1         0         0
**MEASURDATA
 0.0  -20   1990  4000  25
 0.1    0     90  4010  25.5
 0.2   20  -1990  3990  26
**END
 anything
"""
data = read_tydex(write("other.tdx", TEXT))
for name, values in (("slip_angle", np.radians([-1.5, 0.5, 2.5])),
                     ("F_y", [4000, 200, -3960]), ("F_z", [4000, 4010, 3990]),
                     ("pressure", [2.1e5] * 3),
                     ("inclination_angle", [math.radians(-1.5)] * 3),
                     ("slip_ratio", [0] * 3)):
    check(np.allclose(data[name], values, rtol=1e-12, atol=1e-12),
          f"{name} is {data[name]}, not {values}")
check(np.isnan(data["F_x"]).all(), "F_x was not measured")

# columns of ten characters without blanks between them
rows = "".join("".join(f"{word:>10}" for word in line.split()) + "\n"
               for line in TEXT.splitlines() if line.startswith(" 0."))
full = rows.replace("      1990", "1990.00000").replace("       -20", "-20.000000")
check("-20.0000001990.00000" in full, "there are blanks")
begin, end = TEXT.index("\n 0.0") + 1, TEXT.index("**END")
again = read_tydex(write("full.tdx", TEXT[:begin] + full + TEXT[end:]))
check(all(np.allclose(again[name], data[name]) for name in data.columns), "other data")

check(data.unused == ["RUNTIME", "TRCKTEMP"], f"not used: {data.unused}")

# the command reads a directory too
folder = scratch()
(folder / "A.TDX").write_text(TEXT, encoding="ascii")
(folder / "note.txt").write_text("no file", encoding="ascii")
check(output_of("tydex", folder, "--output", folder / "again").split()
      == [str(folder / "again/cornering_01.tdx")], "other files")

# a mark of byte order, and an umlaut of either encoding
for encoding in ("utf-8-sig", "latin-1"):
    path = scratch() / "mark.tdx"
    path.write_bytes(TEXT.replace("New tire", "für").encode(encoding))
    check(all(np.array_equal(read_tydex(path)[name], data[name]) for name in data.columns),
          f"other data in {encoding}")

# NOTAVAIL is no value: a force is missing, a state without its slip is left out, and a
# constant replaces a channel without values
gaps = TEXT.replace("  1990 ", " NOTAVAIL ").replace(" 0.2   20 ", " 0.2 NOTAVAIL ")
gaps = gaps.replace("deg C     1", "bar       1").replace("TRCKTEMP ", "INFLPRES ")
for word in ("25.5\n", "25\n", "26\n"):
    gaps = gaps.replace(f"  {word}", "  NOTAVAIL\n")
partial = read_tydex(write("gaps.tdx", gaps))
check(np.isnan(partial["F_y"]).tolist() == [True, False], f"{partial['F_y']}")
check(np.allclose(partial["slip_angle"], np.radians([-1.5, 0.5])), "other states")
check(np.allclose(partial["pressure"], 2.1e5), f"{partial['pressure']}")

# the same when they are written again
output_of("tydex", write("gaps.tdx", gaps), "--output", folder / "gaps")
again = read_tydex(folder / "gaps/cornering_01.tdx")
check(np.isnan(again["F_y"]).tolist() == [True, False], f"{again['F_y']}")
