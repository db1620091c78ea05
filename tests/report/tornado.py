# SPDX-License-Identifier: LGPL-2.1-or-later

# The tornado chart has a panel for each output that is not 0, with the logarithmic
# derivatives of sensitivities.csv in the order of their magnitude, the largest on
# top, to the right if the output grows with the entry and else to the left.

import math
import sys

from report_test import (PACKAGE, RUNS, check, check_equal, page_of, read_csv,
                         require)

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.drawing import BLUE, RED
from biface_report.sensitivities import bars_of, draw
from matplotlib.colors import to_rgba

lines = read_csv(RUNS / "sensitivities/sensitivities.csv")
expected = {}
for line in lines:
    value = float(line["logarithmic_derivative"])
    if math.isfinite(value):
        expected.setdefault(line["output"], []).append((line["entry"], value))
for bars in expected.values():
    bars.sort(key=lambda bar: -abs(bar[1]))
check(list(expected) == ["force", "loaded_radius"], f"the outputs {list(expected)}")

drawing = draw(bars_of(Results(RUNS / "sensitivities").sensitivities()))
panels = [axes for axes in drawing.axes if axes.get_visible()]
check([axes.get_title() for axes in panels] == list(expected), "other panels")
for axes, bars in zip(panels, expected.values()):
    names = [label.get_text() for label in axes.get_yticklabels()]
    check(names == [name for name, _ in bars], f"the order is {names}")
    check(axes.yaxis_inverted(), "the largest bar is not on top")
    for patch, (name, value) in zip(axes.patches, bars):
        check_equal(patch.get_width(), value, name)
        check(patch.get_facecolor() == to_rgba(BLUE if value > 0 else RED),
              f"the color of {name}")
# the tire is stiffer with stiffer cords, and lower the farther the ground moves
check(dict(expected["force"])["E"] > 0
      > dict(expected["loaded_radius"])["Stage 2/Travel"], "the signs")

# numbers at the bars, also where no entry has an effect
flat = draw({"force": [("a", 250.4), ("b", -0.0312)], "volume": [("a", 0.0)]})
for axes, numbers in zip(flat.axes, (["+250", "−0.031"], ["0"])):
    check([text.get_text() for text in axes.texts] == numbers,
          f"not {numbers}")

page = page_of(RUNS / "sensitivities")
check("there is no logarithmic derivative: rim u_x by E; rim u_x by Stage 1/Pressure; "
      "rim u_x by Stage 2/Travel." in page.text, "the missing bars are not told")
check(any("force: Stage 2/Travel +1.4, E +0.28, Stage 1/Pressure −0.0" in image["alt"]
          for image in page.images), "the chart has no words")
for line in lines:
    rows = [row for row in page.rows
            if row[0][1:4:2] == [line["entry"], line["output"]]]
    check(len(rows) == 1, f"{line['entry']} is there {len(rows)} times")
    check_equal(rows[0][1][2], float(line["derivative"]), "derivative")

check("Sensitivities: No stage asks for" in page_of(RUNS / "bias_tire").text,
      "the reason is not told")
