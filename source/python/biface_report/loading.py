# SPDX-License-Identifier: LGPL-2.1-or-later
"""What changes from step to step: the approach, the load factor or the pressure;
and where the steps of a stage start."""

import numpy as np

from biface.parameters import stages

from .units import units_of

# Columns of history.csv, what they are called, and the kinds of their units
LOADS = {"load_factor": ("load factor", ""), "pressure": ("pressure", "pressure")}

# How the names of the stages of a tire test begin
TESTED = "tire test: "

# Digits of a value in a label, unless labels would be the same
LABEL_DIGITS = 4


def rows_before(run):
    """For each row of the history the row of the step from which it started; -1
    for none. A stage starts from the end of the one before, or of another one."""
    names = run.history["stage"]
    before = np.arange(len(names)) - 1
    planned = dict(stages(run.parameters)) if run.parameters else {}
    ends, number = {}, 0
    for row, name in enumerate(names):
        if row == 0 or name != names[row - 1]:
            later = [i for i in planned if i > number and planned[i] == name]
            number = later[0] if later else number
            start = run.setting(f"Stage {number}/Start from", "previous")
            if start != "previous":
                before[row] = ends.get(int(float(start)), before[row])
        ends[number] = row
    return before


def changing_column(run, stage, columns):
    """The first of some columns of history.csv that changes in a stage, or
    None."""
    chosen = run.history["stage"] == stage
    start = rows_before(run)[int(np.argmax(chosen))]
    for column in columns:
        values = run.history[column]
        before = values[start] if start >= 0 else 0
        if (values[chosen] != before).any():
            return column
    return None


def varying_load(run):
    """The load that changes in the last stage in which any does: its name with
    its unit, and its values. The load factor if both do."""
    for stage in reversed(list(dict.fromkeys(run.history["stage"]))):
        column = changing_column(run, stage, LOADS)
        if column:
            return units_of(run).label(*LOADS[column]), run.history[column]
    return "load factor", run.history["load_factor"]


def step_labels(run, steps):
    """What to call some steps in a legend: by what changes in their stages. No
    two values of one kind that differ look the same."""
    rows = [int(np.searchsorted(run.steps, step)) for step in steps]
    kinds = [changing_column(run, run.history["stage"][row],
                             ("approach", *LOADS)) for row in rows]
    return [f"step {step}, {label_of_row(run, row, kind, kinds, rows)}"
            .replace("-", "−")
            for step, row, kind in zip(steps, rows, kinds)]


def label_of_row(run, row, kind, kinds, rows):
    """The label of a row of the history; kinds and rows are those of the whole
    legend."""
    if kind is None:
        return run.history["stage"][row]
    values = {run.history[kind][other]
              for other, other_kind in zip(rows, kinds) if other_kind == kind}
    digits = LABEL_DIGITS
    while len({f"{value:.{digits}g}" for value in values}) < len(values):
        digits += 1
    name = LOADS[kind][0] if kind in LOADS else kind
    return f"{name} {run.history[kind][row]:.{digits}g}"


def branches(run, chosen):
    """The rows of some steps, chosen by an array of booleans, in curves: each goes
    on without a gap, and its first row is that of the step from which it starts, -1
    if that is not chosen."""
    before = rows_before(run)
    curves = []
    for row in np.flatnonzero(chosen):
        start = before[row] if before[row] >= 0 and chosen[before[row]] else -1
        if not curves or curves[-1][-1] != start:
            curves.append([start])
        curves[-1].append(row)
    return curves


def branch_name(run, rows):
    """The stages of a curve of branches()."""
    return ", ".join(dict.fromkeys(run.history["stage"][rows[1:]]))


def counted_steps(run):
    """The steps whose displacements are measured from the same shape as those of the
    last one: a prestress is a new start."""
    before, names = rows_before(run), run.history["stage"]
    anew = [name for i, name in (stages(run.parameters) if run.parameters else [])
            if run.setting(f"Stage {i}/Start from prestress") == "true"]
    origins = []
    for row, start in enumerate(before):
        is_anew = names[row] in anew and (start < 0 or names[start] != names[row])
        origins.append(row if is_anew else origins[start] if start >= 0 else -1)
    return run.steps[np.array(origins) == origins[-1]]
