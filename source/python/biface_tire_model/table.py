# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a tire test: a CSV file with a row for each steady state."""

from __future__ import annotations

import math
import re

import numpy as np

from biface.delimited import lines_of, read_delimited, separators
from biface.errors import BifaceError
from . import units
from .axes import SIGNS, convert, mentioned, named, slope_of_lateral_force
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

# Other names of channels, without case, blanks and underscores; the meanings of
# channels.py are known, too
LONG_NAMES = {"ALPHA": "slip_angle", "KAPPA": "slip_ratio", "GAMMA": "inclination_angle",
              "INCLINATION": "inclination_angle", "SPEED": "velocity",
              "LOAD": "F_z", "VERTICALLOAD": "F_z", "NORMALLOAD": "F_z",
              "NORMALFORCE": "F_z", "WHEELLOAD": "F_z", "SIDEFORCE": "F_y",
              "ALIGNINGTORQUE": "M_z", "SELFALIGNINGMOMENT": "M_z",
              "SELFALIGNINGTORQUE": "M_z"}

# Names with two meanings, the channel that they may be, and why they are not read
AMBIGUOUS = {
    "CAMBER": ("inclination_angle", "is positive if the top leans outward, which depends "
                                    "on the side of the vehicle"),
    "SR": ("slip_ratio", "may refer to the loaded or to the effective radius")}
AMBIGUOUS["CAMBERANGLE"] = AMBIGUOUS["CAMBER"]

# Other values are a wrong unit: of slips, angles, radii in m and pressures in Pa
LARGEST_SLIP = 2
LARGEST_ANGLE = math.pi / 2
LARGEST_RADIUS = 5
PRESSURES = (1e3, 1e7)

# Tests that reach less, in radians and newtons, are likely to have another unit, if none
# is named
LEAST_ANGLE = math.radians(0.35)
LEAST_LOAD = 20

# No tire has a smaller load, in newtons, whatever the unit
SMALLEST_LOAD = 0.1

# Slip angles up to which the trail is positive
SMALL_ANGLE = math.radians(3.5)

# Correlation by which data contradict their axes
CONTRADICTION = 0.5

# Axes with the other slope of F_y
OTHER_SLOPE = {"iso": "'adapted-iso' or, if y points to the right, 'adapted-sae'",
               "sae": "'adapted-sae'", "adapted-iso": "'iso'", "adapted-sae": "'sae'"}


class Measurements:
    """States of a tire test, in SI units, radians and ISO axes.

    columns  a dictionary of arrays of the same length by the names of channels.py; slips
             that are not there are 0; forces and moments that were not measured are NaN
    unused   the names of other columns of the file
    """

    def __init__(self, columns, unused=()):
        self.unused = list(unused)
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
                             for name, values in self.columns.items()}, self.unused)

    def with_column(self, name, values) -> Measurements:
        """The same with other values in a column."""
        return Measurements({**self.columns, name: values}, self.unused)

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


def read_table(path, system=None, axes: str | None = None) -> Measurements:
    """The states of a CSV file with the columns of channels.py, in any order; others are
    left out, lines that start with # or % are comments. A name may have its unit behind it,
    as in 'F_z [kN]', or below it, in a line of units. The names of SHORT_NAMES and
    LONG_NAMES are known, too, and those of any case. Columns are separated by commas,
    semicolons, tabs or blanks. A column 'status' tells which rows have failed, anything but
    'ok'; they are left out. A column 'axes' names the axes of the table.

    system  the units of columns without one, a units.System; by default those of the first
            line of a table of write_table(), otherwise newtons, meters, degrees
    axes    those of the table, see axes.py; by default those of that line, otherwise iso

    Raises BifaceError with file and line if a value is missing or not possible, or if the
    file contradicts its units or axes."""
    table = read_delimited(path, lambda cell: channel_of(cell)[0] is not None)
    system, axes = conventions(table.remarks, system, axes, path,
                               "axes" in table.names)
    names, numbered = table.names, table.rows
    chosen, numbered = columns_of(names, numbered, system, path)
    if not chosen:
        raise BifaceError(f"{path} has none of the columns {units.one_of(CHANNELS)}, "
                          f"separated by {separators()}.")
    if not numbered:
        raise BifaceError(f"{path} has no rows.")
    numbered, axes = succeeded(numbered, names, axes, path)
    values = {name: [] for _, name, *_ in chosen}
    for number, row in numbered:
        place = f"{path}, line {number}"
        if len(row) != len(names):
            raise BifaceError(f"{place}: the row has {len(row)} fields where {len(names)} "
                              "columns are named.")
        for i, name, size, _ in chosen:
            values[name].append(field(row[i], name, place) * size)
    used = [i for i, *_ in chosen]
    try:
        result = Measurements(to_iso({name: np.array(column, float)
                                      for name, column in values.items()}, axes),
                              [name for i, name in enumerate(names) if i not in used])
    except BifaceError as error:
        raise BifaceError(f"{path}: {error}") from None
    check(result, [f"{path}, line {number}" for number, _ in numbered])
    check_sizes(result, {name for _, name, _, has_unit in chosen if has_unit}, system,
                path)
    check_slopes(result, axes, path)
    return result


def header_of(path):
    """The units and axes in the first line of a table of write_table(), a units.System and
    a key of SIGNS; None of other tables."""
    return own_header(lines_of(path)[1])


def own_header(remarks):
    """The same from the comments of a table."""
    for _, line in remarks[:1]:
        match = re.fullmatch(r"# units: (.*), (deg|rad); axes: ([a-z-]+)", line.strip())
        if match and match.group(3) in SIGNS:
            return units.System(match.group(1), match.group(2)), match.group(3)
    return None


def conventions(remarks, system, axes, path, has_column):
    """The units and axes of a table from what is given, or else from its comments and
    titles. Raises BifaceError if these name axes that are not the default."""
    own = own_header(remarks)
    if own:
        for what, given, found in (
                ("axes", axes, own[1]),
                ("units", system and system.is_given and system.text, own[0].text),
                ("angles", system and system.is_angle_given and system.angle,
                 own[0].angle)):
            if given and given != found:
                raise BifaceError(f"{path} is in the {what} '{found}', as its first line "
                                  f"says, but --{what} is '{given}'.")
        return own
    if axes is None and not has_column:
        for number, line in remarks:
            found = mentioned(line)
            if found - {"iso"}:
                raise BifaceError(f"{path}, line {number}: '{line.strip()}' seems to name "
                                  f"the axes: say --axes {units.one_of(SIGNS)}.")
    return system or units.System(), axes or "iso"


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
    """The name of a column without case, blanks, hyphens and underscores."""
    return re.sub(r"[\s_-]", "", text).upper()


# How a column is named: by channels.py, in words, or by SHORT_NAMES
OWN, WORDS, SHORT = range(3)


def channel_of(text):
    """The channel of a name of a column, one of OWN, WORDS and SHORT, and its unit; None
    where there is none."""
    match = re.fullmatch(r"([^\[(]+?)\s*(?:[\[(](.*)[\])])?", text.strip())
    if not match:
        return None, OWN, None
    name, unit = match.groups()
    for channel in CHANNELS.values():
        if short(name) == short(channel.name):
            return channel.name, OWN, unit
    for channel in CHANNELS.values():
        if short(name) == short(channel.meaning):
            return channel.name, WORDS, unit
    if short(name) in LONG_NAMES:
        return LONG_NAMES[short(name)], WORDS, unit
    return SHORT_NAMES.get(name), SHORT, unit


def refuse_ambiguous(names, channels, path):
    """Refuses a column that may be one of the channels, if that is not there."""
    for text in names:
        name = re.split(r"[\[(]", text)[0].strip()
        channel, reason = AMBIGUOUS.get(short(name), (None, ""))
        if channel and channel not in channels:
            raise BifaceError(f"{path}: the column {name} {reason}: name it {channel}, "
                              "with the sign of the axes, or remove it.")


def line_of_units(row, channels):
    """The units of a line below that of the names, by channel; None if it has a number or
    an empty cell."""
    cells = {name: row[i].strip("[]() ") for i, name in channels.items() if i < len(row)}
    words = [cell for name, cell in cells.items()
             if cell or CHANNELS[name].kind != "slip"]
    if len(cells) < len(channels) or not words or not all(words) \
            or any(map(is_number, words)):
        return None
    return cells


def columns_of(names, rows, system, path):
    """The columns that are used, a list of place, name, size of the unit and whether the
    file names it; and the rows below a line of units. Other names give way to own ones,
    and short ones to words."""
    found = [(i, *channel_of(name)) for i, name in enumerate(names)]
    first = {}
    for _, name, form, _ in found:
        first[name] = min(form, first.get(name, form))
    found = [(i, name, form, unit) for i, name, form, unit in found
             if name and form == first[name]]
    channels = {i: name for i, name, *_ in found}
    for name in channels.values():
        if list(channels.values()).count(name) > 1:
            raise BifaceError(f"{path} has the column {name} twice.")
    refuse_ambiguous(names, channels.values(), path)
    below = line_of_units(rows[0][1], channels) if rows and channels else None
    result = []
    for i, name, form, unit in found:
        unit = unit if unit is not None else (below or {}).get(name)
        kind = CHANNELS[name].kind
        if unit is not None:
            size = units.factor(units.OF_COLUMN[kind], unit,
                                f"{path}: the unit of the column {name}")
        elif form != OWN and kind in ("pressure", "velocity"):
            raise BifaceError(f"{path}: the column {names[i]} needs its unit behind it, as "
                              f"in '{names[i]} [{'kPa' if kind == 'pressure' else 'km/h'}]'"
                              ".")
        else:
            size = system[kind]
        result.append((i, name, size, unit is not None))
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


def to_iso(columns, axes):
    """Columns of a table in ISO axes. In those of adapted SAE, where z points down, F_z of
    a load may be negative."""
    load = columns.get("F_z")
    if axes == "adapted-sae" and load is not None and (load < 0).all():
        columns = {**columns, "F_z": -load}
    return convert(columns, axes, "iso")


def check(data, places):
    """Refuses states that are not possible; @p places tells where each is from."""
    def refuse(wrong, sentence):
        if wrong.any():
            raise BifaceError(f"{places[np.argmax(wrong)]}: {sentence}")

    refuse(data["F_z"] <= 0, "the load F_z must be positive; in SAE axes it is negative, "
                             "see --axes.")
    refuse(data["F_z"] < SMALLEST_LOAD,
           f"the load F_z is less than {SMALLEST_LOAD} N, as with a wrong unit.")
    refuse(np.abs(data["slip_ratio"]) > LARGEST_SLIP,
           f"slip_ratio must lie between -{LARGEST_SLIP} and {LARGEST_SLIP}; it is "
           "a ratio, not percent.")
    for name in ("slip_angle", "inclination_angle"):
        refuse(np.abs(data[name]) >= LARGEST_ANGLE,
               f"{name} must lie between -90 and 90 degrees.")
    for name in ("pressure", "velocity", "loaded_radius"):
        if data[name] is not None:
            refuse(data[name] <= 0, f"{name} must be positive.")
    if data["loaded_radius"] is not None:
        refuse(data["loaded_radius"] > LARGEST_RADIUS,
               f"loaded_radius is more than {LARGEST_RADIUS} m, as with a wrong unit.")
    if data["pressure"] is not None:
        low, high = PRESSURES
        refuse((data["pressure"] < low) | (data["pressure"] > high),
               f"pressure is not between {low:g} and {high:g} Pa, as with a wrong unit.")


def check_sizes(data, with_unit, system, path):
    """Refuses angles and loads that are likely to have another unit than the default."""
    largest = np.abs(data["slip_angle"]).max(initial=0)
    if not ("slip_angle" in with_unit or system.is_angle_given) \
            and 0 < largest < LEAST_ANGLE:
        raise BifaceError(f"{path}: the slip angles reach only {math.degrees(largest):.3g} "
                          "degrees: name their unit, as in 'slip_angle [rad]', or use "
                          "--angles.")
    largest = data["F_z"].max(initial=0)
    if not ("F_z" in with_unit or system.is_given) and 0 < largest < LEAST_LOAD:
        raise BifaceError(f"{path}: the loads reach only {largest:.3g} N: name their unit, "
                          "as in 'F_z [kN]', or use --units.")


def correlation(data, output, slip, chosen):
    """The correlation of a force or moment over the load with a slip, in some of the states;
    0 if they tell nothing."""
    chosen = chosen & np.isfinite(data[output])
    slips, values = data[slip][chosen], (data[output] / data["F_z"])[chosen]
    if len(np.unique(slips)) < 3 or np.ptp(values) == 0:
        return 0
    return np.corrcoef(slips, values)[0, 1]


def check_slopes(data, axes, path):
    """Refuses data whose forces contradict the axes."""
    words = ("falls", "rises")
    upright = np.abs(data["inclination_angle"]) < ANGLE_STEP
    for force, slip, chosen, wanted, (found, right), hint in (
            ("F_y", "slip_angle", data.is_lateral, -1,
             words[::slope_of_lateral_force(axes)], f", such as {OTHER_SLOPE[axes]}"),
            ("F_x", "slip_ratio", data.is_longitudinal, 1, words, "")):
        if wanted * correlation(data, force, slip, chosen & upright) < -CONTRADICTION:
            raise BifaceError(f"{path}: {force} {found} with {slip}, but {right} in the "
                              f"axes '{axes}': it has others{hint}; see --axes.")


def doubts(data):
    """Sentences on signs that few tires have in the axes of ISO, in which data are: those
    of the table may be others than assumed."""
    result = []
    straight = data.is_longitudinal & data.is_lateral
    if correlation(data, "F_y", "inclination_angle", straight) > CONTRADICTION:
        result.append("F_y pushes a tire that leans to the right to the left: the "
                      "inclination angles may have the other sign, see --axes.")
    small = np.abs(data["slip_angle"]) < SMALL_ANGLE
    upright = np.abs(data["inclination_angle"]) < ANGLE_STEP
    if correlation(data, "M_z", "slip_angle",
                   data.is_lateral & upright & small) < -CONTRADICTION:
        result.append("M_z turns the wheel away from its velocity at small slip angles: it "
                      "may have the other sign, see --axes.")
    rolling = data["M_y"][straight & np.isfinite(data["M_y"])]
    if len(rolling) and rolling.mean() > 0:
        result.append("M_y drives a wheel that rolls straight ahead: it may have the other "
                      "sign, see --axes.")
    return result


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
