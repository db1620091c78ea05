# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections of the page. A section whose files are missing is replaced by one
sentence that says so."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from . import charts, maps, view
from .buckling import buckling, critical_points, critical_range
from .drawing import STYLE, embed, plain
from .footprint import Footprint, normal_of_nodes
from .ground import ground_in_step, ground_of
from .loading import counted_steps, step_labels
from .modes import modes
from .motion import motion, moves
from .page import (LeftOut, Section, count, details, figure, missing, number,
                   page, plain_number, table)
from .point_content import ply_stresses, points
from .reactions import reactions
from .response import response
from .rolling import rolling
from .section import (SectionPlane, across_coordinate_line, is_straight,
                      section_around)
from .sensitivities import sensitivities
from .stiffness import stiffness
from .summary import introduction, summary, title
from .tire_test import tire_test
from .units import units_of
from .wheel import stick_slip, wheel_forces
from .zone import zone_of_shell


def report(run):
    """The page of a run."""
    plt.rcParams.update(STYLE)
    footprint = find_footprint(run)
    parts = [summary(run, footprint), view.shell(run), motion(run), curve(run),
             reactions(run),
             footprint_map(run, footprint), stick_slip(run, footprint),
             wheel_forces(run), tire_test(run), rolling(run), stiffness(run),
             sections_of_shell(run), modes(run), response(run), buckling(run),
             critical_points(run), sensitivities(run), points(run), iterations(run),
             ply_stresses(run), input_of_run(run)]
    sections = [part for part in parts if isinstance(part, Section)]
    absent = [part for part in parts if isinstance(part, LeftOut)]
    if absent:
        sections.append(missing(absent))
    return page(title(run), introduction(run), sections, view.scripts(sections))


# ---------------------------------------------------------------- contact


def find_footprint(run):
    """The footprint of the step, or None without contact, without its file, or on
    a mesh without coordinate lines, between which its cells are found."""
    if not run.has_coordinates:
        return None
    contact = run.contact() if run.is_contact else None
    if contact is None:
        return None
    ground = ground_of(run)
    normal = ground.direction if ground else normal_of_nodes(contact)
    if normal is None:
        return None
    if run.has_points_in_cells:
        # nodes around points in contact may be clear of the ground
        contact["active"] = contact["active"] * (contact["clearance"] < 0)
    if not contact["active"].any():
        return None
    zone = zone_of_shell(run, ground_in_step(run), contact)
    footprint = Footprint(contact, normal,
                          run.setting("Mesh/Closed in alpha_2") == "true", zone)
    if zone is None and "footprint_length" in run.history:
        footprint.scale_to(run.last("footprint_length"), run.last("footprint_width"))
    return footprint


def curve(run):
    """Force against approach; without contact, a load against displacements."""
    if moves(run):
        return LeftOut("Load and deflection",
                       "There are steps with inertia, which are no equilibria.")
    if run.in_contact.any():
        html = figure(embed(charts.draw_contact_curve(run)),
                      "Chart of the force on the ground against its "
                      f"approach. {contact_range(run)}",
                      "One point per step in contact."
                      + critical_range(run, run.steps[run.in_contact]))
        return Section("curve", "Load and deflection", html)
    probes = run.probes() if run.setting("Named points", "?") != "" else None
    name = "Load and deflection"
    if len(run.steps) < 2:
        return LeftOut(
            name, "There is only one step; a curve needs two.")
    if probes is None or len(probes) == 0:
        return LeftOut(
            name, "Without contact, the curve needs named points: set the entry "
            "'Named points'.")
    found = charts.ProbeCurves(run, probes)
    if not found.curves:
        return LeftOut(name, "The named points do not move.")
    more = len(found.curves) - found.maximum()
    caption = ("Displacements of the middle surface: for each named point, the "
               "component that changes most.")
    if more > 0:
        caption += f" {count(more, 'more point is', 'more points are')} left out."
    if found.at_rest:
        caption += f" At rest: {escape(', '.join(found.at_rest))}."
    caption += critical_range(run, counted_steps(run))
    html = figure(embed(found.draw()),
                  f"Chart of the {found.load_name} against the displacements of "
                  "the named points.", caption)
    return Section("curve", name, html)


def contact_range(run):
    """The last point of the curve in words."""
    return (f"At an approach of {plain_number(run.last('approach'))} the force "
            f"is {plain_number(run.last('force'))}.")


def footprint_map(run, footprint):
    """The picture of the contact pressure."""
    name = "Footprint"
    if not run.is_contact:
        return LeftOut(
            name, "The shell is not in contact with the ground in step "
            f"{run.step}.")
    if footprint is None:
        path = run.path("contact")
        reason = (f"{path.name} is missing." if not path.exists() else
                  "No node is in contact." if run.has_points_in_cells else
                  "parameters.prm is missing, and too few nodes are in contact to "
                  "find the direction of the ground.")
        return LeftOut(name, reason)
    ground = ground_of(run)
    where = ("" if ground is None or ground.shape == "plane" else
             f", seen along the direction in which the {ground.name()} travels")
    text = (f"Contact pressure per area of the undeformed middle surface{where}, "
            "bilinear between the nodes. Dots: nodes in contact. Line: the "
            "edge of the contact zone, the line of zero clearance"
            + (", estimated from the nodes of the zone alone and stretched to the "
               "length and width of history.csv" if footprint.is_estimated else "")
            + ". Dash-dotted: the principal axes of the zone.")
    length, width = footprint.lengths
    if "footprint_length" in run.history:
        length, width = (run.last(f"footprint_{which}")
                         for which in ("length", "width"))
    alternative = (
        "Map of the contact pressure. The zone is "
        f"{plain_number(length, 4)} long and "
        f"{plain_number(width, 4)} wide; the maximum pressure "
        f"is {plain_number(run.last('max_pressure'))}.")
    return Section("footprint", name, figure(
        embed(maps.draw_footprint(footprint, units_of(run)), "png"), alternative, text))


# ---------------------------------------------------------------- shape


def sections_of_shell(run):
    """The deformed section in several steps."""
    name = "Deformed section"
    found = section_lines(run)
    if isinstance(found, str):
        return LeftOut(name, found)
    chosen, profiles, across, text = found
    grounds = [ground_if_known(run, step) for step in chosen]
    drawing, is_to_scale, has_ground = maps.draw_sections(
        SectionPlane(profiles, normal_of(run), across), profiles,
        [plain(label) for label in step_labels(run, chosen)], grounds,
        units_of(run))
    return Section("section", name, figure(
        embed(drawing), "Drawing of the deformed section of the shell, from step "
        f"{chosen[0]} to step {chosen[-1]}.",
        section_caption(run, text, is_to_scale, has_ground)))


def section_caption(run, text, is_to_scale, has_ground):
    """What a picture of sections shows, from the words of section_lines()."""
    text += (", to scale." if is_to_scale else
             ", <strong>the axes have different scales</strong>.")
    if has_ground:
        text += f" Dashes: the {ground_of(run).name()}."
    return text + " Smooth between the nodes."


def section_lines(run):
    """The lines of the deformed section: along alpha_1, or around the axis where the
    shell is straight along alpha_1. Steps, a table for each, the direction across their
    plane, if it is known, and words; or only the reason why they are missing."""
    if is_straight(run) and run.setting("Output/Write VTU") != "false":
        steps = [step for step in run.steps
                 if run.path("shell", step, "vtu").exists()]
        chosen = maps.chosen_steps(steps)
        lines = [section_around(run, step) for step in chosen]
        if run.step in steps and all(line is not None for line in lines):
            return chosen, lines, np.array([0, 1.0, 0]), (
                "Outer and inner face around the axis, through the nodes at y = "
                f"{plain_number(lines[0]['y'][0])} of the undeformed shell")
    steps = [step for step in run.steps if run.path("profile", step).exists()]
    if run.step not in steps:
        return f"{run.path('profile').name} is missing."
    chosen = maps.chosen_steps(steps)
    profiles = [run.profile(step) for step in chosen]
    if min(map(len, profiles)) < 2:
        return f"{run.path('profile', chosen[0]).name} is empty."
    alpha_2 = profiles[-1]["alpha_2"][0]
    surface = run.setting("Surface/Type")
    text = f"Outer and inner face along α<sub>2</sub> = {plain_number(alpha_2)}"
    path = run.path("shell", ending="vtu")
    if is_straight(run) and not path.exists():
        text += f" (the section around the axis is missing, as is {path.name})"
    return (chosen, profiles, surface and across_coordinate_line(surface, alpha_2),
            text)


def normal_of(run):
    """The direction of the ground, or None if the run has no contact."""
    ground = ground_of(run) if run.in_contact.any() else None
    return ground.direction if ground else None


def ground_if_known(run, step):
    """The ground where it stands in a step, or None."""
    return (None if normal_of(run) is None else ground_in_step(run, step))


# ---------------------------------------------------------------- run


def iterations(run):
    """Newton iterations and times, and the table of all steps."""
    history = run.history
    columns = [("pressure", "Pressure", 5), ("load_factor", "Load factor", 5),
               ("iterations", "Iterations", 5), ("seconds", "Seconds", 3)]
    if run.in_contact.any():
        columns = [("approach", "Approach", 5), ("force", "Force", 5),
                   ("contact_area", "Contact area", 5),
                   ("max_pressure", "Maximum contact pressure", 4)] + columns
    cells = [[str(run.steps[i]), escape(history["stage"][i])]
             + [number(history[column][i], digits) for column, _, digits in columns]
             for i in range(len(history))]
    all_steps = table("All steps, from history.csv",
                      ["Step", "Stage"] + [head for _, head, _ in columns], cells)
    name = "Steps and iterations"
    if len(history) == 1:
        return Section("steps", name, all_steps, True)
    worst = int(np.argmax(history["iterations"]))
    chart = figure(
        embed(charts.draw_iterations(run)),
        "Bar charts of the Newton iterations and the seconds per step.",
        "Newton iterations, including those of failed attempts, and wall time of "
        f"each step. Step {run.steps[worst]} took the most iterations: "
        f"{int(history['iterations'][worst])}.")
    return Section("steps", name,
                   chart + "\n" + details("All steps", all_steps))


def input_of_run(run):
    """The parameters: those that differ from the defaults, then the file."""
    if run.parameters is None:
        return LeftOut("Input", "parameters.prm is missing.")
    changed = run.parameters.changed()
    parts = []
    if changed:
        rows = [[escape(entry.name), escape(entry.value),
                 escape(entry.default) or "(empty)"] for entry in changed]
        parts.append(details(
            f"Entries that differ from the default ({len(changed)})",
            table("Entries that differ from the default",
                  ["Entry", "Value", "Default"], rows).replace(
                      'class="scroll"', 'class="scroll words"', 1), True))
    parts.append(details("All of parameters.prm",
                         f"<pre>{escape(run.parameters.text)}</pre>"))
    return Section("input", "Input", "\n".join(parts), True)
