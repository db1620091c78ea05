#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the side force of the bias tire builds up while it rolls, beside the relaxation
length from the slope of the steady force and the lateral stiffness.

The wheel rolls slowly, with Coulomb friction that sticks to the ground: straight, and
with a slip angle; the difference is the response. It takes five minutes:

    python3 doc/tire_model/relaxation.py --program build/biface --scratch runs --output .
"""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, parse_arguments

ANGLE = 0.5          # degrees
LOAD = 1500          # N
TURN, STEPS = 110, 66  # degrees of the wheel
TIRE = "bias_tire_true_pressure.prm"
COMMON = {
    # fine on the part of the tire that rolls over the ground
    "Mesh/Intervals alpha_2": "-180:-20:10:smooth, -20:130:90, 130:180:3:smooth",
    "Formulation": "standard", "Contact/Multiplier mass": "lumped",
    "Contact/Friction": 0.8, "Contact/Critical velocity": 0.002,
    "Contact/Regularization": 100, "Contact/Tangential regularization": 100,
    "Stage 2/Control": "foundation force", "Stage 2/Travel": "unchanged",
    "Stage 2/Force": LOAD, "Stage 2/Steps": 3, "Stage 2/Friction": 0}


def stage(number, entries):
    return {f"Stage {number}/{entry}": value
            for entry, value in {"Contact": True, "Force": LOAD, **entries}.items()}


def steady(runs):
    """Rolling radius, and the slope of the side force over the slip angle, N/rad."""
    entries = {**COMMON, "Number of stages": 5}
    for number, more in ((3, {"Name": "free", "Ground velocity": 1}),
                         (4, {"Name": "left", "Slip angle": ANGLE}),
                         (5, {"Name": "right", "Slip angle": -ANGLE, "Start from": 3})):
        entries |= stage(number, {"Control": "foundation force and axle moment", **more})
    rolling = runs.run("steady", TIRE, entries).rolling()
    force = dict(zip(rolling["stage"], rolling["F_y"]))
    return (rolling.where(stage="free")["rolling_radius"][-1],
            abs(force["right"] - force["left"]) / (2 * math.radians(ANGLE)))


def stiffness(runs):
    """The lateral stiffness of the standing tire, N/mm."""
    results = runs.run("standing", TIRE, {
        **COMMON, "Number of stages": 3,
        **stage(3, {"Glued": True, "Force": 0, "Slide": "0, 0.5, 0"})})
    return results.stiffness().where(motion="slide")["secant"][-1]


def rolling(runs, radius, angle):
    """The way, and the side force along it."""
    way = radius * math.radians(TURN)
    results = runs.run(f"rolling {angle:g}", TIRE, {
        **COMMON, "Number of stages": 3,
        **stage(3, {"Name": "roll", "Control": "foundation force", "Wheel turn": TURN,
                    "Steps": STEPS,
                    "Slide": f"0, {way * math.tan(math.radians(angle))}, {-way}"})})
    force = results.forces().where(body="foundation", stage="roll")["F_y"]
    return way * np.arange(1, len(force) + 1) / STEPS, force


if __name__ == "__main__":
    arguments = parse_arguments("relaxation", __doc__.split("\n", 1)[0])
    runs = Runs(arguments)
    radius, slope = steady(runs)
    lateral = stiffness(runs)
    way, straight = rolling(runs, radius, 0)
    force = rolling(runs, radius, ANGLE)[1] - straight
    end = slope * math.radians(ANGLE)
    print(f"steady {slope:.0f} N/rad, stiffness {lateral:.1f} N/mm: "
          f"{slope / lateral:.0f} mm")
    print(f"after the first {way[0]:.1f} mm, {end * way[0] / force[0]:.0f} mm")
    print(f"63 % of the steady force after {np.interp(end * (1 - math.exp(-1)), force, way):.0f}"
          f" mm")
