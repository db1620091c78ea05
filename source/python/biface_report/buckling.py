# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predicted buckling loads with their shapes, and critical points on the path."""

from html import escape

import numpy as np

from .page import LeftOut, Section, number, paragraph, plain_number, table
from .shapes import pictures_of
from .units import units_of

# Columns of loads, and their heads
LOADS = {"pressure": "Pressure", "load_factor": "Load factor",
         "approach": "Approach"}


def load_columns(found):
    """The loads that are there."""
    return [column for column in LOADS if (found[column] != 0).any()]


def force_columns(found):
    """The forces that are there: on the ground, and of supports that move; the
    largest one of a support if there are no others."""
    columns = [column for column in found if column == "force"
               or column.endswith(("_force", "_moment"))]
    columns = [column for column in columns if (found[column] != 0).any()]
    return columns or [column for column in ("reaction",) if column in found
                       and (found[column] != 0).any()]


def force_head(column, units):
    """What a column of forces is called, with its unit."""
    own = {"force": "Force on the ground", "reaction": "Largest reaction"}
    kind = "moment" if column.endswith("_moment") else "force"
    return units.label(own.get(column) or
                       f"{kind.capitalize()} of {column.rpartition('_')[0]}", kind)


def wave_columns(found):
    """Columns of wave numbers, if any shape has them."""
    waves = found.get("circumferential_waves", np.array([np.nan]))
    return (["circumferential_waves", "meridional_half_waves"]
            if np.isfinite(waves).any() else [])


def common_heads(found, units):
    """Heads of the cells of common_cells()."""
    return (["Factor"] + [LOADS[column] for column in load_columns(found)]
            + [force_head(column, units) for column in force_columns(found)]
            + (["Work of the loads"] if "load_work" in found else [])
            + (["Waves around", "Half waves along the meridian"]
               if wave_columns(found) else []))


def common_cells(found, i):
    """Factor, loads and wave numbers in row i."""
    cells = [number(found["factor"][i])]
    cells += [number(found[column][i])
              for column in load_columns(found) + force_columns(found)]
    if "load_work" in found:
        # relative to that on a motion of all nodes
        cells.append(number(found["load_work"][i], 3, scale=1))
    return cells + [plain_number(found[column][i])
                    for column in wave_columns(found)]


def buckling(run):
    """The table of buckling.csv, and pictures of the last stage in it."""
    name = "Buckling loads"
    found = run.buckling()
    if found is None:
        return LeftOut(name, "No stage asks for 'Buckling'.")
    if len(found) == 0:
        return LeftOut(name, "The loads do not lead to buckling.")
    rows = [[escape(found["stage"][i]), str(int(found["mode"][i]))]
            + common_cells(found, i) for i in range(len(found))]
    all_loads = table("Buckling loads, from buckling.csv",
                      ["Stage", "Load"] + common_heads(found, units_of(run)), rows)
    text = paragraph(
        "Predicted at the end of each stage. The loads change in the stage; if all "
        "of this change is multiplied by the factor, the shell buckles: at 1, with "
        "the loads at the end of the stage. The loads in the table are these critical "
        "ones. Work of the loads: on the shape, relative to that on a motion of all "
        "nodes by its largest displacement, without prescribed displacements; 0 at a "
        "bifurcation.")
    last = found.where(found["step"] == found["step"][-1])
    pictures = pictures_of(
        run, "buckling", last,
        [f"factor {value:.5g}".replace("-", "−") for value in last["factor"]],
        "Shapes of the first buckling loads.",
        f"The shapes of buckling of the stage {escape(last['stage'][0])} with the "
        "factors of the loads")
    return Section("buckling", name,
                   (pictures + "\n" if pictures else "") + all_loads + text, True)


def critical_points(run):
    """The table of critical_points.csv."""
    name = "Critical points"
    found = run.critical_points()
    if found is None:
        return LeftOut(name, "No stage has 'Critical points' other than 'report'.")
    if len(found) == 0:
        return LeftOut(name, "The number of negative pivots of the tangent changes in "
                       "no step.")
    rows = [[f"Step {int(found['step'][i])}", escape(found["stage"][i]),
             escape(found["kind"][i]),
             "located" if found["located"][i] == "true" else "passed",
             f"{int(found['negative_pivots_before'][i])} → "
             f"{int(found['negative_pivots'][i])}"]
            + common_cells(found, i) for i in range(len(found))]
    text = paragraph(
        "Steps in which the number of negative pivots of the tangent changed. A "
        "located point is the end of its step; a passed one lies within it. At a "
        "limit point the loads work on the critical shape, at a bifurcation they do "
        "not. The loads are those of the end of the step.")
    return Section("critical", name, table(
        "Critical points, from critical_points.csv",
        ["", "Stage", "Kind", "", "Negative pivots"]
        + common_heads(found, units_of(run)), rows)
        + text, True)


def kinds_of_steps(run):
    """The kind of the critical point of each step that has one."""
    found = run.critical_points()
    return {} if found is None else dict(zip(found["step"].astype(int),
                                             found["kind"]))


def critical_range(run, steps):
    """The critical points among some steps in words."""
    kinds = kinds_of_steps(run)
    names = "; ".join(f"{kinds[step]} in step {step}" for step in steps
                      if step in kinds)
    return f" Rings: critical points, {escape(names)}." if names else ""
