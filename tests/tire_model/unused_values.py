# SPDX-License-Identifier: LGPL-2.1-or-later

# Values that no formula uses may be empty or words: the forces are the same, and check
# names them.

from tire_model_test import MADE, check, output_of, require, tire_model, write

require("numpy", "scipy")

words = ["--fz", "4000", "--alpha", "-3,4", "--kappa", "0.1"]
source = MADE.read_text(encoding="utf-8")
path = write("blank.tir", source.replace(
    "[MODEL]\n", "[MODEL]\nROAD_INCREMENT =\nUSE_MODE = $ none\nNOTE = \n")
    + "[INERTIA]\nMASS = kg\nIXX = '2.5'\nIYY =\n")
check("FZMAX = 9000" in source, "there is no FZMAX")
check(output_of("evaluate", path, *words) == output_of("evaluate", MADE, *words),
      "the forces differ")
text = output_of("check", path)
check("Not used (no number): ROAD_INCREMENT, USE_MODE, NOTE, MASS, IYY." in text, text)

# a pressure and a velocity without values are those of a file without them
lines = ("INFLPRES = 220000\n", "LONGVL = 16.7\n")
missing = empty = source
for line in lines:
    check(line in source, f"{line.strip()} is not there")
    missing = missing.replace(line, "")
    empty = empty.replace(line, line.split("=")[0] + "=\n")
check(output_of("evaluate", write("empty.tir", empty), *words)
      == output_of("evaluate", write("missing.tir", missing), *words), "the forces differ")

# a range without values is none
code, _, errors = tire_model("evaluate", write("range.tir", source.replace(
    "FZMAX = 9000", "FZMAX =")), "--fz", "90000")
check(code == 0 and "F_z out of the range" not in errors, errors)
