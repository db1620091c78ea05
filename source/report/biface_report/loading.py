# SPDX-License-Identifier: LGPL-2.1-or-later
"""What changes from step to step: the approach, the load factor or the pressure."""

import numpy as np

from .parameters import stages

# Columns of history.csv, what they are called, and their units
LOADS = {"load_factor": ("load factor", ""),
         "pressure": ("pressure", " [force/length²]")}

# Digits of a value in a label, unless labels would be the same
LABEL_DIGITS = 4


def changing_column(run, stage, columns):
    """The first of some columns of history.csv that changes in a stage, or
    None."""
    chosen = run.history["stage"] == stage
    at = int(np.argmax(chosen))
    for column in columns:
        values = run.history[column]
        before = values[at - 1] if at > 0 else 0
        if (values[chosen] != before).any():
            return column
    return None


def varying_load(run):
    """The load that changes in the last stage in which any does: its name with
    its unit, and its values. The load factor if both do."""
    for stage in reversed(list(dict.fromkeys(run.history["stage"]))):
        column = changing_column(run, stage, LOADS)
        if column:
            return "".join(LOADS[column]), run.history[column]
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


def first_step_counted(run):
    """The first step whose displacements are measured from the same shape as
    those of the last one: a prestress is a new start."""
    first = run.steps[0]
    for i, name in stages(run.parameters) if run.parameters else []:
        chosen = run.history["stage"] == name
        if (run.setting(f"Stage {i}/Start from prestress") == "true"
                and chosen.any()):
            first = run.steps[chosen][0]
    return first
