# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of other programs: rows of cells below a line of names.

Cells are separated by commas, semicolons, tabs or blanks, whichever gives the most known
names of columns. Where they are not separated by commas, numbers may have decimal commas.
"""

from __future__ import annotations

import csv
import re

from .errors import BifaceError

SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", " ": "blanks"}

# Lines that may contain the names, below a title
MOST_TITLES = 3

_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+([eE][+-]?\d+)?")
_DECIMAL_POINT = re.compile(r"[+-]?\d*\.\d+([eE][+-]?\d+)?")


def lines_of(path) -> list[tuple[int, str]]:
    """The lines of a file with their numbers, but empty ones and those that start with #
    or %. Raises BifaceError if it has none or cannot be read."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            lines = [(number, line) for number, line in enumerate(file, 1)
                     if line.strip() and line.lstrip()[0] not in "#%"]
    except UnicodeDecodeError:
        raise BifaceError(f"{path} is not a text file.") from None
    except OSError as error:
        raise BifaceError(f"{path} cannot be read ({error.strerror}).") from None
    if not lines:
        raise BifaceError(f"{path} is empty.")
    return lines


def cells_of(line, separator) -> list[str]:
    """The cells of a line; a unit in brackets belongs to the name before it."""
    if separator == " ":
        return re.split(r"\s+(?!\[)", line.strip())
    return next(csv.reader([line], delimiter=separator, skipinitialspace=True))


def read_delimited(path, is_known) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The names of the columns of a file, and its rows with the numbers of their lines;
    numbers have decimal points.

    is_known  a function that tells whether a cell is the name of a column

    Raises BifaceError if the file cannot be read or is empty, or if some numbers have
    decimal commas and others points."""
    lines = lines_of(path)
    found = [(sum(map(is_known, cells_of(line, separator))), -place, -i, separator)
             for place, (_, line) in enumerate(lines[:MOST_TITLES])
             for i, separator in enumerate(SEPARATORS)]
    count, place, _, separator = max(found)
    place, separator = (-place, separator) if count else (0, ",")
    names = [name.strip() for name in cells_of(lines[place][1], separator)]
    rows = [(number, cells_of(line, separator)) for number, line in lines[place + 1:]]
    return names, rows if separator == "," else with_points(path, rows)


def with_points(path, rows):
    """The rows with decimal points in place of decimal commas."""
    cells = [cell.strip() for _, row in rows for cell in row]
    if not any(map(_DECIMAL_COMMA.fullmatch, cells)):
        return rows
    if any(map(_DECIMAL_POINT.fullmatch, cells)):
        raise BifaceError(f"{path} has numbers with decimal commas and others with decimal "
                          "points, but all must have the same.")
    return [(number, [cell.replace(",", ".") if _DECIMAL_COMMA.fullmatch(cell.strip())
                      else cell for cell in row]) for number, row in rows]


def separators() -> str:
    """The separators in a sentence."""
    *names, last = SEPARATORS.values()
    return ", ".join(names) + " or " + last
