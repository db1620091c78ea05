#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the tables of rolling.md about rolling_tire_at_load.prm, about
rolling_tire.prm beside tire_on_drum_rolling.prm, and about the rolling
resistance.

Usage: examples.py --program build/biface [--scratch DIRECTORY]
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, table

MESHES = {"42 × 21": "-180:-15:6:smooth, -15:15:9, 15:180:6:smooth",
          "42 × 40": "-180:-15:11:smooth, -15:15:18, 15:180:11:smooth",
          "42 × 80": "-180:-15:22:smooth, -15:15:36, 15:180:22:smooth"}


def row(results, stage, angle=None):
    """The last line of a stage in rolling.csv, or that with a slip angle."""
    lines = results.rolling().where(stage=stage)
    if angle is not None:
        lines = lines.where(abs(lines["slip_angle"] - angle) < 1e-9)
    return lines.row(-1)


def travel(results, line):
    """The approach of the ground in the step of a line, in mm."""
    return results.history.where(step=line["step"])["approach"][0]


def at_load(runs):
    results = runs.run("at_load", "rolling_tire_at_load.prm", {})
    rows = [["standing, without friction",
             f"{results.stage('load').last('approach'):.3f}", "", "", ""]]
    for stage, label in (("free", "free"), ("cornering", "free, slip angle 1°"),
                         ("braking", "braked, slip ratio −2 %")):
        last = row(results, stage)
        rows.append([label, f"{travel(results, last):.3f}",
                     f"{last['angular_velocity']:.3f}",
                     f"{-last['F_x']:.2f}", f"{last['F_y']:.1f}"])
    return table(["", "travel, mm", "angular velocity, rad/s", "drag, N",
                  "side force F_y, N"], rows)


def drum(runs):
    plane = runs.run("plane", "rolling_tire.prm", {})
    force = row(plane, "free")["F_z"]
    loaded = {f"Stage {i}/{entry}": value for i in (3, 4, 5) for entry, value in
              (("Control", "foundation force and axle moment"),
               ("Force", force))}
    columns = [plane, runs.run("drum", "tire_on_drum_rolling.prm", {}),
               runs.run("loaded_drum", "tire_on_drum_rolling.prm",
                        {**loaded, "Number of stages": 5})]
    rows = []
    for results in columns:
        free, left = row(results, "free"), row(results, "left", 1)
        right = row(results, "right", -1)
        sharp = row(results, "left", 6)
        rows.append([
            f"{travel(results, free):.2f}",
            f"{free['rolling_radius']:.2f}", f"{free['F_z']:.1f}",
            f"{-free['F_x']:.2f}", f"{free['F_y']:.1f}", f"{left['F_y']:.1f}",
            f"{right['F_y']:.1f}", f"{left['M_z'] / 1000:.2f}",
            f"{sharp['F_y'] / sharp['F_z']:.3f}",
            *(f"{-row(results, stage)['F_x']:.1f}" if stage in results.stages
              else ""
              for stage in ("braking", "locked"))])
    labels = ["travel, mm", "free rolling: radius, mm", "vertical force, N",
              "drag, N", "side force (ply steer), N",
              "slip angle 1°: side force, N", "slip angle −1°: side force, N",
              "slip angle 1°: aligning moment, N m",
              "slip angle 6°: side force over vertical force",
              "braked to 39.35 rad/s: drag, N", "locked: drag, N"]
    return table(["", "plane", "drum", "drum, load of the plane"],
                 [[label, *(column[i] for column in rows)]
                  for i, label in enumerate(labels)])


def resistance(runs):
    rows = []
    for mesh, intervals in MESHES.items():
        results = runs.run("resistance_" + mesh.split()[-1], "rolling_tire.prm",
                           {"Mesh/Intervals alpha_2": intervals,
                            "Number of stages": 3})
        free = row(results, "free")
        rows.append([mesh, f"{free['F_z']:.1f}",
                     f"{free['rolling_resistance']:.2f}",
                     f"{-free['F_x']:.2f}"])
    return table(["cells", "vertical force, N", "rolling resistance, N",
                  "drag of friction, N"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--scratch", type=Path,
                        default=Path("rolling_example_runs"))
    runs = Runs(parser.parse_args())
    runs.scratch.mkdir(parents=True, exist_ok=True)
    for make in (at_load, drum, resistance):
        print(make(runs), end="\n\n", flush=True)


if __name__ == "__main__":
    main()
