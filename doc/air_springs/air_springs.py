#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write air_springs.md and its pictures, from runs of prm/air_spring.prm and
prm/bellows.prm."""

import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, parse_arguments, section, table

PAGE = """<!-- Written by doc/air_springs/air_springs.py: cmake --build build --target air_springs -->

# Air springs

[air_spring.prm](../prm/air_spring.prm) is a rolling-lobe air spring: a sleeve with two plies of cord
between a plate and a piston, a [body](theory.md#bodies-beside-the-ground) along which the lobe
rolls. [bellows.prm](../prm/bellows.prm) has two convolutions and a girdle hoop, and the convolutions roll
onto the plates. Both are pushed and pulled with the gas sealed in, and each takes a second.

    build/biface prm/air_spring.prm

Plates close both ends (`Loads/End plates`): the pressure on a plate is passed on to the edge of the
shell, so that the support of this edge in forces.csv is the force that holds the plate. The cavity
reaches to the axis.

![Sections of the sleeve, its lobe farther up the piston when compressed; of the bellows, whose convolutions roll onto the plates; and their forces over the height](figures/air_springs.png)

*Sections of the inflated springs at 0.5 MPa, compressed and pulled out with the gas sealed in, and
their forces over the change of height: at constant pressure, at constant temperature and without
exchange of heat.*

## Effective area

The force is the pressure times the effective area. A membrane without stiffness has that of the
circle through the middle of the lobe, where the tension has no axial component; here this circle has a radius
of 65 mm before the inflation. At the height of design:

{areas}

At low pressure the bending of the wall, whose lobe is free of stress before the inflation, takes a part of
the force. On half and on twice the cells along the sleeve the force at 0.5 MPa differs by at most {mesh:.2f} %.

## Rates

The rate at the height of design, from steps of 2 mm to both sides, beside two formulas with the
polytropic exponent n and the height h. A gas behind the effective area A has

```math
k_r = \\frac{{n\\,(p + p_a)\\,A^2}}{{V}} + k_0
```

where $`k_0`$ is the rate at constant pressure. The wall gives way: at a given height, force F and volume V grow with the pressure by
F' and V'. Since F and $`-V`$ are derivatives of one energy, F' also is the volume that a change of height displaces, and

```math
k = \\frac{{n\\,(p + p_a)\\,F'^2}}{{V + n\\,(p + p_a)\\,V'}} + k_0 .
```

F' and V' are from inflations to pressures 0.01 MPa higher and lower. In N/mm:

{rates}

The area of the bellows, whose convolutions unroll, depends on the height; that of the sleeve on a
straight piston hardly does. From 26 mm of compression on, the convolutions of the bellows would touch each
other, which is not modeled. A piston that tapers toward its foot by 3 degrees lets the lobe shrink as it rolls down, and
the spring becomes softer:

{pistons}

## To the side and tilted

The whole turn on 32 cells around the axis. The plate moves to the side by 2 mm (`x both = 2`), or tilts by
0.01 radians about the middle of its edge (`axial both = -0.01*x` and so on: values of supports may be formulas),
from the inflated state, with the gas sealed in; secants:

{sides}

To the side the stiffness is negative: a plate that nothing guides would move aside. The force of the gas
acts on the plate in the direction of the undeformed axis.

## The force is given

To find the height at which a given force is carried, let the pressure or the motion follow: with
`Forces on bodies` a force finds the motion of a body, or of supports as the plates of these springs, see
[new_shell.md](new_shell.md).
"""

PRESSURES = (0.1, 0.3, 0.5, 0.7)
TURN = {"Mesh/Intervals alpha_2": "0:360:32", "Mesh/Closed in alpha_2": "true",
        "Supports/alpha_2 min": "free", "Supports/alpha_2 max": "free"}
AMBIENT = 0.101325


class Spring:
    """A path: change of height in mm, force in N, pressure in MPa, volume in
    mm^3, by the step."""

    def __init__(self, results, travel, sectors, plates=("alpha_1 max",)):
        self.results = results
        history, forces = results.history, results.forces()
        force = -sectors * sum(forces.where(body=plate)["F_y"] for plate in plates)
        points = zip(travel * history["load_factor"], force, history["pressure"],
                     sectors * history["volume"])
        self.points = dict(zip(results.steps, points))

    def inflated(self):
        return self.points[self.results.stage("inflation").step]

    def path(self):
        """Both branches in the order of the height."""
        start = self.results.stage("inflation").step
        return sorted(self.points[step] for step in self.points
                      if step >= start)

    def rate(self):
        """Of the force at the inflated height."""
        path = self.path()
        i = path.index(self.inflated())
        below, above = path[i - 1], path[i + 1]
        return -(above[1] - below[1]) / (above[0] - below[0])


GASES = {"constant pressure": {"Stage 2/Gas": "open", "Stage 3/Gas": "open"},
         "constant temperature": {"Gas/Polytropic exponent": 1},
         "no exchange of heat": {}}
EXPONENTS = {"constant temperature": 1, "no exchange of heat": 1.4}


def sleeve(runs, name, entries):
    return Spring(runs.run(f"sleeve_{name}", "air_spring.prm", entries), 30,
                  180)


def bellows(runs, name, entries):
    return Spring(runs.run(f"bellows_{name}", "bellows.prm", entries), 20, 120,
                  ("alpha_1 max", "top"))


def rates_of(springs, around=None):
    """The rates by the gas and, with springs of pressures around that of the
    inflation, those of the formulas."""
    open_rate = springs["constant pressure"].rate()
    rates = {"constant pressure": [open_rate]}
    for gas, n in EXPONENTS.items():
        rates[gas] = [springs[gas].rate()]
        if not around:
            continue
        _, force, pressure, volume = springs[gas].inflated()
        lower, higher = (spring.inflated() for spring in around)
        change = higher[2] - lower[2]
        by_force = (higher[1] - lower[1]) / change
        by_volume = (higher[3] - lower[3]) / change
        gas_stiffness = n * (pressure + AMBIENT)
        rates[gas] += [
            gas_stiffness * (force / pressure)**2 / volume + open_rate,
            gas_stiffness * by_force**2 / (volume + gas_stiffness * by_volume)
            + open_rate]
    return rates


def draw(springs, picture):
    figure, axes = plt.subplots(2, 2, figsize=(9, 7), constrained_layout=True)
    axes[0][0].fill([0, 55, 55, 0], [-40, -40, 60, 60], color="0.85")
    axes[0][0].text(5, 0, "piston")
    for column, (name, of_gas) in enumerate(springs.items()):
        spring = of_gas["no exchange of heat"]
        for stage, color in (("compression", "C3"), ("inflation", "0.4"),
                             ("rebound", "C0")):
            step = spring.results.stage(stage).step
            for face in ("outer", "inner"):
                y, r = section(spring.results, step, face)
                axes[0][column].plot(
                    r, y, color=color, linewidth=0.9,
                    label=stage if face == "outer" else None)
        axes[0][column].set_aspect("equal")
        axes[0][column].set_xlim(0, 200)
        axes[0][column].set_xlabel("distance from the axis [mm]")
        axes[0][column].set_ylabel("height [mm]")
        axes[0][column].set_title(name)
        for gas, color in zip(GASES, ("0.4", "C0", "C3")):
            path = of_gas[gas].path()
            axes[1][column].plot([p[0] for p in path],
                                 [p[1] / 1000 for p in path], color=color,
                                 label=gas)
        axes[1][column].set_xlabel("change of height [mm]")
        axes[1][column].set_ylabel("force [kN]")
        axes[1][column].grid(alpha=0.3)
        axes[1][column].legend(fontsize="small")
    axes[0][0].legend(fontsize="small", loc="upper right")
    figure.savefig(picture, dpi=110)


def main():
    arguments = parse_arguments("air_springs", __doc__)
    runs = Runs(arguments)

    springs = {"sleeve": {}, "bellows": {}}
    for i, (gas, entries) in enumerate(GASES.items()):
        springs["sleeve"][gas] = sleeve(runs, f"gas_{i}", entries)
        springs["bellows"][gas] = bellows(runs, f"gas_{i}", entries)
    draw(springs, arguments.output / "figures/air_springs.png")

    areas = []
    for p in PRESSURES:
        spring = sleeve(runs, f"p_{p}", {"Stage 1/Pressure": p,
                                         "Number of stages": 1})
        _, force, pressure, _ = spring.inflated()
        areas.append([f"{p:g}", f"{force:.0f}",
                      f"{math.sqrt(force / pressure / math.pi):.2f}"])
    middle = springs["sleeve"]["no exchange of heat"].inflated()[1]
    meshes = [100 * (sleeve(runs, f"mesh_{n}", {
        "Mesh/Intervals alpha_1": f"0:20:{8 * n // 4}, 20:150:{104 * n // 4}, "
                                  f"150:end:{20 * n // 4}",
        "Number of stages": 1}).inflated()[1] / middle - 1) for n in (2, 8)]

    rates = []
    for name, make in (("sleeve", sleeve), ("bellows", bellows)):
        around = [make(runs, f"around_{p}", {"Stage 1/Pressure": p,
                                             "Number of stages": 1})
                  for p in (0.49, 0.51)]
        for gas, values in rates_of(springs[name], around).items():
            values += [None] * (3 - len(values))
            rates.append([f"{name}, {gas}",
                          *("" if value is None else f"{value:.1f}"
                            for value in values)])
    pistons = []
    for label, entries in (
            ("straight", {}),
            ("tapered", {"Body piston/Shape": "revolved",
                         "Body piston/Profile":
                             "60 55, -100 46.615, -100 0, 60 0, 60 55"})):
        of_gas = {gas: sleeve(runs, f"{label}_{i}", {**changed, **entries})
                  for i, (gas, changed) in enumerate(GASES.items())}
        _, force, pressure, _ = of_gas["no exchange of heat"].inflated()
        pistons.append([label,
                        f"{math.sqrt(force / pressure / math.pi):.2f}",
                        *(f"{rate[0]:.1f}"
                          for rate in rates_of(of_gas).values())])

    sides = []
    for friction in (0, 0.5):
        common = {**TURN, "Body piston/Friction": friction,
                  "Number of stages": 2, "Stage 2/Load factor": 1,
                  "Stage 2/Steps": 4, "Output/Moment center": "0, 120, 0"}
        aside, tilted = (
            runs.run(f"{name}_{friction}", "air_spring.prm", {
                **common, "Supports/alpha_1 max": motion,
            }).forces().where(body="alpha_1 max").row(-1)
            for name, motion in (
                ("aside", "x both = 2; y both; z both"),
                ("tilted", "x both = 0.01*(y - 120); y both = -0.01*x; z both")))
        sides.append([f"{friction:g}", f"{aside['F_x'] / 2:.1f}",
                      f"{tilted['M_z'] / -0.01 / 1000:.0f}"])

    (arguments.output / "air_springs.md").write_text(PAGE.format(
        areas=table(["Pressure, MPa", "Force, N", "Effective radius, mm"],
                    areas),
        mesh=max(map(abs, meshes)),
        rates=table(["", "computed", "k_r", "k"], rates),
        pistons=table(["Piston", "Effective radius, mm", *GASES], pistons),
        sides=table(["Friction on the piston", "To the side, N/mm",
                     "Tilted, N m per radian"], sides)), encoding="utf-8")


if __name__ == "__main__":
    main()
