# SPDX-License-Identifier: LGPL-2.1-or-later

# The edge of the contact zone in the view is closed, and between the nodes in contact
# and the others.

from report_test import RUNS, check, read_csv, report, require, scratch

require("matplotlib")

import numpy as np
from browser import Browser
from matplotlib.path import Path

target = scratch() / "page.html"
report(RUNS / "shell", target=target)
points = np.reshape(Browser(target).run(
    "return [...view.edge.geometry.attributes.position.array];"), (-1, 3))
ends, which = np.unique(np.round(points, 3), axis=0, return_inverse=True)
# without pieces of no length
pieces = which.reshape(-1, 2)
pieces = pieces[pieces[:, 0] != pieces[:, 1]]
counts = np.bincount(pieces.ravel(), minlength=len(ends))
check(len(ends) > 8 and (counts == 2).all(), f"ends meet {sorted(set(counts))} times")

# walks along the edge, and looks at the nodes along the travel of the plane
walk, left = list(pieces[0]), set(range(1, len(pieces)))
while left:
    piece = next((i for i in left if walk[-1] in pieces[i]), None)
    check(piece is not None, "the edge is not one line")
    left.remove(piece)
    walk.append(pieces[piece].sum() - walk[-1])
edge = Path(ends[walk][:, 1:])
rows = read_csv(RUNS / "shell/contact-0002.csv")
nodes = np.array([[float(row["y"]), float(row["z"])] for row in rows])
active = np.array([float(row["active"]) > 0 for row in rows])
check((edge.contains_points(nodes) == active).all(),
      "the edge is not around the nodes in contact")
