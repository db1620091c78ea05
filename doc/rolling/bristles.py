# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/rolling.md about the bias tire with a tread of bristles:
stiffnesses of the standing tire, side forces on three meshes and on a stiffer
ground, and the iterations of 13 slip angles beside those with a critical velocity.

    python3 doc/rolling/bristles.py --program build/biface
"""

import argparse
import pathlib
import subprocess
import tempfile

from slow_rolling import PRM, TREAD, rows as rows_of

COMMON = {"Contact/Multiplier mass": "lumped", "Output/Write VTU": "false"}
# tangential and normal regularization; None for 'automatic'
SPRINGS = ((1e4, None), (0.075, None), (1e4, 0.3), (0.3, 0.3), (0.15, 0.3),
           (0.075, 0.3))
ANGLES = tuple(range(-6, 0)) + tuple(range(1, 7))


def run(program, directory, entries):
    """Run the bias tire with some entries changed; rows of a file by name."""
    command = [program, PRM, "--quiet", "--output", directory]
    for entry, value in {**COMMON, **entries}.items():
        command += ["--set", f"{entry}={value}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    return lambda name: rows_of(directory / name)


def print_table(header, lines):
    print("| " + " | ".join(header) + " |")
    print("|" + " --- |" * len(header))
    for line in lines:
        print("| " + " | ".join(line).replace("-", "−") + " |")
    print()


def glued(program, scratch):
    """Force and glued stiffnesses of the standing tire."""
    motions = ("Slide", "0, 0, 0.02"), ("Slide", "0, 0.02, 0"), ("Turn", "0.02")
    settings = {"Number of stages": 5, "Stage 2/Steps": 5}
    for stage, (motion, value) in enumerate(motions, 3):
        section = f"Stage {stage}/"
        settings |= {section + "Start from": 2, section + "Contact": "true",
                     section + "Glued": "true", section + motion: value}
    lines = []
    for number, (tangential, normal) in enumerate(SPRINGS):
        rows = run(program, scratch / f"glued_{number}", {
            **settings,
            "Contact/Tangential regularization": tangential,
            "Contact/Regularization": normal or "automatic"})
        contact = [row for row in rows("history.csv")
                   if row["stage"] == "contact"][-1]
        secants = [float(row["secant"]) for row in rows("stiffness.csv")[-3:]]
        lines.append([f"{tangential:g}", f"{normal:g}" if normal else "rigid",
                      f"{float(contact['force']):.1f}", f"{secants[0]:.1f}",
                      f"{secants[1]:.1f}", f"{secants[2]:.0f}"])
    print_table(["k_t, MPa/mm", "k_n, MPa/mm", "force, N",
                 "fore-and-aft, N/mm", "lateral, N/mm",
                 "torsional, N mm per degree"], lines)


def roll(program, directory, angles, entries, steps=1, cells=1):
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
    rows = run(program, directory, {**settings, **entries})
    iterations = {row["step"]: int(row["iterations"])
                  for row in rows("history.csv")}
    rolling = rows("rolling.csv")
    return ({float(row["slip_angle"]): row for row in rolling},
            sum(iterations[row["step"]] for row in rolling))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True)
    program = parser.parse_args().program.resolve()
    bristles = {**TREAD, "Contact/Rolling friction": "bristles"}

    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        glued(program, scratch)

        lines = []
        for cells in (1, 2, 4):
            at, iterations = roll(program, scratch / f"cells_{cells}",
                                  (-0.5, 0.5, 1, 2, 4), bristles, cells=cells)
            side = {angle: float(row["F_y"]) for angle, row in at.items()}
            lines.append([f"42 × {40 * cells}", f"{side[-0.5] - side[0.5]:.1f}"]
                         + [f"{side[angle]:.1f}" for angle in (1, 2, 4)]
                         + [f"{float(at[1]['M_z']):.0f}", f"{iterations}"])
        print_table(["cells", "cornering stiffness, N per degree",
                     "side force at 1°, N", "2°", "4°",
                     "aligning moment at 1°, N mm", "iterations of 6 steps"],
                    lines)

        lines = []
        for normal, cells in ((0.3, 1), (3, 1), (30, 1), (30, 2), (30, 4)):
            at, _ = roll(program, scratch / f"normal_{normal}_{cells}", (1,), {
                "Contact/Rolling friction": "bristles",
                "Contact/Tangential regularization": 0.075,
                "Contact/Regularization": normal}, cells=cells)
            lines.append([f"{normal:g}", f"42 × {40 * cells}",
                          *(f"{float(at[angle]['F_y']):.1f}"
                            for angle in (0, 1))])
        print_table(["k_n, MPa/mm", "cells", "side force in free rolling, N",
                     "at 1°, N"], lines)

        lines = []
        for name, entries, steps in (
                ("bristles", bristles, 1),
                ("s_c = 0.005", {"Contact/Critical velocity": 0.005}, 4)):
            at, iterations = roll(program, scratch / f"angles_{steps}", ANGLES,
                                  entries, steps)
            n_reached = sum(angle in at for angle in (0, *ANGLES))
            lines.append([name, f"{steps}", f"{n_reached} of 13", f"{iterations}"]
                         + [f"{float(at[angle]['F_y']):.1f}"
                            for angle in (-6, -1, 0, 1, 6)])
        print_table(["friction", "steps each", "slip angles", "iterations",
                     "side force at -6°, N", "-1°", "0", "1°", "6°"], lines)


if __name__ == "__main__":
    main()
