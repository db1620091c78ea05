#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write mounted_tire.md and its picture, from runs of prm/mounted_tire.prm."""

import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import (EXAMPLES, Runs, last_step, lines_of,
                          parse_arguments, section, table)

EXAMPLE = "mounted_tire.prm"
MOUNTING_PRESSURE = 0.02

PAGE = """<!-- Written by doc/mounted_tire/mounted_tire.py: cmake --build build --target mounted_tire -->

# A tire on its rim

In [mounted_tire.prm](../prm/mounted_tire.prm) nothing is clamped: the beads of a bias tire
sit on a rim, a [body](theory.md#bodies-beside-the-foundation) with the profile of
[mounted_tire_rim.csv](../prm/mounted_tire_rim.csv), by interference, pressure and friction. The
wires of each bead are a ply of 3 mm with a modulus of 60 000 MPa along the hoop. The tire
is a shell described by its outer face in the mold, whose heel has a radius of 12 mm.

    build/biface prm/mounted_tire.prm

## Inflation

![Section of the tire and the rim: in the mold the beads are short of the flanges; inflated they rest against them; loaded, the sidewall bulges over the flange](figures/mounted_tire.png)

*The section in the plane of the ground's center, in the mold, inflated to 0.2 MPa, and
pressed on the ground by 30 mm; right, one bead.* The pressure slides the beads outward
on the seats of 5 degrees. The seats stretch the wires by tan 5 degrees times the way, and
the beads come to rest against the flanges, already at 0.05 MPa. The heel is the outermost point
of the outer face within 190 mm from the axle. With the coefficient of friction
0.3, as shipped, and without friction:

{inflation}

A press fit has a closed formula: a ring on a cone of 5 degrees, with the interference w, is pushed
on by the force 2π ∫ E t w/R ds tan(5° + arctan μ). The test `model/press_fit` has it within 0.05 %.

## Under load, aside, and braked

The ground, with the coefficient of friction 0.8, is pressed on by 30 mm; then it slides
along the axle by 40 mm, or the rim turns by 10 degrees about the axle. Forces in N on
the tire, the moment about the axle in N m:

{load}

The forces of the rim and the ground do not sum to zero: the pressure in the tire also acts on the rim,
and far from the ground the cells are so wide that the error of the interpolation of rigid motions is
2 to 3 % of the force of the rim.
Both times the ground gives way before the beads do.

## Mounting by two halves

The rim may be two bodies, the halves of a divided rim, that close on the beads: each with half of the
profile, 10 mm farther out at first, so that it does not touch the tire, and with a motion along the axle.
Under {mounting_pressure:g} MPa the halves close and push the beads along the seats; then the tire is inflated. On a sector of 30
degrees whose equator is held in its middle plane, which takes no force, the heel ends at
{halves:.2f} mm and a bead presses on its flange with {pull:.0f} N all around.

## A wheel that finds its place

The rim has motions down, aside and in camber. The wheel is lowered by 10 mm, and then pressed on
the ground, with friction, by a given force of {given:.0f} N, while it may move aside freely
(`Forces on bodies = rim down: {given:.0f}, rim side: 0`) and is turned to a camber angle:

{camber}

*Where the rim is, and its force on the tire in N.* The wheel moves aside to where its side force vanishes.

## How far it goes

Pressed farther, the sidewall rolls over the flange. The run ends at {deepest:.0f} mm and
{largest:.0f} N, {times:.1f} times the force at 30 mm: there the sidewall is folded, with strains
of −0.4, where a linear material has no stiffness left ([limits](limits.md)). The crown does not reach the rim.
"""


def forces(directory, body):
    """F_x, F_y, F_z and the moment about the axle by step."""
    return {int(line["step"]): [float(line[name]) for name in
                                ("F_x", "F_y", "F_z", "M_y")]
            for line in lines_of(directory / "forces.csv")
            if line["body"] == body}


def read_corners(path):
    with open(path, encoding="utf-8") as file:
        rows = [[float(cell) for cell in line.split(",")] for line in file
                if line[0] not in "#a"]
    return [(row[:2], row[2] if len(row) > 2 else 0) for row in rows]


def rounded(corners):
    """Points of a closed polygon with rounded corners."""
    points = [point for point, _ in corners[:-1]]
    result = []
    for i, (corner, radius) in enumerate(corners[:-1]):
        before, after = points[i - 1], points[(i + 1) % len(points)]
        ways = []
        for other in (before, after):
            way = [other[k] - corner[k] for k in (0, 1)]
            ways.append([w / math.hypot(*way) for w in way])
        cosine = -(ways[0][0] * ways[1][0] + ways[0][1] * ways[1][1])
        turn = math.acos(max(-1, min(1, cosine)))
        cut = radius * math.tan(turn / 2)
        middle = [ways[0][k] + ways[1][k] for k in (0, 1)]
        length = math.hypot(*middle)
        if radius == 0:
            result.append(corner)
            continue
        center = [corner[k] + middle[k] / length *
                  math.hypot(radius, cut) for k in (0, 1)]
        first = [corner[k] + cut * ways[0][k] - center[k] for k in (0, 1)]
        last = [corner[k] + cut * ways[1][k] - center[k] for k in (0, 1)]
        for j in range(9):
            arc = [first[k] * (8 - j) + last[k] * j for k in (0, 1)]
            result.append([center[k] + radius * arc[k] / math.hypot(*arc)
                           for k in (0, 1)])
    return result + result[:1]


def draw(directory, picture):
    corners = rounded(read_corners(EXAMPLES / "mounted_tire_rim.csv"))
    mold = [[float(cell) for cell in line.split(",")]
            for line in open(EXAMPLES / "mounted_tire_profile.csv",
                             encoding="utf-8") if line[0] not in "#r"]
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.5),
                                constrained_layout=True)
    shapes = [("inflated", "C0", last_step(directory, "inflation")),
              ("loaded", "C3", last_step(directory, "contact"))]
    for a in axes:
        a.fill(*zip(*corners), color="0.8")
        a.plot([y for _, y in mold], [r for r, _ in mold], color="0.4",
               linestyle=":", label="mold, outer face")
        for label, color, step in shapes:
            for face in ("outer", "inner"):
                a.plot(*section(directory, step, face), color=color,
                       label=label if face == "outer" else None)
        a.set_aspect("equal")
        a.set_xlabel("along the axle [mm]")
    axes[0].set_ylabel("distance from the axle [mm]")
    axes[0].legend(loc="center", fontsize="small")
    axes[1].set_xlim(30, 85)
    axes[1].set_ylim(168, 225)
    axes[0].set_ylim(150, 312)
    figure.savefig(picture, dpi=110)


def heel(directory, step):
    """The largest axial coordinate of the outer face near the rim."""
    return max(y for y, r in zip(*section(directory, step, "outer"))
               if r < 190)


def inflation_rows(directory, label):
    """A row per step: where the heel of a bead is, and the largest contact
    pressure on the rim."""
    rows = []
    for step in range(1, last_step(directory, "inflation") + 1):
        pressure = next(float(line["pressure"])
                        for line in lines_of(directory / "history.csv")
                        if int(line["step"]) == step)
        points = lines_of(directory / f"contact-rim-{step:04d}.csv")
        highest = max(float(p["true_pressure"]) for p in points)
        rows.append([label, f"{pressure:g}",
                     f"{heel(directory, step):.2f}", f"{highest:.2f}"])
    return rows


def main():
    arguments = parse_arguments("mounted_tire", __doc__)
    runs = Runs(arguments)

    aside = runs.run("aside", EXAMPLE, {})
    draw(aside, arguments.output / "figures/mounted_tire.png")
    smooth = runs.run("smooth", EXAMPLE, {
        "Body rim/Friction": 0, "Number of stages": 1})
    braked = runs.run("braked", EXAMPLE, {
        "Stage 3/Name": "braked", "Stage 3/Slide": "0, 0, 0",
        "Stage 3/Load factors": "bodies rim turn: 10", "Stage 3/Steps": 10})
    deep = runs.run("deep", EXAMPLE, {
        "Number of stages": 2, "Stage 2/Travel": 100, "Stage 2/Steps": 20},
        may_stop=True)

    half = "{0}0 155, {0}24 155, {0}32 174.6441 5, {0}63.5 177.4 6.5, " \
        "{0}63.5 195 9.5, {0}80 195 6, {0}80 140, {0}0 140, {0}0 155"
    divided = {}
    for body, sign, opposite in (("left", "-", ""), ("right", "", "-")):
        divided.update({
            f"Body {body}/Shape": "revolved", f"Body {body}/Axis": "0, 1, 0",
            f"Body {body}/Friction": 0.3, f"Body {body}/Profile":
                half.format(sign).replace("-0 ", "0 "),
            f"Body {body}/Point": f"0, {sign}10, 0",
            f"Body {body}/Motions": f"close: 0 {opposite}10 0"})
    halves = runs.run("halves", EXAMPLE, {
        "Bodies": "rim, rim inside, left, right", **divided,
        "Mesh/Intervals alpha_2": "-15:15:1",
        "Mesh/Closed in alpha_2": "false", "Supports/alpha_2 min": "cyclic",
        "Supports/alpha_2 max": "cyclic", "Named points": "crown: end/2 -15",
        "Supports/Point supports":
            "crown: axial middle; circumferential middle",
        "Number of stages": 2, "Stage 1/Name": "mounting",
        "Stage 1/Bodies": "left, right",
        "Stage 1/Pressure": MOUNTING_PRESSURE, "Stage 1/Load factor": 1,
        "Stage 1/Steps": 10, "Stage 2/Name": "inflation",
        "Stage 2/Contact": "false", "Stage 2/Travel": "unchanged",
        "Stage 2/Bodies": "left, right", "Stage 2/Steps": 4})
    given = round(abs(forces(aside, "rim")[last_step(aside, "contact")][0]))
    placed = {"Stage 2/Name": "touch", "Stage 2/Bodies": "rim",
              "Stage 2/Travel": 0, "Stage 2/Steps": 2,
              "Stage 2/Load factors": "bodies rim down: 10",
              "Stage 3/Name": "load", "Stage 3/Bodies": "rim",
              "Stage 3/Travel": 0, "Stage 3/Slide": "unchanged",
              "Stage 3/Forces on bodies": f"rim down: {given}, rim side: 0",
              "Stage 3/Steps": 4}
    camber = []
    for angle in (0, 4):
        directory = runs.run(f"camber_{angle}", EXAMPLE, {
            **placed, "Stage 3/Load factors": f"bodies rim camber: {angle}"})
        place = lines_of(directory / "history.csv")[-1]
        on_tire = forces(directory, "rim")[last_step(directory, "load")]
        camber.append([f"{angle}",
                       *(f"{float(place[f'rim_u_{i}']):.2f}" for i in "xy"),
                       *(f"{abs(round(value, 1)):.1f}" if abs(value) < 0.05
                         else f"{value:.1f}" for value in on_tire[:3])])

    load = []
    for label, directory, step in (
            ("pressed on", aside, last_step(aside, "contact")),
            ("aside by 40 mm", aside, last_step(aside, "aside")),
            ("rim turned by 10°", braked, last_step(braked, "braked"))):
        for body in ("foundation", "rim"):
            *force, moment = forces(directory, body)[step]
            load.append([label, body, *(f"{round(f)}" for f in force),
                         f"{round(moment / 1000)}"])
    reached = [line for line in lines_of(deep / "history.csv")
               if line["stage"] == "contact"][-1]
    at_30 = -forces(aside, "foundation")[last_step(aside, "contact")][0]
    largest = float(reached["force"])
    (arguments.output / "mounted_tire.md").write_text(PAGE.format(
        inflation=table(["Friction", "Pressure, MPa", "Heel at, mm",
                         "Largest contact pressure, MPa"],
                        inflation_rows(aside, "0.3") +
                        inflation_rows(smooth, "0")),
        load=table(["", "Body", "F_x", "F_y", "F_z", "M_y"], load),
        mounting_pressure=MOUNTING_PRESSURE,
        halves=heel(halves, last_step(halves, "inflation")),
        pull=12 * abs(forces(halves, "right")
                      [last_step(halves, "inflation")][1]),
        given=given,
        camber=table(["Camber, degrees", "down, mm", "aside, mm", "F_x", "F_y",
                      "F_z"], camber),
        deepest=float(reached["approach"]), largest=largest,
        times=largest / at_30), encoding="utf-8")


if __name__ == "__main__":
    main()
