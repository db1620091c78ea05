#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write frequency_response.md and its pictures: the steady response to harmonic
excitations and the air in a tire, beside formulas and runs in time."""

import math
import sys
from pathlib import Path

import numpy as np
from matplotlib import pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import ROOT, Runs, biface, parse_arguments, table
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

PAGE = """<!-- Written by doc/frequency_response/frequency_response.py: cmake --build build --target frequency_response -->

# Frequency response

At the end of a stage, `Frequency response` computes the steady vibration about the loaded shell, standing or rolling,
that harmonic forces or motions cause. [shaker.prm](../prm/shaker.prm), a tire shaken on its footprint, is an example.

    build/biface prm/shaker.prm

```
subsection Stage 2
  set Contact            = true
  set Travel             = 20
  set Frequency response = 0:300:121                         # first:last:number, in Hz
  set Excitations        = ground x, ground z, supports x, load factor
  set Loss factor        = 0                                 # of the whole stiffness
end
```

- **What shakes**: motions by 1 of the ground, of one of the `Bodies`, or of all supports together (the wheel), along x, y or z; or loads: `pressure`,
  `load factor` or one of the names of `Load factors`, by 1, with what they prescribe at supports. Each is a response of its own.
- **What is measured**: [response.csv](output.md#responsecsv) has the complex amplitudes of the `Named points` and of the forces of supports, bodies and the
  air in a tire. The real part is in phase with the excitation, the imaginary part a quarter of a period earlier.
- **Losses**: `Loss factor` of a material, as for rolling resistance, or of the stage, for everything; the complex modulus of `Relaxation times`;
  `Mass damping` and `Stiffness damping` as in time. Without any, a resonance is infinite.
- **At the frequency 0** the response is the derivative of the equilibrium: of the forces by the travel of the ground, for example, with the nodes that are in contact.

The equations are solved at each frequency, without modes; see [theory.md](theory.md#frequency-response).

## A bar

A bar of {bar_length} m (E = 70000 MPa, loss factor 0.1, 80 cells), clamped and pulled at its end by 10 N, beside $`u=F\\tan(kL)/(EAk)`$ with the complex modulus and $`k=\\omega\\sqrt{{\\varrho/E}}`$:

{bar}

## A tire on a shaker

![Magnitude and phase of the force on the wheel over the frequency, vertical and fore-aft, with and without the waves of the air](figures/frequency_response_shaker.png)

*prm/shaker.prm: the force on the wheel, of the beads and of the air, if the ground moves by 1 mm up and down (x) and to and fro (z), with the waves of the air and without its inertia.*

Below 150 Hz the tire is a spring between the ground and the fixed wheel. The air adds a sharp peak at {peak_x:.0f} Hz for the vertical and at {peak_z:.0f} Hz for
the fore-aft motion, and it reaches the wheel directly, as a pressure on the rim.

The same force in time: a stage with inertia in which the ground shakes the tire (without the inertia of the air, coarser mesh, `Stiffness damping` of 0.4 ms, 40 steps in a
period), from the last two periods; a step in time changes the frequency to $`\\tan(\\pi f\\,\\Delta t)/(\\pi\\,\\Delta t)`$ and measures the mean force of a step, which is smaller
by $`\\cos(\\pi f\\,\\Delta t)`$; both are taken into account.

{transient}

## The air in a tire

With `Gas/Sound speed`, the air is a column along the circumference with plane waves, whose area is that of the deformed section and whose pressure acts on the wall
and on the rim. They are part of `Modes` (`part_of_air` in [modes.csv](output.md#modescsv) is their part of the kinetic energy) and of the frequency response.
In a rigid torus, the frequencies are those of the formula to {rigid_error} ({rigid:.2f} Hz on 40 cells, beside {rigid_formula:.2f} Hz).

The load makes the section small at the footprint and splits the first wave into one to and fro, whose pressure vanishes there, and a vertical one. The tire of
shaker.prm on 60 even cells around (sound at 343 m/s, 0.15 MPa):

{split}

Measured on passenger car tires, the splits at the rated load are 4 to 14 Hz, with the fore-aft mode below the vertical one, and nearly proportional to the square of the
load @cite ChoiBolton2020 . That of this bias tire, which is softer and flattens more, grows with about the power {power} of the load. Modes of the wall next to the waves exchange energy with them and move them by some Hz; the table has the two modes with
most of the air's energy.

![Frequencies of the first wave of the air over the load](figures/frequency_response_split.png)

*The two modes in which the air has the largest part of the kinetic energy.*

## Limits

- The nodes in contact stay in contact, and with friction they stick, as for `Modes`; a wheel that rolls slips by its slip velocity. There is no response with bristles, to other bodies
  than the ground while a wheel rolls, or with plies that relax in a wheel that rolls.
- Ground, bodies and wheel move without rotation. A force is the sum over the model: half a tire has half of it. Moments are not computed.
- The air: shells of revolution with a rim, standing and held; plane waves along the circumference, without those across the section (above some 1000 Hz in a car tire) and without the inertia of the air
  across it; no losses of its own.
"""

BAR = {"Materials": "metal", "Material metal/Type": "isotropic", "Material metal/E": 70000,
       "Material metal/nu": 0, "Material metal/Density": 2.7e-9,
       "Material metal/Loss factor": 0.1, "Surface/Type": "plane",
       "Mesh/Intervals alpha_1": "0:1000:80", "Mesh/Intervals alpha_2": "0:10:1",
       "Mesh/Closed in alpha_2": False, "Laminate/Plies": "metal: 2 @ 0",
       "Laminate/Reference surface": "middle", "Supports/alpha_1 min": "fixed",
       "Named points": "end: 1000 10", "Loads/Edge forces": "alpha_1 max: 1 0 0",
       "Stage 1/Load factor": 0, "Stage 1/Frequency response": "0, 500, 1000, 1270, 2000",
       "Stage 1/Excitations": "load factor"}


def response(results):
    """The frequencies, and by (excitation, output, kind) the complex amplitudes:
    rows of x, y, z."""
    rows = np.genfromtxt(results.directory / "response.csv", delimiter=",", names=True,
                         dtype=None, encoding="utf-8")
    found = {}
    for row in rows:
        key = row["excitation"], row["output"], row["kind"]
        found.setdefault(key, []).append(
            [row["frequency"]] + [complex(row[f"{i}_real"], row[f"{i}_imaginary"]) for i in "xyz"])
    found = {key: np.array(values) for key, values in found.items()}
    frequencies = next(iter(found.values()))[:, 0].real
    return frequencies, {key: values[:, 1:] for key, values in found.items()}


def on_wheel(found, excitation):
    """The force on the wheel: against those of the beads on the shell and of the rim
    on the air."""
    force = -(found[excitation, "alpha_1 min", "force"] + found[excitation, "alpha_1 max", "force"])
    air = found.get((excitation, "rim on air", "force"))
    return force if air is None else force - air


def bar_table(runs):
    file = runs.scratch / "bar.prm"
    biface.write_parameters(file, {"Output/Write VTU": False, **BAR})
    frequencies, found = response(biface.run(file, {}, runs.scratch / "bar", program=runs.program))
    rows = []
    for frequency, u in zip(frequencies, found["load factor", "end", "outer"][:, 0]):
        modulus, k = 70000 * (1 + 0.1j), 0
        exact = 10 * 1000 / (modulus * 20)
        if frequency > 0:
            k = 2 * np.pi * frequency * np.sqrt(2.7e-9 / modulus)
            exact = 10 * np.tan(k * 1000) / (modulus * 20 * k)
        rows.append([f"{frequency:g}", f"{1000 * u.real:.4f} {1000 * u.imag:+.4f} i",
                     f"{1000 * exact.real:.4f} {1000 * exact.imag:+.4f} i",
                     f"{abs(u / exact - 1):.0e}"])
    return {"bar": table(["frequency, Hz", "displacement, μm", "formula", "deviation"], rows),
            "bar_length": "1"}


def shaker(runs, pictures):
    results = runs.run("shaker", "shaker.prm", {"Output/Points per ply": 0})
    without = runs.run("shaker_without_air", "shaker.prm",
                       {"Gas/Sound speed": "none", "Output/Points per ply": 0,
                        "Stage 1/Modes": 0, "Stage 2/Excitations": "ground x, ground z"})
    frequencies, found = response(results)
    _, light = response(without)
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(2, 2, figsize=(8.2, 5), sharex=True, layout="constrained",
                                height_ratios=[1.5, 1])
    peaks = {}
    for i, (axis, name) in enumerate((("x", "vertical"), ("z", "fore-aft"))):
        for values, color, label in ((light, GRAY, "air without inertia"), (found, BLUE, "with waves of the air")):
            force = on_wheel(values, f"ground {axis}")[:, "xyz".index(axis)]
            # the reaction is opposite to the motion of a spring
            axes[0, i].semilogy(frequencies, np.abs(force), color=color, label=label, linewidth=1.4)
            axes[1, i].plot(frequencies, np.degrees(np.unwrap(np.angle(force))), color=color,
                            linewidth=1.4)
        air = np.abs(found[f"ground {axis}", "rim on air", "force"][:, "xyz".index(axis)])
        peaks[axis] = frequencies[air.argmax()]
        axes[0, i].set_title(name)
        axes[1, i].set(xlabel="frequency (Hz)", xlim=(0, 300))
    axes[0, 0].set_ylabel("force on the wheel (N/mm)")
    axes[1, 0].set_ylabel("phase (degrees)")
    axes[0, 0].legend(fontsize=9)
    save(figure, pictures / "frequency_response_shaker.png")
    return {"peak_x": peaks["x"], "peak_z": peaks["z"]}


def transient_table(runs):
    """Runs in time until the vibration is steady."""
    damping, amplitude, rows = 4e-4, 1e-3, []
    mesh = {"Mesh/Intervals alpha_1": "-120:-45:5, -45:45:8, 45:120:5",
            "Mesh/Intervals alpha_2": "-180:-30:6:smooth, -30:30:8, 30:180:6:smooth",
            "Gas/Sound speed": "none", "Output/Points per ply": 0, "Material cord/Loss factor": 0,
            "Newton/Residual tolerance": 1e-10, "Stage 1/Modes": 0}
    for frequency, periods in ((30, 5), (75, 12), (140, 18)):
        step = 1 / frequency / 40
        shifted = math.tan(math.pi * frequency * step) / (math.pi * step)
        results = runs.run(f"shaken_{frequency}", "shaker.prm", {
            **mesh, "Number of stages": 3, "Stage 2/Stiffness damping": damping,
            "Stage 2/Frequency response": repr(shifted), "Stage 2/Excitations": "ground x",
            "Stage 3/Contact": True, "Stage 3/Inertia": True, "Stage 3/Name": "shaken",
            "Stage 3/Duration": periods / frequency, "Stage 3/Time step": step,
            "Stage 3/Time error": 0, "Stage 3/Stiffness damping": damping,
            "Stage 3/Load history": f"travel: 20 + {amplitude}*sin(2*pi*{frequency}*t)"})
        _, found = response(results)
        # travel is against x
        expected = -found["ground x", "foundation", "force"][0, 0]
        forces = results.forces()
        forces = forces.where((forces["body"] == "foundation") & (forces["stage"] == "shaken"))["F_x"]
        t = (np.arange(len(forces)) + 0.5) * step
        last = t > t[-1] - 2 / frequency
        waves = np.stack([np.sin(2 * np.pi * frequency * t), np.cos(2 * np.pi * frequency * t),
                          np.ones_like(t)], -1)[last]
        sine, cosine, _ = np.linalg.lstsq(waves, forces[last], rcond=None)[0]
        measured = complex(sine, cosine) / amplitude / math.cos(math.pi * frequency * step)
        rows.append([f"{frequency}", f"{abs(measured):.2f}, {np.degrees(np.angle(measured)):.2f}°",
                     f"{abs(expected):.2f}, {np.degrees(np.angle(expected)):.2f}°",
                     f"{100 * abs(measured / expected - 1):.2f} %"])
    return {"transient": table(["frequency, Hz", "in time, N/mm", "response, N/mm", "difference"],
                               rows)}


def rigid_torus(runs):
    """The first wave in a rigid torus."""
    stiff = {"Material cord/E_L": 1e8, "Material cord/E_T": 1e7, "Material cord/G_LT": 5e6,
             "Material cord/G_TT": 3e6, "Material cord/Density": 1e-12}
    results = runs.run("rigid", "tire_modes.prm", {
        **stiff, "Gas/Ambient pressure": 0.1, "Gas/Sound speed": 343000, "Number of stages": 1,
        "Stage 1/Modes": 2, "Stage 1/Pressure": 0.1})
    psi = np.radians(np.linspace(-120, 120, 100001))
    r, z = 200 + 50 * np.cos(psi), 50 * np.sin(psi)
    middle = (r[1:] + r[:-1]) / 2
    of_inverse = np.sum(np.log(middle / r[0]) * np.diff(z))
    of_radius = np.sum((middle**2 - r[0]**2) / 2 * np.diff(z))
    formula = 343000 / (2 * np.pi) * np.sqrt(of_inverse / of_radius)
    found = results.modes()["frequency"][0]
    return {"rigid": found, "rigid_formula": formula,
            "rigid_error": f"{100 * abs(found / formula - 1):.1f} %"}


def split(runs, pictures):
    """The first wave of the air in a tire under loads."""
    travels = (5, 10, 15, 20, 25, 30)
    # an even mesh, which does not split anything
    entries = {"Mesh/Intervals alpha_2": "-180:180:60", "Number of stages": 1 + len(travels),
               "Stage 1/Modes": 16, "Output/Points per ply": 0}
    for i, travel in enumerate(travels):
        for name, value in {"Name": f"{travel} mm", "Contact": True, "Travel": travel, "Steps": 1,
                            "Modes": 20, "Frequency response": "", "Excitations": ""}.items():
            entries[f"Stage {i + 2}/{name}"] = value
    results = runs.run("split", "shaker.prm", entries)
    modes = results.modes()
    rows, drawn = [], []
    for travel in (0, *travels):
        stage = f"{travel} mm" if travel else "inflated"
        of_stage = modes.where(modes["stage"] == stage)
        best = np.argsort(of_stage["part_of_air"])[-2:]
        f, part = np.array(of_stage["frequency"])[best], np.array(of_stage["part_of_air"])[best]
        order = np.argsort(f)
        f, part = f[order], part[order]
        load = results.stage(stage).last("force") if travel else 0
        drawn.append((load, f, part))
        rows.append([f"{travel}", f"{load:.0f}", f"{f[0]:.2f} ({100 * part[0]:.0f} %)",
                     f"{f[1]:.2f} ({100 * part[1]:.0f} %)", f"{f[1] - f[0]:.2f}"])
    first, last = drawn[3], drawn[-1]
    power = (math.log((last[1][1] - last[1][0]) / (first[1][1] - first[1][0]))
             / math.log(last[0] / first[0]))
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(figsize=(5.2, 3.4), layout="constrained")
    for i, (color, label) in enumerate(((BLUE, "vertical"), (RED, "to and fro"))):
        axes.plot([row[0] for row in drawn], [row[1][1 - i] for row in drawn], "o-", color=color,
                  label=label)
    axes.set(xlabel="load (N)", ylabel="frequency (Hz)")
    axes.legend(fontsize=9)
    save(figure, pictures / "frequency_response_split.png")
    return {"power": f"{power:.1f}", "split": table(["travel, mm", "load, N", "to and fro, Hz (part of the air)",
                            "vertical, Hz", "split, Hz"], rows)}


def main():
    arguments = parse_arguments("frequency_response", __doc__)
    runs, pictures = Runs(arguments), arguments.output / "figures"
    (arguments.output / "frequency_response.md").write_text(PAGE.format(
        **bar_table(runs), **shaker(runs, pictures), **transient_table(runs), **rigid_torus(runs),
        **split(runs, pictures)))


if __name__ == "__main__":
    main()
