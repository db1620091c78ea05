# SPDX-License-Identifier: LGPL-2.1-or-later

# A drum and spheres are drawn where the clearances and the approach have them.

import sys

from report_test import PACKAGE, RUNS, check, page_of, read_csv, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np
from biface import Results
from biface_report.ground import ground_in_step

for name, words in (("drum", "drum"), ("sphere", "sphere"),
                    ("hollow_sphere", "hollow sphere")):
    page = page_of(RUNS / name)
    check(f"Dashes: the {words}." in page.text, f"{name} has no trace")

    run = Results(RUNS / name)
    approach = {int(row["step"]): float(row["approach"])
                for row in read_csv(RUNS / name / "history.csv")
                if int(row["contact_nodes"]) > 0}
    check(len(approach) > 1, f"{name} has {len(approach)} steps in contact")
    starts = []
    for step, travel in approach.items():
        ground, contact = ground_in_step(run, step), run.contact(step)
        error = np.abs(ground.clearance(contact.positions())
                       - contact["clearance"]).max()
        check(error < 1e-7, f"{name}, step {step}: clearances are off by {error}")
        starts.append(ground.travel - travel)
    check(np.ptp(starts) < 1e-7, f"{name} starts from {starts}")
