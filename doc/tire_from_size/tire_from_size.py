#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make tires from their sizes by biface-tire, run them, and write tire_from_size.md."""

import contextlib
import io
import shlex
import sys
from pathlib import Path


sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import biface, parse_arguments, table

from biface_tire import program
from biface_tire.bias import AIRCRAFT, BICYCLE
from biface_tire.design import RADIAL
from biface_tire.judge import judge
from biface_tire.parameter_file import NAME, RESULTS

CASES = ("4.00-8 4PR --rim 2.50C", "4.00-8 4PR --rim 2.50C --tread layer",
         "4.00-8 4PR --rim 2.50C --plies 4 --tread layer", "7.50-16", "49x17 26PR",
         "195/65 R15 91", "205/60 R15 91V --rim 6J", "700x25C")
SHOWN = ("4.00-8 4PR --rim 2.50C", "7.50-16", "49x17 26PR", "195/65 R15 91",
         "205/60 R15 91V --rim 6J", "700x25C")
FIRST = "4.00-8 4PR --rim 2.50C"


def command(*words):
    """What biface-tire prints."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        program.main(list(words))
    return output.getvalue()


def make(arguments, case):
    """The design, what `new` prints, the results and their judgment of a case."""
    directory = arguments.scratch / case.replace("/", "_").replace(" ", "_")
    words = ["new", *shlex.split(case), "--output", str(directory)]
    printed = command(*words)
    results = biface.run(directory / NAME, {}, directory / RESULTS,
                         program=arguments.program, may_stop=True)
    made = program.make_parser().parse_args(words)
    design = program.make_design(made)
    judgment = judge(design, directory / RESULTS, made.tread)
    print(command("judge", str(directory)), flush=True)
    return design, printed, results, judgment, command("judge", str(directory))


def value(judgment, name, which="value", source=""):
    """A number of a judgment in words; empty if there is none."""
    for line in judgment.lines:
        if line.name == name and source in line.source:
            number = getattr(line, which)
            return f"{number:.4g}" if which == "value" else f"{number:.2f}"
    return ""


def results_table(made):
    """A row for each case."""
    rows = []
    for case, (design, _, _, judgment, _) in made.items():
        stopped = "" if judgment.force > 0.999 * design.load else " (stopped)"
        rows.append([
            f"`{case}`", f"{design.load / 1000:.4g}{stopped}", f"{design.pressure:.3g}",
            f"{judgment.deflection:.3g}", value(judgment, "deflection", "ratio"),
            value(judgment, "force", "ratio", "NASA"),
            value(judgment, "force", "ratio", "pressure"),
            value(judgment, "footprint length"), value(judgment, "footprint width"),
            value(judgment, "rolling radius"), value(judgment, "cord tension, loaded",
                                                     "ratio"),
            value(judgment, "mass without beads"), value(judgment, "lowest frequency")])
    return table(["Size", "Load, kN", "Pressure, MPa", "Deflection, mm", "over the height",
                  "Force over NASA's", "over p A", "Length, mm", "Width, mm",
                  "Rolling radius, mm", "Cords over strength", "Mass, kg",
                  "Lowest mode, Hz"], rows)


def stiffness_table(made):
    """Stiffnesses, with the ratio to NASA's where it holds."""
    rows = []
    names = ("vertical stiffness", "lateral stiffness", "longitudinal stiffness",
             "torsional stiffness")
    for case, (_, _, _, judgment, _) in made.items():
        cells = []
        for name in names:
            ratio = value(judgment, name, "ratio")
            cells.append(value(judgment, name) + (
                f" ({ratio})" if ratio not in ("", "nan") else ""))
        rows.append([f"`{case}`", *cells])
    return table(["Size", "Vertical, N/mm", "Lateral, N/mm", "Longitudinal, N/mm",
                  "Torsional, N m/degree"], rows)


def draw(made, path):
    """Sections, inflated and loaded, each to its own scale."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(2, 3, figsize=(9, 5.6), layout="constrained")
    for place, case in zip(axes.flat, SHOWN):
        design, _, results, _, _ = made[case]
        stage = results.history["stage"]
        for name, color, label in (("vibration", "0.55", "inflated"),
                                   ("load", "C0", "loaded")):
            step = results.steps[stage == name][-1]
            profile = results.profile(step)
            for face in ("outer", "inner"):
                radius = profile[f"{face}_x"]
                place.plot(profile[f"{face}_y"], radius, color=color, lw=1.2,
                           label=label if face == "outer" else None)
        half, top = design.rim_width / 2, design.rim_diameter / 2
        end = design.tire.end
        for side in (-1, 1):
            place.plot([side * half, side * half], [top, end], "k", lw=2)
        place.plot([-half, half], [top, top], "k", lw=2, label="rim")
        place.set_title(f"{design.size.text}, {design.load / 1000:.3g} kN", fontsize=9)
        place.set_aspect("equal")
        place.tick_params(labelsize=7)
        place.set_xlabel("axial, mm", fontsize=7)
        place.set_ylabel("distance from the axle, mm", fontsize=7)
    figure.legend(*axes.flat[0].get_legend_handles_labels(), fontsize=8, ncols=3,
                  loc="lower center")
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
    figure.savefig(path, dpi=110)


def rules_table():
    """The rules of radial tires."""
    rows = []
    for kind, rules in RADIAL.items():
        more = rules.more
        rows.append([
            kind, rules.carcass.name, f"{len(more.get('belts', (1, 2)))} x {rules.belt.name}",
            f"±{more.get('belt_angle', 24)}°",
            f"{more.get('groove', 7.5):g} + {more.get('under_groove', 2):g}",
            f"{rules.land:g}", f"{more.get('sidewall', 2.5):g}",
            f"{rules.filler:g}, {rules.turn_up:g} of {rules.height:g}", rules.source])
    return table(["Kind", "Carcass", "Belts", "Angle", "Groove and rubber below, mm",
                  "Land", "Sidewall, mm", "Filler, turn-up over the flange, mm, of a height",
                  "Source"], rows)


def bias_table():
    """The rules of bias tires."""
    return table(
        ["Kind", "Cord", "Pitch, mm", "Ply, mm", "Strength, N", "Liner, sidewall, mm",
         "Tread, mm", "Rubber, MPa", "Source"],
        [[name, rules.cord.name, f"{rules.cord.pitch:.3g}", f"{rules.cord.ply:g}",
          f"{rules.cord.strength:g}", f"{rules.liner:g}, {rules.sidewall:g}",
          f"{rules.tread_base:g} + {rules.tread_slope:g} S", f"{rules.rubber:g}",
          rules.source] for name, rules in (("all but bicycles", AIRCRAFT),
                                            ("bicycle", BICYCLE))])


def page(made):
    """The text."""
    template = (Path(__file__).parent / "tire_from_size.md.in").read_text(encoding="utf-8")
    for name, text in (("NEW", made[FIRST][1].split("Wrote")[0].rstrip()),
                       ("JUDGE", made[FIRST][4].rstrip()),
                       ("RESULTS", results_table(made)),
                       ("STIFFNESS", stiffness_table(made)),
                       ("RADIAL", rules_table()), ("BIAS", bias_table())):
        template = template.replace(f"@{name}@", text)
    return template


def main():
    arguments = parse_arguments("tire_from_size", __doc__)
    made = {case: make(arguments, case) for case in CASES}
    draw(made, arguments.output / "figures/tire_from_size.png")
    (arguments.output / "tire_from_size.md").write_text(page(made), encoding="utf-8")


if __name__ == "__main__":
    main()
