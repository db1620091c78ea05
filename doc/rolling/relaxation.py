#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the tables of doc/rolling.md about the relaxation length, from
prm/slip_step.prm, and draw its picture, doc/figures/relaxation.png.

    python3 doc/rolling/relaxation.py --program build/biface
"""

import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, table

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

SPEED = 10000.0
WAY = 834.0
# of prm/slip_step.prm: cells of the footprint in this way
CELLS = 80
ANGLES = 0.25, 1, 2, 4


def response(results):
    """The way from the turn of the wheel, in mm, and the side force."""
    rolling = results.rolling()
    rows = np.isin(rolling["stage"], ("steer", "corner"))
    time = rolling["time"][rows]
    return SPEED * (time - time[0]), rolling["F_y"][rows]


def relaxation_length(way, force, end):
    """The way after which the part 1 - 1/e of the change has happened."""
    part = (force - force[0]) / (end - force[0])
    return float(np.interp(1 - np.exp(-1), part, way))


def steady(runs, name, entries):
    return runs.run(name + "_steady", "slip_step.prm", {
        **entries, "Number of stages": 4,
        "Stage 4/Transient rolling": "false"}).rolling().row(-1)["F_y"]


def standing(runs):
    """The lateral stiffness of the standing tire, glued to the ground, in N/mm."""
    return runs.run("standing", "slip_step.prm", {
        "Number of stages": 3, "Stage 3/Glued": "true", "Stage 3/Slide": "0, 0.02, 0",
        "Stage 3/Control": "load", "Stage 3/Ground velocity": 0,
        "Stage 3/Friction": 0.5}).stiffness()["secant"][-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=Path, default=Path("build/biface"))
    parser.add_argument("--scratch", type=Path, default=Path("build/relaxation"))
    parser.add_argument("--output", type=Path,
                        default=Path(__file__).resolve().parents[1] / "figures")
    arguments = parser.parse_args()
    arguments.scratch.mkdir(parents=True, exist_ok=True)
    runs = Runs(arguments)
    plt.rcParams.update(STYLE)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2),
                                         gridspec_kw={"wspace": 0.3})

    rows, slope, free = [], None, None
    for angle, color in zip(ANGLES, (GRAY, BLUE, RED, "black")):
        entries = {"Stage 4/Slip angle": angle}
        results = runs.run(f"angle_{angle}", "slip_step.prm", entries)
        way, force = response(results)
        end = steady(runs, f"angle_{angle}", entries)
        free = force[0]
        if slope is None:
            slope = (end - force[0]) / np.radians(angle)
        rows.append([f"{angle:g}°", f"{end:.1f}", f"{force[-1]:.1f}",
                     f"{relaxation_length(way, force, end):.0f}"])
        left.plot(way, -force, color=color, label=f"{angle:g}°")
        left.plot(way[-1] + 30, -end, "o", color=color, markersize=3)
    print(table(["slip angle", "steady side force, N", "after 834 mm, N",
                 "relaxation length, mm"], rows))
    stiffness = standing(runs)
    print(f"slope {abs(slope):.0f} N per radian over lateral stiffness "
          f"{stiffness:.2f} N/mm: {abs(slope) / stiffness:.0f} mm; "
          f"free rolling: {free:.1f} N\n")

    rows = []
    for cells in (0.5, 1, 2, 4, 8):
        entries = {"Stage 4/Slip angle": 0.25, "Stage 5/Steps": round(CELLS / cells)}
        results = runs.run(f"cells_{cells}", "slip_step.prm", entries)
        way, force = response(results)
        end = steady(runs, "angle_0.25", {"Stage 4/Slip angle": 0.25})
        corner = results.stage("corner")
        rows.append([f"{cells:g}", f"{round(CELLS / cells)}",
                     f"{sum(corner.history['iterations']):.0f}",
                     f"{relaxation_length(way, force, end):.0f}"])
    print(table(["cells in a step", "steps", "iterations", "relaxation length, mm"], rows))

    brake = runs.run("brake", "slip_step.prm", {
        "Stage 4/Slip angle": 0, "Stage 4/Angular velocity": 41})
    rolling = brake.rolling()
    rows = np.isin(rolling["stage"], ("steer", "corner"))
    time = rolling["time"][rows]
    right.plot(SPEED * (time - time[0]), -rolling["F_x"][rows], color=BLUE)
    left.set_ylabel("Side force $-F_y$, N")
    left.legend(title="slip angle")
    right.set_ylabel("Drag $-F_x$, N")
    right.set_ylim(bottom=0)
    for axes in (left, right):
        axes.set_xlabel("Way after the step, mm")
    save(figure, arguments.output / "relaxation.png")


if __name__ == "__main__":
    main()
