#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write obstacles.md and its picture, from runs of prm/cleat.prm and
prm/curb_step.prm."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, biface, parse_arguments, table

PAGE = """<!-- Written by doc/obstacles/obstacles.py: cmake --build build --target obstacles -->

# A tire on obstacles

[cleat.prm](../prm/cleat.prm) lets the bias tire, pressed on a plane by 20 mm, pass a bar of
10 mm with a half-round top, slowly and without friction. [curb_step.prm](../prm/curb_step.prm) is a
step of 15 mm. Both obstacles are [bodies](theory.md#bodies-beside-the-ground) on the
ground, and a tread of 8 mm of rubber, springs of 0.3 MPa/mm, lies between them and
the carcass.

    build/biface prm/cleat.prm

## The enveloping curve

![The vertical force has two maxima, where the bar is near the ends of the footprint; the longitudinal force changes its sign between them](figures/cleat.png)

*Vertical and longitudinal force of road and cleat on the tire, the sum of two lines of
forces.csv, over the position of the cleat ahead of the axle.* At a constant height of the axle the
force is largest, {maximum:.0f} N, with the bar {where:.0f} mm ahead of or behind the axle. Below the axle it is {below:.0f} N,
little more than the {plane:.0f} N without a bar, since the bar lifts the middle of the
footprint off the road. The longitudinal force pushes the wheel back from an
obstacle ahead, by up to {back:.0f} N.

Under a constant vertical force of {load:.0f} N, that without a bar, the cleat lifts the axle by its effective
height and pushes the wheel back with its effective slope, the longitudinal over the vertical force. `Control = foundation force` prescribes the force on the ground and the bodies on it.

![The effective height has two maxima before and behind the axle; the effective slope is positive before and negative behind](figures/cleat_at_load.png)

*The axle rises by up to {height:.2f} mm, a quarter of the height of the bar, since the tire envelops it,
and by {height_below:.2f} mm with the bar below it; the slope is up to {slope:.3f}.*

## A stone and measured ground

A formula that is negative in the body gives other shapes, such as a stone of the same height, 40 mm across the road
and 30 mm along it, half in the road; x, y and z are measured from `Point`:

    build/biface prm/cleat.prm --set "Body cleat/Shape=formula" \\
      --set "Body cleat/Formula={formula}" --set "Body cleat/Size=10"

The force is largest, {stone_maximum:.0f} N, with the stone {stone_where:.0f} mm ahead of or behind the axle, and {stone_below:.0f} N
with the stone below the axle. The wheel is pushed back by up to {stone_back:.0f} N.

Ground that has been measured is a height field: `Shape = height field` and, in `Height file`, rows of

    u, v, height
    0, 0, 1.2
    0, 5, 0.8
    5, 0, 1.0
    5, 5, 1.5

With the `Direction` 1, 0, 0 from the axle into the road and the `Axis` 0, 1, 0, u is measured from `Point` along z, v along y,
and the height toward the axle. The tire also touches the plane of the ground, at the height 0, so that
heights are best counted from their lowest point.

## Beside an independent program

Forces in N, vertical and longitudinal, of the [independent
program](bias_tire.md#the-independent-program) in parentheses, on 42 cells along the meridian and 40 and 55 around.
The bar is below the axle and 40 mm behind it.

{bars}

## Edges and nodes

By default only nodes make contact. An edge that is sharper than the cells are long is felt where a node happens to
be. The tread rounds it by its height, and the forces hardly depend on the mesh. A step of 15 mm
with an edge of 2 mm, whose wall is {wall} mm behind the axle, with the tread of 8 mm:

{steps}

`Contact/Points in cells` feel the edge without a tread, too: the same step with the wall 40 mm behind the axle, with
contact of 0.3 MPa/mm at the face of the carcass, at nodes and at 4 × 4 points in each cell. At nodes
the forces depend on where the nodes happen to be and on the way to this place.

{points}

Rigid contact, without a tread, on 42 × 40 cells: a bar of 10 mm that rises from the road 40 and 90 mm behind the axle.
Pushed to the same place along the road, its steep side would take single nodes along, and the
forces would depend on the way.

{rigid}
"""

STONE = "(x/10)^2 + (y/20)^2 + (z/15)^2 - 1"
MESHES = {
    "42 × 40": "-180:-15:11:smooth, -15:15:18, 15:180:11:smooth",
    "42 × 55": "-180:-27.5:11:smooth, -27.5:27.5:33, 27.5:180:11:smooth",
    "42 × 94": "-180:-27.5:14:smooth, -27.5:27.5:66, 27.5:180:14:smooth"}
# the independent program
BARS = {("42 × 40", 0): (1953.2, 0), ("42 × 40", -40): (2066.2, 37.5),
        ("42 × 55", 0): (1924.4, 0), ("42 × 55", -40): (2043.1, 39.6)}
STEPS = {"42 × 40": (2495.7, 240.1), "42 × 55": (2471.0, 254.6)}
RIGID = {-40: (2077.2, 109.4), -90: (2027.7, 256.0)}
# with the tread around it, the wall of the step of the independent program is
# 40 mm behind the axle
WALL = 48


def steps_of(runs, name, example, entries, body="cleat"):
    """Vertical and longitudinal force of each step of the last stage."""
    results = runs.run(name, example, entries)
    forces = results.stage(results.stages[-1]).forces()
    ground, other = forces.where(body="foundation"), forces.where(body=body)
    return list(zip(0 - ground["F_x"] - other["F_x"], ground["F_z"] + other["F_z"]))


def beside(forces, other):
    """Forces, with those of the independent program."""
    return [f"{force + 0:.1f} ({expected:.1f})".replace("-0.0", "0.0")
            for force, expected in zip(forces, other)]


def positions_of(steps):
    """Where the bar is after each step: the first one takes it 5 mm back."""
    if len(steps) != 52:
        raise SystemExit("some steps were cut; the positions are not known")
    return [130 - 5 * (i + 1) for i in range(len(steps))]


def draw(positions, upper, lower, picture):
    """Two curves, each a label and values, the lower one about zero."""
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(6, 5),
                                constrained_layout=True)
    for a, color, (label, values) in zip(axes, ("C0", "C1"), (upper, lower)):
        a.plot(positions, values, color=color)
        a.set_ylabel(label)
        a.grid(alpha=0.3)
    axes[1].axhline(0, color="0.7", linewidth=0.8)
    axes[1].set_xlabel("position of the cleat ahead of the axle [mm]")
    figure.savefig(picture, dpi=110)


def envelope(runs, name, entries, picture=None):
    """The numbers in the words on the enveloping curve; draw it."""
    forces = steps_of(runs, name, "cleat.prm", entries)
    positions = positions_of(forces)
    vertical, longitudinal = zip(*forces)
    if picture:
        draw(positions, ("vertical force [N]", vertical),
             ("longitudinal force [N]", longitudinal), picture)
    top = max(range(len(forces)), key=lambda i: vertical[i])
    return {"maximum": vertical[top], "where": abs(positions[top]),
            "below": vertical[positions.index(0)], "plane": vertical[0],
            "back": -min(longitudinal)}


def envelope_at_load(runs, load, picture):
    """The numbers in the words on the curve at a constant load; draw it."""
    given = {"Control": "foundation force", "Force": load,
             "Travel": "unchanged"}
    name, example = "envelope_at_load", "cleat.prm"
    forces = steps_of(runs, name, example, {
        f"Stage {i}/{entry}": value for i in (2, 3)
        for entry, value in given.items()})
    history = biface.Results(runs.scratch / name).stage("cleat").history
    positions = positions_of(history)
    heights = list(20 - history["approach"])
    slopes = [-longitudinal / vertical for vertical, longitudinal in forces]
    draw(positions, ("effective height [mm]", heights),
         ("effective slope", slopes), picture)
    return {"load": load, "height": max(heights),
            "height_below": heights[positions.index(0)], "slope": max(slopes)}


def main():
    arguments = parse_arguments("obstacles", __doc__)
    runs = Runs(arguments)

    words = envelope(runs, "envelope", {},
                     arguments.output / "figures/cleat.png")
    stone = envelope(runs, "stone", {"Body cleat/Shape": "formula",
                                     "Body cleat/Formula": STONE,
                                     "Body cleat/Size": 10})
    words |= {f"stone_{word}": value for word, value in stone.items()}
    # the first steps are before the cleat
    words |= envelope_at_load(
        runs, words["plane"],
        arguments.output / "figures/cleat_at_load.png")
    bars = []
    for (mesh, z), expected in BARS.items():
        forces = steps_of(runs, f"bar_{len(bars)}", "cleat.prm", {
            "Mesh/Intervals alpha_2": MESHES[mesh],
            "Body cleat/Motions": f"pass: 0 0 {z - 130}",
            "Stage 3/Steps": 16})[-1]
        bars.append([mesh, f"{-z}", *beside(forces, expected)])
    steps = []
    for mesh, expected in STEPS.items():
        forces = steps_of(runs, f"step_{len(steps)}", "curb_step.prm", {
            "Mesh/Intervals alpha_2": MESHES[mesh],
            "Body step/Point": f"1, 0, {-WALL}"}, "step")[-1]
        steps.append([mesh, *beside(forces, expected)])
    points = []
    for mesh, intervals in MESHES.items():
        forces = []
        for k in (0, 4):
            forces += steps_of(runs, f"points_{len(points)}_{k}", "curb_step.prm", {
                "Mesh/Intervals alpha_2": intervals,
                "Contact/Tread/Height": "none",
                "Contact/Tread/Modulus": 0,
                "Contact/Regularization": 0.3,
                "Contact/Points in cells": k}, "step")[-1]
        points.append([mesh, *(f"{force:.1f}" for force in forces)])
    rigid = []
    for z, expected in RIGID.items():
        forces = steps_of(runs, f"rigid_{len(rigid)}", "cleat.prm", {
            "Mesh/Intervals alpha_2": MESHES["42 × 40"],
            "Contact/Tread/Height": "none",
            "Contact/Tread/Modulus": 0,
            "Contact/Regularization": 1e4,
            "Body cleat/Point": f"10.5, 0, {z}",
            "Body cleat/Motions": "rise: -10.5 0 0",
            "Stage 3/Steps": 8})[-1]
        rigid.append([f"{-z}", *beside(forces, expected)])
    both = ["vertical", "longitudinal"]
    (arguments.output / "obstacles.md").write_text(PAGE.format(
        **words, formula=STONE, wall=WALL,
        bars=table(["Cells", "Behind the axle, mm", *both], bars),
        steps=table(["Cells", *both], steps),
        points=table(["Cells", "nodes: vertical", "longitudinal",
                      "points: vertical", "longitudinal"], points),
        rigid=table(["Behind the axle, mm", *both], rigid)), encoding="utf-8")


if __name__ == "__main__":
    main()
