# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/rolling.md about the tire with a tread: the tire of
rolling_tire.prm with the rubber of tread_tire.prm, as bristles, as a ply of a
single layer and as a layer of its own, rolls freely with slip angles from -6 to 6 degrees.

    python3 doc/rolling/tread_tire.py --program build/biface
"""

import argparse
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from example_page import Runs

SPEED = 1e4  # mm/s, in the parameter file
# instead of the tread of bristles of the parameter file
SLIP_VELOCITY = {
    "Contact/Rolling friction": "slip velocity",
    "Contact/Critical velocity": 0.005 * SPEED,
    "Contact/Tread/Height": "none",
    "Contact/Tread/Modulus": 0,
    "Contact/Regularization": 1e4,
    "Stage 3/Steps": 5,
}
TREAD = {
    **SLIP_VELOCITY,
    "Materials": "cord, rubber",
    "Material rubber/Type": "isotropic",
    "Material rubber/E": 1.8,
    "Material rubber/nu": 0.49,
    "Material rubber/Density": 1.2e-9,
    "Laminate/Plies": "2 x (cord: 1.2 @ +-52), rubber: 8 @ 0 from -60 to 60",
    "Mesh/Intervals alpha_1": "-120:-60:9, -60:60:24, 60:120:9",
    "Formulation": "standard",
}
WALLS = (("no tread", SLIP_VELOCITY),
         ("bristles", {}),
         ("one layer", {**TREAD, "Laminate/Layers": "one"}),
         ("two layers", {**TREAD, "Laminate/Layers": "4, 1"}))
# s_c over the speed
FRACTIONS = (0.02, 0.01, 0.005, 0.0025, 0.00125)


def run(runs, entries, angle=6, steps=6):
    """The last lines of rolling.csv by slip angle, to both sides up to the given
    one or as far as steps converge."""
    lines = {}
    for end in (-angle, angle):
        cornering = {"Number of stages": 4, "Stage 4/Slip angle": end,
                     "Stage 4/Steps": steps}
        results = runs.run("tread", "rolling_tire.prm",
                           {**cornering, **entries}, may_stop=True)
        for line in results.rolling().rows():
            if line["stage"] in ("free", "right"):
                lines[round(line["slip_angle"], 6)] = line
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", required=True)
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as scratch:
        arguments.scratch = pathlib.Path(scratch)
        runs = Runs(arguments)
        print("| | load, N | at 1°, over the load | at −1° | at 6° | at −6° "
              "| slip angles that converge |")
        print("| --- | --- | --- | --- | --- | --- | --- |")
        for name, wall in WALLS:
            lines = run(runs, wall)

            def ratio(angle):
                line = lines.get(angle)
                return ("failed" if line is None else
                        f"{line['F_y'] / line['F_z']:.3f}")
            print(f"| {name} | {lines[0]['F_z']:.1f} | "
                  + " | ".join(ratio(angle) for angle in (1, -1, 6, -6))
                  + f" | {sum(angle in lines for angle in range(-6, 7))} of 13 |",
                  flush=True)

        print("\n| s_c over the speed | one layer: cornering stiffness, N per "
              "degree | change | two layers | change |")
        print("| --- | --- | --- | --- | --- |")
        before = [math.nan, math.nan]
        for fraction in FRACTIONS:
            cells = []
            for i, (_, wall) in enumerate(WALLS[2:]):
                entries = {"Contact/Critical velocity": fraction * SPEED}
                lines = run(runs, {**wall, **entries}, 0.5, 1)
                slope = (lines[-0.5]["F_y"] - lines[0.5]["F_y"]
                         if {-0.5, 0.5} <= set(lines) else math.nan)
                cells += [f"{slope:.1f}", "" if math.isnan(before[i]) else
                          f"{100 * (slope / before[i] - 1):+.1f} %"]
                before[i] = slope
            print(f"| {fraction:g} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
