# SPDX-License-Identifier: LGPL-2.1-or-later

# Between the nodes of a coarse mesh, the view draws an undeformed torus as a torus.

from report_test import RUNS, check, report, require, scratch

require("matplotlib")

import numpy as np
from browser import Browser

# the tire of the run: radii of the center line and of both faces
CENTER, FACES = 200, (50, 54.8)

target = scratch() / "page.html"
report(RUNS / "shell", target=target)
browser = Browser(target)
browser.set("Displacements", 0)
found = browser.run("""
    const { position } = view.surface.geometry.attributes;
    return [view.chosen.base.length, [...position.array]];""")
points = np.reshape(found[1], (-1, 3))
check(points.size > 8 * found[0], "there are no points between the nodes")
distances = np.hypot(np.hypot(points[:, 0], points[:, 2]) - CENTER, points[:, 1])
nearest = np.abs(distances[:, None] - FACES).min(1)
check(nearest.max() < 0.5, f"points are off by {nearest.max()}")
