# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command prints."""

import math
import textwrap


def wrapped(sentence):
    """A sentence with a capital, in lines."""
    return textwrap.fill(sentence[0].upper() + sentence[1:], 88)


def facts(design, file):
    """The lines of a summary of a design and its parameter file."""
    rows = [(fact.name, fact.value, fact.source) for fact in design.facts]
    cells = file.mesh.cells
    rows.append(("mesh", f"{cells[0]} x {cells[1]} cells, {file.unknowns} unknowns",
                 "along the meridian, around the axle"))
    width = max(len(name) for name, *_ in rows) + 2
    middle = max(len(value) for _, value, _ in rows) + 2
    return [f"{name:{width}}{value:{middle}}{source}" for name, value, source in rows]


def summary(design, file):
    """The summary with its warnings."""
    size = design.size
    title = (f"{size.text}: {'radial' if size.is_radial else 'bias'} tire, "
             f"rules for {size.kind}")
    return "\n".join([title, *facts(design, file), *notes(design.warnings)]) + "\n"


def notes(sentences):
    """Warnings."""
    return [wrapped("note: " + sentence) for sentence in sentences]


def judgment(result):
    """A table of what is compared, and warnings."""
    design = result.design
    lines = [f"{design.size.text} under {result.force:.0f} N at {result.pressure:.4g} MPa",
             f"{'':24}{'computed':>10} {'':11}{'compared':>10}{'ratio':>8}  with"]
    for line in result.lines:
        known = math.isfinite(line.other)
        lines.append((f"{line.name:24}{line.value:10.5g} {line.unit:11}"
                      + (f"{line.other:10.5g}{line.ratio:8.2f}  {line.source}"
                         + (f" (usual: {line.range[0]:g} to {line.range[1]:g})"
                            if line.range else "") if known else "")).rstrip())
    return "\n".join([*lines, *notes(design.warnings), *(
        wrapped("warning: " + text) for text in result.warnings)]) + "\n"
