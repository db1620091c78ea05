# SPDX-License-Identifier: LGPL-2.1-or-later

# In the view of the shell, nodes have the colors of their values.

from report_test import PACKAGE, RUNS, check, report, require, scratch

require("matplotlib")

import sys

import matplotlib.pyplot as plt
import numpy as np
from browser import Browser

sys.path.insert(0, str(PACKAGE))

from biface import read_vtu

target = scratch() / "page.html"
report(RUNS / "shell", target=target)
browser = Browser(target)
for box in ("Mesh", "Edge of contact"):
    browser.set(box, False)
data = read_vtu(RUNS / "shell/shell-0002.vtu")
# the camera looks at the zone
nodes = np.flatnonzero(data["active"] > 0)
points = np.c_[data["Points"][nodes], np.ones(len(nodes))]
for field, colors in (("contact_pressure", "plasma"), ("displacement", "viridis")):
    browser.set("Color", f"{field} -1")
    values = data[field] if data[field].ndim == 1 else np.linalg.norm(
        data[field], axis=1)
    matrices, place = browser.run("""
        const { camera, canvas } = view;
        const { left, top, width, height } = canvas.getBoundingClientRect();
        return [[camera.projectionMatrix.elements,
                 camera.matrixWorldInverse.elements],
                [left, top, width, height]];""")
    # the matrices are those of column vectors, column by column
    projection, inverse = (np.reshape(matrix, (4, 4)) for matrix in matrices)
    x, y = (points @ inverse @ projection)[:, :2].T
    columns = (place[0] + place[2] * (1 + x) / 2).astype(int)
    rows = (place[1] + place[3] * (1 - y) / 2).astype(int)
    seen = browser.picture()[rows, columns]
    # the range of both steps, of which the second has the maximum, starts at 0
    shown = 255 * plt.get_cmap(colors)(values[nodes] / values.max())[:, :3]
    errors = np.abs(seen - shown).max(1)
    check(np.ptp(shown, axis=0).max() > 50, "the colors are all alike")
    check(np.median(errors) < 6, f"{field}: the colors are off by {errors}")
