# SPDX-License-Identifier: LGPL-2.1-or-later

# Powers of ten are in the labels of the axes, not over them, and numbers do not break
# across lines.

import sys

from report_test import PACKAGE, check, require

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

import matplotlib.pyplot as plt
from biface_report.drawing import STYLE, embed
from biface_report.page import plain_number

plt.rcParams.update(STYLE)
for label, expected in (("length [mm]", "length [$10^{-7}$ mm]"),
                        ("index", "index [$10^{-7}$]")):
    figure, axes = plt.subplots()
    axes.plot([0, 1], [0, 3e-7])
    axes.set(ylabel=label, xlabel="time [s]")
    embed(figure)
    check(axes.get_ylabel() == expected, f"the label is {axes.get_ylabel()}")
    check(axes.get_xlabel() == "time [s]", f"the label is {axes.get_xlabel()}")
    check(not axes.yaxis.get_offset_text().get_visible(), "a power above the axis")
# charts in a column have one label
figure, (above, below) = plt.subplots(2, 1, sharex=True)
for axes in (above, below):
    axes.plot([0, 3e-7], [0, 1])
embed(figure)
check((above.get_xlabel(), below.get_xlabel()) == ("", "[$10^{-7}$]"),
      "the labels of a column")
check(" " not in plain_number(3.2e-9), "a number may break")
