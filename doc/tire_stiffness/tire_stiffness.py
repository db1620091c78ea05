#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write tire_stiffness.md from a run of prm/tire_stiffness.prm."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, parse_arguments, table

PAGE = """<!-- Written by doc/tire_stiffness/tire_stiffness.py: cmake --build build --target tire_stiffness -->

# Stiffness of a loaded tire

[tire_stiffness.prm](../prm/tire_stiffness.prm) inflates the tire of
[bias_tire.md](bias_tire.md), under true pressure, to 0.12 and 0.15 MPa and presses it on
the ground by two forces, without friction. Eight stages branch from each of these four
loaded states (`Start from`): the force changes by 5 % up and down, and the ground slides
across the tire and along it and turns, each once with the footprint glued to it and once
with a coefficient of friction of 0.8.

```sh
build/biface prm/tire_stiffness.prm
build/biface-report output
```

The tables contain numbers from `stiffness.csv`, which
[output.md](output.md#stiffnesscsv) describes; `biface-report` shows them as well, and
[biface-tire-model](tire_model.md#structure) brings them into .tir files. The
mesh has 42 × 40 cells and lumped multipliers; the run takes about 20 s.

## Without slip

Secant stiffnesses: from the loaded state to a force 5 % smaller or larger, to a slide
of 0.1 mm, and to a turn of 0.1°.

{glued}

A bias tire couples the directions: when the ground slides across it, the ground also
pushes it along, and the other way round. For small motions the two forces per length of
the slide agree, since the glued tire has an energy. In the last row they differ: while the
ground slides along, one node enters the footprint and another leaves it.

Under the dead pressure of bias_tire.prm, 0.15 MPa, at an approach of 20 mm, 1929.45 N, the
[independent program](bias_tire.md#the-independent-program) gives 145.24 N/mm across with
-12.87 N/mm along, 1049.6 N/mm along, and 58,655 N mm/degree; the test
`bias_tire/stiffness` compares them with those of the program, which agree within 0.1 %.

Nodes enter and leave the footprint one by one, so that the vertical stiffness changes in
small jumps with the load.

## With friction

The stiffnesses of glued footprints are upper bounds: with friction the edge of the
footprint slips from the start. Secants to the end of the motion, and tangents of its last
step. The lateral slide is 6 mm, the longitudinal one 0.6 mm, in two steps each; the
turn 1°, in one step, in which secant and tangent agree.

{rough}
"""

# Columns of both tables: heading, stage, column of stiffness.csv, its factor
GLUED = [("vertical, less load, N/mm", "less load", "secant"),
         ("vertical, more load, N/mm", "more load", "secant"),
         ("lateral, N/mm", "lateral glued", "secant"),
         ("lateral, force along, N/mm", "lateral glued", "secant_F_z"),
         ("longitudinal, N/mm", "longitudinal glued", "secant"),
         ("longitudinal, force across, N/mm", "longitudinal glued", "secant_F_y"),
         ("turn, N mm/degree", "turn glued", "secant")]
ROUGH = [("lateral, secant, N/mm", "lateral rough", "secant"),
         ("lateral, tangent, N/mm", "lateral rough", "tangent"),
         ("longitudinal, secant, N/mm", "longitudinal rough", "secant"),
         ("longitudinal, tangent, N/mm", "longitudinal rough", "tangent"),
         ("turn, secant, N mm/degree", "turn rough", "secant")]


def rows_of(lines, columns):
    """A row for each loaded state, under a header."""
    # the last line of each stage
    last = {line["stage"]: line for line in lines.rows()}
    states = dict.fromkeys(stage.partition(": ")[0] for stage in last
                           if ": " in stage)
    rows = []
    for state in states:
        values = [last[f"{state}: {stage}"][column] for _, stage, column in columns]
        rows.append([state, f"{last[f'{state}: less load']['approach']:.2f}"]
                    + [f"{value:.0f}" if abs(value) >= 1000 else f"{value:.2f}"
                       for value in values])
    return ["Load", "approach, mm"] + [column[0] for column in columns], rows


def main():
    arguments = parse_arguments("tire_stiffness", __doc__)
    lines = Runs(arguments).run("four_loads", "tire_stiffness.prm", {}).stiffness()
    (arguments.output / "tire_stiffness.md").write_text(
        PAGE.format(glued=table(*rows_of(lines, GLUED)),
                    rough=table(*rows_of(lines, ROUGH))), encoding="utf-8")


if __name__ == "__main__":
    main()
