# SPDX-License-Identifier: LGPL-2.1-or-later

# A wheel goes around its axle, and the ground is across it: a straight seal has no
# wheel axes and no loaded radius, and its section is drawn around the axis.

import sys

from report_test import PACKAGE, RUNS, check, copy_of, page_of, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Results
from biface_report.section import section_around
from biface_report.wheel import is_wheel

page = page_of(RUNS / "seal")
check("Forces in wheel axes" not in page.headings, "a seal has wheel axes")
check(all(cells[0] != "Loaded radius" for cells, _ in page.rows), "a loaded radius")
check("around the axis, through the nodes at y = 30" in page.text, "another section")
check("Forces in wheel axes" in page_of(RUNS / "bias_tire").headings,
      "a tire has no wheel axes")

directory = copy_of("seal")
for path in directory.glob("shell-*.vtu"):
    path.unlink()
text = page_of(directory).text
check("the section around the axis is missing, as is shell-0003.vtu" in text,
      "the missing section is not told")

# the wall is 1.5 thick; after the contact the outer face ends where the ground is
run = Results(RUNS / "seal")
line = section_around(run, run.step)
outer, inner = (line.positions(face) for face in ("outer_", "inner_"))
check(len(outer) == 15, f"{len(outer)} nodes around")
for face, radius in ((outer, 11.5), (inner, 10)):
    check(np.allclose(face[[0, -1]][:, [0, 2]], [[0, -radius], [0, radius]], atol=1e-4),
          f"the ends of the section {face[[0, -1]]}")
check(np.all(np.diff(np.arctan2(outer[:, 2], outer[:, 0])) > 0), "not in order")


class Run:
    """The entries of a run."""

    def __init__(self, changes):
        self.entries = {"Surface/Type": "surface of revolution",
                        "Mesh/Closed in alpha_2": "true",
                        "Contact/Direction": "1, 0, 0",
                        **changes}

    def setting(self, entry, otherwise=None):
        """The value of an entry."""
        return self.entries.get(entry, otherwise)

    numbers = Results.numbers


tube = {"Surface/Meridian": "straight line", "Surface/Straight line/Start": "10, 0"}
for changes, expected in (
        ({}, True), ({"Surface/Type": "plane"}, False),
        ({"Mesh/Closed in alpha_2": "false"}, False),
        ({"Contact/Direction": "0, -1, 0.1"}, False),
        ({**tube, "Surface/Straight line/End": "10, 15"}, True),
        ({**tube, "Surface/Straight line/End": "10, 25"}, False)):
    check(is_wheel(Run(changes)) == expected, f"{changes}")
