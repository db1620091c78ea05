#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write seals_and_saddles.md and its pictures, from runs of
prm/inflatable_seal.prm, prm/saddle_tank.prm and prm/band_brake.prm."""

import math
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, parse_arguments, section, table

PAGE = """<!-- Written by doc/seals_and_saddles/seals_and_saddles.py: cmake --build build --target seals_and_saddles -->

# Seals, saddles and straps

Three shells between or on rigid [bodies](theory.md#bodies-beside-the-ground), beside formulas:
[inflatable_seal.prm](../prm/inflatable_seal.prm), a hose that closes the gap of a door,
[saddle_tank.prm](../prm/saddle_tank.prm), a tank full of water on saddles, and
[band_brake.prm](../prm/band_brake.prm), a strap around a drum. Each takes a few seconds.

    build/biface prm/inflatable_seal.prm
    build/biface prm/saddle_tank.prm
    build/biface prm/band_brake.prm

## An inflatable seal

A flat straight hose of rubber, with cords along its section, is held at its foot on the seat of a door. The
pressure makes it round, and it closes the gap of 6 mm between itself and the door.

![Sections of the flat and of the inflated hose between seat and door; contact pressure over gas pressure across the door, about 1 and higher near the edges of the zone at low pressure; the drag grows in proportion to the slide and then is constant](figures/inflatable_seal.png)

*Left, sections; middle, the contact pressure on the door, per deformed area, over that of the gas, without
friction; right, the drag per length of the hose.*

A membrane whose section has the length L, the foot included, forms two half-circles between walls at the
distance g of its middle line. It lies flat on the door along b = (L - πg)/2, where the contact pressure
is that of the gas, p, so that the force per length is p b. L follows from the cords, which stretch by up to {stretch:.1f} %. Without friction, on {fine} cells along the section; the width is that
between the outermost nodes in contact, which are 0.25 mm apart:

{pressures}

The force is p times the width within {width_low:.0f} % at 0.1 MPa, and at 0.4 and 0.5 MPa within {width_high:.1f} %, less than the distance of two nodes. At low pressure the
bending of the wall, which is free of stress where it is flat, adds to the contact pressure near the edges
of the zone and makes the zone narrower than that of the membrane. In the middle the pressure is that of the gas
within {middle_high:.1f} %, and {middle_low:.1f} % at 0.5 MPa. On {coarse} cells the force at 0.5 MPa differs by {coarse_error:+.2f} %. At other gaps, at 0.5 MPa:

{gaps}

Once b is less than the foot is wide, 10 mm, the lower side is not flat, and the formula does not hold. Without
friction the hose may sway: nothing but the bending of its wall resists as long as both sides of the foot lie
flat. Here its sides end {left:.1f} and {right:.1f} mm from the middle.

### The door slides

With friction on seat and door, the door then slides along the hose by 21 mm. The hose goes along until it slips everywhere, and the drag is Coulomb's law:

{drags}

The friction is that in the plane of the door, from F_x and F_z in forces.csv, F the normal force. Almost all of it points along the hose in the end;
the part across is left from the inflation, in which the wall slid outward. Friction on the outer face also bends the wall: with μ = 0.2 the
pressure in the middle of the zone is {middle_friction:.3f} p before the slide, and the force that of no friction within {force_friction:.1f} %.

## A tank on saddles

A bay of a long steel tank of 1 m radius with a wall of 10 mm, 8 m between saddles that embrace it by 120
degrees. A pad of plastic, a ply that covers only a part of the length, lies between
the tank and the saddle, which is infinitely long, as all extruded bodies are: the pad is what makes it 300 mm wide.

### A ring

A slice of the tank in plane strain has solutions to compare with. Zick's coefficient is that of a ring which is
clamped at the horns, β from the top, and carries the weight Q by shear flows Q sin φ/(π r). With s = sin β/β, c = cos β and d = s² - 1/2 - sin 2β/(4β) the
moment at the horn is K Q r,

```math
K = \\frac{{\\tfrac34 c s^2 - \\tfrac54 s c^2 + \\tfrac12 c^3 - \\tfrac14 s + \\tfrac14 c - \\beta \\sin\\beta\\, d}}{{2\\pi d}} ,
```

{zick:.5f} for 120 degrees (L. P. Zick, Stresses in large horizontal cylindrical pressure vessels on two saddle
supports, Welding Journal Research Supplement, September 1951; derived again for this page from the equations of the
inextensible arch). On a bed that can only push, a ring full of water lifts off behind the horn. The
script solves such a ring, of {elements} beams, whose nodes are in contact or not, in moments over Q r:

{rings}

![Bending moment around the ring, that of the clamped ring from the horn on and that of the ring on a bed, which is zero at the bottom; the points of biface lie on it; hoop stress along the line of the horn, largest at the edge of the saddle and twice the value of Zick's formula](figures/saddle_tank.png)

*Left, the bending moment around the ring over Q r: lines are beams, points are biface. Right, the
hoop stress of both faces of the steel along the horn of the tank; dashed, Zick's formula.*

### The tank

The saddle carries {force:.1f} N of a quarter of the bay, and so much water pushes down: the difference
is {balance:.0e} of it. The water in the round tank weighs {weight:.1f} N; the flat cells lack {lack:.3f} %. The hoop stresses
at the horn, in MPa, in the middle of the saddle and where they are largest, near its edge. Zick spreads the moment over a width of 4 r, so that in the form of
the handbooks the stress is

```math
-\\frac{{Q}}{{4\\,t\\,(b + 1.56\\sqrt{{r t}})}} \\mp \\frac{{3\\,K\\,Q}}{{2\\,t^2}}
```

with the width b of the saddle.

{tanks}

The bending stress at a rigid horn is about twice that of Zick's formula in the middle of the saddle, and still larger near its edge:
the width of 4 r is an agreement, not a solution, and real saddles and pads give way. A gas pressure rounds the tank
and relieves the horn, which only nonlinear theory sees. On cells half as long the outer stress changes by {mesh_change:.1f} % in the
middle of the saddle and by {edge_change:.1f} % where it is largest. The contact pressure at the end of the horn, {peak:.0f} MPa
as shipped, is that of a corner and grows as the cells become smaller.

### What it takes

- The tank is held by contact alone. The bed starts 0.01 mm too high, so that some nodes touch it; with a bed that just
  touches, the first iteration has no contact, and the tank falls.
- A ring in a bed of its own radius rests on all nodes at first, and they let go one after the other:
  the ring above, on cells of 0.1 degrees at the horn, takes {iterations} iterations, more than the 25 that
  `Newton/Maximum iterations` allows; the script sets 200.

## A strap around a drum

A steel strap lies around a drum. One end is held, at the other a force of 1 N per mm of width pulls. The drum
turns and drags the strap toward the held end, and then, turning back, away from it. Of a strap without bending stiffness, whose
friction acts at its middle line, the tensions have Euler's ratio exp(μθ). At the faces of a strap of
the thickness h on a drum of the radius R it is exp(kθ) with k = μ/(1 + h/(2R)), up to terms of μ² h/R:
the normal pressure is T/R per area of the face, and so the friction μT/R, whose arm about the axis is R, while that of T is R + h/2.

{straps}

These are the deviations from exp(kθ) of the ratio when the drum turns back, on cells of 4 and of 2 degrees; the ratio when it turns
is the reciprocal within {reciprocal:.0e}. A polygon has the ratio (1 + μ tan(Δ/2))/(1 - μ tan(Δ/2)) per
corner of the angle Δ, so that the error of the mesh decreases with the square of Δ. A thick strap, on cells of 2 degrees, half around, with μ = 0.3:

{thick}

The moment of the drum in forces.csv is the difference of the tensions times R + h/2, within {moment:.0e}.

![Tension along the strap: it changes from a constant one to an exponential from the held end on; when the drum turns back, slip begins there again and the slope reverses](figures/band_brake.png)

*The tension along the strap, from the contact pressure, as the drum turns by 0.004 degrees (blue) and back by twice as
much (red). Slip begins at the held end and spreads; dashed, Euler's slopes.*

### What it takes

With a `Contact/Tangential regularization` of 100 MPa/mm a node sticks within a hundredth of the strap's stretch, and
{strap_steps} steps take {strap_iterations} iterations. When all slips, the tensions do not depend on it: with `automatic`, 45 MPa/mm, with 10 and
with 1000 MPa/mm the ratio differs by less than {regularization:.0e}.
"""

# of the seal
RADIUS_OF_SEAL, WALL, FOOT = 30000, 1.2, 10
SECTOR = math.radians(0.002) * RADIUS_OF_SEAL
SEAL_CELLS = (172, 344)


def section_of(points):
    """Both coordinates of a line of points as arrays, and its length."""
    a, r = (np.array(values) for values in points)
    return a, r, float(np.hypot(np.diff(a), np.diff(r)).sum())


class SealStep:
    """A step of the seal: line force, pressure, width and pressure of the
    contact on the door, and the length of the cords."""

    def __init__(self, results, step):
        self.pressure = results.history.where(step=step)["pressure"][0]
        self.force = -results.forces().where(step=step, body="door")["F_y"][0]
        self.line_force = self.force / SECTOR
        nodes = results.contact(step, "door").where(alpha_2=0, active=1)
        self.places = np.hypot(nodes["x"], nodes["z"]) - RADIUS_OF_SEAL
        self.pressures = nodes["true_pressure"] / self.pressure
        self.width = max(self.places) - min(self.places)
        self.middle = self.pressures[len(nodes) // 2]
        _, _, self.length = section_of(section(results, step, "carcass"))


def step_at(results, pressure):
    near = np.isclose(results.history["pressure"], pressure, rtol=1e-6, atol=0)
    if not near.any():
        raise SystemExit(f"no step of {results.directory} is at {pressure} MPa")
    return results.steps[near.argmax()]


def seal_at(results, pressure):
    return SealStep(results, step_at(results, pressure))


def membrane_width(seal, gap):
    return (seal.length + FOOT - math.pi * (gap - WALL)) / 2


def draw_seal(free, shipped, picture):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6),
                                constrained_layout=True)
    for pressure, color in ((0.01, "0.6"), (0.05, "C0"), (0.5, "C3")):
        step = step_at(free, pressure)
        for face in ("outer", "inner"):
            y, r = section(free, step, face)
            axes[0].plot(r - RADIUS_OF_SEAL, y, color=color, linewidth=1, label=(
                f"{pressure:g} MPa" if face == "outer" else None))
    for low, high in ((-3, 0), (20, 23)):
        axes[0].axhspan(low, high, color="0.85")
    axes[0].text(-19.5, 20.8, "door")
    axes[0].text(-19.5, -2.2, "seat")
    axes[0].set_aspect("equal")
    axes[0].set_xlabel("distance from the middle [mm]")
    axes[0].set_ylabel("height [mm]")
    axes[0].legend(fontsize="small", loc="center")
    for pressure, color in ((0.1, "C0"), (0.3, "C2"), (0.5, "C3")):
        seal = seal_at(free, pressure)
        axes[1].plot(seal.places, seal.pressures, color=color,
                     label=f"{pressure:g} MPa")
    axes[1].axhline(1, color="0.6", linewidth=0.8)
    axes[1].set_ylim(0, None)
    axes[1].set_xlabel("distance from the middle [mm]")
    axes[1].set_ylabel("contact pressure / gas pressure")
    axes[1].legend(fontsize="small")
    for friction, results in shipped.items():
        slide = results.stage("slide")
        along = np.radians(slide.history["door_turn_y"]) * RADIUS_OF_SEAL
        drag = slide.forces().where(body="door")["F_z"] / SECTOR
        axes[2].plot(np.abs(np.append(0, along)), np.abs(np.append(0, drag)),
                     marker=".",
                     label=f"μ = {friction:g}")
    axes[2].set_xlabel("slide of the door [mm]")
    axes[2].set_ylabel("drag along the hose [N/mm]")
    axes[2].grid(alpha=0.3)
    axes[2].legend(fontsize="small", loc="lower right")
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def seal_words(runs, picture):
    free = {"Body seat/Friction": 0, "Body door/Friction": 0,
            "Number of stages": 1}
    cells = {n: runs.run(f"seal_{n}", "inflatable_seal.prm", {
        **free, "Mesh/Intervals alpha_1": f"0:end:{n}"}) for n in SEAL_CELLS}
    coarse, fine = (cells[n] for n in SEAL_CELLS)
    last = SealStep(fine, fine.stage("inflation").step)
    rows, ratios, middles = [], [], []
    for pressure in (0.1, 0.2, 0.3, 0.4, 0.5):
        seal = seal_at(fine, pressure)
        ratios.append(seal.line_force / (pressure * seal.width) - 1)
        middles.append(seal.middle - 1)
        rows.append([f"{pressure:g}", f"{seal.line_force:.3f}",
                     f"{seal.width:.2f}",
                     f"{pressure * seal.width:.3f}",
                     f"{membrane_width(seal, 20):.2f}",
                     f"{seal.middle:.3f}", f"{max(seal.pressures):.2f}"])
    gaps = []
    for height in (17, 20, 23):
        results = runs.run(f"seal_gap_{height}", "inflatable_seal.prm", {
            **free, "Body door/Point": f"0, {height}, 0"})
        seal = SealStep(results, results.stage("inflation").step)
        formula = membrane_width(seal, height)
        equivalent = seal.line_force / seal.pressure
        gaps.append([f"{height - 14}", f"{seal.line_force:.3f}",
                     f"{equivalent:.2f}", f"{formula:.2f}",
                     f"{100 * (equivalent / formula - 1):+.1f} %"])
    shipped, drags = {}, []
    for friction in (0.1, 0.2, 0.3):
        results = runs.run(f"seal_drag_{friction}", "inflatable_seal.prm", {
            "Body seat/Friction": friction, "Body door/Friction": friction})
        shipped[friction] = results
        force = results.forces().where(body="door").row(-1)
        normal = -force["F_y"]
        tangential = math.hypot(force["F_x"], force["F_z"])
        slipping = (f"{results.last('door_slipping_nodes'):.0f} of "
                    f"{results.last('door_contact_nodes'):.0f}")
        drags.append([f"{friction:g}",
                      f"{normal / SECTOR:.3f}", slipping,
                      f"{tangential / (friction * normal):.6f}",
                      f"{abs(force['F_z']) / (friction * normal):.6f}"])
    draw_seal(fine, shipped, picture)
    stretch = last.length / 82.2 - 1
    _, sides = section(fine, fine.stage("inflation").step, "outer")
    rough = SealStep(shipped[0.2], shipped[0.2].stage("inflation").step)
    return {
        "left": RADIUS_OF_SEAL - min(sides),
        "right": max(sides) - RADIUS_OF_SEAL,
        "middle_friction": rough.middle,
        "force_friction": 100 * abs(rough.force / last.force - 1),
        "stretch": 100 * stretch, "fine": SEAL_CELLS[1],
        "coarse": SEAL_CELLS[0],
        "width_low": 100 * abs(ratios[0]), "width_high": 100 * max(map(abs, ratios[-2:])),
        "middle_low": 100 * abs(middles[-1]),
        "middle_high": 100 * max(map(abs, middles)),
        "coarse_error": 100 * (seal_at(coarse, 0.5).force
                               / seal_at(fine, 0.5).force - 1),
        "pressures": table(
            ["Pressure, MPa", "Line force, N/mm", "Width, mm",
             "p times width, N/mm", "b of the membrane, mm",
             "Pressure in the middle / p", "Largest pressure / p"], rows),
        "gaps": table(["Gap, mm", "Line force, N/mm", "Line force / p, mm",
                       "b of the membrane, mm", "Deviation"], gaps),
        "drags": table(["μ", "Line force, N/mm", "Slipping nodes",
                        "Friction / (μ F)", "Drag along the hose / (μ F)"],
                       drags)}


# of the tank
RADIUS, THICKNESS, PAD, WIDTH, HALF_BAY = 1000, 10, 5, 300, 4000
WEIGHT = 9.81e-6
MIDDLE = RADIUS + THICKNESS / 2
SLICE = WEIGHT * math.pi * RADIUS**2  # N per mm
STEEL = (210000, 0.3)


def zick_moment(saddle):
    """The moment at the horns of a clamped ring over Q r, by Zick."""
    beta = math.pi - math.radians(saddle) / 2
    s, c = math.sin(beta) / beta, math.cos(beta)
    d = s * s - 0.5 - math.sin(2 * beta) / (4 * beta)
    return (0.75 * c * s**2 - 1.25 * s * c**2 + c**3 / 2 - s / 4 + c / 4
            - beta * math.sin(beta) * d) / (2 * math.pi * d)


def bed(radius, saddle):
    """The profile of a saddle with rounded horns."""
    half, beyond = math.radians(saddle) / 2, 40
    across = radius * math.sin(half) + beyond * math.cos(half)
    height = -radius * math.cos(half) + beyond * math.sin(half)
    return (f"-1500 {height:.4f}, {-across:.4f} {height:.4f} 50, "
            f"0 {-radius / math.cos(half):.4f} {radius}, "
            f"{across:.4f} {height:.4f} 50, 1500 {height:.4f}")


def ring_of_beams(angles, saddle=None):
    """Bending moments over Q r of a half ring at the angles from the bottom,
    in degrees: full of water on a bed or, without one, clamped at the first
    angle under Zick's shear flows."""
    a, n = np.radians(angles), len(angles)
    modulus, poisson = STEEL
    bending = modulus * THICKNESS**3 / 12 / (1 - poisson**2)
    stretching = modulus * THICKNESS / (1 - poisson**2)
    x = MIDDLE * np.stack([np.cos(a), np.sin(a)], 1)
    matrix, load, elements = np.zeros((3 * n, 3 * n)), np.zeros(3 * n), []
    for e in range(n - 1):
        way = x[e + 1] - x[e]
        length = np.hypot(*way)
        c, s = way / length
        k, b = stretching / length, bending / length**3
        local = np.array([
            [k, 0, 0, -k, 0, 0],
            [0, 12 * b, 6 * b * length, 0, -12 * b, 6 * b * length],
            [0, 6 * b * length, 4 * b * length**2, 0, -6 * b * length,
             2 * b * length**2],
            [-k, 0, 0, k, 0, 0],
            [0, -12 * b, -6 * b * length, 0, 12 * b, -6 * b * length],
            [0, 6 * b * length, 2 * b * length**2, 0, -6 * b * length,
             4 * b * length**2]])
        turn = np.kron(np.eye(2), [[c, s, 0], [-s, c, 0], [0, 0, 1]])
        part = slice(3 * e, 3 * e + 6)
        matrix[part, part] += turn.T @ local @ turn
        elements.append((local @ turn, part))
        middle = (a[e] + a[e + 1]) / 2
        if saddle:  # pressure on the inner face
            force = (WEIGHT * RADIUS * (1 + math.cos(middle)) * RADIUS *
                     np.array([math.cos(middle), math.sin(middle)]))
        else:
            force = (SLICE / math.pi * math.sin(middle) *
                     np.array([math.sin(middle), -math.cos(middle)]))
        for node in (e, e + 1):
            load[3 * node:3 * node + 2] += force * (a[e + 1] - a[e]) / 2
    held = [3 * n - 2, 3 * n - 1, 1, 2] + ([] if saddle else [0])
    free = np.setdiff1d(np.arange(3 * n), held)
    solution = np.zeros(3 * n)
    if not saddle:
        solution[free] = np.linalg.solve(matrix[np.ix_(free, free)],
                                         load[free])
    else:
        # clearance of the outer face from the arc and, beyond the horn, from
        # its tangent
        horn = math.radians(saddle / 2)
        near = a < horn + 0.03
        at = np.minimum(a[near], horn)
        gap = (MIDDLE + THICKNESS / 2) * (1 - np.cos(a[near] - at))
        rows = np.zeros((len(at), 3 * n))
        for j, angle in enumerate(at):
            rows[j, 3 * j:3 * j + 3] = (
                -math.cos(angle), -math.sin(angle),
                THICKNESS / 2 * math.sin(a[j] - angle))
        rows = rows[:, free]
        active = a[near] <= horn
        while True:
            c = rows[active]
            zero = np.zeros((len(c), len(c)))
            result = np.linalg.solve(
                np.block([[matrix[np.ix_(free, free)], -c.T], [c, zero]]),
                np.concatenate([load[free], -gap[active]]))
            solution[free] = result[:len(free)]
            changed = gap + rows @ solution[free] < -1e-12
            changed[active] = result[len(free):] > 0
            if (changed == active).all():
                break
            active = changed
    moments = np.zeros(n)
    for e, (stiffness, part) in enumerate(elements):
        ends = stiffness @ solution[part]
        moments[e], moments[e + 1] = -ends[2], ends[5]
    return moments / (SLICE * MIDDLE)


def hoop_stresses(results):
    """Of both faces of the steel at the named points."""
    stresses = {}
    for line in results.plies().where(ply=1).rows():
        stresses.setdefault(line["name"], []).append(line["s_22"])
    return stresses


def points_at(places):
    return ", ".join(f"a{i} {j}: {alpha_1:g} {alpha_2:g}"
                     for i, alpha_1, j, alpha_2 in places)


SLOWLY = {"Newton/Maximum iterations": 200}
RING_MESH = "0:50:100, 50:56:24, 56:64:80, 64:70:24, 70:180:220"
RING = {"Surface/Straight line/End": "1000, 1",
        "Mesh/Intervals alpha_1": "0:1:1",
        "Laminate/Plies": "steel: 10 @ 0", "Output/Points per ply": 2,
        "Contact/Regularization": "automatic", **SLOWLY}


def moments_of(results):
    """Bending moments over Q r at the named points."""
    return {name: (outer - inner) * THICKNESS**2 / 12 / (SLICE * MIDDLE)
            for name, (inner, outer) in hoop_stresses(results).items()}


def ring_words(runs, axis):
    angles = np.concatenate([
        np.arange(0, 50, 0.5), np.arange(50, 56, 0.25),
        np.arange(56, 64, 0.1), np.arange(64, 70, 0.25),
        np.arange(70, 180.1, 0.5)])
    beams = ring_of_beams(angles, 120)
    clamped_angles = np.linspace(60, 180, 481)
    clamped = ring_of_beams(clamped_angles)
    axis.plot(clamped_angles, clamped, color="0.6", label="clamped at the horn")
    axis.plot(angles, beams, color="C0", label="on a bed")
    axis.axhline(0, color="0.8", linewidth=0.8)

    places = [0, 10, 20, 30, 40, 50, 55, 58, 60, 60.2, 60.4, 60.6, 62, 65, 70,
              80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180]
    named = ", ".join(f"p{i}: 0 {angle:g}" for i, angle in enumerate(places))
    on_bed = runs.run("ring", "saddle_tank.prm", {
        **RING, "Mesh/Intervals alpha_2": RING_MESH, "Named points": named,
        "Body saddle/Profile": bed(RADIUS + THICKNESS, 120)})
    computed = moments_of(on_bed)
    values = [computed[f"p{i}"] for i in range(len(places))]
    axis.plot(places, values, "k.", markersize=5, label="biface")

    flow = SLICE / math.pi / MIDDLE**2 / 2
    held = runs.run("ring_held", "saddle_tank.prm", {
        **RING, "Mesh/Intervals alpha_2": "60:64:80, 64:70:48, 70:180:440",
        "Supports/alpha_2 min": "fixed", "Stage 1/Bodies": "",
        "Stage 1/Pressure": 0, "Stage 1/Load factor": 1,
        # per area of the faces, whose radii differ
        "Loads/Inner traction": f"0; {-flow}*z*{MIDDLE**2 / RADIUS / (MIDDLE - THICKNESS / 2)}; 0; local",
        "Loads/Outer traction": f"0; {-flow}*z*{MIDDLE**2 / RADIUS / (MIDDLE + THICKNESS / 2)}; 0; local",
        "Named points": "horn: 0 60, top: 0 180"})
    computed_held = moments_of(held)

    top_beams, horn_beams = beams[-1], beams.min()
    horn, top = min(values), values[-1]
    rows = []
    for label, expected, value in (
            ("clamped, at the horn", zick_moment(120), -computed_held["horn"]),
            ("clamped, at the top", -clamped[-1], -computed_held["top"]),
            ("on a bed, largest", -horn_beams, -horn),
            ("on a bed, at the top", -top_beams, -top)):
        rows.append([label, f"{expected:.5f}", f"{value:.5f}",
                     f"{100 * (value / expected - 1):+.2f} %"])
    return {"zick": zick_moment(120), "elements": len(angles) - 1,
            "iterations": f"{on_bed.last('iterations'):.0f}",
            "rings": table(["Moment over Q r", "Formula or beams", "biface",
                            "Deviation"], rows)}


def zick_stresses(saddle):
    load = SLICE * 2 * HALF_BAY
    membrane = -load / (4 * THICKNESS * (
        WIDTH + 1.56 * math.sqrt(MIDDLE * THICKNESS)))
    bending = 1.5 * zick_moment(saddle) * load / THICKNESS**2
    return membrane + bending, membrane - bending


TANK_MESH_1 = "0:150:{}, 150:300:{}, 300:1000:{}, 1000:4000:{}"
NONLINEAR = {"Stage 1/Strain theory": "nonlinear", "Stage 1/Steps": 4}


def tank_words(runs, axis):
    def tank(name, horn, entries):
        """Stresses along the horn: the largest of some lines beside it."""
        distances = (0, 30, 60, 90, 120, 135, 150, 165, 180, 210, 240, 300,
                     400, 600, 800, 1000)
        beside = (-0.625, 0, 0.625, 1.25)
        points = points_at((i, alpha_1, j, horn + offset)
                           for i, alpha_1 in enumerate(distances)
                           for j, offset in enumerate(beside))
        results = runs.run(name, "saddle_tank.prm", {
            **entries, **SLOWLY, "Named points": points,
            "Output/Points per ply": 2})
        stresses = hoop_stresses(results)
        at = {}
        for i, alpha_1 in enumerate(distances):
            both = [stresses[f"a{i} {j}"] for j in range(len(beside))]
            at[alpha_1] = (max(b[0] for b in both), min(b[1] for b in both))
        return results, at

    fine = {"Mesh/Intervals alpha_1": TANK_MESH_1.format(20, 20, 28, 30),
            "Mesh/Intervals alpha_2": "0:50:80, 50:70:64, 70:180:88"}
    gas = {"Loads/Pressure distribution": "1 + x/1000 + 0.1/0.00981"}
    wide = {"Body saddle/Profile": bed(RADIUS + THICKNESS + PAD, 150),
            "Mesh/Intervals alpha_2": "0:65:52, 65:85:32, 85:180:38"}
    rows, at_middle, worst = [], {}, {}
    for name, label, saddle, entries in (
            ("tank", "as shipped", 120, {}),
            ("tank_fine", "cells half as long", 120, fine),
            ("tank_nonlinear", "nonlinear", 120, NONLINEAR),
            ("tank_gas", "nonlinear, 0.1 MPa of gas", 120,
             {**NONLINEAR, **gas}),
            ("tank_150", "saddle of 150°", 150, wide)):
        results, at = tank(name, saddle / 2, entries)
        at_middle[name] = at[0]
        inner, outer = zick_stresses(saddle)
        worst[name] = min(both[1] for both in at.values())
        rows.append([label, *(f"{stress:.0f}" for stress in at[0]),
                     f"{max(both[0] for both in at.values()):.0f}",
                     f"{worst[name]:.0f}", f"{inner:.0f}", f"{outer:.0f}"])
        if name == "tank":
            shipped, along = results, at
    for face, color in ((0, "C3"), (1, "C0")):
        axis.plot(list(along), [both[face] for both in along.values()],
                  color=color, marker=".",
                  label=("inner face", "outer face")[face])
        axis.axhline(zick_stresses(120)[face], color=color, linestyle="--",
                     linewidth=0.9)
    axis.axvspan(0, WIDTH / 2, color="0.9")
    axis.text(WIDTH / 4, -20, "saddle", ha="center")

    forces = {line["body"]: line["F_x"] for line in shipped.forces().rows()}
    weight = SLICE * HALF_BAY / 2
    return {
        "force": -forces["saddle"], "weight": weight,
        "balance": abs(forces["saddle"] / forces["loads"] + 1),
        "lack": 100 * (1 - forces["loads"] / weight),
        "peak": shipped.last("saddle_max_pressure"),
        "mesh_change": 100 * abs(at_middle["tank_fine"][1]
                                 / at_middle["tank"][1] - 1),
        "edge_change": 100 * abs(worst["tank_fine"] / worst["tank"] - 1),
        "tanks": table(["", "Middle, inner", "Middle, outer", "Largest, inner",
                        "Largest, outer", "Zick, inner", "Zick, outer"], rows)}


def saddle_words(runs, picture):
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8),
                                constrained_layout=True)
    words = ring_words(runs, axes[0])
    axes[0].set_xlabel("angle from the bottom [degrees]")
    axes[0].set_ylabel("bending moment / (Q r)")
    axes[0].grid(alpha=0.3)
    axes[0].legend(fontsize="small")
    words |= tank_words(runs, axes[1])
    axes[1].set_xlabel("distance from the middle of the saddle [mm]")
    axes[1].set_ylabel("hoop stress at the horn [MPa]")
    axes[1].grid(alpha=0.3)
    axes[1].legend(fontsize="small")
    figure.savefig(picture, dpi=110)
    plt.close(figure)
    return words


# of the strap
DRUM, STRAP = 100, 0.2


def held_tensions(results):
    """The tension at the held end after the turn and after the turn back."""
    held = (results.stage(stage).forces().where(body="alpha_2 min").row(-1)
            for stage in ("turn", "turn back"))
    return [math.hypot(force["F_x"], force["F_z"]) for force in held]


def draw_strap(results, friction, picture):
    figure, axis = plt.subplots(figsize=(6.5, 4), constrained_layout=True)
    for stage, color, parts in (("turn", "C0", (0.1, 0.2, 0.3, 1)),
                                ("turn back", "C3", (0.05, 0.15, 0.25, 0.35, 1))):
        steps = results.stage(stage).steps
        for i, part in enumerate(parts):
            step = steps[round(part * len(steps)) - 1]
            nodes = results.contact(step, "drum").where(alpha_1=0, active=1)
            axis.semilogy(
                nodes["alpha_2"][1:-1], nodes["pressure"][1:-1] * (DRUM + STRAP / 2),
                color=color, alpha=0.35 + 0.65 * (i + 1) / len(parts),
                linewidth=1.2, label=stage if part == 1 else None)
    angles = np.array([0, 180])
    for sign in (-1, 1):
        axis.semilogy(angles, np.exp(sign * friction
                                     * np.radians(180 - angles)),
                      "k--", linewidth=0.8)
    axis.set_xlabel("angle from the held end [degrees]")
    axis.set_ylabel("tension [N/mm]")
    ticks = (0.4, 0.6, 1, 1.5, 2, 2.5)
    axis.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axis.minorticks_off()
    axis.grid(alpha=0.3)
    axis.legend(fontsize="small")
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def strap_words(runs, picture):
    rows, reciprocal = [], 0
    for wrap in (90, 180, 270):
        for friction in (0.1, 0.3, 0.5):
            ratio = math.exp(friction * math.radians(wrap)
                             / (1 + STRAP / 2 / DRUM))
            cells = []
            for angle in (4, 2):
                turn, back = held_tensions(runs.run(
                    f"strap_{wrap}_{friction}_{angle}", "band_brake.prm", {
                        "Mesh/Intervals alpha_2":
                            f"0:{wrap}:{wrap // angle + wrap % angle // 2}",
                        "Body drum/Motions": "turn: 0 0 0 turn 0.05",
                        "Body drum/Friction": friction}))
                cells.append(f"{100 * (back / ratio - 1):+.3f} %")
                reciprocal = max(reciprocal, abs(turn * back - 1))
            rows.append([f"{wrap}", f"{friction:g}",
                         f"{math.exp(friction * math.radians(wrap)):.4f}",
                         f"{ratio:.4f}", *cells])
    thick = []
    for h in (0.2, 1, 2, 5):
        _, back = held_tensions(runs.run(f"strap_thick_{h}", "band_brake.prm", {
            "Laminate/Plies": f"steel: {h} @ 0"}))
        formula = math.exp(0.3 * math.pi / (1 + h / 2 / DRUM))
        thick.append([f"{h:g}", f"{back:.4f}", f"{formula:.4f}",
                      f"{100 * (back / formula - 1):+.3f} %"])
    shipped = runs.run("strap", "band_brake.prm", {})
    draw_strap(runs.run("strap_slowly", "band_brake.prm", {
        "Body drum/Motions": "turn: 0 0 0 turn 0.004"}), 0.3, picture)
    moment = shipped.forces().where(body="drum")["M_y"][-1]
    _, back = held_tensions(shipped)
    others = [held_tensions(runs.run(f"strap_{value}", "band_brake.prm", {
        "Contact/Tangential regularization": value}))[1]
        for value in ("automatic", 10, 1000)]
    return {
        "straps": table(
            ["Wrap, degrees", "μ", "exp(μθ)", "exp(kθ)", "Cells of 4°",
             "Cells of 2°"], rows),
        "reciprocal": reciprocal,
        "thick": table(["Thickness, mm", "Ratio", "exp(kθ)", "Deviation"],
                       thick),
        "moment": abs(abs(moment)
                      / ((back - 1) * (DRUM + STRAP / 2)) - 1),
        "regularization": max(abs(other / back - 1) for other in others),
        "strap_iterations": int(shipped.history["iterations"].sum()),
        "strap_steps": len(shipped.steps)}


def main():
    arguments = parse_arguments("seals_and_saddles", __doc__)
    runs = Runs(arguments)
    figures = arguments.output / "figures"
    words = seal_words(runs, figures / "inflatable_seal.png")
    words |= saddle_words(runs, figures / "saddle_tank.png")
    words |= strap_words(runs, figures / "band_brake.png")
    (arguments.output / "seals_and_saddles.md").write_text(
        PAGE.format(**words), encoding="utf-8")


if __name__ == "__main__":
    main()
