# SPDX-License-Identifier: LGPL-2.1-or-later
"""The head of the page, and the table of its most important numbers."""

import re
from collections import namedtuple
from html import escape

import numpy as np

from biface import read_vtu
from biface.parameters import stages
from biface.tables import read_text

from . import charts, plies
from .page import Section, count, number, paragraph, plain_number, table
from .units import units_of
from .wheel import is_wheel


def title(run):
    """The title of the page: it names the parameter file if that is known."""
    return f"biface: {input_name(run)}"


def input_name(run):
    """The parameter file, or else the directory of the results."""
    if run.parameters and run.parameters.source:
        return run.parameters.source.rsplit("/", 1)[-1]
    return run.directory.resolve().name


def introduction(run):
    """Where the numbers come from, their units, and whether the run is complete."""
    facts = [f"Results in the directory {escape(run.directory.resolve().name)}"]
    if run.parameters and run.parameters.version:
        facts.append(f"biface {escape(run.parameters.version)}")
    facts.append(f"step {run.step} of {run.last_step}")
    facts.append(f"stage “{escape(run.last('stage'))}”")
    result = [paragraph(", ".join(facts) + ".", "facts"),
              paragraph(units_of(run).sentence(), "facts")]
    result += [paragraph(escape(text), "warning") for text in warnings(run)]
    return "\n".join(result)


def warnings(run):
    """What is missing of the run, in sentences."""
    result = []
    if run.is_cut:
        result.append("The last line of history.csv is cut off, as if the run was "
                      "stopped while writing it; that line is left out.")
    if run.parameters and run.step == run.last_step:
        result += unfinished(run) or ended_early(run)
    return result


def ended_early(run):
    """A warning if run.log does not end as that of a complete run."""
    path = run.directory / "run.log"
    ends = (re.findall(r"^Results (so far )?in ", read_text(path), re.MULTILINE)
            if path.exists() else [""])
    return [] if ends and not ends[-1] else [
        "The run is not complete: it is still running, or was stopped."]


def unfinished(run):
    """What is left of the stages of the input."""
    planned = stages(run.parameters)
    names = [name for _, name in planned]
    if run.last("stage") not in names:
        return []
    if run.last("stage") != names[-1]:
        rest = names[names.index(run.last("stage")) + 1:]
        return [f"The run ended in the stage “{run.last('stage')}”, before: "
                f"{', '.join(rest)}."]
    last = f"Stage {planned[-1][0]}/"
    goals = {"load": [("Pressure", "pressure"), ("Load factor", "load_factor")],
             "foundation force": [("Force", "force")],
             "foundation force and axle moment": [("Force", "force")]}
    goals = list(goals.get(run.setting(last + "Control"), []))
    if (run.setting(last + "Contact") == "true"
            and run.setting(last + "Control") == "load"):
        goals.append(("Travel", "approach"))
    missed = []
    for entry, column in goals:
        try:
            goal = float(run.setting(last + entry))
        except (TypeError, ValueError):
            continue
        if not np.isclose(run.last(column), goal, rtol=1e-3, atol=1e-12):
            missed.append(f"{entry.lower()} {plain_number(run.last(column))} of "
                          f"{plain_number(goal)}")
    return [] if not missed else [
        f"The run ended before its last stage was done: {', '.join(missed)}."]


# ---------------------------------------------------------------- numbers


# A line of the table: what it is, its value, unit, and a remark in HTML
Row = namedtuple("Row", "name value unit remark digits", defaults=["", "", 5])


def in_brackets(unit):
    """A unit behind a number or a name, in HTML."""
    return f' <span class="unit">[{unit}]</span>' if unit else ""


def summary(run, footprint):
    """The table of numbers; the footprint is None without contact."""
    text = table(f"Step {run.step}, stage {run.last('stage')}", [],
                 [[row.name, number(row.value, row.digits) + in_brackets(row.unit),
                   row.remark] for row in rows_of(run, footprint)])
    text = text.replace('<div class="scroll"', '<div class="scroll summary"', 1)
    return Section("summary", "Summary", text, True)


def rows_of(run, footprint):
    """The lines of the table."""
    units = units_of(run)
    rows = (contact_rows(run, footprint) if run.is_contact else
            displacement_rows(run))
    history = run.history
    if history["pressure"].any():
        rows.append(Row("Pressure on the shell", run.last("pressure"),
                        units["pressure"]))
    if history["load_factor"].any():
        rows.append(Row("Load factor", run.last("load_factor"), "",
                        "of dead loads and prescribed displacements"))
    rows += tension_rows(run)
    rows += failure_rows(run)
    if "strain_energy" in history:
        rows.append(Row("Strain energy", run.last("strain_energy"),
                        units["energy"]))
    if "slack_cords" in history:
        rows.append(Row("Slack cords", 100 * run.last("slack_cords"), "",
                        "% by volume, of those that can go slack", 3))
    rows += [Row("Steps", len(run.steps), "",
                 count(len(dict.fromkeys(history["stage"])), "stage")),
             Row("Newton iterations", history["iterations"].sum(), "",
                 f"at most {int(history['iterations'].max())} in a step"),
             Row("Wall time", history["seconds"].sum(), "s",
                 "of all steps so far", 3)]
    return rows


def contact_rows(run, footprint):
    """Numbers of a step in contact."""
    units = units_of(run)
    force, area = run.last("force"), run.last("contact_area")
    rows = [Row("Force on the ground", force, units["force"]),
            Row("Approach of the ground", run.last("approach"),
                units["length"], "since it first touched the shell")]
    slope = charts.stiffness(run)
    if slope is not None:
        rows.append(Row("Stiffness", slope, units["stiffness"],
                        "increment of force over increment of approach"))
    points = "point" if run.has_points_in_cells else "node"
    rows.append(Row("Contact area", area, units["area"],
                    f"{count(int(run.last('contact_nodes')), points)}, on the "
                    "undeformed middle surface"))
    has_footprint = "footprint_length" in run.history
    if has_footprint:
        rows += history_rows(run, FOOTPRINT_ROWS)
    elif area > 0:
        rows.append(Row("Mean contact pressure", force / area,
                        units["pressure"], "force over contact area"))
    rows.append(Row("Maximum contact pressure", run.last("max_pressure"),
                    units["pressure"], "at a point in a cell"
                    if run.has_points_in_cells else "at a node" + place_of_peak(run)))
    if has_footprint:
        rows += history_rows(run, PRESSURE_ROWS)
    elif footprint is not None:
        rows += footprint_rows(run, footprint)
    if is_wheel(run):
        rows += history_rows(run, WHEEL_ROWS)
    if run.last("slipping_area") if "slipping_area" in run.history else 0:
        rows.append(Row("Slipping", 100 * run.last("slipping_area") / area, "",
                        "% of the contact area", 3))
    return rows


# Columns of the history, what to call them, kind of unit, remark
FOOTPRINT_ROWS = (
    ("footprint_length", "Length of the footprint", "length",
     "normal to the y axis, to the line of zero clearance"),
    ("footprint_width", "Width of the footprint", "length", "across it"),
    ("footprint_area", "Area of the footprint", "area",
     "of the deformed outer face, within the line of zero clearance"),
    ("mean_pressure", "Mean contact pressure", "pressure",
     "force over this deformed area; may therefore exceed the mean by force"))
PRESSURE_ROWS = (
    ("recovered_max_pressure", "Maximum pressure, recovered", "pressure",
     "with dual basis functions if the mortar matrix is lumped"),
    ("weighted_pressure", "Mean contact pressure by force", "pressure",
     "weighted by the force that it carries; per area of the undeformed middle "
     "surface"),
    ("pressure_variation", "Variation of the contact pressure", "",
     "its standard deviation over this mean"),
    ("load_ratio", "Force over pressure times area", "",
     "1 if the gas carries all of the load"))
WHEEL_ROWS = (
    ("loaded_radius", "Loaded radius", "length",
     "from the origin to the ground"),)
TENSION_ROWS = (
    ("max_cord_tension", "Maximum cord tension", "force"),
    ("max_fiber_tension", "Maximum fiber tension", "tension"))


def history_rows(run, columns):
    """Rows of the columns that are there and not zero."""
    units = units_of(run)
    return [Row(name, run.last(column), units[kind], remark)
            for column, name, kind, remark in columns
            if column in run.history and run.last(column)]


def place_in_history(run, column):
    """Where a maximum of the history is, from the columns beside it."""
    ply = f"ply {plain_number(run.last(column + '_ply'))}"
    if not run.has_coordinates:
        return ply
    return (f"α<sub>1</sub> = {plain_number(run.last(column + '_alpha_1'))}, "
            f"α<sub>2</sub> = {plain_number(run.last(column + '_alpha_2'))}, {ply}")


def tension_rows(run):
    """The maximum tension and its place."""
    units = units_of(run)
    return [Row(name, run.last(column), units[kind], place_in_history(run, column))
            for column, name, kind in TENSION_ROWS if column in run.history]


def displacement_rows(run):
    """The largest displacement of the shell, or only of the named points if there
    is no file of the whole shell."""
    name, unit = "Largest displacement", units_of(run)["length"]
    path = run.path("shell", ending="vtu")
    if path.exists() and run.setting("Output/Write VTU") != "false":
        data = read_vtu(path)
        moved = np.linalg.norm(data["displacement"], axis=1)
        at = int(np.argmax(moved))
        face = "outer" if data["outer_face"][at] > 0.5 else "inner"
        scale = np.abs(data["Points"]).max()
        place = ", ".join(number(value, 4, scale) for value in
                          data["Points"][at] - data["displacement"][at])
        return [Row(name, moved[at], unit,
                    f"magnitude, of the whole shell, on the {face} face at "
                    f"(x, y, z) = ({place}) of the undeformed shell")]
    probes = run.probes()
    probes = [] if probes is None else probes.where(probes["step"] == run.step)
    if len(probes) == 0:
        return []
    moved = np.linalg.norm(probes.positions("u_"), axis=1)
    at = int(np.argmax(moved))
    return [Row(name + " of a named point", moved[at], unit,
                f"magnitude, at “{escape(probes['name'][at])}”; the shell may move "
                f"more elsewhere: {path.name} is missing")]


def failure_rows(run):
    """The largest value of each failure index in the shell, or only at the named
    points where the history has none."""
    rows = []
    table_of_plies = run.plies() or {}
    for column, name in plies.INDICES.items():
        if column in run.history and np.isfinite(run.last(column)):
            rows.append(Row(f"Largest {name}", run.last(column), "",
                            place_in_history(run, column.removesuffix("_index"))
                            + "; a ply fails at 1"))
            continue
        values = table_of_plies.get(column, np.array([np.nan]))
        if not np.isfinite(values).any():
            continue
        at = int(np.nanargmax(values))
        rows.append(Row(
            f"Largest {name}, of the named points", values[at], "",
            f"at “{escape(table_of_plies['name'][at])}”, ply "
            f"{int(table_of_plies['ply'][at])}; a ply fails at 1. It may be larger "
            "elsewhere: history.csv has no maximum"))
    return rows


def place_of_peak(run):
    """Where the contact pressure is largest."""
    contact = run.contact()
    if contact is None or len(contact) == 0:
        return ""
    at = np.argmax(contact["pressure"])
    if not run.has_coordinates:
        return ", x, y, z = " + ", ".join(plain_number(contact[i][at]) for i in "xyz")
    return (f", α<sub>1</sub> = {plain_number(contact['alpha_1'][at])}, "
            f"α<sub>2</sub> = {plain_number(contact['alpha_2'][at])}")


def footprint_rows(run, footprint):
    """Length and width, each with its bounds."""
    rows = []
    for i, name in enumerate(("Length of the footprint", "Width of the footprint")):
        least, most = footprint.minimum_lengths[i], footprint.maximum_lengths[i]
        rows.append(Row(
            name, footprint.lengths[i], units_of(run)["length"],
            f"{direction(footprint, i)}; between {number(least, 4)} (nodes in "
            f"contact) and {number(most, 4)} (with their neighbors)", 4))
    return rows


def direction(footprint, i):
    """The direction of a principal axis in words, relative to the nearest axis."""
    axis = footprint.principal[i]
    near = np.argmax(np.abs(axis))
    name = footprint.axis_names[near]
    name = name if name.startswith("along") else f"along {name}"
    angle = np.degrees(np.arctan2(axis[1 - near], axis[near]))
    angle = (angle + 90) % 180 - 90
    if footprint.is_round:
        return name + "; the zone is nearly round"
    if abs(angle) < 0.05:
        return name
    toward = footprint.axis_names[1 - near]
    return (f"{name}, turned by {plain_number(abs(angle), 2)}° "
            f"{'toward' if angle > 0 else 'away from'} "
            f"{toward if len(toward) == 1 else 'the other axis'}")
