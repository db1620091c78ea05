# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test protocols: tables of what is to be measured on a tire."""

from __future__ import annotations

import math
import re
from collections import namedtuple
from pathlib import Path

from biface.delimited import read_delimited
from biface.errors import BifaceError
from biface_tire_model.units import ANGLE, OF_COLUMN, factor, one_of

FOLDER = Path(__file__).parent / "protocols"

# What a row asks for: of a standing tire that is pressed on the ground, of the same with
# the ground moving, of one on a bar, of one that vibrates, of one that rolls
PRESSED, MOVED = ("radial", "footprint"), ("lateral", "longitudinal", "torsional")
BARS = ("transversal bar", "longitudinal bar")
MODES, STEADY, RUN_OVER = "modes", "steady", "bar run over"
KINDS = (*PRESSED, *MOVED, *BARS, MODES, STEADY, RUN_OVER)

# Of each column: its units in SI units and the unit by default. "%" of loads and pressures
# is of those of the tire, which is a size of 0 here.
OWN = 0
COLUMNS = {
    "pressure": ({**OF_COLUMN["pressure"], "%": OWN}, "%"),
    "load": ({**OF_COLUMN["force"], "%": OWN}, "%"),
    "inclination_angle": (ANGLE, "deg"),
    "slip_angle": (ANGLE, "deg"),
    "slip_ratio": ({"-": 1, "%": 0.01}, "-"),
    "velocity": (OF_COLUMN["velocity"], "km/h"),
    "height": (OF_COLUMN["length"], "mm")}

# Columns that have no meaning for kinds
UNUSED = {
    "load": (MODES,),
    "inclination_angle": (MODES, *BARS, RUN_OVER),
    "slip_angle": tuple(kind for kind in KINDS if kind != STEADY),
    "slip_ratio": tuple(kind for kind in KINDS if kind != STEADY),
    "velocity": tuple(kind for kind in KINDS if kind not in (STEADY, RUN_OVER)),
    "height": tuple(kind for kind in KINDS if kind not in (*BARS, RUN_OVER))}

# Beyond this the program has no inclination, and a wheel would lie on its side
LARGEST_ANGLE = math.pi / 2
LARGEST_SLIP = 1
# A load or pressure in parts of that of the tire that is a wrong unit
LARGEST_PART = 10
# Height of bars, mm, if there is none
HEIGHT = 10

# A list in a cell: more is a mistake
MOST_VALUES = 1000

# A row of a protocol. kind is one of KINDS; the others are tuples of numbers in SI units and
# radians, of loads and pressures negative ones: -0.5 is half of that of the tire. place names
# file and line
Row = namedtuple("Row", "place kind pressure load inclination_angle slip_angle slip_ratio "
                        "velocity height")


def shipped():
    """The names of the protocols that come with the program."""
    return sorted(path.stem for path in FOLDER.glob("*.csv"))


def find(name: str) -> Path:
    """The file of a protocol: one that is shipped, or any other. Raises BifaceError if there
    is none."""
    if name in shipped():
        return FOLDER / f"{name}.csv"
    path = Path(name)
    if not path.is_file():
        raise BifaceError(f"the protocol is '{name}', but must be {one_of(shipped())}, or a "
                          "file.")
    return path


def read_protocol(path) -> list[Row]:
    """The rows of a protocol: a CSV file with the column kind and any of COLUMNS, each with
    its unit behind it, as in 'load [kN]'. A cell may hold several values, separated by
    blanks, or begin:end:number; the row stands for all their combinations. Empty cells are
    100 % of loads and pressures, otherwise 0; of velocities, that of the file of the tire.

    Raises BifaceError with file and line for what is not possible."""
    table = read_delimited(path, lambda cell: name_of(cell)[0] in ("kind", *COLUMNS))
    columns = columns_of(table.names, path)
    if not table.rows:
        raise BifaceError(f"{path} has no rows: a protocol needs one at least.")
    result, seen = [], {}
    for number, cells in table.rows:
        place = f"{path}, line {number}"
        if len(cells) != len(table.names):
            raise BifaceError(f"{place}: the row has {len(cells)} fields where "
                              f"{len(table.names)} columns are named.")
        row = row_of(cells, columns, place)
        if row[1:] in seen:
            raise BifaceError(f"{place} says the same as line {seen[row[1:]]}: remove one "
                              "of them.")
        seen[row[1:]] = number
        result.append(row)
    return result


def name_of(cell):
    """The name of a column and its unit, None without one."""
    match = re.fullmatch(r"([A-Za-z_ ]+?)\s*(?:\[(.*)\])?", cell.strip())
    if not match:
        return None, None
    return re.sub(r"[ _]+", "_", match[1]).lower(), match[2]


def columns_of(names, path):
    """Of each column its number and the size of its unit; of kind the number alone."""
    result = {}
    for i, cell in enumerate(names):
        name, unit = name_of(cell)
        if name not in ("kind", *COLUMNS):
            raise BifaceError(f"{path}: the column '{cell}' is not known: a protocol has "
                              f"{one_of(('kind', *COLUMNS))}.")
        if name in result:
            raise BifaceError(f"{path} has the column {name} twice.")
        if name == "kind":
            result[name] = i, None
            continue
        sizes, default = COLUMNS[name]
        result[name] = i, factor(sizes, default if unit is None else unit,
                                 f"{path}: the unit of the column {name}")
    if "kind" not in result:
        raise BifaceError(f"{path} has no column 'kind', which says what each row asks for.")
    return result


def row_of(cells, columns, place):
    """A Row of the cells of a line."""
    kind = re.sub(r"[ _]+", " ", cells[columns["kind"][0]].strip().lower())
    if kind not in KINDS:
        raise BifaceError(f"{place}: the kind is '{kind}', but must be {one_of(KINDS)}.")
    values = {}
    for name in COLUMNS:
        i, size = columns.get(name, (None, None))
        text = "" if i is None else cells[i].strip()
        if text and kind in UNUSED.get(name, ()):
            raise BifaceError(f"{place}: {name} is '{text}', but a row of the kind '{kind}' "
                              "has none: leave it empty.")
        values[name] = scaled(list_of(text, f"{place}: {name}"), name, size, text, place)
    if kind != MODES and not values["load"]:
        values["load"] = (-1.0,)
    if not values["pressure"]:
        values["pressure"] = (-1.0,)
    for name in ("inclination_angle", "slip_angle", "slip_ratio"):
        values[name] = values[name] or (0.0,)
    if kind in (*BARS, RUN_OVER):
        values["height"] = values["height"] or (HEIGHT / 1000,)
    return Row(place, kind, **values)


def list_of(text, what):
    """The numbers of a cell, in their order and each once."""
    result = []
    for word in text.split():
        try:
            parts = [float(part) for part in word.split(":")]
            if not all(map(math.isfinite, parts)) or len(parts) not in (1, 3):
                raise ValueError
        except ValueError:
            raise BifaceError(f"{what} is '{text}', but must be numbers separated by blanks, "
                              "or begin:end:number.") from None
        if len(parts) == 1:
            result += parts
            continue
        begin, end, count = parts
        if count != int(count) or not 2 <= count <= MOST_VALUES:
            raise BifaceError(f"{what} is '{text}', but the number in begin:end:number must "
                              f"be a whole one from 2 to {MOST_VALUES}.")
        result += [begin + (end - begin) * i / (count - 1) for i in range(int(count))]
    for value in result:
        if result.count(value) > 1:
            raise BifaceError(f"{what} is '{text}', which has {value:g} twice.")
    return result


def scaled(values, name, size, text, place):
    """Values in SI units, parts of those of the tire as negative ones. Refuses those that are
    not possible."""
    def refuse(what):
        raise BifaceError(f"{place}: {name} is '{text}', but must {what}.")

    if name in ("load", "pressure", "velocity", "height") and any(v <= 0 for v in values):
        refuse("be positive")
    if size == OWN and name in ("load", "pressure"):
        if any(value > 100 * LARGEST_PART for value in values):
            refuse(f"be at most {100 * LARGEST_PART} % of that of the tire")
        return tuple(-value / 100 for value in values)
    values = tuple(value * (size or 1) for value in values)
    if name in ("inclination_angle", "slip_angle") \
            and any(abs(value) >= LARGEST_ANGLE for value in values):
        refuse("lie between -90 and 90 degrees")
    if name == "slip_ratio" and any(abs(value) > LARGEST_SLIP for value in values):
        refuse(f"lie between -{LARGEST_SLIP} and {LARGEST_SLIP}; -1 is a locked wheel")
    return values
