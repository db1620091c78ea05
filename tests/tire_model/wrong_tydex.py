# SPDX-License-Identifier: LGPL-2.1-or-later

# A wrong TYDEX file is refused in one sentence with file, line and value.

from tire_model_test import check_refused, require, scratch, write

require("numpy", "scipy")

GOOD = """**HEADER
RELEASE   Release of TYDEX-Format                 1.3
**MEASURCHANNELS
SLIPANGL  Slip angle                    deg       1         0         0
FYW       Lateral force                 N         1         0         0
FZW       Vertical force                N         1         0         0
**MEASURDATA
-1 900 4000
1 -900 4000
**END
"""
for text, sentence in [
        ("", "has no **HEADER: it is not a complete TYDEX file"),
        (GOOD.replace("**END\n", ""), "has no **END"),
        (GOOD.replace("**MEASURDATA\n", "**DATA\n"),
         "line 7: the keyword is **DATA, but must be one of **HEADER, **COMMENTS"),
        ("text\n" + GOOD, "line 1: text before the first keyword, which is **HEADER"),
        (GOOD.replace("**MEASURDATA", "**HEADER"), "line 7: **HEADER occurs twice"),
        (GOOD.replace("deg", "gon"), "line 4: the unit of SLIPANGL is 'gon', but must be"),
        (GOOD.replace("FYW ", "FZW ", 1), "line 6: the channel FZW occurs twice"),
        (GOOD.replace("N         1  ", "N         one", 1),
         "line 5: the factor of FYW is 'one', but must be a number"),
        (GOOD.replace("1 -900 4000", "1 -900"),
         "line 9: the line has 2 numbers where 3 channels are named"),
        (GOOD.replace("-900", "much"), "line 9: a value is 'much', but must be a number"),
        (GOOD.replace("-1 900 4000\n1 -900 4000\n", ""), "has no data"),
        (GOOD.replace("-900 4000", "-900 -4000"), "line 9: the load F_z must be positive"),
        (GOOD.replace("1 -900", "99 -900"),
         "line 9: slip_angle must lie between -90 and 90 degrees"),
        (GOOD.replace("FZW ", "FZX "), "the table has no column F_z, the load"),
        (GOOD.replace("FYW ", "FZX "), "the table has no forces and moments"),
        (GOOD.replace("4000", "NOTAVAIL"), "the table has no column F_z, the load"),
        (GOOD.replace("900 4000\n1", "900 NOTAVAIL\nNOTAVAIL"),
         "has no data: some input is NOTAVAIL in each line")]:
    check_refused(["tydex", write("test.tdx", text), "--output", scratch()], sentence)
check_refused(["tydex", scratch(), "--output", scratch()], "has no files .tdx")
path = scratch()
(path / "a.tdx").write_text(GOOD, encoding="ascii")
(path / "b.tdx").write_text(GOOD.replace("FZW ", "FZX "), encoding="ascii")
check_refused(["tydex", path, "--output", scratch()],
              "b.tdx has no FZW, which other files have")
