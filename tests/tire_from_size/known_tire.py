# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program in place of biface, whose tire is a known Magic Formula with known stiffnesses
and frequencies: it reads the parameter files of a series of runs and writes the results that
this series needs. Tests start it by the script that known_program() writes."""

import os
import sys
import time
from pathlib import Path

# N/m, N/m, N m/rad, and N/m along the normal of the ground
STIFFNESS = {"lateral": 1e5, "longitudinal": 3e5, "torsional": 800.0}
RADIAL = 2e5
FREQUENCY, RADIUS = 60.0, 0.2

# The file in which each call leaves a line, and the one whose presence lets runs wait
CALLS, WAIT = "calls.txt", "wait"


def known_program(directory):
    """The script; returns its path."""
    path = directory / "biface"
    source = Path(os.environ["BIFACE_SOURCE"])
    path.write_text(f"#!/bin/sh\nPYTHONPATH={source}/source/python:{Path(__file__).parent} "
                    f"exec {sys.executable} -B {__file__} {directory} \"$@\"\n",
                    encoding="utf-8")
    path.chmod(0o755)
    return path


def formula():
    """The known tire."""
    from biface_tire_model.magic_formula import FORMULAS
    return FORMULAS["5.2"]({
        "FNOMIN": 2690.0, "UNLOADED_RADIUS": RADIUS, "PCY1": 1.4, "PDY1": 0.9, "PDY2": -0.1,
        "PEY1": -0.5, "PKY1": -14.0, "PKY2": 1.8, "PCX1": 1.6, "PDX1": 1.0, "PKX1": 22.0,
        "PEX1": 0.1})


def main(directory, words):
    """Answers a command line."""
    with open(directory / CALLS, "a", encoding="utf-8") as file:
        file.write(" ".join(words) + "\n")
    if words == ["--version"]:
        print("biface 0")
        return
    from biface.parameters import read_parameters, stages
    path = Path(next(word for word in words if word.endswith(".prm")))
    parameters = read_parameters(path)
    if "--check" in words:
        print("Expected: little memory and a time of seconds for 5 steps.\nParameters OK.")
        return
    output = Path(words[words.index("--output") + 1])
    output.mkdir(parents=True, exist_ok=True)
    (output / "checkpoint.bin").write_text("", encoding="utf-8")
    while (directory / WAIT).exists():
        time.sleep(0.05)
    (output / "parameters.prm").write_text(parameters.text, encoding="utf-8")
    found = {name: entry.value for name, entry in parameters.entries.items()}
    write_standing(output, found, stages(parameters))
    if "Tire test/Loads" in found:
        write_test(output, found)


def table(path, columns, rows):
    """Writes a CSV file."""
    path.write_text("".join(",".join(map(str, row)) + "\n" for row in (columns, *rows)),
                    encoding="utf-8")


def write_standing(output, found, names):
    """history.csv, stiffness.csv and modes.csv of the stages."""
    history, stiffness, modes = [], [], []
    for step, (number, name) in enumerate(names, start=1):
        get = lambda entry: found.get(f"Stage {number}/{entry}", "")  # noqa: E731
        force = float(get("Force") or 0)
        kind = name.split()[0]
        if kind in STIFFNESS or kind == "load":
            load = force or float(name.split()[1])
            slide = get("Turn") or max(get("Slide").split(", "), default="") or 1
            unit = {"load": RADIAL / 1000}.get(kind, STIFFNESS.get(kind, 0) / 1000)
            if kind == "torsional":
                unit = STIFFNESS[kind] * 1000 * 3.14159265358979 / 180
            stiffness.append((step, name, 0.386, load if kind != "load" else 0, 1,
                              {"load": "approach", "torsional": "turn"}.get(kind, "slide"),
                              slide, int(kind == "torsional"), int(kind == "lateral"),
                              int(kind == "longitudinal"), unit, unit, 0, 0, 0))
        history.append((step, name, force / RADIAL * 1000, force, 9 * (force > 0), 0, 0, 1, 1,
                        0.38641, 1))
        if get("Modes") not in ("", "0"):
            modes.append((step, 1, name, FREQUENCY, 0, 0, 0.9, 0, 1, 0, 1))
    table(output / "history.csv", ("step", "stage", "approach", "force", "contact_nodes",
                                   "contact_area", "max_pressure", "iterations", "seconds",
                                   "pressure", "load_factor"), history)
    if stiffness:
        table(output / "stiffness.csv", (
            "step", "stage", "pressure", "force", "approach", "motion", "amount",
            "direction_x", "direction_y", "direction_z", "secant", "tangent", "secant_F_x",
            "secant_F_y", "secant_F_z"), stiffness)
    if modes:
        table(output / "modes.csv", (
            "step", "mode", "stage", "frequency", "growth_rate", "effective_mass_x",
            "effective_mass_y", "effective_mass_z", "total_mass", "circumferential_waves",
            "meridional_half_waves"), modes)


def write_test(output, found):
    """tire_test.csv at pure slip, without moments."""
    from math import radians
    loads, angles, ratios = ([float(word) for word in found.get(f"Tire test/{name}", "")
                              .split(",") if word.strip()]
                             for name in ("Loads", "Slip angles", "Slip ratios"))
    pressure = float(found["Tire test/Pressures"])
    known, rows = formula(), []
    for load in loads:
        for angle, ratio in [(0, 0), *((a, 0) for a in angles), *((0, r) for r in ratios)]:
            forces = known.evaluate(load, ratio, radians(angle))
            rows.append((len(rows) + 1, "ok", "ISO", load, pressure, 16666.7, 0, angle, ratio,
                         forces.F_x, forces.F_y, load, "nan", "nan", "nan",
                         1000 * (RADIUS - load / RADIAL), 1000 * RADIUS))
    table(output / "tire_test.csv", (
        "point", "status", "axes", "load", "pressure", "velocity", "inclination_angle",
        "slip_angle", "slip_ratio", "F_x", "F_y", "F_z", "M_x", "M_y", "M_z",
        "loaded_radius", "rolling_radius"), rows)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
