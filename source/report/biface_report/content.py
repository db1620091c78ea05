# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the page says, section by section. A section whose files are missing
says so in a sentence."""

import tempfile
from html import escape
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from . import charts, maps, shell_view
from .drawing import STYLE, embed, embed_png
from .footprint import Footprint, normal_of_nodes
from .foundation import foundation_in_step, foundation_of
from .loading import step_labels
from .page import (LeftOut, Section, details, figure, missing, number, page,
                   plain_number, table)
from .point_content import ply_stresses, points
from .section import SectionPlane
from .summary import introduction, summary, title


def report(run):
    """The page of a run."""
    plt.rcParams.update(STYLE)
    footprint = find_footprint(run)
    parts = [summary(run, footprint), curve(run), footprint_map(run, footprint),
             sections_of_shell(run), shell(run), points(run), iterations(run),
             ply_stresses(run), input_of_run(run)]
    sections = [part for part in parts if isinstance(part, Section)]
    absent = [part for part in parts if isinstance(part, LeftOut)]
    if absent:
        sections.append(missing(absent))
    return page(title(run), introduction(run), sections)


# ---------------------------------------------------------------- contact


def find_footprint(run):
    """The footprint of the step, or None without contact or without its file."""
    contact = run.contact() if run.is_contact else None
    if contact is None:
        return None
    foundation = foundation_of(run)
    normal = foundation.direction if foundation else normal_of_nodes(contact)
    if normal is None:
        return None
    return Footprint(contact, normal,
                     run.setting("Mesh/Closed in alpha_2") == "true")


def curve(run):
    """Force against approach, or a load against displacements."""
    if run.in_contact.any():
        html = figure(embed(charts.draw_contact_curve(run)),
                       "Chart of the force on the foundation against its "
                       f"approach. {contact_range(run)}",
                       "One point for each step in contact.")
        return Section("curve", "Load and deflection", html)
    probes = run.probes() if run.setting("Named points", "?") != "" else None
    name = "Load and deflection"
    if len(run.steps) < 2:
        return LeftOut(
            name, "The run has one step only up to here; a curve takes two.")
    if probes is None or len(probes) == 0:
        return LeftOut(
            name, "There is no curve, since the run has no contact and no named "
            "points: the entry Points of the input names them.")
    found = charts.ProbeCurves(run, probes)
    if not found.curves:
        return LeftOut(name, "The named points do not move.")
    more = len(found.curves) - charts.GREATEST_NUMBER_OF_CURVES
    caption = ("Displacements of the middle of the wall, each point in the "
               "direction of x, y and z in which it moves most.")
    if more > 0:
        caption += f" {more} further points are left out."
    if found.at_rest:
        caption += f" At rest: {escape(', '.join(found.at_rest))}."
    html = figure(embed(found.draw()),
                   f"Chart of the {found.load_name} against the displacements of "
                   "the named points.", caption)
    return Section("curve", name, html)


def contact_range(run):
    """The end of the curve in words."""
    return (f"At an approach of {plain_number(run.last('approach'))} the force "
            f"is {plain_number(run.last('force'))}.")


def footprint_map(run, footprint):
    """The picture of the contact pressure."""
    name = "Footprint"
    if not run.is_contact:
        return LeftOut(
            name, f"In step {run.step} the shell touches no foundation.")
    if footprint is None:
        path = run.path("contact")
        reason = (f"{path.name} is missing." if not path.exists() else
                  "the nodes in contact do not tell the plane of the foundation, "
                  "and parameters.prm is missing.")
        return LeftOut(name, reason)
    foundation = foundation_of(run)
    where = ("" if foundation is None or foundation.shape == "plane" else
             f", seen along the direction in which the {foundation.name()} travels")
    text = (f"Contact pressure per area of the undeformed middle surface{where}, "
            "bilinear between the nodes. Dots: nodes in contact. Line: the edge "
            "of the contact zone, drawn halfway between the last node in contact "
            "and the next one. Dash-dotted: the principal axes of the zone.")
    alternative = (
        "Map of the contact pressure. The zone is "
        f"{plain_number(footprint.lengths[0], 4)} long and "
        f"{plain_number(footprint.lengths[1], 4)} wide; the greatest pressure "
        f"is {plain_number(run.last('max_pressure'))}.")
    return Section("footprint", name, figure(
        embed(maps.draw_footprint(footprint), "png"), alternative, text))


# ---------------------------------------------------------------- shape


def sections_of_shell(run):
    """The deformed section in some steps."""
    name = "Deformed section"
    steps = [step for step in run.steps if run.path("profile", step).exists()]
    if run.step not in steps:
        return LeftOut(
            name, f"{run.path('profile').name} is missing.")
    chosen = maps.chosen_steps(steps)
    profiles = [run.profile(step) for step in chosen]
    if min(map(len, profiles)) < 2:
        return LeftOut(
            name, f"{run.path('profile', chosen[0]).name} has no section.")
    foundations = [None] * len(chosen)
    normal = None
    if run.in_contact.any() and foundation_of(run):
        foundations = [foundation_in_step(run, step) for step in chosen]
        normal = foundation_of(run).direction
    plane = SectionPlane(profiles, normal, run.setting("Surface/Type"))
    drawing, is_to_scale, has_foundation = maps.draw_sections(
        plane, profiles, step_labels(run, chosen), foundations)
    text = "Outer and inner face along the line " + (
        f"α<sub>2</sub> = {plain_number(profiles[-1]['alpha_2'][0])}, "
        + ("to scale." if is_to_scale else
           "<strong>the axes have different scales</strong>."))
    if has_foundation:
        text += f" Dashes: the {foundation_of(run).name()}."
    return Section("section", name, figure(
        embed(drawing), "Drawing of the deformed section of the shell, from step "
        f"{chosen[0]} to step {chosen[-1]}.", text))


def shell(run):
    """The picture of the whole shell."""
    path = run.path("shell", ending="vtu")
    name = "Deformed shell"
    if run.setting("Output/Write VTU") == "false" or not path.exists():
        reason = ("the entry Output/Write VTU of the input is false."
                  if run.setting("Output/Write VTU") == "false"
                  else f"{path.name} is missing.")
        return LeftOut(name, reason)
    with tempfile.TemporaryDirectory() as directory:
        target = Path(directory) / "shell.png"
        try:
            foundation, direction = shell_view.draw_shell(run, target)
        except shell_view.NoPicture as error:
            return LeftOut(name, str(error))
        image = embed_png(target.read_bytes(), 800)
    what = "contact pressure" if foundation else "length of the displacement"
    where = (f"through the {foundation.name()}, of which a part is drawn as glass"
             if foundation else "from outside, aside and above")
    text = (f"Displacements to scale, color: {what}. Seen {where}; the camera is in "
            "the direction ({:.2f}, {:.2f}, {:.2f}) of the shell. ".format(
                *direction).replace("-", "−")
            + "Between the nodes the shell is drawn straight.")
    return Section("shell", name, figure(
        image, f"The deformed shell, colored by {what}.", text))


# ---------------------------------------------------------------- run


def iterations(run):
    """How the iteration went."""
    history = run.history
    cells = [[str(run.steps[i]), escape(history["stage"][i])]
             + [number(history[column][i], digits) for column, digits in
                (("approach", 5), ("force", 5), ("contact_area", 5),
                 ("max_pressure", 4), ("pressure", 5), ("load_factor", 5),
                 ("iterations", 5), ("seconds", 3))]
             for i in range(len(history))]
    heads = ["Step", "Stage", "Approach", "Force", "Contact area",
             "Greatest contact pressure", "Pressure", "Load factor",
             "Iterations", "Seconds"]
    all_steps = table("All steps, from history.csv", heads, cells)
    name = "Steps and iterations"
    if len(history) == 1:
        return Section("steps", name, all_steps, True)
    worst = int(np.argmax(history["iterations"]))
    chart = figure(
        embed(charts.draw_iterations(run)),
        "Bar charts of Newton iterations and of seconds in each step.",
        "Newton iterations, those of failed attempts included, and wall time of "
        f"each step. The most iterations, {int(history['iterations'][worst])}, "
        f"are those of step {run.steps[worst]}.")
    return Section("steps", name,
                   chart + "\n" + details("All steps", all_steps))


def input_of_run(run):
    """The parameters: first those that are not defaults, then the file."""
    if run.parameters is None:
        return LeftOut("Input", "parameters.prm is missing.")
    changed = run.parameters.changed()
    parts = []
    if changed:
        rows = [[escape(entry.name), escape(entry.value),
                 escape(entry.default) or "(empty)"] for entry in changed]
        parts.append(details(
            f"Entries that are not the default ({len(changed)})",
            table("Entries with another value than the default",
                  ["Entry", "Value", "Default"], rows).replace(
                      'class="scroll"', 'class="scroll words"', 1), True))
    parts.append(details("All of parameters.prm",
                         f"<pre>{escape(run.parameters.text)}</pre>"))
    return Section("input", "Input", "\n".join(parts), True)
