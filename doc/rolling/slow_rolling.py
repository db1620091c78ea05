# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of doc/rolling.md that compares steady rolling at a slip angle of 2
degrees with a tire turned slowly over the ground, in steps of a part of a cell.

    python3 doc/rolling/slow_rolling.py --program build/biface
"""

import argparse
import csv
import math
import pathlib
import subprocess
import tempfile

PRM = pathlib.Path(__file__).parents[2] / "prm" / "bias_tire.prm"
SLIP_ANGLE = math.radians(2)
CELLS_AROUND = 96
CELLS_TURNED = 32
# of the ground to the side before the tire is turned, near that in rolling
FIRST_SLIDE = -6.0

TREAD = {"Contact/Tread/Height": 8, "Contact/Tread/Modulus": 1.8}
COMMON = {
    **TREAD,
    "Mesh/Intervals alpha_1": "-120:-45:4, -45:45:8, 45:120:4",
    "Mesh/Intervals alpha_2": f"-180:180:{CELLS_AROUND}",
    "Contact/Multiplier mass": "lumped",
    "Contact/Friction": 0.5,
    "Contact/Rolling friction": "bristles",
    "Number of stages": 4,
    "Stage 2/Friction": 0,
    "Stage 2/Steps": 2,
    "Stage 3/Contact": "true",
    "Stage 4/Contact": "true",
    "Output/Write VTU": "false",
}


def run(program, directory, entries):
    """Run the bias tire with some entries changed."""
    command = [program, PRM, "--output", directory]
    for entry, value in {**COMMON, **entries}.items():
        command += ["--set", f"{entry}={value}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def rows(file):
    with open(file, newline="", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def steady(program, directory):
    """The forces F_x, F_y, F_z of steady rolling, and the rolling radius."""
    run(program, directory, {
        "Stage 3/Ground velocity": 1,
        "Stage 3/Control": "axle moment",
        "Stage 4/Slip angle": math.degrees(SLIP_ANGLE),
        "Stage 4/Control": "axle moment",
    })
    last = rows(directory / "rolling.csv")[-1]
    forces = [float(last[column]) for column in ("F_x", "F_y", "F_z")]
    return forces, float(last["rolling_radius"])


def slow(program, directory, radius, steps_per_cell):
    """The same forces, means over the last cell that is turned."""
    turn = 2 * math.pi * CELLS_TURNED / CELLS_AROUND
    side = FIRST_SLIDE - radius * turn * math.tan(SLIP_ANGLE)
    n_steps = CELLS_TURNED * steps_per_cell
    run(program, directory, {
        "Stage 3/Slide": f"0, {FIRST_SLIDE}, 0",
        "Stage 3/Steps": 4,
        "Stage 4/Wheel turn": repr(math.degrees(turn)),
        "Stage 4/Slide": f"0, {side!r}, {-radius * turn!r}",
        "Stage 4/Steps": n_steps,
    })
    ground = [row for row in rows(directory / "forces.csv")
              if row["body"] == "foundation"][-steps_per_cell:]
    mean = [0.0, 0.0, 0.0]
    for i, row in enumerate(ground):
        # from the axes that turn with the wheel: down is x at the start
        angle = turn * (n_steps - steps_per_cell + i + 1) / n_steps
        x, y, z = (float(row[column]) for column in ("F_x", "F_y", "F_z"))
        forward = math.cos(angle) * z - math.sin(angle) * x
        up = -math.cos(angle) * x - math.sin(angle) * z
        for j, force in enumerate((forward, y, up)):
            mean[j] += force / steps_per_cell
    return mean


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--steps", type=int, nargs="+", default=[1, 2, 4, 8])
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        forces, radius = steady(options.program, scratch / "steady")
        print("| steps a cell | vertical force, N | drag, N | side force, N | "
              "beside steady |\n| --- | --- | --- | --- | --- |")
        for n in options.steps:
            now = slow(options.program, scratch / f"slow_{n}", radius, n)
            print(f"| {n} | {now[2]:.1f} | {-now[0]:.1f} | {now[1]:.1f} | "
                  f"{100 * (now[1] / forces[1] - 1):+.1f} % |".replace(
                      "-", "−"))
        print(f"| steady | {forces[2]:.1f} | {-forces[0]:.1f} | "
              f"{forces[1]:.1f} | |".replace("-", "−"))


if __name__ == "__main__":
    main()
