# SPDX-License-Identifier: LGPL-2.1-or-later

# A damaged file for ParaView, or one of another run, is an error that names it.

import shutil

from report_test import RUNS, check, complaint, copy_of, require, require_three

require("matplotlib")
require_three()
run = copy_of("shell")
path = run / "shell-0002.vtu"
text = path.read_text(encoding="utf-8")
for damaged in (text[:len(text) // 2], text.replace('"outer_face"', '"outer"'),
                text.replace("</Piece>", "")):
    path.write_text(damaged, encoding="utf-8")
    errors = complaint(run)
    check(str(path) in errors and "damaged" in errors, errors)
shutil.copy(RUNS / "buckling/shell-0001.vtu", path)
errors = complaint(run)
check(str(path) in errors, errors)
