# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a tire test: a CSV file with a row for each steady state."""

from __future__ import annotations

import math
import re

import numpy as np

from biface.delimited import read_delimited, separators
from biface.errors import BifaceError
from . import units
from .axes import convert, named
from .channels import CHANNELS, INPUTS, OUTPUTS

# Slips up to which a state counts as one without that slip; angle in radians
PURE_SLIP = 0.005
PURE_ANGLE = math.radians(0.1)

# Values that differ by less are one level of a test: of loads, pressures and velocities
# relative to the largest, of angles in radians
RELATIVE_STEP = 0.03
ANGLE_STEP = math.radians(0.25)

# Names of columns in measurements; those of angles and forces as in the axes of the table
SHORT_NAMES = {"SA": "slip_angle", "SL": "slip_ratio", "IA": "inclination_angle",
               "P": "pressure", "V": "velocity", "RL": "loaded_radius"}

# Larger values are a wrong unit
LARGEST_SLIP = 2
LARGEST_ANGLE = math.pi / 2


class Measurements:
    """States of a tire test, in SI units, radians and ISO axes.

    columns  a dictionary of arrays of the same length by the names of channels.py; slips
             that are not there are 0; forces and moments that were not measured are NaN
    """

    def __init__(self, columns):
        self.columns = {name: np.asarray(values, float)
                        for name, values in columns.items()}
        if "F_z" not in self.columns:
            raise BifaceError("the table has no column F_z, the load.")
        if not any(name in self.columns for name in ("slip_ratio", "slip_angle")):
            raise BifaceError("the table has neither a column slip_ratio nor a "
                              "column slip_angle.")
        if not any(name in self.columns for name in OUTPUTS):
            raise BifaceError("the table has no forces and moments: it needs at least one "
                              f"of the columns {units.one_of(OUTPUTS)}.")

    def __len__(self):
        return len(self.columns["F_z"])

    def __getitem__(self, name):
        """A column; zeros for slips that are not there, NaN for what was not measured, and
        None for pressure, velocity and loaded radius."""
        if name in self.columns:
            return self.columns[name]
        if name in ("pressure", "velocity", "loaded_radius"):
            return None
        return np.full(len(self), 0.0 if name in INPUTS else np.nan)

    def where(self, chosen) -> Measurements:
        """Some of the states, by an array of booleans or numbers of rows."""
        return Measurements({name: values[chosen]
                             for name, values in self.columns.items()})

    def with_column(self, name, values) -> Measurements:
        """The same with other values in a column."""
        return Measurements({**self.columns, name: values})

    def arguments(self):
        """The arguments of MagicFormula.evaluate()."""
        return {"F_z": self["F_z"], "kappa": self["slip_ratio"],
                "alpha": self["slip_angle"], "gamma": self["inclination_angle"],
                "pressure": self["pressure"], "velocity": self["velocity"]}

    @property
    def is_lateral(self):
        """Where there is no longitudinal slip."""
        return np.abs(self["slip_ratio"]) <= PURE_SLIP

    @property
    def is_longitudinal(self):
        """Where there is no slip angle."""
        return np.abs(self["slip_angle"]) <= PURE_ANGLE

    def levels(self, name):
        """The values at which a quantity was held, as an array, and the number of the
        level of each state. Without the column there is a single level, NaN."""
        values = self[name]
        if values is None:
            return np.array([np.nan]), np.zeros(len(self), int)
        largest = np.abs(values).max(initial=0)
        step = (ANGLE_STEP if CHANNELS[name].kind == "angle" else
                PURE_SLIP if CHANNELS[name].kind == "slip" else RELATIVE_STEP * largest)
        return group(values, step)


def group(values, step):
    """The means of the groups of an array in which neighbors differ by at most a step, and
    the number of the group of each value."""
    order = np.argsort(values, kind="stable")
    starts = np.diff(values[order], prepend=values[order][:1]) > step
    numbers = np.empty(len(values), int)
    numbers[order] = np.cumsum(starts)
    return np.array([values[numbers == number].mean()
                     for number in range(numbers.max(initial=0) + 1)]), numbers


def read_table(path, system=None, axes: str = "iso") -> Measurements:
    """The states of a CSV file with the columns of channels.py, in any order; others are
    left out, lines that start with # or % are comments. A name may have its unit behind it,
    as in 'F_z [kN]', or below it, in a line of units. The short names of SHORT_NAMES are
    known, too, and those of any case. Columns are separated by commas, semicolons, tabs or
    blanks. A column 'status' tells which rows have failed, anything but 'ok'; they
    are left out. A column 'axes' names the axes of the table.

    system  the units of columns without one, a units.System; newtons, meters, degrees by
            default
    axes    those of the table, see axes.py

    Raises BifaceError with file and line if a value is missing or not possible."""
    system = system or units.System()
    names, numbered = read_delimited(path, lambda cell: channel_of(cell)[0] is not None)
    chosen, numbered = columns_of(names, numbered, system, path)
    if not chosen:
        raise BifaceError(f"{path} has none of the columns {units.one_of(CHANNELS)}, "
                          f"separated by {separators()}.")
    if not numbered:
        raise BifaceError(f"{path} has no rows.")
    numbered, axes = succeeded(numbered, names, axes, path)
    values = {name: [] for _, name, _ in chosen}
    for number, row in numbered:
        place = f"{path}, line {number}"
        if len(row) != len(names):
            raise BifaceError(f"{place}: the row has {len(row)} fields where {len(names)} "
                              "columns are named.")
        for i, name, size in chosen:
            values[name].append(field(row[i], name, place) * size)
    try:
        result = Measurements(convert({name: np.array(column, float)
                                       for name, column in values.items()}, axes, "iso"))
    except BifaceError as error:
        raise BifaceError(f"{path}: {error}") from None
    check(result, [f"{path}, line {number}" for number, _ in numbered])
    return result


def succeeded(numbered, names, axes, path):
    """The rows that have not failed, and the axes that they name."""
    def cells(name):
        return [row[names.index(name)] if len(row) == len(names) else ""
                for _, row in numbered]

    if "axes" in names:
        found = sorted(set(cells("axes")))
        if len(found) > 1:
            raise BifaceError(f"{path} has rows in different axes, {found[0]} and "
                              f"{found[1]}.")
        axes = named(found[0])
    if "status" in names:
        numbered = [line for line, status in zip(numbered, cells("status"))
                    if status in ("ok", "")]
        if not numbered:
            raise BifaceError(f"all rows of {path} have failed, see the column 'status'.")
    return numbered, axes


def short(text):
    """The name of a column without case and underscores."""
    return text.replace("_", "").upper()


def channel_of(text):
    """The channel of a name of a column, whether it is one of SHORT_NAMES, and its unit;
    None where there is none."""
    match = re.fullmatch(r"(\w+)\s*(?:[\[(](.*)[\])])?", text.strip())
    if not match:
        return None, False, None
    name, unit = match.groups()
    for channel in CHANNELS:
        if short(name) == short(channel):
            return channel, False, unit
    return SHORT_NAMES.get(name), True, unit


def line_of_units(row, channels):
    """The units of a line below that of the names, by channel; None if it has a number or
    an empty cell."""
    cells = [row[i].strip("[]() ") for i in channels if i < len(row)]
    if len(cells) < len(channels) or not all(cells) or any(map(is_number, cells)):
        return None
    return dict(zip(channels.values(), cells))


def columns_of(names, rows, system, path):
    """The columns that are used, a list of place, name and size of the unit; and the rows
    below a line of units. Short names give way to long ones."""
    found = [(i, *channel_of(name)) for i, name in enumerate(names)]
    long = {name for _, name, is_short, _ in found if name and not is_short}
    found = [(i, name, is_short, unit) for i, name, is_short, unit in found
             if name and not (is_short and name in long)]
    channels = {i: name for i, name, *_ in found}
    for name in channels.values():
        if list(channels.values()).count(name) > 1:
            raise BifaceError(f"{path} has the column {name} twice.")
    below = line_of_units(rows[0][1], channels) if rows and channels else None
    result = []
    for i, name, is_short, unit in found:
        unit = unit if unit is not None else (below or {}).get(name)
        kind = CHANNELS[name].kind
        if unit is not None:
            size = units.factor(units.OF_COLUMN[kind], unit,
                                f"{path}: the unit of the column {name}")
        elif is_short and kind in ("pressure", "velocity"):
            raise BifaceError(f"{path}: the column {names[i]} needs its unit behind it, as "
                              f"in '{names[i]} [{'kPa' if kind == 'pressure' else 'km/h'}]'"
                              ".")
        else:
            size = system[kind]
        result.append((i, name, size))
    return result, rows[1:] if below else rows


def is_number(text):
    """Whether a cell is a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def field(text, name, place):
    """A number of a row. That of a force or moment may be missing."""
    if name in OUTPUTS and text.strip().lower() in ("", "nan"):
        return math.nan
    return to_float(text, place, name)


def to_float(text, place, what):
    """A finite number of a file."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise BifaceError(f"{place}: {what} is '{text.strip()}', but must be a number.")
    return value


def check(data, places):
    """Refuses states that are not possible; @p places tells where each is from."""
    def refuse(wrong, sentence):
        if wrong.any():
            raise BifaceError(f"{places[np.argmax(wrong)]}: {sentence}")

    refuse(data["F_z"] <= 0, "the load F_z must be positive; in SAE axes it is negative, "
                             "see --axes.")
    refuse(np.abs(data["slip_ratio"]) > LARGEST_SLIP,
           f"slip_ratio must lie between -{LARGEST_SLIP} and {LARGEST_SLIP}; it is "
           "a ratio, not percent.")
    for name in ("slip_angle", "inclination_angle"):
        refuse(np.abs(data[name]) >= LARGEST_ANGLE,
               f"{name} must lie between -90 and 90 degrees.")
    for name in ("pressure", "velocity", "loaded_radius"):
        if data[name] is not None:
            refuse(data[name] <= 0, f"{name} must be positive.")


def write_table(columns, system, axes="iso"):
    """A table as text.

    columns  a dictionary of arrays by the names of channels.py, in SI units and ISO axes
    system   the units to write, a units.System"""
    columns = convert(columns, "iso", axes)
    names = [name for name in CHANNELS if name in columns]
    arrays = np.broadcast_arrays(*(columns[name] for name in names))
    rows = zip(*(array.ravel() / system[CHANNELS[name].kind]
                 for name, array in zip(names, arrays)))
    return (f"# units: {system.text}, {system.angle}; axes: {axes}\n"
            + ",".join(names) + "\n"
            + "".join(",".join(f"{value + 0.0:.10g}" for value in row) + "\n"
                      for row in rows))
