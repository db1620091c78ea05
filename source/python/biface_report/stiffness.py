# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of stiffnesses against motions of the ground."""

from html import escape

import numpy as np

from .page import LeftOut, Section, number, paragraph, table
from .units import units_of
from .wheel import is_wheel

# A direction is along an axis if it deviates less than this
ALONG = 1e-6


def stiffness(run):
    """A row for each stage of stiffness.csv, from where it started to its last
    step."""
    name = "Stiffness"
    found = run.stiffness()
    if found is None or len(found) == 0:
        return LeftOut(name, "In no step does the ground move in contact while "
                       "all other loads rest.")
    rows, units = [], units_of(run)
    for first, last in stages_of(found):
        at = {column: values[last] for column, values in found.items()}
        is_turn = at["motion"] == "turn"
        unit = units["moment"] + "/degree" if is_turn else units["stiffness"]
        across = coupling(run, at)
        rows.append(
            [escape(at["stage"]), number(at["pressure"]), number(at["force"]),
             number(at["approach"]), motion_name(run, at),
             number(at["amount"]) + ("°" if is_turn else "")]
            + [number(value) for value in
               (at["secant"], found["tangent"][first], at["tangent"])]
            + ["" if across is None else number(across, scale=abs(at["secant"])),
               f'<span class="unit">[{unit}]</span>'])
    heads = ["Stage", "Pressure", "Force", "Approach", "Motion", "Amount", "Secant",
             "Tangent, first step", "Tangent, last step", "Across", ""]
    text = paragraph(
        "Pressure, force and approach are those where the stage starts. Secant: the "
        "change of what the ground exerts on the shell since then, along the "
        "motion, over the motion. Tangent: the same of a single step. Across: the "
        "force in the ground across a slide, over the slide, since the start. "
        "All components are in stiffness.csv.")
    return Section("stiffness", name, table(
        "Stiffnesses against motions of the ground", heads, rows) + text, True)


def stages_of(found):
    """The first and the last row of each stage."""
    names = found["stage"]
    starts = [i for i in range(len(names)) if i == 0 or names[i] != names[i - 1]]
    return zip(starts, [i - 1 for i in starts[1:]] + [len(names) - 1])


def motion_name(run, at):
    """What a motion is called: that of a wheel around the y axis, or else by its
    direction."""
    if at["motion"] == "approach":
        return "vertical" if is_wheel(run) else "approach"
    if at["motion"] == "turn":
        return "turn"
    along = direction_of(at)
    if is_wheel(run) and abs(along[1]) > 1 - ALONG:
        return "lateral"
    if is_wheel(run) and abs(along[1]) < ALONG:
        return "longitudinal"
    return "slide along ({:.3g}, {:.3g}, {:.3g})".format(*along).replace("-", "−")


def direction_of(at):
    """The unit vector along the motion."""
    return np.array([at["direction_" + i] for i in "xyz"])


def coupling(run, at):
    """The force across a slide, in the ground, over the slide: positive about
    the direction of the ground. None for other motions."""
    outward = run.numbers("Contact/Direction", 3)
    if at["motion"] != "slide" or outward is None:
        return None
    across = np.cross(outward / np.linalg.norm(outward), direction_of(at))
    return float(across @ [at["secant_F_" + i] for i in "xyz"])
