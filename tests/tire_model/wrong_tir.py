# SPDX-License-Identifier: LGPL-2.1-or-later

# A wrong .tir file is refused in one sentence with file, line, entry and value.

from tire_model_test import check, check_refused, require, scratch, write

require("numpy", "scipy")

GOOD = ("[MODEL]\nFITTYP = 61\n[DIMENSION]\nUNLOADED_RADIUS = 0.3\n[VERTICAL]\n"
        "FNOMIN = 4000\n")
CASES = [
    ("", "has no section, such as [MODEL]"),
    ("! only\n$ comments\n", "has no section"),
    ("FITTYP = 61\n" + GOOD, "line 1: 'FITTYP = 61' stands before the first section"),
    (GOOD + "[\n", "line 7: '[' is not a section, such as [MODEL]"),
    (GOOD + "[]\n", "line 7: '[]' is not a section"),
    (GOOD + "[SHAPE\n", "line 7: '[SHAPE' is not a section"),
    (GOOD + "[vertical]\nFNOMIN = 3000\n",
     "line 8: FNOMIN occurs twice in [VERTICAL], with different values"),
    (GOOD + "[OTHER]\nFNOMIN = 3000\n",
     "FNOMIN in [VERTICAL] is 4000, but FNOMIN in [OTHER] is 3000: only one of them can "
     "hold"),
    (GOOD + "LFZO = 1\nLFZ0 = 1.1\n",
     "LFZO in [VERTICAL] is 1, but LFZ0 in [VERTICAL] is 1.1"),
    (GOOD + "PROPERTY_FILE_FORMAT = 'PAC_MC'\n", "PROPERTY_FILE_FORMAT is 'PAC_MC', whose "
                                                 "equations are not those of MF 5.2 or MF"),
    (GOOD + "PCX1\n", "line 7: 'PCX1' is neither an entry, such as LCX = 1, nor a section "
                      "nor a comment"),
    (GOOD + "= 3\n", "line 7: '= 3' is neither an entry"),
    (GOOD + "FNOMIN = 3000\n", "line 7: FNOMIN occurs twice in [VERTICAL]"),
    (GOOD + "TEXT = 'open\n", "line 7: the text of TEXT has no closing quote"),
    (GOOD + "PCX1 = one\n", "line 7: PCX1 is 'one', but must be a number"),
    (GOOD + "PCX1 = \n", "line 7: PCX1 is '', but must be a number"),
    (GOOD + "PCX1 = 1,3\n", "line 7: PCX1 is '1,3', but must be a number with a decimal "
                          "point"),
    (GOOD + "PCX1 = nan\n", "line 7: PCX1 is 'nan', but must be a number"),
    (GOOD + "PCX1 = 1e999\n", "line 7: PCX1 is '1e999', but must be a number"),
    (GOOD + "LFZ0 = 'one'\n", "line 7: LFZ0 is 'one', but must be a number"),
    (GOOD + "LONGVL = fast $ comment\n", "line 7: LONGVL is 'fast', but must be a number"),
    (GOOD.replace("61", "sixty"), "line 2: FITTYP is 'sixty', but must be a number"),
    (GOOD.replace("61", "89"), "FITTYP is 89, but must be 5, 6, 21, 52, 60, 61 or 62"),
    (GOOD.replace("FNOMIN = 4000", ""), "FNOMIN is missing, which the Magic Formula needs"),
    (GOOD.replace("4000", "-4000"), "FNOMIN is -4000, but must be positive"),
    (GOOD.replace("= 4000", "="), "line 6: FNOMIN is '', but must be a number"),
    (GOOD + "LFZO = 0\n", "LFZO is 0, but must be positive"),
    (GOOD.replace("0.3", "0"), "UNLOADED_RADIUS is 0, but must be positive"),
    (GOOD + "[SHAPE]\n{}\n", "line 8: '{}' does not name columns, as {pen fz} does"),
    (GOOD + "[SHAPE]\n{radial width}\n1 0 1\n",
     "line 9: the row has 3 numbers where 2 columns are named"),
    (GOOD + "[SHAPE]\n{radial width}\n1 half\n",
     "line 9: the column WIDTH of [SHAPE] is 'half', but must be a number"),
    (GOOD + "[SHAPE]\n{radial width}\n1 0\n{a b}\n",
     "line 10: the section [SHAPE] has a second table"),
    (GOOD + "[UNITS]\nLENGTH = 'furlong'\n",
     "line 8: LENGTH is 'furlong', but must be m, meter,"),
    (GOOD + "[UNITS]\nANGLE = 'grad'\n", "line 8: ANGLE is 'grad', but must be rad,"),
    (GOOD + "[UNITS]\nPRESSURE = 'torr'\n", "line 8: PRESSURE is 'torr', but must be pa,"),
    (GOOD + "[UNITS]\nVELOCITY = 'km/h'\n", "line 8: [UNITS] has the entry VELOCITY, "
     "but only has LENGTH, FORCE, TIME, ANGLE, MASS or PRESSURE"),
]
for text, sentence in CASES:
    check_refused(["check", write("tire.tir", text)], sentence)
path = scratch() / "binary.tir"
path.write_bytes(b"[MODEL]\0\0")
check_refused(["check", path], "is not a text file")
check_refused(["check", "no_such.tir"], "no_such.tir cannot be read (No such file")
check_refused(["check", scratch()], "cannot be read (Is a directory")
check(len(CASES) >= 30, "there are fewer cases")
