#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write design.md and its pictures from runs and studies of the bias tire."""

import argparse
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np

from even_footprint import RANGES, SAMPLES, optimize, read

PAGE = """<!-- Written by doc/design/design.py: cmake --build build --target design -->

# From a tire to a better one

The bias tire of [bias_tire.md](bias_tire.md) carries its load. A designer asks next:
how does it vibrate, when does it buckle, what matters most, what if everything varies a
little, and what should change? Each answer below is one command; the target `design`
runs them all and writes this page.

## How does it vibrate?

    build/biface prm/tire_modes.prm

`Modes` of a stage, and a `Density` of the material, give the natural frequencies of the
shell as it stands: unloaded, inflated to 0.15 MPa, and pressed on the ground by 20 mm.

![Natural frequencies of the unloaded, the inflated and the pressed tire](design/modes.png)

The tension of the cords raises the lowest frequency from {unloaded} to {inflated} Hz.
The inflated tire is round, and its modes come in pairs; the ground splits them. See
[output.md](output.md#modescsv) for the file, and the report for pictures of the shapes.

## When does it buckle?

A tire is not made for a vacuum. With the inflation alone, `Pressure = -1e-4` and
`Buckling = 4`, the program predicts from this small part of the load at which multiples
of it the tire buckles:

{buckling}

The first shape has no wave around the tire.

[laminated_cylinder.prm](../prm/laminated_cylinder.prm) shows the two ways together: a
prediction from a small load, and `Critical points = locate` on the path.

## What matters most?

    subsection Sensitivities
      set Entries = pressure: Stage 1/Pressure, Stage 2/Pressure; \\
                    angle: Laminate/Plies[2], -Laminate/Plies[4], \\
                           Laminate/Plies[6], -Laminate/Plies[8]; \\
                    cords: Material cord/E_L; \\
                    rubber: factor of Material cord/G_LT, Material cord/G_TT; \\
                    profile: Surface/Circular arc/Radius; \\
                    approach: Stage 2/Travel
      set Outputs = force, mean_pressure, footprint_length, max_fiber_tension
    end

This section, appended to `bias_tire.prm`, lists numbers of the same file and results. The
program adds the derivative of each result by each number, for one linear system per
number with the factors at hand, see section 11 of [theory.md](theory.md). The whole
loading follows: the plane touches the inflated tire elsewhere if the profile changes.

    build/biface my_tire.prm
    build/biface-report output

![Logarithmic derivatives of force, mean pressure, footprint length and largest cord tension](design/sensitivities.png)

*Logarithmic derivatives of the tire pressed by 20 mm: the change in percent for one
percent more of an entry. `angle` turns all plies, `cords` is their modulus `E_L`, `rubber`
their two shear moduli, `profile` the radius of the meridian.*

## What if everything varies?

    mpirun -n 2 build/biface --study prm/study_of_footprint.prm
    build/biface-report study

Cord angle, profile, pressure and the modulus of the cords vary at random within their
ranges in 200 tires, each inflated and pressed on the ground by 20 mm (see
[studies.md](studies.md)).

![Change of the outputs over the range of each variable](design/effects.png)

*The change of each output as one variable goes through its range, with the others in
the middle, from the report.*

{study}

The pressure decides on the force, and the cord angle on the size of the footprint; a
larger radius of the profile lowers the maximum of the pressure.

## What should change?

Which cord angle and which radius of the profile make the pressure of the footprint most
even, at a force of {force} N? The unevenness is the standard deviation of the pressure,
weighted by the force that it carries, relative to its mean: zero if all the ground that
carries is under the same pressure. [even_footprint.py](design/even_footprint.py) is an
optimizer outside of the program: it writes a study file, runs it, reads the table and
the pressures, and lets SciPy choose the next samples. A study keeps all cores busy and
starts each sample from its neighbor.

![Unevenness of the samples over cord angle and radius, with the fitted polynomial](design/even.png)

*Dots: {samples} samples of the first study, and as many of the second one around the
minimum of the first. Lines: the polynomial fitted to the first. Cross: the best
design; ring: the base design.*

{best}

The samples of the second study deviate from its polynomial by {deviation} (standard
deviation), as nodes enter and leave the footprint one by one. Derivatives at a single
design hold the nodes in contact fixed and cannot know of this; the optimizer, SciPy's
L-BFGS-B, gets those of the polynomial instead, which averages over many samples. No
derivatives by the program were used.
"""


def table(rows):
    """A table in Markdown; the first column is text."""
    lines = [rows[0], ["---"] + ["---:"] * (len(rows[0]) - 1)] + rows[1:]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


class Pages:
    """Runs the program, and writes pictures."""

    def __init__(self, arguments):
        self.program = arguments.program
        self.prm = arguments.prm
        self.scratch = arguments.scratch
        self.pictures = arguments.output / "design"
        self.pictures.mkdir(parents=True, exist_ok=True)

    def run(self, name, file, *settings):
        """Runs a parameter file; returns the directory of the results."""
        directory = self.scratch / name
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([self.program, "--quiet", "--output", directory, *words,
                        file], check=True)
        return directory

    def save(self, figure, name):
        """Writes a picture."""
        figure.savefig(self.pictures / f"{name}.png", dpi=110,
                       bbox_inches="tight", metadata={"Software": None})

    def modes(self, plt):
        """The chart of frequencies; returns the lowest ones."""
        directory = self.run("modes", self.prm / "tire_modes.prm",
                             "Output/Write VTU=false")
        lines = read(directory / "modes.csv")
        figure, axes = plt.subplots(figsize=(7, 2.6))
        names = list(dict.fromkeys(line["stage"] for line in lines))
        for row, name in enumerate(names):
            values = [float(line["frequency"]) for line in lines
                      if line["stage"] == name]
            axes.plot(values, [row] * len(values), "|", markersize=22,
                      markeredgewidth=1.6)
        axes.set_yticks(range(len(names)), names)
        axes.set(xlabel="frequency, Hz", ylim=(-0.6, len(names) - 0.4),
                 xlim=(0, None))
        axes.invert_yaxis()
        self.save(figure, "modes")
        return {name: "{:.1f}".format(min(
            float(line["frequency"]) for line in lines if line["stage"] == name))
            for name in names}

    def buckling(self):
        """The table of buckling loads under a vacuum."""
        text = (self.prm / "bias_tire.prm").read_text(encoding="utf-8")
        # the inflation only
        text = re.sub(r"^subsection Stage 2$.*?^end$", "", text,
                      flags=re.MULTILINE | re.DOTALL)
        file = self.scratch / "vacuum.prm"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        directory = self.run("vacuum", file, "Number of stages=1",
                             "Stage 1/Pressure=-1e-4", "Stage 1/Buckling=4",
                             "Element/Strain sampling=means",
                             "Output/Write VTU=false")
        rows = [["Shape", "pressure, MPa", "waves around the tire"]]
        for line in read(directory / "buckling.csv"):
            rows.append([line["mode"], f"{float(line['pressure']):.4f}".replace(
                "-", "−"), line["circumferential_waves"]])
        return table(rows)

    def sensitivities(self, plt):
        """The tornado chart of the tire on the ground."""
        from biface_report import sensitivities as report
        from biface_report.results import Run
        directory = self.run(
            "sensitivities", self.prm / "bias_tire.prm",
            "Contact/Multiplier mass=lumped", "Stage 2/Steps=2",
            "Newton/Residual tolerance=1e-11", "Output/Write VTU=false",
            "Sensitivities/Entries=pressure: Stage 1/Pressure, Stage 2/Pressure; "
            "angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
            "-Laminate/Plies[8]; cords: Material cord/E_L; rubber: factor of "
            "Material cord/G_LT, Material cord/G_TT; profile: Surface/Circular arc/Radius; "
            "approach: Stage 2/Travel",
            "Sensitivities/Outputs=force, mean_pressure, footprint_length, "
            "max_fiber_tension")
        self.save(report.draw(report.bars_of(Run(directory).sensitivities())),
                  "sensitivities")
        plt.close("all")

    def study(self, plt, ranks):
        """The chart of main effects; returns a sentence on the cost."""
        from biface_report import study as report
        from biface_report.drawing import Picture
        directory = self.scratch / "study"
        subprocess.run([*ranks, self.program, "--study", "--quiet", "--output",
                        directory, self.prm / "study_of_footprint.prm"], check=True)
        study = report.Study(directory)
        drawn = []
        report.embed = lambda figure, kind="svg": (drawn.append(figure),
                                                   Picture("", 0))[1]
        report.main_effects(study)
        self.save(drawn[0], "effects")
        plt.close("all")
        log = (directory / "study.log").read_text(encoding="utf-8")
        done = re.search(r"([0-9.]+) s, groups busy for ([0-9.]+) %", log)
        return textwrap.fill(f"The {len(study.status)} tires took {float(done.group(1)):.0f} s on "
                f"two ranks, which were busy for {done.group(2)} % of that time, "
                "on a machine of two cores that had other work, too.", 88)

    def even(self, plt, ranks):
        """The map of the unevenness; returns the text on the best design, and the
        deviation of samples from the polynomial."""
        rounds, single = optimize(self.program, self.prm / "bias_tire.prm",
                                  self.scratch, ranks)
        fit = rounds[0][2]
        figure, axes = plt.subplots(figsize=(6, 4.4))
        x, y = (np.linspace(*RANGES[name], 60) for name in ("angle", "radius"))
        z = [[fit((a, b)) for a in x] for b in y]
        contours = axes.contour(x, y, z, 10, cmap="viridis", linewidths=1)
        axes.clabel(contours, fontsize=8)
        for _, lines, _, _ in rounds:
            axes.scatter([float(line["angle"]) for line in lines],
                         [float(line["radius"]) for line in lines], s=18,
                         c=[line["unevenness"] for line in lines], cmap="viridis",
                         vmin=np.min(z), vmax=np.max(z))
        best = rounds[-1][3]
        axes.plot(*best, "x", color="#c0392b", markersize=11, markeredgewidth=3,
                  clip_on=False, zorder=5)
        axes.plot(52, 50, "o", color="#c0392b", markersize=10, fillstyle="none",
                  markeredgewidth=2)
        axes.set(xlabel="cord angle, degrees", ylabel="radius of the profile, mm")
        self.save(figure, "even")
        rows = [["Design", "angle", "radius, mm", "unevenness", "approach, mm",
                 "mean pressure, MPa"]]
        for name, line in single.items():
            rows.append([name, f"{float(line['angle']):.1f}°",
                         f"{float(line['radius']):.1f}",
                         f"{line['unevenness']:.3f}",
                         f"{float(line['approach']):.2f}",
                         f"{float(line['mean_pressure']):.4f}"])
        values = [f"{fit(best):.3f}" for _, _, fit, best in rounds]
        text = (textwrap.fill(f"The polynomials have their minima, {values[0]} and {values[1]}, at "
                + " and ".join("{:.1f}° and {:.1f} mm".format(*point)
                               for _, _, _, point in rounds)
                + ". Single runs of the base design and of the best one:", 88)
                + "\n\n" + table(rows)
                + "\n\n" + textwrap.fill("The unevenness falls by {:.0f} %.".format(
                    100 - 100 * single["best"]["unevenness"]
                    / single["base"]["unevenness"])
                + (" The best design lies on the bounds of the ranges: it is they "
                   "that limit the gain." if any(
                       value in RANGES[name] for name, value in
                       zip(RANGES, best)) else ""), 88))
        return text, f"{rounds[-1][2].deviation:.3f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--prm", type=Path, required=True)
    parser.add_argument("--report", type=Path, required=True,
                        help="the folder of the package biface_report")
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True,
                        help="where to write design.md")
    parser.add_argument("--mpirun", default="mpirun -n 2")
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.report))
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from biface_report.drawing import STYLE
    plt.rcParams.update(STYLE)

    ranks = arguments.mpirun.split()
    pages = Pages(arguments)
    lowest = pages.modes(plt)
    buckling = pages.buckling()
    pages.sensitivities(plt)
    study = pages.study(plt, ranks)
    best, deviation = pages.even(plt, ranks)
    (arguments.output / "design.md").write_text(PAGE.format(
        unloaded=lowest["unloaded"], inflated=lowest["inflated"], buckling=buckling,
        study=study, force=1900, samples=SAMPLES, best=best, deviation=deviation),
        encoding="utf-8")


if __name__ == "__main__":
    main()
