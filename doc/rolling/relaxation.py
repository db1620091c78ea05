#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the tables of doc/rolling.md about the relaxation length, from
prm/slip_step.prm, and about a tire that starts to roll beside one that is turned
over the ground, and draw doc/figures/relaxation.png.

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


# a tire that starts to roll, in cells of a mesh with as many around
AROUND, TURNED = 96, 24
RADIUS = 239.8
STARTS = {
    "Contact/Tread/Height": 8, "Contact/Tread/Modulus": 1.8, "Contact/Friction": 0.5,
    "Contact/Multiplier mass": "lumped", "Contact/Rolling friction": "bristles",
    "Mesh/Intervals alpha_1": "-120:-45:4, -45:45:8, 45:120:4",
    "Mesh/Intervals alpha_2": f"-180:180:{AROUND}",
    "Stage 2/Friction": 0, "Stage 2/Steps": 2, "Stage 3/Contact": "true"}


def turned(runs, name, radius, angle):
    """F_x and F_y of a tire that is turned over the ground with its mesh, after each
    cell, in steps of half a cell."""
    turn = 2 * np.pi * TURNED / AROUND
    ground = runs.run(f"turned_{name}", "bias_tire.prm", {
        **STARTS, "Number of stages": 3, "Stage 3/Wheel turn": repr(np.degrees(turn)),
        "Stage 3/Slide": f"0, {-radius * turn * np.tan(angle)!r}, {-radius * turn!r}",
        "Stage 3/Steps": 2 * TURNED}).forces().where(body="foundation")
    ground = ground.rows()[-2 * TURNED + 1::2]
    forces = []
    for i, row in enumerate(ground, 1):
        # from axes that turn with the wheel: down is x at the start
        psi = turn * i / TURNED
        forces.append((np.cos(psi) * row["F_z"] - np.sin(psi) * row["F_x"], row["F_y"]))
    return np.array(forces)


def starts(runs, name, radius, angle):
    """The same of one that rolls through the mesh of the axle, a cell in a step."""
    rolling = runs.run(f"starts_{name}", "bias_tire.prm", {
        **STARTS, "Number of stages": 4, "Stage 3/Angular velocity": 10,
        "Stage 3/Ground velocity": repr(10 * radius / np.cos(angle)),
        "Stage 3/Slip angle": repr(np.degrees(angle)),
        "Stage 3/Transient rolling": "true", "Stage 3/Duration": 1e-8,
        "Stage 4/Contact": "true", "Stage 4/Transient rolling": "true",
        "Stage 4/Duration": repr(2 * np.pi * TURNED / AROUND / 10),
        "Stage 4/Steps": TURNED}).rolling()
    return np.stack([rolling["F_x"], rolling["F_y"]], axis=1)[-TURNED:]


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
        left.plot(way, -force, color=color)
        left.axhline(-end, color=color, linewidth=0.8, linestyle="--")
        left.annotate(f"{angle:g}°", (way[-1], -force[-1]), (0, -13),
                      textcoords="offset points", ha="right")
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

    lines = []
    for name, title, radius, angle, column, color in (
            ("slip_angle", "$F_y$, slip angle 2°", RADIUS, np.radians(2), 1, RED),
            ("braked", "$F_x$, braked by 2 %", 1.02 * RADIUS, 0., 0, BLUE)):
        of_mesh, of_axle = (-f(runs, name, radius, angle)[:, column]
                            for f in (turned, starts))
        way = 2 * np.pi * radius / AROUND * np.arange(1, TURNED + 1)
        right.plot(way, of_mesh, "o", color=color, markersize=3)
        right.plot(way, of_axle, color=color)
        right.annotate(title, (way[-1], of_axle[-1]), (0, -32),
                       textcoords="offset points", ha="right")
        for cells in (1, 4, 8, 16, 24):
            lines.append((name, cells, of_axle[cells - 1], of_mesh[cells - 1]))
    rows = [[str(cells), *(f"{value:.1f}" for name in ("slip_angle", "braked")
                           for line in lines if line[:2] == (name, cells)
                           for value in line[2:])] for cells in (1, 4, 8, 16, 24)]
    print("\n" + table(["cells rolled", "slip angle 2°: $-F_y$, N", "turned, N",
                        "braked by 2 %: $-F_x$, N", "turned, N"], rows))
    left.set_ylabel("Side force $-F_y$, N")
    right.set_ylabel("Force on the ground, N")
    left.set_xlabel("Distance after the change, mm")
    right.set_xlabel("Distance from standing, mm")
    for axes in (left, right):
        axes.set_ylim(bottom=0)
    save(figure, arguments.output / "relaxation.png")


if __name__ == "__main__":
    main()
