# SPDX-License-Identifier: LGPL-2.1-or-later

# A run on a mesh from a file has no coordinates: its contact is read, its report names
# the place of the largest pressure by its position and has no picture of the footprint.

import sys

from report_test import PACKAGE, RUNS, check, page_of, require

require("matplotlib")
sys.path.insert(0, str(PACKAGE))

from biface import Results
from biface_report.summary import place_of_peak

run = Results(RUNS / "mesh_from_file")
contact = run.contact()
check((contact["active"] > 0).sum() == run.last("contact_nodes"), "contact nodes")
check(place_of_peak(run).startswith(", x, y, z = "), place_of_peak(run))
page = page_of(RUNS / "mesh_from_file")
check("Footprint" not in page.headings, f"{page.headings}")
