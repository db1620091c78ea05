#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write design.md and its pictures from runs and studies of the bias tire."""

import argparse
import re
import resource
import sys
import textwrap
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, biface, table

import even_footprint as even
from biface_report import sensitivities as sensitivity_report
from biface_report import study as study_report
from biface_report.drawing import STYLE, Picture

PAGE = """<!-- Written by doc/design/design.py: cmake --build build --target design -->

# From a tire to a better one

The bias tire of [bias_tire.md](bias_tire.md) carries its load. A designer asks next:
how does it vibrate, when does it buckle, what matters most, what if everything varies a
little, and what should change? Each answer below is one command; the target `design`
runs them all and writes this page. In all of them the pressure follows the wall, as in
[bias_tire_true_pressure.prm](../prm/bias_tire_true_pressure.prm).

## How does it vibrate?

    build/biface prm/tire_modes.prm

`Modes` of a stage, and a `Density` of the material, give the natural frequencies of the
shell as it stands: unloaded, inflated to 0.15 MPa, and pressed on the ground by 20 mm.

![Natural frequencies of the unloaded, the inflated and the pressed tire](design/modes.png)

*The first ten modes. Numbers: waves around the axle, half waves along the meridian.
Wide bars: pairs of the same frequency.*

The tension of the cords raises the lowest frequency from {unloaded} to {inflated} Hz.
The inflated tire is round, and its modes come in pairs; the ground splits them. See
[output.md](output.md#modescsv) for the file, and the report for pictures of the shapes.

## When does it buckle?

A tire is not made for a vacuum. With the inflation alone, `Pressure = -1e-4` and
`Buckling = 4`, the program predicts from this small part of the load at which multiples
of it the tire buckles:

{buckling}

The first two shapes have no waves around the tire.

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

This section, appended to `bias_tire_true_pressure.prm`, lists numbers of the same file and
results. The program adds the derivative of each result by each number, for one linear
system per number with the factors at hand, see section 11 of [theory.md](theory.md). The
whole loading follows: the plane touches the inflated tire elsewhere if the profile
changes.

Each number has its own linear system, the direct way. The adjoint way, one transposed
system per result, would not pay: with twenty numbers and two results of the bias tire the
forty solutions of both stages take 6 % of the time of the derivatives, and the adjoint
way would save at most those of the last stage, since the stage before must be followed in
any case. The rest goes to the residuals of the perturbed runs, to their models, and to the
factorization that both ways need. For ten numbers and six results with six steps of the
loading, the derivatives take about a sixth of the run.

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
the middle of their ranges, from the report.*

[studies.md](studies.md#cost) has the time that this takes.

The pressure decides on the force, and the cord angle on the size of the footprint; a
larger radius of the profile lowers the maximum of the pressure.

## What should change?

Which cord angle and which radius of the profile make the pressure of the footprint most
even, at a force of {force} N, if the cords must not carry more than in the base design?
The measure is `weighted_pressure` of [history.csv](output.md#historycsv), the mean of the
pressure weighted by the force that it carries, $`\\int p^2/\\int p`$. At a given force it
is lowest if all of the ground carries the same, on as large an area as possible. The limit
is for `max_fiber_tension`, the largest force per width in a ply.

[even_footprint.py](design/even_footprint.py) is an optimizer outside of the program:
SciPy's SLSQP, sequential quadratic programming, which obeys bounds and a nonlinear limit.
A run takes seconds, so that starting the program costs nothing beside it, and the program
need not contain an optimizer. SLSQP asks for the derivatives of both functions, which a
run writes into [sensitivities.csv](output.md#sensitivitiescsv):

    subsection Sensitivities
      set Entries = angle: Laminate/Plies[2], -Laminate/Plies[4], \\
                           Laminate/Plies[6], -Laminate/Plies[8]; \\
                    radius: Surface/Circular arc/Radius
      set Outputs = weighted_pressure, max_fiber_tension
    end

The force is controlled (`Stage 2/Control = foundation force`), so that these are
derivatives at a given force. They agree with those of whole runs, by central differences:

{check}

![Weighted pressure over cord angle and radius, with the limit of the tension and the path of the optimizer](design/even.png)

*Lines: the weighted pressure, MPa, a polynomial fitted to the samples of a study (dots).
Dashed: the limit of the tension; it is met to the left. Ring: the base design. Red: the
path of the optimizer, which knows nothing of the study; cross: the best design.*

{best}

The `variation` of the table, `pressure_variation`, is the standard deviation of the
pressure relative to its mean, with the same weights. As an objective it is less smooth,
since it is a small difference of large numbers: nodes enter and leave the footprint one by
one, and derivatives, which hold the nodes in contact fixed, then differ from the trend.

## What does it cost?

One run of [tire_modes.prm](../prm/tire_modes.prm) on one rank, with all of it at the end
of the last stage, beside the mean of its four contact steps of 5 mm:

{cost}

Derivatives include two more models for each number, which follow all steps of the loading
that later ones read.
"""


def cpu_seconds():
    """The CPU time of all runs so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def draw_modes(modes):
    """A bar for each frequency, with its wave numbers; equal ones share a bar."""
    # the least distances of labels in a row, and of different frequencies
    label_width, same = 11, 1e-4
    figure, axes = plt.subplots(figsize=(8.5, 3.6))
    names = list(dict.fromkeys(modes["stage"]))
    for row, name in enumerate(names):
        bars = []
        for line in modes.where(stage=name).rows():
            frequency = line["frequency"]
            waves = (f"{line['circumferential_waves']:g}, "
                     f"{line['meridional_half_waves']:g}")
            if bars and frequency - bars[-1][0] < same * frequency:
                bars[-1][2] += 1
            else:
                bars.append([frequency, waves, 1])
        ends = []
        for frequency, waves, count in bars:
            level = next((i for i, end in enumerate(ends) if end <= frequency),
                         len(ends))
            ends[level:level + 1] = [frequency + label_width]
            axes.plot(2 * [frequency], [row - 0.22, row + 0.22],
                      color=f"C{row}", linewidth=2 if count == 1 else 4)
            axes.annotate(waves, (frequency, row - 0.22), (0, 2 + 12 * level),
                          textcoords="offset points", ha="center", va="bottom",
                          fontsize=9)
    axes.set_yticks(range(len(names)), names)
    axes.set(xlabel="frequency, Hz", ylim=(len(names) - 0.6, -0.85), xlim=(0, None))


class Pages:
    """Runs the program, and writes pictures."""

    def __init__(self, arguments):
        self.program = arguments.program
        self.scratch = arguments.scratch
        self.pictures = arguments.output / "design"
        self.pictures.mkdir(parents=True, exist_ok=True)

    def run(self, name, file, settings=None):
        """Runs a parameter file."""
        return biface.run(file, {"Output/Write VTU": False, **(settings or {})},
                          self.scratch / name, program=self.program)

    def save(self, figure, name):
        """Writes a picture."""
        figure.savefig(self.pictures / f"{name}.png", dpi=110,
                       bbox_inches="tight", metadata={"Software": None})

    def modes(self):
        """The chart of frequencies; returns the lowest ones."""
        modes = self.run("modes", EXAMPLES / "tire_modes.prm").modes()
        draw_modes(modes)
        self.save(plt.gcf(), "modes")
        return {name: f"{modes.where(stage=name)['frequency'].min():.1f}"
                for name in modes["stage"]}

    def buckling(self):
        """The table of buckling loads under a vacuum."""
        text = (EXAMPLES / "bias_tire_true_pressure.prm").read_text(encoding="utf-8")
        # the inflation only
        text = re.sub(r"^subsection Stage 2$.*?^end$", "", text,
                      flags=re.MULTILINE | re.DOTALL)
        file = self.scratch / "vacuum.prm"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        buckling = self.run("vacuum", file, {
            "Number of stages": 1, "Stage 1/Pressure": -1e-4, "Stage 1/Buckling": 4,
            "Formulation": "standard"}).buckling()
        return table(["Shape", "pressure, MPa", "waves around the tire"], [
            [f"{line['mode']:g}", f"{line['pressure']:.4f}".replace("-", "−"),
             f"{line['circumferential_waves']:g}"] for line in buckling.rows()])

    def sensitivities(self):
        """The tornado chart of the tire on the ground."""
        results = self.run(
            "sensitivities", EXAMPLES / "bias_tire_true_pressure.prm", {
                "Contact/Multiplier mass": "lumped", "Stage 2/Steps": 2,
                "Newton/Residual tolerance": 1e-11,
                "Sensitivities/Entries":
                "pressure: Stage 1/Pressure, Stage 2/Pressure; "
                "angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
                "-Laminate/Plies[8]; cords: Material cord/E_L; rubber: factor of "
                "Material cord/G_LT, Material cord/G_TT; profile: "
                "Surface/Circular arc/Radius; approach: Stage 2/Travel",
                "Sensitivities/Outputs":
                "force, mean_pressure, footprint_length, max_fiber_tension"})
        self.save(sensitivity_report.draw(
            sensitivity_report.bars_of(results.sensitivities())), "sensitivities")
        plt.close("all")

    def cost(self):
        """The table of times relative to a contact step."""
        results = self.run("cost", EXAMPLES / "tire_modes.prm", {
            "Stage 1/Modes": 0, "Stage 2/Modes": 0, "Stage 3/Modes": 10,
            "Stage 3/Buckling": 2,
            "Sensitivities/Entries": "Stage 2/Pressure; Stage 3/Travel; "
            "Laminate/Plies[2]; Laminate/Plies[4]; Material cord/E_L; "
            "Material cord/E_T; Material cord/G_LT; Material cord/G_TT; "
            "Surface/Circular arc/Radius; Contact/Regularization",
            "Sensitivities/Outputs": "force, mean_pressure, max_pressure, "
            "footprint_length, footprint_area, max_fiber_tension"})
        steps = results.history["seconds"][results.history["approach"] > 0]
        log = (results.directory / "run.log").read_text(encoding="utf-8")
        rows = []
        for section, what in [("Modes", "ten modes"),
                              ("Buckling", "two buckling loads"),
                              ("Sensitivities",
                               "derivatives of six results by ten numbers")]:
            seconds = float(re.search(
                rf"\| {section} +\| +[0-9]+ \| +([0-9.e+-]+)s", log).group(1))
            rows.append([what, f"{seconds / np.mean(steps):.1f}"])
        return table(["", "contact steps"], rows)

    def study(self, ranks):
        """The chart of main effects."""
        study = biface.run_study(EXAMPLES / "study_of_footprint.prm",
                                 output=self.scratch / "study", ranks=ranks,
                                 program=self.program)
        drawn = []
        study_report.embed = lambda figure, kind="svg": (drawn.append(figure),
                                                         Picture("", 0))[1]
        study_report.main_effects(study)
        self.save(drawn[0], "effects")
        plt.close("all")

    def even(self, ranks):
        """The map of the objective with the path of the optimizer; returns the
        tables of derivatives and of designs."""
        base = EXAMPLES / "bias_tire_true_pressure.prm"
        tires, points, runs, seconds = {}, {}, {}, {}
        for key in (True, False):
            start = cpu_seconds()
            tires[key] = even.tire(self.program, base, self.scratch / f"even_{key}",
                                   key)
            points[key] = even.optimize(tires[key], key)
            runs[key], seconds[key] = len(tires[key].runs), cpu_seconds() - start
        path = list(tires[True].runs)
        check = [[f"`{name}`", entry, f"{own:.6f}".replace("-", "−"),
                  f"{other:.6f}".replace("-", "−")]
                 for name, entry, own, other in even.check(tires[True], tires[False])]
        self.draw_even(path, even.sample(self.program, base, self.scratch / "even",
                                         ranks))

        header = ["Design", "angle", "radius, mm", "weighted pressure, MPa",
                  "mean pressure, MPa", "variation", "tension, N/mm", "approach, mm"]
        rows, results = [], []
        for name, point in (("base", even.BASE.values()), ("best", points[True])):
            angle, radius = point
            results.append(tires[True].results(point).history.row(-1))
            rows.append([name, f"{angle:.2f}°", f"{radius:.2f}"] + [
                f"{results[-1][column]:.{digits}f}" for column, digits in
                ((even.OBJECTIVE, 4), ("mean_pressure", 4),
                 ("pressure_variation", 3), (even.LIMITED, 3), ("approach", 2))])
        gains = [100 - 100 * results[1][name] / results[0][name]
                 for name in (even.OBJECTIVE, "pressure_variation")]
        on_bound = " and ".join(
            name for name, value in zip(even.RANGES, points[True])
            if min(abs(value - end) for end in even.RANGES[name]) < 1e-3)
        apart = np.max(np.abs(points[True] - points[False])
                       / np.diff(list(even.RANGES.values()))[:, 0])
        text = (
            f"The optimizer needs {runs[True]} runs ({seconds[True]:.0f} s of CPU time) "
            f"with derivatives by the program, and {runs[False]} runs "
            f"({seconds[False]:.0f} s) with those by differences of whole runs; the "
            f"designs differ by {apart:.0e} of the ranges.",
            f"The weighted pressure falls by {gains[0]:.1f} %, and the variation of "
            f"the pressure by {gains[1]:.0f} %, without more tension"
            + (f"; the {on_bound} is on the bound of its range, which limits the "
               "gain." if on_bound else "."))
        return (table(["derivative of", "by", "program", "whole runs"], check),
                "\n\n".join((textwrap.fill(text[0], 88), table(header, rows),
                             textwrap.fill(text[1], 88))))

    def draw_even(self, path, samples):
        """The chart of the optimization."""
        figure, axes = plt.subplots(figsize=(6, 4.4))
        x, y = (np.linspace(*values, 60) for values in even.RANGES.values())
        objective, limited = (even.Polynomial(samples, name)
                              for name in (even.OBJECTIVE, even.LIMITED))
        contours = axes.contour(x, y, [[objective((a, b)) for a in x] for b in y],
                                10, cmap="viridis", linewidths=1)
        axes.clabel(contours, fontsize=8)
        axes.contour(x, y, [[limited((a, b)) for a in x] for b in y],
                     [limited(list(even.BASE.values()))], colors="#555555",
                     linestyles="--")
        axes.scatter(samples["angle"], samples["radius"], s=18,
                     c=samples[even.OBJECTIVE], cmap="viridis")
        axes.plot(*zip(*path), ".-", color="#c0392b", linewidth=1)
        axes.plot(*path[-1], "x", color="#c0392b", markersize=11,
                  markeredgewidth=3, clip_on=False, zorder=5)
        axes.plot(*path[0], "o", color="#c0392b", markersize=10, fillstyle="none",
                  markeredgewidth=2)
        axes.set(xlabel="cord angle, degrees", ylabel="radius of the profile, mm")
        self.save(figure, "even")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True,
                        help="where to write design.md")
    parser.add_argument("--ranks", type=int, default=2, help="of the studies")
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)

    pages = Pages(arguments)
    lowest = pages.modes()
    buckling = pages.buckling()
    pages.sensitivities()
    cost = pages.cost()
    pages.study(arguments.ranks)
    check, best = pages.even(arguments.ranks)
    (arguments.output / "design.md").write_text(PAGE.format(
        unloaded=lowest["unloaded"], inflated=lowest["inflated"], buckling=buckling,
        force=even.FORCE, check=check, best=best,
        cost=cost), encoding="utf-8")


if __name__ == "__main__":
    main()
