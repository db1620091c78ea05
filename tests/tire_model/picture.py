# SPDX-License-Identifier: LGPL-2.1-or-later

# Pictures show the curves through the points of the table.

from tire_model_test import MADE, check, output_of, require, scratch, sweeps

require("numpy", "scipy", "matplotlib")

import numpy as np
from biface_report.drawing import plt
from biface_tire_model import read_tir
from biface_tire_model.picture import draw_ellipse, draw_sweep

for ending, start in (("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")):
    path = scratch() / f"curves.{ending}"
    output_of("evaluate", MADE, "--fz", "2000,4000", "--alpha", "-8,8", "--picture", path,
              "-o", scratch() / "table.csv")
    check(path.read_bytes().startswith(start), f"this is no {ending} file")

formula = read_tir(MADE).formula()
data = sweeps(formula, (2000, 4000))
ranges = {"loads": np.array([2000.0, 4000]), "slip_angle": 0.2, "slip_ratio": 0.4}
for slip, force in (("slip_angle", "F_y"), ("slip_angle", "M_z"),
                    ("slip_ratio", "F_x")):
    panel = plt.subplots()[1]
    draw_sweep(panel, formula, ranges, data, slip, force)
    curves = [line for line in panel.lines if line.get_linestyle() == "-"]
    points = [line for line in panel.lines if line.get_linestyle() == "None"]
    check(len(curves) == len(points) == 2, f"{len(curves)} curves, {len(points)} points")
    # degrees and percent
    end = np.degrees(0.2) if slip == "slip_angle" else 40
    check(abs(curves[0].get_xdata().max() - end) < 1e-9, "the axis has another unit")
    for curve, marks in zip(curves, points):
        inside = np.abs(marks.get_xdata()) < curve.get_xdata().max()
        check(inside.sum() > 8, "there are few points")
        error = np.interp(marks.get_xdata()[inside], curve.get_xdata(), curve.get_ydata()) \
            - marks.get_ydata()[inside]
        check(np.abs(error).max() < 0.01 * np.abs(curve.get_ydata()).max(),
              f"the points are off the curve by {np.abs(error).max()}")
panel = plt.subplots()[1]
draw_ellipse(panel, formula, ranges, data)
points = panel.lines[-1]
check(len(points.get_xdata()) == ((data["F_z"] == 4000) & ~data.is_lateral).sum(),
      "points of the ellipse are missing")
