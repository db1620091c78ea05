# SPDX-License-Identifier: LGPL-2.1-or-later

# No two steps have the same label: it names what changes in the stage, with as many
# digits as it takes.

import sys

from report_test import PACKAGE, check, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Table
from biface_report.loading import step_labels


class Run:
    """An inflation, a prescribed rest, and a contact in two small steps."""
    steps = np.arange(1, 7)
    parameters = None
    history = Table({
        "stage": np.array(["air", "air", "rest"] + 3 * ["ground"], dtype=object),
        "pressure": np.array([0.1, 0.2, 0.2, 0.2, 0.2, 0.2]),
        "load_factor": np.zeros(6),
        "approach": np.array([0, 0, 0, 1.00001, 1.00002, 2])})

    def setting(self, entry, otherwise=None):
        """There is no parameters.prm."""
        return otherwise


labels = step_labels(Run(), Run.steps)
check(labels == ["step 1, pressure 0.1", "step 2, pressure 0.2", "step 3, rest",
                 "step 4, approach 1.00001", "step 5, approach 1.00002",
                 "step 6, approach 2"], f"{labels}")
