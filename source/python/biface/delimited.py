# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of other programs: rows of cells below a line of names.

Cells are separated by commas, semicolons, tabs or blanks, whichever gives the most known
names of columns. Where they are not separated by commas, numbers may have decimal commas.
"""

from __future__ import annotations

import csv
import re
from collections import namedtuple

from .errors import BifaceError
from .text_file import text_of_file

SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", " ": "blanks"}

# Lines that may contain the names, below titles
MOST_TITLES = 20

_DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?")
_DECIMAL_POINT = re.compile(r"[+-]?\d*\.\d+([eE][+-]?\d+)?")

# One thousand two hundred, or a number with three decimals
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")

# Numbers with both, by what separates their thousands
_GROUPED = {",": re.compile(r"[+-]?\d{1,3}(,\d{3})+\.\d+"),
            ".": re.compile(r"[+-]?\d{1,3}(\.\d{3})+,\d+")}

# Blanks that do not break a line, which some programs write between thousands
_BLANK_IN_NUMBER = re.compile("(?<=\\d)[\u00a0\u2009\u202f](?=\\d)")

# names    of the columns
# rows     pairs of the number of the line and its cells
# remarks  lines that start with # or %, and titles: pairs of number and text
Delimited = namedtuple("Delimited", "names rows remarks")


def lines_of(path) -> tuple[list[tuple[int, str]], list[tuple[int, str]]]:
    """The lines of a file with their numbers, but empty ones; first those of the table,
    then those that start with # or %. Raises BifaceError if it has none of the former or
    cannot be read."""
    text = _BLANK_IN_NUMBER.sub("", text_of_file(path)).replace("\N{MINUS SIGN}", "-")
    numbered = [(number, line) for number, line in
                enumerate(re.split("\r\n|\r|\n", text), 1) if line.strip()]
    lines = [pair for pair in numbered if pair[1].lstrip()[0] not in "#%"]
    if not lines:
        raise BifaceError(f"{path} is empty.")
    return lines, [pair for pair in numbered if pair[1].lstrip()[0] in "#%"]


def cells_of(line, separator) -> list[str]:
    """The cells of a line; a unit in brackets belongs to the name before it."""
    if separator == " ":
        return re.split(r"\s+(?!\[)", line.strip())
    cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    return [without_thousands(cell.strip()) for cell in cells]


def without_thousands(cell) -> str:
    """A cell without separators of thousands, if its decimals tell what they are."""
    for separator, form in _GROUPED.items():
        if form.fullmatch(cell):
            return cell.replace(separator, "")
    return cell


def without_empty_end(cells, least=0) -> list[str]:
    """Cells without empty ones at the end beyond the first @p least."""
    count = len(cells)
    while count > least and not cells[count - 1]:
        count -= 1
    return cells[:count]


def read_delimited(path, is_known) -> Delimited:
    """A table of a file; numbers have decimal points. Rows of empty cells, and empty cells
    at the end of a row, are left out.

    is_known  a function that tells whether a cell is the name of a column

    Raises BifaceError if the file cannot be read or is empty, if some numbers have decimal
    commas and others points, or if commas may separate thousands."""
    lines, remarks = lines_of(path)
    found = [(sum(map(is_known, cells_of(line, separator))), -place, -i, separator)
             for place, (_, line) in enumerate(lines[:MOST_TITLES])
             for i, separator in enumerate(SEPARATORS)]
    count, place, _, separator = max(found)
    place, separator = (-place, separator) if count else (0, ",")
    names = without_empty_end(cells_of(lines[place][1], separator))
    rows = [(number, without_empty_end(cells_of(line, separator), len(names)))
            for number, line in lines[place + 1:]]
    rows = [(number, row) for number, row in rows if any(row)]
    return Delimited(names, rows if separator == "," else with_points(path, rows),
                     sorted(remarks + lines[:place]))


def with_points(path, rows):
    """The rows with decimal points in place of decimal commas."""
    cells = [cell for _, row in rows for cell in row]
    commas = list(filter(_DECIMAL_COMMA.fullmatch, cells))
    if not commas:
        return rows
    if any(map(_DECIMAL_POINT.fullmatch, cells)):
        raise BifaceError(f"{path} has numbers with decimal commas and others with decimal "
                          "points, but all must have the same.")
    if all(map(_THOUSANDS.fullmatch, commas)):
        raise BifaceError(f"{path} has numbers such as '{commas[0]}', whose comma may "
                          "separate decimals or thousands: write them with decimal points, "
                          "or without separators of thousands.")
    return [(number, [cell.replace(",", ".") if _DECIMAL_COMMA.fullmatch(cell) else cell
                      for cell in row]) for number, row in rows]


def separators() -> str:
    """The separators in a sentence."""
    *names, last = SEPARATORS.values()
    return ", ".join(names) + " or " + last
