# SPDX-License-Identifier: LGPL-2.1-or-later

# Frequencies at which no response was found are gaps of the curves, and a sentence names
# them.

import sys

from report_test import PACKAGE, check, copy_of, page_of, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np

from biface import Results
from biface_report import response

directory = copy_of("response")
check("was not found" not in page_of(directory).text, "there is a gap already")
path = directory / "response.csv"
lines = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()]
for line in lines[1:]:
    if line[4] in ("220", "230"):
        line[7:] = 6 * ["nan"]
path.write_text("".join(",".join(line) + "\n" for line in lines), encoding="utf-8")
page = page_of(directory)
check("In the stage contact the response was not found at 2 frequencies from 220 to 230, "
      "where curves have gaps." in page.text, "the gaps are not named")
run = Results(directory)
found = run.response().where(excitation="ground x")
for curve in response.force_curves(run, found, 0) + response.point_curves(found):
    missing = found.where(output="foundation")["frequency"][np.isnan(curve.values)]
    check(list(missing) == [220, 230], f"{curve.label} has gaps at {missing}")

for line in lines[1:]:
    line[7:] = 6 * ["nan"]
path.write_text("".join(",".join(line) + "\n" for line in lines), encoding="utf-8")
page = page_of(directory)
check("was not found at 17 frequencies from 0 to 270" in page.text,
      "it is not said that nothing was found")
check(not any("phase" in image["alt"] for image in page.images), "nothing is drawn")
