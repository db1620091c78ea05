# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of doc/rolling.md that compares steady rolling at a slip angle of 2
degrees with a tire turned slowly over the ground, in steps of a part of a cell.

    python3 doc/rolling/slow_rolling.py --program build/biface
"""

import argparse
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from example_page import Runs

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
}


def steady(runs):
    """The forces F_x, F_y, F_z of steady rolling, and the rolling radius."""
    last = runs.run("steady", "bias_tire.prm", {
        **COMMON,
        "Stage 3/Ground velocity": 1,
        "Stage 3/Control": "axle moment",
        "Stage 4/Slip angle": math.degrees(SLIP_ANGLE),
        "Stage 4/Control": "axle moment",
    }).rolling().row(-1)
    return [last[column] for column in ("F_x", "F_y", "F_z")], last["rolling_radius"]


def slow(runs, radius, steps_per_cell):
    """The same forces, means over the last cell that is turned."""
    turn = 2 * math.pi * CELLS_TURNED / CELLS_AROUND
    side = FIRST_SLIDE - radius * turn * math.tan(SLIP_ANGLE)
    n_steps = CELLS_TURNED * steps_per_cell
    forces = runs.run(f"slow_{steps_per_cell}", "bias_tire.prm", {
        **COMMON,
        "Stage 3/Slide": f"0, {FIRST_SLIDE}, 0",
        "Stage 3/Steps": 4,
        "Stage 4/Wheel turn": repr(math.degrees(turn)),
        "Stage 4/Slide": f"0, {side!r}, {-radius * turn!r}",
        "Stage 4/Steps": n_steps,
    }).forces()
    ground = forces.where(body="foundation").rows()[-steps_per_cell:]
    mean = [0.0, 0.0, 0.0]
    for i, row in enumerate(ground):
        # from the axes that turn with the wheel: down is x at the start
        angle = turn * (n_steps - steps_per_cell + i + 1) / n_steps
        x, y, z = (row[column] for column in ("F_x", "F_y", "F_z"))
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
        options.scratch = pathlib.Path(scratch)
        runs = Runs(options)
        forces, radius = steady(runs)
        print("| steps a cell | vertical force, N | drag, N | side force, N | "
              "beside steady |\n| --- | --- | --- | --- | --- |")
        for n in options.steps:
            now = slow(runs, radius, n)
            print(f"| {n} | {now[2]:.1f} | {-now[0]:.1f} | {now[1]:.1f} | "
                  f"{100 * (now[1] / forces[1] - 1):+.1f} % |".replace(
                      "-", "−"))
        print(f"| steady | {forces[2]:.1f} | {-forces[0]:.1f} | "
              f"{forces[1]:.1f} | |".replace("-", "−"))


if __name__ == "__main__":
    main()
