# SPDX-License-Identifier: LGPL-2.1-or-later

# The displacements of a step are compared with those of all steps, also on other
# branches, that are measured from the same shape: that of the last prestress on the
# way to it.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface.parameters import parse_parameters
from biface_report.loading import counted_steps

STAGES = """set Number of stages = 4
subsection Stage 1
  set Name = air
end
subsection Stage 2
  set Name = tensioned
  set Start from prestress = {tensioned}
end
subsection Stage 3
  set Name = snow
end
subsection Stage 4
  set Name = wind
  set Start from = {start}
end
"""


class Run:
    """Two steps of air, one of tension, two of snow and two of wind."""
    steps = np.arange(1, 8)
    history = Table({"stage": np.array(
        2 * ["air"] + ["tensioned"] + 2 * ["snow"] + 2 * ["wind"], dtype=object)})

    def __init__(self, start, tensioned):
        self.parameters = parse_parameters(
            STAGES.format(start=start, tensioned=tensioned))

    def setting(self, entry, otherwise=None):
        """The value of an entry."""
        found = self.parameters.entries.get(entry)
        return found.value if found else otherwise


for start, tensioned, expected in (
        ("previous", "false", [1, 2, 3, 4, 5, 6, 7]),
        ("1", "false", [1, 2, 3, 4, 5, 6, 7]), ("previous", "true", [3, 4, 5, 6, 7]),
        ("2", "true", [3, 4, 5, 6, 7]), ("1", "true", [1, 2, 6, 7])):
    found = counted_steps(Run(start, tensioned))
    check(list(found) == expected, f"{start}, {tensioned}: {found}")
