# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/rolling.md about the bias tire with a tread of bristles:
stiffnesses of the standing tire, side forces on three meshes and on a stiffer
ground, and the iterations of 13 slip angles beside those with a critical velocity.

    python3 doc/rolling/bristles.py --program build/biface
"""

import argparse
import pathlib
import tempfile

import numpy as np

from slow_rolling import TREAD, Runs

COMMON = {"Contact/Multiplier mass": "lumped"}
# tangential and penalty stiffness; None for 'automatic'
SPRINGS = ((1e4, None), (0.075, None), (1e4, 0.3), (0.3, 0.3), (0.15, 0.3),
           (0.075, 0.3))
ANGLES = tuple(range(-6, 0)) + tuple(range(1, 7))


def print_table(header, lines):
    print("| " + " | ".join(header) + " |")
    print("|" + " --- |" * len(header))
    for line in lines:
        print("| " + " | ".join(line).replace("-", "−") + " |")
    print()


def glued(runs):
    """Force and glued stiffnesses of the standing tire."""
    motions = ("Slide", "0, 0, 0.02"), ("Slide", "0, 0.02, 0"), ("Turn", "0.02")
    settings = {"Number of stages": 5, "Stage 2/Steps": 5}
    for stage, (motion, value) in enumerate(motions, 3):
        section = f"Stage {stage}/"
        settings |= {section + "Start from": 2, section + "Contact": "true",
                     section + "Glued": "true", section + motion: value}
    lines = []
    for number, (tangential, normal) in enumerate(SPRINGS):
        results = runs.run(f"glued_{number}", "bias_tire.prm", {
            **COMMON, **settings,
            "Contact/Tangential regularization": tangential,
            "Contact/Regularization": normal or "automatic"})
        secants = results.stiffness()["secant"][-3:]
        lines.append([f"{tangential:g}", f"{normal:g}" if normal else "rigid",
                      f"{results.stage('contact').last('force'):.1f}",
                      f"{secants[0]:.1f}", f"{secants[1]:.1f}", f"{secants[2]:.0f}"])
    print_table(["k_t, MPa/mm", "k_n, MPa/mm", "force, N",
                 "fore-and-aft, N/mm", "lateral, N/mm",
                 "torsional, N mm per degree"], lines)


def roll(runs, name, angles, entries, steps=1, cells=1):
    """Free rolling, and from there each slip angle: the last line of
    rolling.csv by angle, and the iterations of all."""
    around = [round(n * cells) for n in (11, 18, 11)]
    settings = {
        "Mesh/Intervals alpha_2": f"-180:-15:{around[0]}:smooth, "
        f"-15:15:{around[1]}, 15:180:{around[2]}:smooth",
        "Contact/Friction": 0.5, "Stage 2/Friction": 0, "Stage 2/Steps": 2,
        "Number of stages": 3 + len(angles), "Stage 3/Ground velocity": 1}
    for stage in range(3, 4 + len(angles)):
        section = f"Stage {stage}/"
        settings |= {section + "Contact": "true",
                     section + "Control": "axle moment",
                     section + "Steps": steps}
        if stage > 3:
            settings |= {section + "Start from": 3,
                         section + "Slip angle": angles[stage - 4]}
    results = runs.run(name, "bias_tire.prm", {**COMMON, **settings, **entries})
    rolling = results.rolling()
    rolls = np.isin(results.steps, rolling["step"])
    return ({row["slip_angle"]: row for row in rolling.rows()},
            sum(results.history.where(rolls)["iterations"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    bristles = {**TREAD, "Contact/Rolling friction": "bristles"}

    with tempfile.TemporaryDirectory() as scratch:
        arguments.scratch = pathlib.Path(scratch)
        runs = Runs(arguments)
        glued(runs)

        lines = []
        for cells in (1, 2, 4):
            at, iterations = roll(runs, f"cells_{cells}",
                                  (-0.5, 0.5, 1, 2, 4), bristles, cells=cells)
            side = {angle: row["F_y"] for angle, row in at.items()}
            lines.append([f"42 × {40 * cells}", f"{side[-0.5] - side[0.5]:.1f}"]
                         + [f"{side[angle]:.1f}" for angle in (1, 2, 4)]
                         + [f"{at[1]['M_z']:.0f}", f"{iterations:.0f}"])
        print_table(["cells", "cornering stiffness, N per degree",
                     "side force at 1°, N", "2°", "4°",
                     "aligning moment at 1°, N mm", "iterations of 6 steps"],
                    lines)

        lines = []
        for normal, cells in ((0.3, 1), (3, 1), (30, 1), (30, 2), (30, 4)):
            at, _ = roll(runs, f"normal_{normal}_{cells}", (1,), {
                "Contact/Rolling friction": "bristles",
                "Contact/Tangential regularization": 0.075,
                "Contact/Regularization": normal}, cells=cells)
            lines.append([f"{normal:g}", f"42 × {40 * cells}",
                          *(f"{at[angle]['F_y']:.1f}"
                            for angle in (0, 1))])
        print_table(["k_n, MPa/mm", "cells", "side force in free rolling, N",
                     "at 1°, N"], lines)

        lines = []
        for name, entries, steps in (
                ("bristles", bristles, 1),
                ("s_c = 0.005", {"Contact/Critical velocity": 0.005}, 4)):
            at, iterations = roll(runs, f"angles_{steps}", ANGLES, entries, steps)
            n_reached = sum(angle in at for angle in (0, *ANGLES))
            lines.append([name, f"{steps}", f"{n_reached} of 13", f"{iterations:.0f}"]
                         + [f"{at[angle]['F_y']:.1f}"
                            for angle in (-6, -1, 0, 1, 6)])
        print_table(["friction", "steps each", "slip angles", "iterations",
                     "side force at -6°, N", "-1°", "0", "1°", "6°"], lines)


if __name__ == "__main__":
    main()
