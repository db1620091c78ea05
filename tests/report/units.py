# SPDX-License-Identifier: LGPL-2.1-or-later

# The entry Units names the units of tables and labels: N/mm² is MPa; without it they
# are the words length and force.

import sys

from report_test import PACKAGE, RUNS, check, copy_of, page_of, require

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.charts import draw_contact_curve
from biface_report.units import KINDS, Units

for text, expected in (
        ("mm, N, s", {"pressure": "MPa", "stiffness": "N/mm", "frequency": "Hz",
                      "mass": "t", "energy": "mJ", "moment": "N · mm"}),
        ("m,N,s", {"pressure": "Pa", "energy": "J", "velocity": "m/s", "mass": "kg"}),
        ("in, lbf, min", {"pressure": "psi", "area": "in²", "frequency": "1/min"}),
        ("", {"pressure": "force/length²", "frequency": "1/time"})):
    for kind, unit in expected.items():
        check(Units(text)[kind] == unit, f"{kind} of {text}: {Units(text)[kind]}")
for text in (None, "mm", "mm, N, s, K", "mm, <b>, s", "mm,,s"):
    check(not Units(text).are_named, f"'{text}' was accepted")
check(set(Units("mm, N, s").names) == {"mm", "N", "s"}, "other names")
check(all(Units("mm, N, s")[kind] for kind in KINDS), "a kind without a unit")

INPUT = "Entries that differ from the default"
directory = copy_of("bias_tire")
path = directory / "parameters.prm"
path.write_text(path.read_text(encoding="utf-8") + "set Units =\n", encoding="utf-8")
text = page_of(directory).text.partition(INPUT)[0]
check("[force/length²]" in text and "MPa" not in text, "a unit that no entry names")

directory = RUNS / "bias_tire"
text = page_of(directory).text.partition(INPUT)[0]
check("Units: mm, N, s." in text, "the units are not named")
check("[MPa]" in text, "no MPa")
for word in ("[length", "[force", "force/length"):
    check(word not in text, f"{word} is left")
axes = draw_contact_curve(Results(directory)).axes[0]
check((axes.get_xlabel(), axes.get_ylabel())
      == ("approach [mm]", "force on the ground [N]"), "the labels of the curve")
