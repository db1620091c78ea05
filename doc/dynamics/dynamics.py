#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write dynamics.md and its pictures: shells with inertia, beside an independent
program, formulas and published values."""

import sys
from pathlib import Path

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.collections import PolyCollection
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, biface, parse_arguments, section, table
from biface_report.drawing import BLUE, DISTINCT, GRAY, RED, STYLE, save, shades

PAGE = """<!-- Written by doc/dynamics/dynamics.py: cmake --build build --target dynamics -->

# Shells in time

With `Inertia = true` a stage goes through the time `Duration`, from the state and the velocities at the end of the
stage before, instead of through equilibria: impact, snap-through, vibration, free flight.
[drop_test.prm](../prm/drop_test.prm), a ball that bounces, [tire_drop.prm](../prm/tire_drop.prm), a tire with its rim, and
[snap_of_a_cap.prm](../prm/snap_of_a_cap.prm) are examples.

    build/biface prm/drop_test.prm

```
subsection Stage 2
  set Inertia           = true
  set Contact           = true
  set Duration          = 0.012
  set Time step         = 1e-4                # the first one; then by 'Time error'
  set Initial velocity  = 0; -6264; 0         # formulas of x, y, z
  set Load history      = pressure: 0.08*min(1, t/0.02)
  set Stiffness damping = 5e-4
end
```

history.csv has the time, kinetic and strain energy, the energy of the springs of contact, what damping has dissipated,
momentum and angular momentum, and `energy_error`, what is missing in the sum of all of them and the work of the loads.

![A strip flies away from left to right and up, bends and turns over](figures/dynamics_strip.png)

*A strip of steel, pushed at three of its corners for 4 ms and then free, every 5 ms.*

## The method

The step from $`\\mathbf V_0, \\mathbf v_0`$ to $`\\mathbf V_1, \\mathbf v_1`$ is that of the energy-momentum method
@cite SimoTarnow1992 :

```math
\\frac{{\\mathbf V_1-\\mathbf V_0}}{{\\Delta t}} = \\frac{{\\mathbf v_0+\\mathbf v_1}}2 ,\\qquad
\\mathbf M\\,\\frac{{\\mathbf v_1-\\mathbf v_0}}{{\\Delta t}} + \\mathbf B^T\\!\\left(\\tfrac12(\\mathbf V_0+\\mathbf V_1)\\right)
\\mathbf D\\,\\tfrac12\\bigl(\\mathbf E(\\mathbf V_0)+\\mathbf E(\\mathbf V_1)\\bigr) = \\mathbf F
```

with the dead loads halfway. The strains are quadratic in the displacements, so that their change is exactly
$`\\mathbf B(\\tfrac12(\\mathbf V_0+\\mathbf V_1))\\,(\\mathbf V_1-\\mathbf V_0)`$, and the work of the stresses is the change of the energy, for steps of any length.
The usual midpoint rule has the stresses of the strains at the mean position instead of the mean of the strains, from which they differ by a term quadratic in the step,
and gains or loses energy by it. Laws that are not linear have a discrete derivative of their energy instead of the mean
@cite Gonzalez2000 , contact that of its springs @cite LaursenChawla1997 , and a gas
the mean of its pressure between the two volumes. The velocities at the end are all that a step needs to know of
those before. See [theory.md](theory.md#steps-in-time).

The independent program is written in Python for the same element with strains at the vertices, on coordinates of its own; its values are called *independent* or stand
in parentheses. A drift is the largest change since
the loads are gone; history.csv has 12 digits.

## Free flight

The strip above, 300 × 60 × 2 mm of steel (E = 206000 MPa, ν = 0), on 30 × 2 cells: forces (0, 0, 300), (100, 0, 600) and (0, 150, 0) N
at three corners rise for 2 ms and fall for 2 ms; displacement of the middle of the end x = 300 after 50 ms:

{strip}

The momentum is ({strip_momentum}) N s and the angular momentum ({strip_angular_momentum}) N mm s after the pulse, at Δt = 0.1 ms.
These runs have `Newton/Residual tolerance = 1e-12`. With the tolerances by default a step takes
{default_iterations} iterations at 0.1 ms, and the drifts are {default_drift} (energy) and {default_angular} (angular momentum).
Where the iteration fails, a step is halved: of 0.5 ms the strip takes {strip_steps} steps instead of 100.

A curved panel of four plies, [45, -45, 0, 90] of 0.25 mm, radius 100 mm, 90 degrees and 120 mm long, on 8 × 12 cells: three forces
at corners for 2 ms; displacement of the fourth along x, along its tangent at 0 degrees and along the axis, after 20 ms:

{panel}

The cells of this interpolation are chords. Both programs treat the curvature inside them in their own way, which is the difference of 3e-4 of the
energies; on finer meshes it vanishes. Energy after the pulse and displacement of that
corner then, with `Formulation = vertices`, `standard` and `paper`:

{panel_meshes}

Of 0.2 ms this panel takes {panel_steps} steps instead of 100.

## Small vibrations

A vibration of the frequency f has, in the steps, the frequency $`\\operatorname{{atan}}(\\pi f\\,\\Delta t)/(\\pi\\,\\Delta t)`$, without any damping.
A strip on two supports, let go from its deflection under a load, whose lowest frequency by `Modes` is {vibration_frequency} 1/s:

{vibration}

## A ring that bounces

A ring of radius 100 mm, 5 × 20 mm (E = 100 MPa, ν = 0, 1.2e-9 t/mm³), is thrown at a plane at 4 m/s, half of it by symmetry. Contact is springs of 1 MPa/mm
at the nodes, without friction. The velocity of its center after 50 ms over that before, without damping:

{ring}

`energy_error` is {ring_balance} of the energy. The velocity scatters nevertheless, in both programs, by 2 %, and does not converge with mesh and step: each node that
strikes the plane sends waves through the wall as short as the cells and the springs permit. They bring nodes off the plane and back, so that the contact force is a row of
peaks, and how much of the energy is left in vibrations at the end depends on when each of them happens. What a wall of
real material damps must be damped: with `Stiffness damping = 2e-4`, 0.2 ms, the result does not depend on mesh and step any more.

{damped_ring}

![Without damping the force is a row of peaks; with damping it is smooth after the first 10 ms. A quarter of the energy is dissipated](figures/dynamics_ring.png)

*The mean force of each step, of forces.csv, and the energies; thin without damping. 40 cells, 0.2 ms.*

Damping by `Contact damping` and `Numerical damping`, 40 cells and 0.2 ms:

{contact_damping}

`Contact damping` alone takes energy out of the springs at each touch, but not the waves that are in the wall
already: the velocity scatters as without damping. In the second line both programs differ by a twentieth of what is dissipated: contact does not pull here, and may do so there.

### Steps that adapt

`Time error` is the error of a step relative to the largest displacement in it. On 20 cells, beside those of the independent
program, which also ends steps where nodes touch, but for the first line:

{adaptive}

Without damping the waves that no step resolves keep steps short. With `Numerical damping = 0.2`, the default
`Time error = 0.01` takes half as many steps as equal steps of 0.2 ms.

## A torus full of gas

A closed torus of radii 100 and 30 mm and 3 mm thick (E = 10 MPa, ν = 0.3, 1.2e-9 t/mm³), on a mesh from a file with 0.005 MPa sealed in
(`Polytropic exponent = 1.4`, 0.1 MPa outside), is thrown with a velocity that deforms it, 3000 (x/100, -y/200, 0.3 (x² - y²)/10⁴) + (200, -100, 300) mm/s
plus a spin. A free shell has no unique equilibrium to which it could be
inflated: a stage with much `Mass damping` and `Numerical damping = 2` finds one. Drift of the energy, with that of the gas, over the kinetic one, drift of
the angular momentum, pressure, and displacement of the point at (130, 0, 0), in 20 ms:

{torus}

The energy is exact; the force of the gas turns the torus by an error of second order in the step, since
it is the mean of the forces during a straight motion of all nodes. The coarse cells turn by 45 degrees around the tube, and
the two programs treat the curvature in them in their own way, as in the panel: the inflation makes the volume larger by {torus_growth} mm³, by 13458 mm³
in the independent program, and by {torus_growth_fine} mm³ on the finer mesh. The motions that follow differ accordingly.

## A ball that falls on the ground

[drop_test.prm](../prm/drop_test.prm): a football of 430 g with 0.08 MPa meets the ground after a fall from 2 m. In {ball_steps} steps it
is flattened and bounces with {ball_speed} m/s, enough for {ball_rebound} m. It touches the ground for {ball_contact} ms; a thin ball whose pressure acts
on the flat part as a spring of $`2\\pi R p`$ would for {ball_formula} ms. The pressure rises to {ball_pressure} kPa,
and the wall has dissipated {ball_dissipated} % of the energy.

![Sections of the ball on the ground, flattened at its bottom to a width of 100 mm, and above the ground again](figures/dynamics_ball.png)

*Sections through the axis.*

## A tire that falls with its rim

[tire_drop.prm](../prm/tire_drop.prm): the bias tire at 0.15 MPa meets the ground at 0.99 m/s, after a fall from 50 mm. Its beads
are fixed to a rim of 10 kg: one factor moves both of them, and `Forces on bodies` has the weight of the rim in place of a `Load factor`, so that
the balance of its mass finds the motion.

```
subsection Supports
  set alpha_1 min = x both = 1; y both; z both
  set alpha_1 max = x both = 1; y both; z both
  set Masses      = supports: 0.01        # t
end
subsection Stage 2
  set Inertia          = true
  set Forces on bodies = supports: 98.1   # N
  set Initial velocity = 990; 0; 0
  ...
```

Beside it a mass on the spring that the static force over the deflection is, without damping and without waves in the wall:

{tire}

![The force rises to 1.24 kN and falls, as that of the mass on the static curve; the rim sinks by 13 mm and rises again](figures/dynamics_tire.png)

*The force of the ground, its mean in each of the {tire_steps} steps, and the deflection; thin, the mass of rim and tire on the static curve.* In each step the sum of
all energies, that of the rim included, changes by what the loads do and what is dissipated: what is missing is {tire_error} of the energy. A run takes 10 s.

## A cap that snaps

[snap_of_a_cap.prm](../prm/snap_of_a_cap.prm): a clamped spherical cap (radius 22.27 in, half angle 26.67 degrees, 0.41 in thick,
E = 10.5e6 psi, ν = 0.3, 2.45e-4 lb s²/in⁴) under a pressure of 600 psi that acts at once, per area of the middle surface. Statically the apex moves by {cap_static} in.
The first extrema of its deflection:

{cap}

![The apex swings to -0.09 in, back to 0.04 and again to -0.085; values of three authors lie near the first two extrema](figures/dynamics_cap.png)

*Beside extrema of curves in the literature, as they are digitized and labelled in `spherical_cap_expl_examples.jl` of FinEtoolsFlexStructures.jl (P. Krysl).*
The curve follows that of Belytschko. The second minimum is 12 % smaller than Bathe's, at the same time, on every mesh and with every step.

## A roof that snaps through

The hinged roof of [verification.md](verification.md) with 12.7 mm and 1e-9 t/mm³ under a force at its center that acts at once, on 6 × 6 cells for a quarter, at Δt = 0.1 ms:

{roof}

![Equilibria with a limit point at 2200 N; under 1690 N the center swings between 1 and 15 mm, under 1720 N to 30 mm and back](figures/dynamics_roof.png)

*Left, equilibria; right, the deflection after the force is there.* Statics needs {roof_limit} N for the roof to snap through; a force that acts at once does it with
less than 1720 N. A slow force finds the equilibrium: 1000 N after a rise of 0.1 s is at {roof_ramp_1} mm and after 0.2 s
at {roof_ramp_2} mm, in steps of 1 ms, beside {roof_static} mm in statics.

## A plate under a step of pressure, NAFEMS 13

A simply supported plate, 10 × 10 × 0.05 m (E = 200 GPa, ν = 0.3, 8000 kg/m³), under 100 Pa that act at once, with 2 % of the critical
damping (test 13T of *Selected Benchmarks for Forced Vibration*, NAFEMS R0016, 1993). Rayleigh's damping has α = 0.2987 1/s and β = 1.3393 ms: `Mass damping` and `Stiffness damping`. Deflections of the center for a
thousandth of the load, times 1000, on n × n cells for a quarter:

{plate}

The published numbers are those of the first mode alone, which is 2.4 % softer in statics than the plate. A plate with all its
modes must not reach 3.523 mm: it reaches 3.460 mm, as biface does.

## What to choose

- **Time step**: the error of a frequency is $`(\\pi f\\,\\Delta t)^2/3`$, 0.8 % with 20 steps in a period and 0.13 % with 50. Faster
  vibrations are kept in energy, but not in time. If the iteration fails, steps are halved, which
  costs more than a step that is shorter from the start. `Time error = 0` makes equal steps, the best choice for
  comparisons; the default 0.01 suits an impact. The first step of a stage has no step before it to tell its error: give a `Time step`
  of a tenth of the shortest time that matters, or it is a thousandth of `Duration`, as is the step in which a motion begins from rest.
- **Damping**: `Stiffness damping` τ gives a vibration of the frequency f the damping ratio π f τ, `Mass damping` α the ratio
  α/(4 π f). The first does not brake rigid motions, the second does. `Numerical damping = 0.2` takes out what the steps do not resolve and changes with the step: 1.6 · 0.2 f Δt. After an impact, one
  of them is needed for results that converge.
- **Contact**: the springs of `Regularization` take up energy, too. `automatic` is as stiff as in statics; nodes that strike such
  springs make waves that only short steps resolve. Choose one that lets the shell penetrate by a few percent of its thickness.
- **Forces on the ground**: those in forces.csv are the means of a step, whose impulse is the change of the momentum; `force` in history.csv
  is that at its end.
- **Load history**: a pulse of 4 ms is `load factor: max(0, 1 - abs(t/0.002 - 1))`; with `History tables = road: road.csv` a measured history is
  `travel: 10 + road`. Loads count halfway in each step, so that the steps must resolve
  their history. With `Time error`, steps become shorter where a load changes unevenly in them, and are at most a twentieth of the
  stage: a pulse that is much shorter than that wants a stage of its own, or equal steps.
- **Element**: the standard one, which no rotation strains. On curved surfaces with `Formulation = paper` energy
  is kept as well, but while the panel above flies its momentum changes by {components_momentum} and its angular momentum by {components_angular}.
- **Equilibria of free shells**: a stage with `Mass damping` of some times the lowest frequency and `Numerical damping = 2` goes to them in a few
  long steps.

## Limits

- Wheels that roll or spin have no such stages, nor have materials with `Relaxation times`, linear theory, `Coarse meshes`,
  derivatives, and any `Control` but that of the loads.
- The ground has no mass and moves as prescribed. Bodies and supports with `Masses` move along their motions; bodies only translate.
- Friction dissipates, and springs that hold nodes sideways lose a part of their energy; only frictionless contact is without any loss.
- Angular momentum is exact without a gas; with one it drifts with the square of the step.
"""

# the element of the independent program, on which round-off is visible
ELEMENT = {"Formulation": "vertices", "Laminate/Reference surface": "middle",
           "Newton/Residual tolerance": 1e-12, "Newton/Update tolerance": 1e-13}
CYLINDER = {"Surface/Type": "surface of revolution", "Surface/Meridian": "straight line"}
ARC = {"Surface/Type": "surface of revolution", "Surface/Meridian": "circular arc"}
MILLISECOND = 1e-3


class Runner:
    def __init__(self, arguments):
        self.program, self.scratch = arguments.program, arguments.scratch

    def run(self, name, entries, may_stop=False):
        file = self.scratch / f"{name}.prm"
        biface.write_parameters(file, {
            "Output/Write VTU": False, "Output/Points per ply": 0,
            "Checkpoint/Write": False, **entries})
        return biface.run(file, {}, self.scratch / name, program=self.program,
                          may_stop=may_stop)


def isotropic(young, poisson, density, thickness):
    return {"Materials": "m", "Material m/Type": "isotropic", "Material m/E": young,
            "Material m/nu": poisson, "Material m/Density": density,
            "Laminate/Plies": f"m: {thickness} @ 0"}


def stages(*all_entries):
    """Stages with inertia and equal steps unless their entries say otherwise."""
    entries = {"Number of stages": len(all_entries)}
    for i, of_stage in enumerate(all_entries):
        for name, value in {"Inertia": True, "Time error": 0, **of_stage}.items():
            entries[f"Stage {i + 1}/{name}"] = value
    return entries


def pulse(rise, end, step, **damping):
    """A load factor that rises to 1 and falls to 0, and free motion to the end."""
    common = {"Time step": step, **damping}
    return stages(
        {"Name": "up", "Duration": rise, "Load history": f"load factor: t/{rise}", **common},
        {"Name": "down", "Duration": rise, "Load history": f"load factor: 1 - t/{rise}",
         **common},
        {"Name": "free", "Duration": end - 2 * rise, **common})


def energy(history):
    return history["kinetic_energy"] + history["strain_energy"] + history["contact_energy"]


def vectors(history, name):
    return np.stack([history[f"{name}_{i}"] for i in "xyz"], -1)


def drift(values):
    """The largest change of a vector since the first row over its length there."""
    return (np.linalg.norm(values - values[0], axis=-1).max()
            / np.linalg.norm(values[0]))


def iterations(results):
    return f"{results.history['iterations'].mean():.2f}"


def displacement(results, name, order="xyz"):
    row = results.probes().where(name=name).row(-1)
    return ", ".join(f"{row[f'u_{i}']:.3f}" for i in order)


def small(value):
    """A drift: history.csv has 12 digits."""
    return f"{value:.0e}" if value > 1e-11 else "< 1e-11"


def free_flight_row(results, name, order="xyz"):
    """Iterations, energy after the pulse, drifts, and the place at the end."""
    free = results.history.where(results.history["time"] >= results.stage("down")
                                 .history["time"][-1] - 1e-12)
    total = energy(free)
    return [iterations(results), f"{total[0]:.{5 if total[0] < 1000 else 3}f}",
            small(np.abs(total / total[0] - 1).max()),
            small(drift(vectors(free, "momentum"))),
            small(drift(vectors(free, "angular_momentum"))),
            displacement(results, name, order)], free


FREE_FLIGHT = ["Δt, ms", "", "iterations", "energy, N mm", "its drift", "momentum",
               "angular momentum", "displacement, mm"]


def strip_entries(step):
    return {"Surface/Type": "plane", "Mesh/Intervals alpha_1": "0:300:30",
            "Mesh/Intervals alpha_2": "0:60:2", "Mesh/Closed in alpha_2": False,
            **isotropic(206000, 0, 7.8e-9, 2), **ELEMENT,
            "Named points": "a: 0 0, b: 300 60, c: 300 0, m: 300 30",
            "Loads/Point forces": "a: 0 0 300, b: 100 0 600, c: 0 150 0",
            **pulse(2e-3, 50e-3, step)}


def draw_strip(results, picture):
    """The strip every 5 ms, each time farther to the right, seen from the side and above."""
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(figsize=(12, 3.6))
    across, up = np.array([0.95, 0.3, 0]), np.array([-0.12, 0.38, 0.92])
    toward = np.cross(across, up)
    times, right = np.arange(0, 51, 5), 0
    for t, color in zip(times, shades(len(times))):
        step = results.steps[np.argmin(np.abs(results.history["time"] - t * MILLISECOND))]
        shell = results.vtu("shell", step)
        points = shell["Points"] - (shell["displacement"] if t == 0 else 0)
        cells = points[shell["connectivity"].reshape(-1, 4)]
        # the faces lie on each other: the nearer ones are drawn last
        cells = cells[np.argsort(cells.mean(1) @ toward)]
        normals = np.cross(cells[:, 2] - cells[:, 0], cells[:, 3] - cells[:, 1])
        light = np.abs(normals @ [0.35, -0.75, 0.55]) / np.linalg.norm(normals, axis=1)
        colors = color[:3] * (0.45 + 0.55 * light[:, None])
        # room for the label, too
        half = max(np.ptp(points @ across) / 2, 60)
        shift = right + half + 15 - (np.ptp(points @ across) / 2 + (points @ across).min())
        right += 2 * half + 15
        axes.add_collection(PolyCollection(
            np.stack([cells @ across + shift, cells @ up], -1), facecolors=colors,
            edgecolors=colors * 0.8, linewidths=0.3))
        axes.text(right - half, (points @ up).max() + 12, f"{t} ms",
                  ha="center", va="bottom", fontsize=10)
    axes.set(xlim=(0, right + 30), ylim=(-60, 540), aspect="equal")
    axes.axis("off")
    save(figure, picture)


# of the independent program: iterations, energy, drifts, displacement
STRIP = {0.1: ["4.00", "22820.834", "4e-14", "–", "6e-14", "-200.632, 72.085, 429.031"],
         0.2: ["4.96", "22760.12", "6e-14", "–", "3e-14", "-201.83, 71.91, 427.95"]}


def strip_table(runner, pictures):
    rows, facts = [], {}
    for step in (0.2, 0.1, 0.05):
        results = runner.run(f"strip_{step}", {**strip_entries(step * MILLISECOND),
                                               "Output/Write VTU": step == 0.2})
        row, free = free_flight_row(results, "m")
        rows.append([f"{step}", "biface"] + row)
        if step in STRIP:
            rows.append(["", "independent"] + STRIP[step])
        if step == 0.2:
            draw_strip(results, pictures / "dynamics_strip.png")
        if step == 0.1:
            facts = {f"strip_{name}": ", ".join(f"{v:.{digits}f}" for v in
                                                vectors(free, name)[0])
                     for name, digits in (("momentum", 4), ("angular_momentum", 2))}
    # the accuracy of a run by default
    default = runner.run("strip_default", {
        **strip_entries(0.1 * MILLISECOND), "Newton/Residual tolerance": 1e-8,
        "Newton/Update tolerance": 1e-9})
    row, _ = free_flight_row(default, "m")
    facts.update(default_iterations=row[0], default_drift=row[2],
                 default_angular=row[4])
    return {"strip": table(FREE_FLIGHT, rows), **facts}


PLIES = "carbon: 0.25 @ 45, carbon: 0.25 @ -45, carbon: 0.25 @ 0, carbon: 0.25 @ 90"
CARBON = {"Materials": "carbon", "Material carbon/Type": "transversely isotropic",
          "Material carbon/E_L": 135000, "Material carbon/E_T": 9000,
          "Material carbon/nu_LT": 0.3, "Material carbon/nu_TT": 0.4,
          "Material carbon/G_LT": 5000, "Material carbon/G_TT": 3200,
          "Material carbon/Density": 1.6e-9, "Laminate/Plies": PLIES}
PANEL = {0.1: ["4.99", "615.55028", "5e-14", "4e-14", "7e-14", "125.829, 11.042, -51.844"],
         0.05: ["4.00", "615.63824", "2e-13", "2e-13", "3e-13", "125.525, 11.183, -51.605"],
         0.025: ["3.21", "615.76255", "2e-13", "5e-13", "9e-13", "125.265, 11.327, -51.425"]}


def panel_entries(step, refinement=1):
    return {**CYLINDER, "Surface/Straight line/Start": "100, 0",
            "Surface/Straight line/End": "100, 120",
            "Mesh/Intervals alpha_1": f"0:120:{8 * refinement}",
            "Mesh/Intervals alpha_2": f"-45:45:{12 * refinement}",
            "Mesh/Closed in alpha_2": False, **CARBON, **ELEMENT,
            "Named points": "a: 0 -45, b: 120 45, c: 120 -45",
            "Loads/Point forces": "a: 15 25 0, b: 38 0 10, c: 0 -15 20",
            **pulse(1e-3, 20e-3, step)}


def panel_table(runner):
    """The axis of the panel of the independent program is z."""
    rows = []
    for step in (0.1, 0.05, 0.025):
        results = runner.run(f"panel_{step}", panel_entries(step * MILLISECOND))
        row, _ = free_flight_row(results, "b", "xzy")
        rows.append([f"{step}", "biface"] + row)
        rows.append(["", "independent"] + PANEL[step])
    components = runner.run("panel_components", {
        **panel_entries(0.1 * MILLISECOND), "Formulation": "paper"}).stage("free").history
    meshes = []
    for refinement in (1, 2, 4):
        row = [f"{8 * refinement} × {12 * refinement}"]
        for name in ("vertices", "standard", "paper"):
            results = runner.run(
                f"panel_{name}_{refinement}",
                {**panel_entries(0.05 * MILLISECOND, refinement), "Formulation": name,
                 "Newton/Residual tolerance": 1e-8, "Number of stages": 2})
            row += [f"{energy(results.history)[-1]:.3f}", displacement(results, "b", "xzy")]
        meshes.append(row)
    return {"components_momentum": f"{100 * drift(vectors(components, 'momentum')):.1f} %",
            "components_angular":
                f"{100 * drift(vectors(components, 'angular_momentum')):.1f} %",
            "panel": table(FREE_FLIGHT, rows), "panel_meshes": table(
        ["cells"] + ["energy", "displacement, mm"] * 3, meshes)}


# Half a ring that is thrown at a plane.

def ring_entries(cells, step, **motion):
    return {**CYLINDER, "Surface/Straight line/Start": "100, 0",
            "Surface/Straight line/End": "100, 20", "Mesh/Intervals alpha_1": "0:20:1",
            "Mesh/Intervals alpha_2": f"0:180:{cells}", "Mesh/Closed in alpha_2": False,
            **isotropic(100, 0, 1.2e-9, 5), **ELEMENT,
            "Newton/Residual tolerance": 1e-10, "Newton/Update tolerance": 1e-11,
            "Supports/alpha_1 min": "axial both", "Supports/alpha_1 max": "axial both",
            "Supports/alpha_2 min": "z both", "Supports/alpha_2 max": "z both",
            "Contact/Direction": "-1, 0, 0", "Contact/Regularization": 1,
            # the ground starts where it touches the shell: 1 mm away from it in the
            # first stage, at rest
            **stages({"Name": "gap", "Contact": True, "Duration": 1e-9, "Travel": -1},
                     {"Name": "impact", "Contact": True, "Duration": 0.05, "Time step": step,
                      "Initial velocity": "-4000; 0; 0", **motion})}


def ring_facts(results):
    """What is left of the velocity and of the energy, and what is dissipated."""
    history = results.stage("impact").history
    work = sum(history[name] for name in ("damping_work", "numerical_work", "contact_work"))
    start = energy(history)[0] + work[0]
    mass = 2 * start / 4000**2
    return {"iterations": f"{history['iterations'].mean():.2f}",
            "restitution": history["momentum_x"][-1] / mass / 4000,
            "dissipated": work[-1] / start,
            "force": results.forces().where(body="foundation")["F_x"].max(),
            "balance": np.abs(history["energy_error"]).max() / start}


# A cap under a step of pressure.

CAP_HALF_ANGLE = 26.67
# on the outer face, of 600 psi per area of the middle surface
CAP_PRESSURE = 600 * (22.27 / (22.27 + 0.41 / 2))**2
LITERATURE = {"Bathe": ([0.356, 0.576, 0.852], [-0.0902, 0.0515, -0.0982]),
              "Belytschko": ([0.402, 0.583], [-0.0929, 0.0416]),
              "Tabiei": ([0.333, 0.540], [-0.0896, 0.0474])}


def cap_entries(cells, step, **motion):
    return {**ARC, "Surface/Circular arc/Radius": 22.27,
            "Surface/Circular arc/Center radius": 0,
            "Mesh/Intervals alpha_1": f"{90 - CAP_HALF_ANGLE}:89.97:{cells}",
            "Mesh/Intervals alpha_2": "0:4:1", "Mesh/Closed in alpha_2": False,
            **isotropic(10.5e6, 0.3, 2.45e-4, 0.41), **ELEMENT,
            "Newton/Residual tolerance": 1e-10, "Newton/Update tolerance": 1e-11,
            "Supports/alpha_1 min": "fixed", "Supports/alpha_1 max": "symmetry",
            "Supports/alpha_2 min": "symmetry", "Supports/alpha_2 max": "symmetry",
            "Named points": "apex: 89.97 0", "Loads/Pressure type": "dead",
            "Loads/Pressure face": "outer",
            **stages({"Duration": 1.1e-3, "Time step": step,
                      "Load history": f"pressure: {CAP_PRESSURE!r}", **motion})}


def extrema(t, w):
    """The large extrema of a curve, by parabolas."""
    result = []
    for i in range(1, len(w) - 1):
        if (w[i] - w[i - 1]) * (w[i + 1] - w[i]) <= 0:
            around = slice(max(i - 20, 0), i + 21)
            if w[i] in (w[around].min(), w[around].max()):
                result.append((t[i], w[i]))
    return result


# A hinged roof under a step of force.

def roof_entries(cells, **more):
    return {**CYLINDER, "Surface/Straight line/Start": "2540, 0",
            "Surface/Straight line/End": "2540, 254",
            "Mesh/Intervals alpha_1": f"0:254:{cells}",
            "Mesh/Intervals alpha_2": f"0:{np.degrees(0.1)!r}:{cells}",
            "Mesh/Closed in alpha_2": False,
            **isotropic(3102.75, 0.3, 1e-9, 12.7), **ELEMENT,
            "Newton/Residual tolerance": 1e-10, "Newton/Update tolerance": 1e-11,
            "Named points": "center: 0 0", "Supports/alpha_1 min": "symmetry",
            "Supports/alpha_2 min": "symmetry", "Supports/alpha_2 max": "hinged",
            "Loads/Point forces": "center: -0.25 0 0", **more}


# A plate, NAFEMS 13.

def plate_entries(cells, **more):
    return {"Surface/Type": "plane", "Mesh/Intervals alpha_1": f"0:5:{cells}",
            "Mesh/Intervals alpha_2": f"0:5:{cells}", "Mesh/Closed in alpha_2": False,
            **isotropic(200e9, 0.3, 8000, 0.05), **ELEMENT,
            "Newton/Residual tolerance": 1e-10, "Newton/Update tolerance": 1e-11,
            "Supports/alpha_1 min": "v_3 middle; v_2 difference",
            "Supports/alpha_2 min": "v_3 middle; v_1 difference",
            "Supports/alpha_1 max": "symmetry", "Supports/alpha_2 max": "symmetry",
            "Named points": "center: 5 5", "Loads/Area force": "0, 0, 0.1", **more}


# A torus full of gas that rotates.

def write_torus(path, around_tube, around_axis, radius=100, tube=30):
    """MSH 2.2, with the point 'P' at the outer equator."""
    psi, phi = np.meshgrid(2 * np.pi * np.arange(around_tube) / around_tube,
                           2 * np.pi * np.arange(around_axis) / around_axis, indexing="ij")
    distance = radius + tube * np.cos(psi)
    nodes = np.stack([distance * np.cos(phi), distance * np.sin(phi), tube * np.sin(psi)],
                     -1).reshape(-1, 3)

    def node(i, j):
        return i % around_tube * around_axis + j % around_axis + 1

    elements = ["15 2 1 0 1"] + [
        f"3 2 2 0 {node(i, j)} {node(i, j + 1)} {node(i + 1, j + 1)} {node(i + 1, j)}"
        for i in range(around_tube) for j in range(around_axis)]
    path.write_text("\n".join(
        ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '0 1 "P"',
         '2 2 "wall"', "$EndPhysicalNames", "$Nodes", str(len(nodes))]
        + [f"{i + 1} {x:.16g} {y:.16g} {z:.16g}" for i, (x, y, z) in enumerate(nodes)]
        + ["$EndNodes", "$Elements", str(len(elements))]
        + [f"{i + 1} {element}" for i, element in enumerate(elements)]
        + ["$EndElements", ""]))


def torus_entries(mesh, step, spin, duration=20e-3, **gas):
    x, y, z = spin * np.array([1, 0.5, 2]) / np.sqrt(5.25)
    velocity = "; ".join([f"30*x + 200 + {y!r}*z - {z!r}*y",
                          f"-15*y - 100 + {z!r}*x - {x!r}*z",
                          f"0.09*(x^2 - y^2) + 300 + {x!r}*y - {y!r}*x"])
    return {"Surface/Type": "mesh", "Surface/Mesh/File": str(mesh.resolve()),
            "Surface/Mesh/Fold angle": 60, **isotropic(10, 0.3, 1.2e-9, 3), **ELEMENT,
            "Formulation": "standard",
            "Gas/Ambient pressure": 0.1, "Gas/Polytropic exponent": 1.4,
            # without supports, the torus finds its inflated shape by damped motion
            **stages({"Name": "inflation", "Duration": 0.1, "Time step": 1e-3,
                      "Load history": "pressure: 0.005*min(1, t/0.02)", "Mass damping": 500,
                      "Numerical damping": 2},
                     {"Name": "flight", "Duration": duration, "Time step": step,
                      "Initial velocity": velocity, **{"Gas": "sealed", **gas}})}


# A strip on two supports that vibrates a little.

def vibration_entries(step, n_steps):
    return {"Surface/Type": "plane", "Mesh/Intervals alpha_1": "0:200:16",
            "Mesh/Intervals alpha_2": "0:20:1", "Mesh/Closed in alpha_2": False,
            **isotropic(206000, 0, 7.8e-9, 2), **ELEMENT, "Named points": "m: 100 0",
            "Supports/alpha_1 min": "v_1 middle; v_3 middle",
            "Supports/alpha_1 max": "v_3 middle", "Supports/alpha_2 min": "symmetry",
            "Supports/alpha_2 max": "symmetry",
            "Loads/Inner traction": "0; 0; 1e-7*sin(pi*x/200)",
            **stages({"Name": "deflection", "Inertia": False, "Load factor": 1, "Modes": 10},
                     {"Name": "vibration", "Duration": step * n_steps, "Time step": step,
                      "Load history": "load factor: 0"})}


# of the independent program, without and with stiffness damping of 0.2 ms: restitution,
# dissipated energy over that of the start, largest force
RING = {(20, 0.4): 0.7501, (20, 0.2): 0.7490, (20, 0.1): 0.7420, (40, 0.4): 0.7456,
        (40, 0.2): 0.7336, (40, 0.1): 0.7543, (80, 0.4): 0.7330, (80, 0.2): 0.7474,
        (80, 0.1): 0.7308}
DAMPED_RING = {(20, 0.2): (0.6711, 0.2540, 47.1), (40, 0.4): (0.6746, 0.2537, 41.8),
               (40, 0.2): (0.6733, 0.2542, 56.6), (40, 0.1): (0.6733, 0.2541, 65.3),
               (80, 0.2): (0.6770, 0.2541, 54.1)}
# damping: of contact, numerical; of the independent program: restitution, dissipated
CONTACT_DAMPING = {(0.222, 0): (0.7445, 0.1334), (1, 0): (0.7490, 0.1367),
                   (0, 0.222): (0.7250, 0.1666), (0.222, 0.222): (0.7369, 0.1736),
                   (0.667, 0.667): (0.7154, 0.1957)}


def ring_tables(runner, pictures):
    def run(name, cells, step, **motion):
        return runner.run(f"ring_{cells}_{step}{name}",
                          ring_entries(cells, step * MILLISECOND, **motion))

    undamped = []
    for cells in (20, 40, 80):
        row = [str(cells)]
        for step in (0.4, 0.2, 0.1):
            facts = ring_facts(run("", cells, step))
            row.append(f"{facts['restitution']:.4f} ({RING[cells, step]:.4f})")
            balance = facts["balance"]
        undamped.append(row)
    plain = run("", 40, 0.2)

    damped = []
    for (cells, step), expected in DAMPED_RING.items():
        results = run("_tau", cells, step, **{"Stiffness damping": 2e-4})
        facts = ring_facts(results)
        damped.append([f"{cells}", f"{step}", facts["iterations"],
                       f"{facts['restitution']:.4f} ({expected[0]:.4f})",
                       f"{facts['dissipated']:.4f} ({expected[1]:.4f})",
                       f"{facts['force']:.1f} ({expected[2]})", small(facts["balance"])])
    draw_ring(plain, run("_tau", 40, 0.2, **{"Stiffness damping": 2e-4}),
              pictures / "dynamics_ring.png")

    by_contact = []
    for (contact, numerical), expected in CONTACT_DAMPING.items():
        facts = ring_facts(run(f"_{contact}_{numerical}", 40, 0.2, **{
            "Contact damping": contact, "Numerical damping": numerical}))
        by_contact.append([f"{contact}", f"{numerical}", facts["iterations"],
                           f"{facts['restitution']:.4f} ({expected[0]:.4f})",
                           f"{facts['dissipated']:.4f} ({expected[1]:.4f})"])
    return {"ring": table(["cells", "0.4 ms", "0.2 ms", "0.1 ms"], undamped),
            "ring_balance": small(balance),
            "damped_ring": table(["cells", "Δt, ms", "iterations", "restitution",
                                  "dissipated / initial energy", "largest force, N", "balance"],
                                 damped),
            "contact_damping": table(["Contact damping", "Numerical damping", "iterations",
                                      "restitution", "dissipated / initial energy"],
                                     by_contact)}


def draw_ring(plain, damped, picture):
    plt.rcParams.update(STYLE)
    figure, (force, parts) = plt.subplots(1, 2, figsize=(11, 4),
                                          gridspec_kw={"wspace": 0.28})
    for results, color, label in ((plain, BLUE, "without damping"),
                                  (damped, RED, "stiffness damping 0.2 ms")):
        impact = results.stage("impact")
        force.stairs(impact.forces().where(body="foundation")["F_x"],
                     np.append(0, impact.history["time"]) / MILLISECOND, color=color,
                     label=label, linewidth=1.3)
    force.set(xlabel="time (ms)", ylabel="force of the plane (N)", xlim=(0, 50), ylim=(0, 110))
    force.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)
    for name, color, label in (("kinetic_energy", DISTINCT[0], "kinetic"),
                               ("strain_energy", DISTINCT[1], "strain"),
                               ("damping_work", DISTINCT[2], "dissipated")):
        parts.plot(damped.stage("impact").history["time"] / MILLISECOND,
                   damped.stage("impact").history[name], color=color, label=label)
        if name != "damping_work":
            parts.plot(plain.stage("impact").history["time"] / MILLISECOND,
                       plain.stage("impact").history[name], color=color, linewidth=0.8)
    parts.set(xlabel="time (ms)", ylabel="energy (N mm)", xlim=(0, 50), ylim=(0, None))
    parts.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)
    save(figure, picture)


# of the independent program: steps, dissipated, restitution (with events located but
# for the first)
ADAPTIVE = {(0.222, 0.01): ("120", "0.194, 0.709"), (0.222, 0.001): ("1205", "0.154, 0.728"),
            (0.667, 0.01): ("77", "0.282, 0.672"), (0.667, 0.001): ("687", "0.190, 0.709"),
            (0, 0.01): ("1120", "0.000, 0.731")}


def adaptive_table(runner):
    rows = []
    for (damping, error), (steps, expected) in ADAPTIVE.items():
        results = runner.run(f"adaptive_{damping}_{error}", ring_entries(
            20, 2e-4, **{"Time error": error, "Numerical damping": damping}))
        history = results.stage("impact").history
        size = np.diff(history["time"]) / MILLISECOND * 1000
        facts = ring_facts(results)
        rows.append([f"{damping}", f"{error}", f"{len(history)} ({steps})",
                     f"{size.min():.0f}, {size.mean():.0f}, {size.max():.0f}",
                     f"{facts['dissipated'] + 0:.3f}, {facts['restitution']:.3f} "
                     f"({expected})".replace("-0.000", "0.000"), small(facts["balance"])])
    return {"adaptive": table(["Numerical damping", "Time error", "steps",
                               "step, μs: least, mean, largest", "dissipated, restitution",
                               "balance"], rows)}


# of the independent program: pressure least, largest, at the end; drift of the angular
# momentum; displacement
TORUS = {(0, 0.2): ("0.004335, 0.009985, 0.006676", "–", "5.986, -2.000, 3.693"),
         (100, 0.2): ("0.003586, 0.009289, 0.004876", "8e-07", "-169.571, 125.174, -12.920"),
         (100, 0.4): ("0.003641, 0.009386, 0.004818", "3e-06", "-170.181, 125.500, -12.846")}


def torus_table(runner):
    rows, facts = [], {}
    for (cells, (around_tube, around_axis)) in enumerate(((8, 16), (16, 32))):
        mesh = runner.scratch / f"torus_{around_tube}.msh"
        write_torus(mesh, around_tube, around_axis)
        for spin, step in TORUS:
            if cells > 0 and step > 0.2:
                continue
            results = runner.run(f"torus_{around_tube}_{spin}_{step}",
                                 torus_entries(mesh, step * MILLISECOND, spin))
            history = results.stage("flight").history
            n, outside = 1.4, 0.1
            content = (history["pressure"][0] + outside) * history["volume"][0]**n
            total = energy(history) + (content * history["volume"]**(1 - n) / (n - 1)
                                       + outside * history["volume"])
            pressure = history["pressure"]
            rows.append([f"{around_tube} × {around_axis}", f"{spin}", f"{step}", "biface",
                         f"{history['iterations'].mean():.2f}",
                         small(np.abs(total - total[0]).max() / history["kinetic_energy"][0]),
                         small(drift(vectors(history, "angular_momentum"))) if spin else "–",
                         f"{pressure.min():.6f}, {pressure.max():.6f}, {pressure[-1]:.6f}",
                         displacement(results, "P")])
            # under a follower pressure, of the strain energy
            grown = 2 * results.stage("inflation").last("strain_energy") / 0.005
            facts["torus_growth" if cells == 0 else "torus_growth_fine"] = f"{grown:.0f}"
            if cells == 0:
                pressures, angular, place = TORUS[spin, step]
                rows.append(["", "", "", "independent", "", "", angular, pressures, place])
    return {"torus": table(["cells", "spin, 1/s", "Δt, ms", "", "iterations", "energy",
                            "angular momentum", "pressure: least, largest, at the end, MPa",
                            "displacement, mm"], rows), **facts}


def vibration_table(runner):
    """The frequency of the scheme, from a fit of the deflection by all modes, of which
    only the first one is not prescribed."""
    rows = []
    results = runner.run("vibration", vibration_entries(1e-4, 1))
    modes = results.modes()["frequency"]
    for per_period in (10, 20, 50):
        step, n = 1 / modes[0] / per_period, 40 * per_period
        results = runner.run(f"vibration_{per_period}", vibration_entries(step, n))
        signal = results.stage("vibration").probes().where(name="m")["u_z"]
        angles = 2 * np.arctan(np.pi * modes * step)

        def misfit(first):
            turns = np.outer(np.arange(1, n + 1), np.append(first, angles[1:]))
            waves = np.hstack([np.cos(turns), np.sin(turns)])
            return ((waves @ np.linalg.lstsq(waves, signal, rcond=1e-13)[0] - signal)**2).sum()

        found = minimize_scalar(misfit, bounds=angles[0] * np.array([0.9999, 1.0001]),
                                method="bounded", options={"xatol": 1e-14}).x
        rows.append([f"{per_period}", f"{found / (2 * np.pi * step):.6f}",
                     f"{angles[0] / (2 * np.pi * step):.6f}", f"{found / angles[0] - 1:.0e}"])
    return {"vibration": table(["steps in a period", "measured, 1/s",
                                "atan(π f Δt)/(π Δt)", "difference"], rows),
            "vibration_frequency": f"{modes[0]:.6f}"}


# of the independent program, with 32 and 64 cells
CAP_REFERENCE = {32: "-0.05207, -0.03858, -0.09367, 0.04443, -0.08708",
                 64: "-0.05233, -0.03842, -0.09292, 0.04295, -0.08610"}


def cap_table(runner, pictures):
    rows = []
    for cells, step in ((32, 5e-6), (64, 5e-6), (64, 2.5e-6)):
        results = runner.run(f"cap_{cells}_{step}", cap_entries(cells, step))
        t = np.append(0, results.history["time"]) / MILLISECOND
        w = np.append(0, results.probes().where(name="apex")["u_y"])
        found = extrema(t, w)[:5]
        rows.append([f"{cells}, {step * 1e6:g} μs", "biface",
                     ", ".join(f"{at:.3f}" for at, _ in found),
                     ", ".join(f"{value:.5f}" for _, value in found)])
        if step == 5e-6:
            rows.append(["", "independent", "", CAP_REFERENCE[cells]])
        if (cells, step) == (64, 2.5e-6):
            draw_cap(t, w, pictures / "dynamics_cap.png")
    static = runner.run("cap_static", {
        **cap_entries(64, 5e-6), "Stage 1/Inertia": False, "Stage 1/Load history": "",
        "Stage 1/Time step": "Duration/Steps", "Stage 1/Pressure": CAP_PRESSURE})
    return {"cap": table(["cells, step", "", "at, ms", "deflection, in"], rows),
            "cap_static": f"{static.probes().where(name='apex')['u_y'][-1]:.4f}"}


def draw_cap(t, w, picture):
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(figsize=(7.5, 4))
    axes.axhline(0, color="0.7", linewidth=0.8)
    axes.plot(t, w, color=BLUE, label="biface, 64 cells")
    for (name, (at, values)), marker, color in zip(LITERATURE.items(), "osD", DISTINCT[1:]):
        axes.plot(at, values, marker, color=color, label=name, markersize=7, zorder=3)
    axes.set(xlabel="time (ms)", ylabel="deflection of the apex (in)", xlim=(0, t[-1]))
    axes.legend(loc=(0.63, 0.62))
    save(figure, picture)


# of the independent program: the deflection at 2, 4, 6, 8, 10, 15, 20 ms
ROOF = {1690: "4.656, 8.571, 9.656, 12.605, 14.453, 13.434, 7.182",
        1720: "4.742, 8.761, 9.955, 13.168, 15.576, 19.234, 28.839"}


def roof_tables(runner, pictures):
    def deflection(results):
        return np.append(0, -results.probes().where(name="center")["u_x"])

    rows, curves = [], {}
    for force in ROOF:
        results = runner.run(f"roof_{force}", roof_entries(6, **stages(
            {"Duration": 0.04, "Time step": 1e-4, "Load history": f"load factor: {force}"})))
        curves[force] = (np.append(0, results.history["time"]) / MILLISECOND,
                         deflection(results))
        at = [f"{np.interp(time, *curves[force]):.3f}" for time in (2, 4, 6, 8, 10, 15, 20)]
        rows += [[f"{force}", "biface", ", ".join(at)], ["", "independent", ROOF[force]]]
    ramps = {}
    for duration, expected in ((0.1, 2.9158), (0.2, 2.8958)):
        results = runner.run(f"roof_ramp_{duration}", roof_entries(6, **stages(
            {"Duration": duration, "Time step": 1e-3,
             "Load history": f"load factor: 1000*t/{duration}"})))
        ramps[duration] = f"{deflection(results)[-1]:.4f} ({expected})"
    static = runner.run("roof_static", roof_entries(6, **{"Stage 1/Load factor": 1000}))
    path = runner.run("roof_path", roof_entries(6, **{
        "Stage 1/Load factor": 2600, "Stage 1/Control": "displacement",
        "Stage 1/Control point": "center", "Stage 1/Control component": "x",
        "Stage 1/Control value": -30, "Stage 1/Steps": 60}))
    loads = path.history["load_factor"]
    bend = next(i for i in range(1, len(loads) - 1) if loads[i] > loads[i + 1])
    parabola = np.polyfit(np.arange(-1, 2), loads[bend - 1:bend + 2], 2)
    draw_roof(curves, deflection(path), np.append(0, loads),
              pictures / "dynamics_roof.png")
    return {"roof": table(["force, N", "", "deflection at 2, 4, 6, 8, 10, 15 and 20 ms, mm"],
                          rows),
            "roof_ramp_1": ramps[0.1], "roof_ramp_2": ramps[0.2],
            "roof_static": f"{deflection(static)[-1]:.4f}",
            "roof_limit": f"{np.polyval(parabola, -parabola[1] / 2 / parabola[0]):.0f}"}


def draw_roof(curves, deflection, load, picture):
    plt.rcParams.update(STYLE)
    figure, (statics, axes) = plt.subplots(
        1, 2, figsize=(11, 4), gridspec_kw={"width_ratios": [1, 1.5], "wspace": 0.25})
    statics.plot(load, deflection, color=GRAY, label="equilibria")
    for (force, (t, w)), color in zip(curves.items(), (BLUE, RED)):
        statics.plot([force] * 2, [0, w.max()], color=color, linewidth=1.3, linestyle="--")
        axes.plot(t, w, color=color, label=f"{force} N at once")
    statics.set(xlabel="force (N)", ylabel="deflection of the center (mm)", xlim=(0, 2700),
                ylim=(0, 32))
    statics.legend(loc="lower right")
    axes.set(xlabel="time (ms)", xlim=(0, 40), ylim=(0, 32))
    axes.legend(loc="upper left")
    save(figure, picture)


# Rayleigh's damping, 2 % of the critical one in the first mode, in equal halves
ALPHA, BETA = 0.2987, 1.3393e-3


def plate_by_modes(all_modes):
    """Static deflection and largest deflection of the thin plate of NAFEMS 13 under a step of
    pressure, by its modes with Rayleigh's damping."""
    side, thickness, young, poisson, density, pressure = 10, 0.05, 200e9, 0.3, 8000, 100
    stiffness = young * thickness**3 / 12 / (1 - poisson**2)
    mass = density * thickness
    odd = np.arange(1, 60 if all_modes else 2, 2)
    m, n = (values.ravel() for values in np.meshgrid(odd, odd))
    omega = np.pi**2 * (m**2 + n**2) / side**2 * np.sqrt(stiffness / mass)
    static = (16 * pressure / (np.pi**2 * m * n * mass * omega**2)
              * (-1.)**((m - 1) // 2 + (n - 1) // 2))
    zeta = (ALPHA / omega + BETA * omega) / 2
    # the highest modes are overdamped, and small
    zeta = np.minimum(zeta, 0.999999)
    free = omega * np.sqrt(1 - zeta**2)
    t = np.linspace(0.19, 0.23, 4001)[:, None]
    w = (static * (1 - np.exp(-zeta * omega * t)
                   * (np.cos(free * t) + zeta * omega / free * np.sin(free * t)))).sum(1)
    return static.sum() * 1e3, w.max() * 1e3, t[w.argmax(), 0]


def plate_table(runner):
    """Deflections in mm under a thousandth of the load, times 1000."""
    rows = [["published", "1.817", "3.523", "0.210"]]
    for name, all_modes in (("thin plate, first mode", False), ("thin plate, all modes", True)):
        rows.append([name] + [f"{value:.{digits}f}" for value, digits in
                              zip(plate_by_modes(all_modes), (3, 3, 3))])
    expected = {(4, 5): ("1.7695", "3.4729"), (8, 5): ("1.7734", "3.4591"),
                (8, 2.5): ("1.7734", "3.4607"), (16, 5): ("1.7743", "3.4593")}
    for (cells, step), (static, peak) in expected.items():
        statics = runner.run(f"plate_{cells}", plate_entries(cells, **{
            "Stage 1/Load factor": 1}))
        results = runner.run(f"plate_{cells}_{step}", plate_entries(cells, **stages(
            {"Duration": 0.25, "Time step": step * MILLISECOND, "Load history": "load factor: 1",
             "Mass damping": ALPHA, "Stiffness damping": BETA})))
        t = results.history["time"]
        w = results.probes().where(name="center")["u_z"] * 1e6
        top = w.argmax()
        parabola = np.polyfit(t[top - 1:top + 2] - t[top], w[top - 1:top + 2], 2)
        at = -parabola[1] / 2 / parabola[0]
        sunk = statics.probes().where(name="center")["u_z"][-1] * 1e6
        rows.append([f"{cells} × {cells}, {step} ms", f"{sunk:.4f} ({static})",
                     f"{np.polyval(parabola, at):.4f} ({peak})", f"{t[top] + at:.3f}"])
    return {"plate": table(["", "static, mm", "largest, mm", "at, s"], rows)}


def ball_facts(runner, pictures):
    """prm/drop_test.prm, and its sections."""
    results = biface.run(EXAMPLES / "drop_test.prm", {"Output/Write VTU": False},
                         runner.scratch / "drop_test", program=runner.program)
    bounce = results.stage("bounce")
    history = bounce.history
    t = (history["time"] - results.stage("inflation").history["time"][-1]) / MILLISECOND
    radius, pressure, mass = 110, 0.08, 0.43e-3
    velocity = 120 * history["momentum_y"] / mass  # of a sector of 3 degrees
    dissipated = 120 * (history["damping_work"][-1]
                        - results.stage("inflation").last("damping_work"))
    last = np.flatnonzero(history["contact_nodes"] > 0)[-1]
    section_after = [bounce.steps[0], bounce.steps[np.argmin(np.abs(t - 2))],
                     bounce.steps[history["pressure"].argmax()], bounce.steps[last + 1]]

    floor = section(results.stage("inflation"), None, "outer")[0].min()
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(1, 4, figsize=(11, 3.1), sharey=True)
    for a, step, color in zip(axes, section_after, shades(4)):
        for face in ("inner", "outer"):
            y, r = section(bounce, step, face)
            a.plot(np.append(-r, r[::-1]), np.append(y, y[::-1]) - floor, color=color,
                   linewidth=1.3)
        a.axhline(0, color="0.3", linewidth=1.5)
        a.set(aspect="equal", title=f"{t[bounce.steps == step][0]:.1f} ms",
              xlabel="radius (mm)")
    axes[0].set_ylabel("height (mm)")
    save(figure, pictures / "dynamics_ball.png")
    return {"ball_steps": str(len(history)), "ball_speed": f"{velocity[-1] / 1000:.2f}",
            "ball_rebound": f"{2 * (velocity[-1] / 6264)**2:.2f}",
            "ball_contact": f"{(t[last] + t[last + 1]) / 2:.1f}",
            "ball_formula": f"{1000 * np.pi * np.sqrt(mass / (2 * np.pi * radius * pressure)):.1f}",
            "ball_pressure": f"{history['pressure'].max() * 1000:.1f}",
            "ball_dissipated":
                f"{100 * dissipated / (mass * 6264**2 / 2):.0f}"}


def on_static_curve(deflection, force, mass, weight, velocity):
    """Contact time, largest deflection, its time, and the motion of a mass."""
    motion = solve_ivp(lambda _, state: [state[1], (weight - np.interp(
        state[0], deflection, force)) / mass], (0, 0.06), [0, velocity], max_step=5e-5,
                       events=lambda _, state: state[0] + 1e-9)
    motion.events = motion.t_events[0]
    leaves = motion.events[motion.events > 1e-3][0]
    deepest = motion.y[0].argmax()
    return leaves, motion.y[0][deepest], motion.t[deepest], motion


def tire_facts(runner, pictures):
    """prm/tire_drop.prm beside a mass on the static curve of its force."""
    file, velocity, weight, rim = EXAMPLES / "tire_drop.prm", 990, 98.1, 0.01
    quiet = {"Output/Write VTU": False}
    static = biface.run(file, {**quiet, "Stage 2/Inertia": False, "Stage 2/Initial velocity": "",
                               "Stage 2/Stiffness damping": 0, "Stage 2/Duration": 0,
                               "Stage 2/Time step": "Duration/Steps",
                               "Stage 2/Forces on bodies": "", "Stage 2/Load factor": 15,
                               "Stage 2/Steps": 30},
                        runner.scratch / "tire_static", program=runner.program)
    deflection = np.append(0, static.stage("bounce").history["alpha_1_min_displacement"])
    force = np.append(0, static.stage("bounce").history["force"])
    rows = []
    for damping in (2e-4, 5e-5):
        results = biface.run(file, {**quiet, "Stage 2/Stiffness damping": damping},
                             runner.scratch / f"tire_{damping}", program=runner.program)
        drop = results.stage("bounce")
        history = drop.history
        t = history["time"] / MILLISECOND
        sunk = history["alpha_1_min_displacement"]
        touching = np.flatnonzero(history["force"] > 0)[-1]
        mean = -drop.forces().where(body="foundation")["F_x"]
        total = energy(history)[0]
        rows.append([f"biface, `Stiffness damping = {damping * 1000:g}` ms",
                     f"{(t[touching] + t[touching + 1]) / 2:.1f}", f"{sunk.max():.2f}",
                     f"{t[sunk.argmax()]:.1f}", f"{mean.max():.0f}"])
        if damping == 2e-4:
            shown, facts = (np.append(0, t), mean, sunk), {
                "tire_steps": str(len(history)),
                "tire_error": small(np.abs(history["energy_error"]).max() / total)}
    tire = 1.764e-3
    for mass, label in ((rim, "rim alone"), (rim + tire, "rim and tire")):
        leaves, depth, at, motion = on_static_curve(deflection, force, mass, weight, velocity)
        rows.append([f"static curve, {label}, {1000 * mass:.2f} kg",
                     f"{leaves / MILLISECOND:.1f}", f"{depth:.2f}", f"{at / MILLISECOND:.1f}",
                     f"{np.interp(depth, deflection, force):.0f}"])

    plt.rcParams.update(STYLE)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.6), gridspec_kw={"wspace": 0.25})
    times, mean, sunk = shown
    left.stairs(mean, times, color=BLUE, linewidth=1.3)
    right.plot(times, np.append(0, sunk), color=BLUE)
    on = motion.t < leaves
    left.plot(motion.t[on] / MILLISECOND, np.interp(motion.y[0][on], deflection, force),
              color=GRAY, linewidth=0.9)
    right.plot(motion.t / MILLISECOND, motion.y[0], color=GRAY, linewidth=0.9)
    left.set(xlabel="time (ms)", ylabel="force of the ground (N)", xlim=(0, 50), ylim=(0, None))
    right.set(xlabel="time (ms)", ylabel="deflection (mm)", xlim=(0, 50))
    save(figure, pictures / "dynamics_tire.png")
    return {"tire": table(["", "contact, ms", "deflection, mm", "at, ms", "largest force, N"],
                          rows), **facts}


def limits_of_steps(runner):
    """Steps that are too long for the iteration are halved."""
    panel = runner.run("panel_0.2", panel_entries(0.2 * MILLISECOND), may_stop=True)
    strip = runner.run("strip_0.5", strip_entries(0.5 * MILLISECOND), may_stop=True)
    return {"panel_steps": str(len(panel.history)), "strip_steps": str(len(strip.history))}


def main():
    arguments = parse_arguments("dynamics", __doc__)
    runner, pictures = Runner(arguments), arguments.output / "figures"
    (arguments.output / "dynamics.md").write_text(PAGE.format(
        **strip_table(runner, pictures), **panel_table(runner), **ring_tables(runner, pictures),
        **adaptive_table(runner), **torus_table(runner), **vibration_table(runner),
        **cap_table(runner, pictures), **roof_tables(runner, pictures), **plate_table(runner),
        **ball_facts(runner, pictures), **tire_facts(runner, pictures), **limits_of_steps(runner)))


if __name__ == "__main__":
    main()
