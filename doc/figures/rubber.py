#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon of prm/rubber_balloon.prm, its sections and its pressure, and the
sections of prm/rubber_bellows.prm."""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "source/python"), str(ROOT / "doc")]

from biface import Results
from biface_report.drawing import BLUE, GRAY, STYLE, save, shades
from example_page import section

# The balloon: shear modulus (MPa), thickness and radius (mm)
MU, THICKNESS, RADIUS = 0.4, 0.3, 50


def draw_sections(axes, results, steps, whole):
    """Both faces after some steps, with their mirror images if whole."""
    for step, color in zip(steps, shades(len(steps))):
        for face in ("inner", "outer"):
            y, r = section(results, step, face)
            for x_sign, y_sign in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
                if whole or x_sign == y_sign == 1:
                    axes.plot(x_sign * r, y_sign * y, color=color, linewidth=1.3)
    axes.set(xlabel="radius (mm)", ylabel="along the axis (mm)",
             aspect="equal")


def draw_pressure(axes, results, steps):
    """The pressure over the stretch of the equator during the inflation."""
    inflation = results.stage("inflation")
    radius = inflation.probes().where(name="equator")["u_x"]
    stretch = np.append(1, 1 + radius / RADIUS)
    pressure = np.append(0, 1e3 * inflation.history["pressure"])
    axes.plot(stretch, pressure, "-", color=BLUE, label="computed")
    exact = np.linspace(1, 3, 200)
    axes.plot(exact, 2e3 * MU * THICKNESS / RADIUS * (1 / exact - exact ** -7), "--",
              color=GRAY, linewidth=1.3, label="thin sphere")
    for step, color in zip(steps, shades(len(steps))):
        axes.plot(stretch[step], pressure[step], "o", color=color, zorder=3)
    axes.set(xlabel="stretch of the equator", ylabel="pressure (kPa)", ylim=(0, None))
    axes.legend(loc="lower right")


def main():
    """Draw the results of two runs."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("balloon", "bellows"):
        parser.add_argument(name, type=Path, help="a directory of results")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)

    figure, (path, balloon, bellows) = plt.subplots(
        1, 3, figsize=(12, 4), gridspec_kw={"width_ratios": [1.1, 1, 0.4], "wspace": 0.32})
    results = Results(arguments.balloon)
    last = results.stage("inflation").step
    steps = [1, 4, 6, last // 2 + 1, last]
    draw_pressure(path, results, steps)
    draw_sections(balloon, results, steps, whole=True)
    results = Results(arguments.bellows)
    steps = results.steps[np.isin(results.history["load_factor"], (0, 0.5, 1))]
    draw_sections(bellows, results, steps, whole=False)
    bellows.set_xlim(75, None)
    for axes, title in ((path, "balloon"), (balloon, "balloon"), (bellows, "bellows")):
        axes.set_title(title)
    save(figure, arguments.picture)


if __name__ == "__main__":
    main()
