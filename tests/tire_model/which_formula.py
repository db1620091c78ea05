# SPDX-License-Identifier: LGPL-2.1-or-later

# FITTYP decides the formula, and PROPERTY_FILE_FORMAT without it; others are refused.

from tire_model_test import check, require

require("numpy", "scipy")

from biface.errors import BifaceError
from biface_tire_model.tir_file import parse

REST = "\n[DIMENSION]\nUNLOADED_RADIUS = 0.3\n[VERTICAL]\nFNOMIN = 4000\n"
for entries, name in [
        *((f"FITTYP = {number}", "5.2") for number in (5, 6, 21, 52)),
        *((f"FITTYP = {number}", "6.1") for number in (60, 61, 62)),
        ("PROPERTY_FILE_FORMAT = 'PAC2002'", "5.2"),
        ("PROPERTY_FILE_FORMAT = 'pac2002'", "5.2"),
        ("PROPERTY_FILE_FORMAT = 'MF_05'", "5.2"),
        ("PROPERTY_FILE_FORMAT = 'USER'\nFITTYP = 61", "6.1"),
        ("PROPERTY_FILE_FORMAT = 'PAC2002'\nFITTYP = 61", "6.1")]:
    found = parse(f"[MODEL]\n{entries}{REST}").formula().name
    check(found == name, f"{entries} gives {found}")
for entries, sentence in [
        ("FITTYP = 7", "FITTYP is 7, but must be 5, 6, 21, 52, 60, 61 or 62."),
        ("FITTYP = 6.5", "FITTYP is 6.5, but must be 5"),
        ("USE_MODE = 14", "does not tell its formula: [MODEL] needs FITTYP"),
        ("PROPERTY_FILE_FORMAT = 'FIALA'", "PROPERTY_FILE_FORMAT is 'FIALA', but must be "
                                           "PAC2002 or MF_05"),
        ("PROPERTY_FILE_FORMAT = 'PAC89'", "PROPERTY_FILE_FORMAT is 'PAC89', but must be")]:
    try:
        parse(f"[MODEL]\n{entries}{REST}").formula()
        check(False, f"{entries} is accepted")
    except BifaceError as error:
        check(sentence in str(error), f"'{sentence}' is not in '{error}'")
