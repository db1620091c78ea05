# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of results with lines of numbers, read and checked."""

from __future__ import annotations

import html
import os
from pathlib import Path

import numpy as np

from .errors import BifaceError

# Columns of numbers that may be NaN
UNDEFINED = ("logarithmic_derivative", "x_real", "x_imaginary", "y_real", "y_imaginary",
             "z_real", "z_imaginary")

# Rows at each end of a table that notebooks show
ROWS_AT_ENDS = 5

# Columns of text
WORDS = ("stage", "name", "face", "material", "body", "motion", "kind", "located",
         "entry", "output", "status", "axes", "excitation")


class Table(dict):
    """Columns by name: NumPy arrays of numbers or of text, all of the same length,
    which is the length of the table."""

    def __init__(self, columns):
        super().__init__(columns)
        self.n_rows = len(next(iter(columns.values())))

    def __missing__(self, name):
        raise BifaceError(f"There is no column '{name}' among "
                          f"{', '.join(map(repr, self))}.")

    def __len__(self):
        return self.n_rows

    def __repr__(self):
        return f"<Table of {self.n_rows} rows: {', '.join(self)}>"

    def _repr_html_(self) -> str:
        """The table as notebooks show it: its first and last rows."""
        shown = range(self.n_rows)
        if self.n_rows > 2 * ROWS_AT_ENDS + 1:
            shown = [*shown[:ROWS_AT_ENDS], None, *shown[-ROWS_AT_ENDS:]]

        def line(tag, cells):
            return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>"
                                    for cell in cells) + "</tr>"

        def text(value):
            return value if isinstance(value, str) else f"{value:.6g}"

        lines = [line("th", self)] + [
            line("td", ["…" for _ in self] if i is None else
                 [text(column[i]) for column in self.values()]) for i in shown]
        return (f"<table>{''.join(lines)}</table>"
                f"<p>{self.n_rows} rows, {len(self.keys())} columns</p>")

    def where(self, chosen=None, **values) -> Table:
        """The rows chosen by an array of booleans, and those with the given values in
        columns, as in where(body="foundation")."""
        chosen = np.ones(self.n_rows, bool) if chosen is None else chosen
        for name, value in values.items():
            chosen = chosen & (self[name] == value)
        return Table({name: column[chosen] for name, column in self.items()})

    def row(self, i: int) -> dict:
        """The values of a row by column; -1 is the last one."""
        return {name: column[i] for name, column in self.items()}

    def rows(self) -> list[dict]:
        """All rows, each as a dictionary."""
        return [self.row(i) for i in range(self.n_rows)]

    def positions(self, prefix: str = "") -> np.ndarray:
        """The columns x, y and z, after a prefix, as rows of points."""
        return np.stack([self[prefix + i] for i in "xyz"], -1)

    def to_pandas(self):
        """A DataFrame of pandas with the same columns."""
        try:
            from pandas import DataFrame
        except ImportError:
            raise BifaceError("to_pandas() needs the module pandas (Debian: "
                              "python3-pandas).") from None
        return DataFrame(dict(self))


def read_text(path):
    """The text of a file."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise BifaceError(f"{path} is damaged: it is not text.") from None
    except OSError as error:
        raise BifaceError(f"{path} cannot be read ({error.strerror}).") from None


def to_number(text, name, place):
    """A field as a number; an empty one is NaN."""
    try:
        return float(text) if text else np.nan
    except ValueError:
        raise BifaceError(f"{place} is damaged: '{text}' in the column '{name}' "
                          "is not a number.") from None


def read_table(path: str | os.PathLike) -> Table:
    """Any file of biface with lines of numbers. A field that is empty is NaN."""
    return read_csv(path, ())[0]


def read_csv(path, required, may_be_cut=False):
    """One of biface's CSV files, and whether its last line is cut off.

    Throws a BifaceError if a required column is missing or has a line without a
    number, or if a line has too few or too many fields."""
    lines = read_text(path).split("\n")
    is_cut = lines.pop() != ""
    if is_cut and not may_be_cut:
        raise BifaceError(f"{path} is damaged: its last line is cut off.")
    if not lines and not required:
        raise BifaceError(f"{path} is damaged: it is empty.")
    names = lines[0].split(",") if lines else []
    for name in required:
        if name not in names:
            raise BifaceError(f"{path} is damaged: its first line does not name "
                              f"the column '{name}'.")
    rows = []
    for number, line in enumerate(lines[1:], start=2):
        fields = line.split(",")
        place = f"{path}, line {number},"
        if len(fields) != len(names):
            raise BifaceError(f"{place} is damaged: it has {len(fields)} fields "
                              f"where {len(names)} are named.")
        rows.append([field if name in WORDS else to_number(field, name, place)
                     for name, field in zip(names, fields)])
    columns = {name: np.array([row[i] for row in rows],
                              dtype=object if name in WORDS else float)
               for i, name in enumerate(names)}
    for name in set(required) - set(WORDS + UNDEFINED):
        finite = np.isfinite(columns[name])
        if not finite.all():
            raise BifaceError(f"{path}, line {np.argmin(finite) + 2}, is damaged: "
                              f"the column '{name}' has no finite number.")
    return Table(columns), is_cut
