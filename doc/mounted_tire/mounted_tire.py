#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write mounted_tire.md and its picture, from runs of prm/mounted_tire.prm."""

import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, Runs, parse_arguments, section, table

EXAMPLE = "mounted_tire.prm"
MOUNTING_PRESSURE = 0.02
# a part of the tire, the same all around; its crown stays in the middle
SECTOR = {"Mesh/Intervals alpha_2": "-5:5:1",
          "Mesh/Closed in alpha_2": "false", "Supports/alpha_2 min": "cyclic",
          "Supports/alpha_2 max": "cyclic",
          "Named points": "crown: end/2 -5, left: 130 -5, right: end-130 -5",
          "Supports/Point supports":
              "crown: axial middle; circumferential middle"}
SECTORS = 36
INFLATION_STEPS = 8
# of the flanges, toward each other, until the beads are free on their seats
UNSEATING_WAY = 12
# friction and pressure of the tires that are pushed off their seats and turned
STATES = ((0.3, 0.2), (0.1, 0.2), (0.3, 0.1), (0.1, 0.1))

PAGE = """<!-- Written by doc/mounted_tire/mounted_tire.py: cmake --build build --target mounted_tire -->

# A tire on its rim

In [mounted_tire.prm](../prm/mounted_tire.prm) nothing is clamped: the beads of a bias tire
sit on a rim, a [body](theory.md#bodies-beside-the-ground) with the profile of
[mounted_tire_rim.csv](../prm/mounted_tire_rim.csv), by interference, pressure and friction. The
wires of each bead are a ply of 3 mm with a modulus of 60 000 MPa along the hoop. The tire
is a shell described by its outer face in the mold, whose heel has a radius of 12 mm.

    build/biface prm/mounted_tire.prm

## Inflation

![Section of the tire and the rim: in the mold the beads are short of the flanges; inflated they rest against them; loaded, the sidewall bulges over the flange](figures/mounted_tire.png)

*The section in the plane of the ground's center, in the mold, inflated to 0.2 MPa, and
pressed on the ground by 30 mm; right, one bead.* The pressure slides the beads outward
on the seats of 5 degrees. The seats stretch the wires by tan 5 degrees times the way, and
the beads come to rest against the flanges. The heel is the outermost point
of the outer face within 190 mm from the axle. With the coefficient of friction
0.3, as shipped, and without friction:

{inflation}

Friction of a node begins at the end of the step in which it comes into contact
([limits](limits.md)), so that the beads slide too easily in the four steps of this file. On a sector of 10 degrees
(the entries are those of `SECTOR` in doc/mounted_tire/mounted_tire.py), with the coefficient of friction 0.3, the heel is at

{steps}

Without friction the steps do not matter. With {inflation_steps} steps or more, friction holds the beads back until
some 0.13 MPa, and carries a part of what would press on the flange. The following two sections have
{inflation_steps} steps.

A press fit has a closed formula: a ring on a cone of 5 degrees, with the interference w, is pushed
on by the force 2π ∫ E t w/R ds tan(5° + arctan μ). The test `model/press_fit` has it within 0.05 %.

## Off the seat

![Contact pressure along the seat; force of a flange over its way; moment over the angle of the rim](figures/mounted_tire_unseated.png)

*Left: true contact pressure on the seat and the flange of a bead at rest. Middle: force of a flange that is
pushed toward the other. Right: moment about the axle while the rim turns.*

What unseats a bead? On the sector the rim consists of three bodies, the seats with the well, and two
flanges. After inflation the flanges, with the same friction, move toward each other, by {unseating_way} mm each, and
push the beads off their seats, all around at the same time. Forces of a flange on the whole bead:

{unseating}

Friction of the seat is N tan(arctan μ − 5°) with the force N normal to it from its contact pressures, of a
rigid ring that is pushed down a cone, at the motion of the maximum. The rest, the force less that, is what
the pressure in the tire exerts on the bead: it is nearly the force once the bead is loose, without interference. With μ = 0.3
there is a maximum, at which the bead breaks loose; the interference, and with it the friction, vanish over the next
3 mm or so. With μ = 0.1, which is hardly above tan 5° = 0.087, there is none: the force of
the pressure alone resists, and grows as the bead goes on. Half the pressure has half of this part.

In the test of standards a block pushes one sidewall toward the other side. With a bar of radius 30 mm across
the tire, 240 mm from the axle, instead of the ground, the whole tire converges up to {bar_force:.0f} N, at which the
heel beside the bar has moved inward by {bar_heel:.1f} mm; there the run ends, also in smaller steps, with softer contact
springs or without friction. If the ground of the run below, pressed on by 30 mm, is glued to the tread (`Glued`) instead and slides
along the axle, the side force grows to {glued_force:.0f} N, at which the heel on the other side has moved inward by {glued_heel:.1f} mm,
and there the run ends. In neither case is the maximum reached.

## Slip on the rim

On the same sector, with the rim as one body, the outer tread is held against a turn on three lines, at the crown
and at the edges of the tread, and the rim turns by 20 degrees. The beads slip at the largest moment, of both all around.
Beside it is μ ∫ p r dA of the contact pressures before the turn and at its end:

{slip}

The estimate from the tire at rest is too small: as the rim turns, friction turns from the meridian to the
circumference and no longer holds the beads back, so that the pressure slides them farther up the seats
and against the flanges. Where they have arrived, the estimate is {slip_low:.1f} to {slip_high:.1f} % too large: contact pressures per true
area are those of the curvature at a node, which is not that of the cells beside it at the ends of the arc of the heel.

A braking moment of the ground, {braked_moment:.0f} N m with the coefficient of friction 0.8 at 30 mm
(below), is far below these.

## Under load, aside, and braked

The ground, with the coefficient of friction 0.8, is pressed on by 30 mm; then it slides
along the axle by 40 mm, or the rim turns by 10 degrees about the axle. Forces in N on
the tire, the moment about the axle in N m:

{load}

The forces of the rim and the ground do not sum to zero: the pressure in the tire also acts on the rim. The
line `loads` of forces.csv, the pressure on the tire alone, has what is missing.
Both times the ground gives way before the beads do.

## Mounting by two halves

The rim may be two bodies, the halves of a divided rim, that close on the beads: each with half of the
profile, 10 mm farther out at first, so that it does not touch the tire, and with a motion along the axle.
Under {mounting_pressure:g} MPa the halves close and push the beads along the seats; then the tire is inflated. On a sector of 10
degrees whose equator is held in its middle plane, which takes no force, the heel ends at
{halves:.2f} mm and a bead presses on its flange with {pull:.0f} N all around.

## A wheel that finds its place

The rim has motions down, aside and in camber. The wheel is lowered by 10 mm, and then pressed on
the ground, with friction, by a given force of {given:.0f} N, while it may move aside freely
(`Forces on bodies = rim down: {given:.0f}, rim side: 0`) and is turned to a camber angle:

{camber}

*Where the rim is, and its force on the tire in N.* The wheel moves aside to where its side force vanishes.

## It rolls

A wheel that rolls steadily feels its rim without friction: the body is the same at any angle of the wheel. The beads, which
stick to a real rim, are held around the axle by supports, and the tire rolls on a tread of bristles, 8 mm of rubber
with E = 1.8 MPa and μ = 0.8, after it has been pressed on by 30 mm:

    build/biface prm/mounted_tire.prm {rolling_options}

{rolling}

*In the axes of the wheel.* Each step takes {rolling_iterations} iterations.

## How far it goes

Pressed farther, the sidewall rolls over the flange. The run ends at {deepest:.0f} mm and
{largest:.0f} N, {times:.1f} times the force at 30 mm: there the sidewall is folded, with strains
of −0.4, where a linear material has no stiffness left ([limits](limits.md)). The crown does not reach the rim.
"""


ROLLING = {
    "Body rim/Friction": 0, "Body rim/Motions": "",
    "Supports/alpha_1 min": "circumferential outer",
    "Supports/alpha_1 max": "circumferential outer",
    "Contact/Multiplier mass": "lumped", "Contact/Rolling friction": "bristles",
    "Contact/Tread/Height": 8, "Contact/Tread/Modulus": 1.8,
    "Number of stages": 4, "Stage 3/Name": "free rolling",
    "Stage 3/Control": "axle moment", "Stage 3/Ground velocity": 10000,
    "Stage 3/Slide": "unchanged", "Stage 3/Steps": 1,
    "Stage 4/Name": "slip angle", "Stage 4/Control": "axle moment",
    "Stage 4/Ground velocity": 10000, "Stage 4/Slip angle": 1,
    "Stage 4/Contact": "true", "Stage 4/Travel": 30,
    "Stage 4/Bodies": "rim, rim inside", "Stage 4/Pressure": 0.2,
    "Stage 4/Steps": 2}


def roll(runs):
    """What the page says of the wheel that rolls."""
    results = runs.run("rolling", EXAMPLE, ROLLING)
    rolling = results.rolling()
    rows = [[f"{line['slip_angle']:g}", f"{line['rolling_radius']:.2f}",
             *(f"{line[name]:.1f}" for name in ("F_x", "F_y", "F_z")),
             f"{line['M_z'] / 1000:.2f}"] for line in rolling.rows()]
    iterations = results.history["iterations"][np.isin(results.steps, rolling["step"])]
    options = [f'--set "{entry}={value}"' for entry, value in ROLLING.items()]
    pairs = (" ".join(options[i:i + 2]) for i in range(0, len(options), 2))
    return {
        "rolling_options": " \\\n      ".join(pairs),
        "rolling": table(["Slip angle, °", "R_e, mm", "F_x, N", "F_y, N",
                          "F_z, N", "M_z, N m"], rows),
        "rolling_iterations": f"{min(iterations):.0f} to {max(iterations):.0f}"}


def ring_integral(points, weight):
    """The integral of the contact pressure times a function of the distance from
    the axle, all around, over the line of nodes alpha_2 = -5 of one bead."""
    line = line_of_bead(points)
    y, r = line["y"], np.hypot(line["x"], line["z"])
    values = line["true_pressure"] * r * weight(r)
    return math.pi * (np.hypot(np.diff(y), np.diff(r))
                      * (values[1:] + values[:-1])).sum()


def line_of_bead(points):
    """The nodes alpha_2 = -5 of one bead."""
    return points.where(points["y"] > 0, alpha_2=-5)


def unseat(runs, friction, pressure, steps=INFLATION_STEPS):
    """The run in which flanges push the beads off their seats."""
    bodies = {"Body seats/Shape": "revolved", "Body seats/Axis": "0, 1, 0",
              "Body seats/Friction": friction, "Body seats/Profile":
                  "-80 178.8435, -32 174.6441 5, -24 155, 24 155, "
                  "32 174.6441 5, 80 178.8435, 80 140, -80 140, -80 178.8435"}
    for body, sign, opposite in (("left", "-", ""), ("right", "", "-")):
        bodies.update({
            f"Body {body}/Shape": "revolved", f"Body {body}/Axis": "0, 1, 0",
            f"Body {body}/Friction": friction, f"Body {body}/Profile":
                "{0}63.5 170, {0}63.5 195 9.5, {0}80 195 6, {0}80 170, "
                "{0}63.5 170".format(sign),
            f"Body {body}/Motions": f"push: 0 {opposite}1 0"})
    present = "seats, left, right"
    return runs.run(f"unseat_{friction}_{pressure}_{steps}", EXAMPLE, {
        **SECTOR, **bodies, "Bodies": f"rim, rim inside, {present}",
        "Number of stages": 2, "Stage 1/Bodies": present,
        "Stage 1/Pressure": pressure, "Stage 1/Load factor": 0,
        "Stage 1/Steps": steps, "Stage 2/Name": "push",
        "Stage 2/Contact": "false", "Stage 2/Travel": "unchanged",
        "Stage 2/Bodies": present, "Stage 2/Pressure": pressure,
        "Stage 2/Load factor": UNSEATING_WAY,
        "Stage 2/Steps": 4 * UNSEATING_WAY})


def unseating_curve(results):
    """Ways of the flange and its forces on the whole bead, by step."""
    ways = dict(zip(results.steps, results.history["load_factor"]))
    return {step: (ways[step], -SECTORS * force[1]) for step, force in
            forces(results, "right").items()
            if step >= results.stage("inflation").step}


def unseating_row(results, friction, pressure):
    curve = unseating_curve(results)
    rest = min(curve)

    def seat(step):
        return ring_integral(results.contact(step, "seats"), lambda r: 1)

    def friction_of_seat(step):
        return seat(step) * math.tan(math.atan(friction) - math.radians(5))

    loose = next(step for step in curve if curve[step][0] >= 7)
    peak = max((step for step in curve if step <= loose),
               key=lambda step: curve[step][1])
    row = [f"{friction:g}", f"{pressure:g}", f"{abs(curve[rest][1]):.0f}",
           f"{seat(rest):.0f}"]
    if peak < loose:
        way, force = curve[peak]
        by_friction = friction_of_seat(peak)
        row += [f"{force:.0f}", f"{way:.2f}", f"{by_friction:.0f}",
                f"{force - by_friction:.0f}"]
    else:
        row += ["none", "", "", ""]
    return row + [f"{curve[loose][1]:.0f}"]


def turn_rim(runs, friction, pressure):
    """The run in which the rim turns, and the moments of both beads by angle."""
    results = runs.run(f"slip_{friction}_{pressure}", EXAMPLE, {
        **SECTOR, "Body rim/Friction": friction,
        "Supports/Point supports": "crown: axial middle; circumferential both, "
            "left: circumferential both, right: circumferential both",
        "Number of stages": 2, "Stage 1/Pressure": pressure,
        "Stage 1/Load factor": 0, "Stage 1/Steps": INFLATION_STEPS,
        "Stage 2/Name": "turn", "Stage 2/Contact": "false",
        "Stage 2/Travel": "unchanged", "Stage 2/Bodies": "rim",
        "Stage 2/Pressure": pressure,
        "Stage 2/Load factors": "bodies rim turn: 20", "Stage 2/Steps": 80})
    rest = results.stage("inflation").step
    return results, {0.25 * (step - rest): SECTORS * force[3] / 1e6
                       for step, force in forces(results, "rim").items()
                       if step >= rest}


def draw_unseated(unseated, turned, picture):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8),
                                constrained_layout=True)
    for i, (state, results) in enumerate(unseated.items()):
        label = f"μ = {state[0]:g}, {state[1]:g} MPa"
        turn, moments = turned[state]
        points = line_of_bead(turn.stage("inflation").contact(body="rim"))
        axes[0].plot(points["alpha_1"].max() - points["alpha_1"],
                     points["true_pressure"],
                     marker=".", color=f"C{i}", label=label)
        axes[1].plot(*zip(*((u, f / 1000) for u, f in
                            unseating_curve(results).values())),
                     color=f"C{i}", label=label)
        axes[2].plot(moments.keys(), moments.values(), color=f"C{i}",
                     label=label)
    for a, x, y in zip(axes, ("from the toe along the outer face [mm]",
                              "way of the flange [mm]",
                              "turn of the rim [degrees]"),
                       ("contact pressure [MPa]", "force on a bead [kN]",
                        "moment [kN m]")):
        a.set_xlabel(x)
        a.set_ylabel(y)
        a.set_ylim(bottom=0)
    axes[1].set_xlim(0, UNSEATING_WAY)
    axes[2].set_xlim(0, 5)
    axes[1].legend(loc="lower right", fontsize="small")
    figure.savefig(picture, dpi=110)


def forces(results, body):
    """F_x, F_y, F_z and the moment about the axle by step."""
    table = results.forces().where(body=body)
    return dict(zip(table["step"].astype(int), np.stack(
        [table[name] for name in ("F_x", "F_y", "F_z", "M_y")], -1)))


def last_force(results, body, stage):
    """The same at the end of a stage."""
    return forces(results.stage(stage), body)[results.stage(stage).step]


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


def draw(results, picture):
    corners = rounded(read_corners(EXAMPLES / "mounted_tire_rim.csv"))
    mold = [[float(cell) for cell in line.split(",")]
            for line in open(EXAMPLES / "mounted_tire_profile.csv",
                             encoding="utf-8") if line[0] not in "#r"]
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.5),
                                constrained_layout=True)
    shapes = [("inflated", "C0", results.stage("inflation").step),
              ("loaded", "C3", results.stage("contact").step)]
    for a in axes:
        a.fill(*zip(*corners), color="0.8")
        a.plot([y for _, y in mold], [r for r, _ in mold], color="0.4",
               linestyle=":", label="mold, outer face")
        for label, color, step in shapes:
            for face in ("outer", "inner"):
                a.plot(*section(results, step, face), color=color,
                       label=label if face == "outer" else None)
        a.set_aspect("equal")
        a.set_xlabel("along the axle [mm]")
    axes[0].set_ylabel("distance from the axle [mm]")
    axes[0].legend(loc="center", fontsize="small")
    axes[1].set_xlim(30, 85)
    axes[1].set_ylim(168, 225)
    axes[0].set_ylim(150, 312)
    figure.savefig(picture, dpi=110)


def heel(results, step=None):
    """The largest axial coordinate of the outer face near the rim."""
    return heels(results, step)[1]


def heels(results, step=None):
    """The extreme axial coordinates of the outer face near the rim."""
    y, r = section(results, step, "outer")
    return y[r < 190].min(), y[r < 190].max()


def inflation_rows(results, label):
    """A row per step: where the heel of a bead is, and the largest contact
    pressure on the rim."""
    return [[label, f"{line['pressure']:g}", f"{heel(results, line['step']):.2f}",
             f"{results.contact(line['step'], 'rim')['true_pressure'].max():.2f}"]
            for line in results.stage("inflation").history.rows()]


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
        "Bodies": "rim, rim inside, left, right", **divided, **SECTOR,
        "Number of stages": 2, "Stage 1/Name": "mounting",
        "Stage 1/Bodies": "left, right",
        "Stage 1/Pressure": MOUNTING_PRESSURE, "Stage 1/Load factor": 1,
        "Stage 1/Steps": 10, "Stage 2/Name": "inflation",
        "Stage 2/Contact": "false", "Stage 2/Travel": "unchanged",
        "Stage 2/Bodies": "left, right", "Stage 2/Steps": 4})
    given = round(abs(last_force(aside, "rim", "contact")[0]))
    placed = {"Stage 2/Name": "touch", "Stage 2/Bodies": "rim",
              "Stage 2/Travel": 0, "Stage 2/Steps": 2,
              "Stage 2/Load factors": "bodies rim down: 10",
              "Stage 3/Name": "load", "Stage 3/Bodies": "rim",
              "Stage 3/Travel": 0, "Stage 3/Slide": "unchanged",
              "Stage 3/Forces on bodies": f"rim down: {given}, rim side: 0",
              "Stage 3/Steps": 4}
    camber = []
    for angle in (0, 4):
        results = runs.run(f"camber_{angle}", EXAMPLE, {
            **placed, "Stage 3/Load factors": f"bodies rim camber: {angle}"})
        on_tire = last_force(results, "rim", "load")
        camber.append([f"{angle}",
                       *(f"{results.last(f'rim_u_{i}'):.2f}" for i in "xy"),
                       *(f"{abs(round(value, 1)):.1f}" if abs(value) < 0.05
                         else f"{value:.1f}" for value in on_tire[:3])])

    bar = runs.run("bar", EXAMPLE, {
        "Bodies": "rim, rim inside, bar", "Body bar/Shape": "cylinder",
        "Body bar/Axis": "0, 0, 1", "Body bar/Radius": 30,
        "Body bar/Point": "240, 107, 0", "Body bar/Motions": "push: 0 -1 0",
        "Number of stages": 2, "Stage 1/Load factor": 0,
        "Stage 2/Name": "push", "Stage 2/Contact": "false",
        "Stage 2/Travel": "unchanged",
        "Stage 2/Bodies": "rim, rim inside, bar",
        "Stage 2/Load factors": "bodies bar push: 40", "Stage 2/Steps": 20},
        may_stop=True)
    glued = runs.run("glued", EXAMPLE, {"Stage 3/Glued": "true"}, may_stop=True)
    unseated = {state: unseat(runs, *state) for state in STATES}
    turned = {state: turn_rim(runs, *state) for state in STATES}
    draw_unseated(unseated, turned,
                  arguments.output / "figures/mounted_tire_unseated.png")
    slip, excesses = [], []
    for (friction, pressure), (results, moments) in turned.items():
        estimates = [2e-6 * friction * ring_integral(
            results.stage(stage).contact(body="rim"), lambda r: r)
            for stage in ("inflation", "turn")]
        at_slip = max(moments.values())
        excesses.append(100 * (estimates[1] / at_slip - 1))
        slip.append([f"{friction:g}", f"{pressure:g}", f"{at_slip:.2f}",
                     *(f"{estimate:.2f}" for estimate in estimates)])
    steps = []
    for number in (4, 8, 40):
        results = unseat(runs, 0.3, 0.2, number)
        steps.append([f"{number}", *(
            f"{heel(results, round(number * part)):.2f}"
            for part in (0.25, 0.5, 0.75, 1))])

    load = []
    for label, results, stage in (("pressed on", aside, "contact"),
                                  ("aside by 40 mm", aside, "aside"),
                                  ("rim turned by 10°", braked, "braked")):
        for body in ("foundation", "rim"):
            *force, moment = last_force(results, body, stage)
            load.append([label, body, *(f"{round(f)}" for f in force),
                         f"{round(moment / 1000)}"])
    reached = deep.stage("contact")
    at_30 = -last_force(aside, "foundation", "contact")[0]
    largest = reached.last("force")
    (arguments.output / "mounted_tire.md").write_text(PAGE.format(
        **roll(runs),
        inflation=table(["Friction", "Pressure, MPa", "Heel at, mm",
                         "Largest contact pressure, MPa"],
                        inflation_rows(aside, "0.3") +
                        inflation_rows(smooth, "0")),
        steps=table(["Steps", *(f"{p:g} MPa" for p in (0.05, 0.1, 0.15, 0.2))],
                    steps),
        inflation_steps=INFLATION_STEPS, unseating_way=UNSEATING_WAY,
        unseating=table(
            ["Friction", "Pressure, MPa", "Flange at rest, N",
             "Normal to the seat at rest, N", "Maximum, N", "at, mm",
             "friction of the seat, N", "the rest, N", "At 7 mm, N"],
            [unseating_row(unseated[state], *state) for state in STATES]),
        slip=table(["Friction", "Pressure, MPa", "Moment at slip, kN m",
                    "From the pressures at rest, kN m", "at the end, kN m"], slip),
        slip_low=min(excesses), slip_high=max(excesses),
        braked_moment=abs(last_force(braked, "rim", "braked")[3]) / 1000,
        bar_force=abs(last_force(bar, "bar", "push")[1]),
        glued_force=last_force(glued, "foundation", "aside")[1],
        glued_heel=max(abs(a - b) for a, b in zip(
            heels(glued.stage("contact")), heels(glued.stage("aside")))),
        bar_heel=heel(bar.stage("inflation")) - heel(bar.stage("push")),
        load=table(["", "Body", "F_x", "F_y", "F_z", "M_y"], load),
        mounting_pressure=MOUNTING_PRESSURE,
        halves=heel(halves.stage("inflation")),
        pull=SECTORS * abs(last_force(halves, "right", "inflation")[1]),
        given=given,
        camber=table(["Camber, degrees", "down, mm", "aside, mm", "F_x", "F_y",
                      "F_z"], camber),
        deepest=reached.last("approach"), largest=largest,
        times=largest / at_30), encoding="utf-8")


if __name__ == "__main__":
    main()
