# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a study, read and checked."""

from __future__ import annotations

import csv
import io
import os
from pathlib import Path

import numpy as np

from .errors import BifaceError
from .parameters import read_parameters
from .results import Results
from .tables import Table, read_text, to_number

# The columns after the outputs
LAST_COLUMNS = ["status", "steps", "iterations", "seconds"]


class Study(Table):
    """The table of a study: a row for each sample, with the columns "sample", those
    of the variables, those of the outputs (NaN in samples that failed), "status",
    "steps", "iterations" and "seconds".

    directory           where it is
    variables, outputs  the names of these columns
    is_ok               for each sample, whether it did not fail
    """

    def __init__(self, directory: str | os.PathLike):
        self.directory = Path(directory)
        path = self.directory / "study.csv"
        lines = list(csv.reader(io.StringIO(read_text(path))))
        names = lines[0] if lines else []
        if len(names) < 6 or names[0] != "sample" or names[-4:] != LAST_COLUMNS:
            raise BifaceError(f"{path} is damaged: its first line does not name "
                              "the columns of a study.")
        if len(lines) == 1:
            raise BifaceError(f"{path} has no sample: there is nothing to report "
                              "before the first one is done.")
        twice = [name for i, name in enumerate(names) if name in names[:i]]
        if twice:
            raise BifaceError(f"{path} has two columns '{twice[0]}': give the variable "
                              "another name.")
        for i, line in enumerate(lines[1:], start=2):
            if len(line) != len(names):
                raise BifaceError(f"{path}, line {i}, is damaged: it has "
                                  f"{len(line)} fields where {len(names)} are "
                                  "named.")
        super().__init__({
            name: np.array([line[k] if name == "status" else
                            to_number(line[k], name, f"{path}, line {i},")
                            for i, line in enumerate(lines[1:], start=2)],
                           dtype=object if name == "status" else float)
            for k, name in enumerate(names)})
        self.is_ok = self["status"] == "ok"
        self.parameters = self._read_parameters()
        self.variables, self.outputs = self._split(names[1:-4])

    def _read_parameters(self):
        path = self.directory / "study.prm"
        return read_parameters(path) if path.exists() else None

    def _split(self, names):
        """The columns of variables and those of outputs: the latter are as many
        as study.prm names, and empty in samples that failed. Those over the outputs of
        a `Reference sample` are among them."""
        entry = self.parameters and self.parameters.entries.get("Study/Outputs")
        n_outputs = (len([item for item in entry.value.split(",") if item.strip()])
                     if entry else 0)
        # each has a column more, over the output of a reference
        if any(" / sample " in name for name in names[-1:]):
            n_outputs *= 2
        at = max(len(names) - n_outputs, 0)
        return names[:at], names[at:]

    def values(self, name: str) -> np.ndarray:
        """The numbers of a column, of the samples that did not fail."""
        return self[name][self.is_ok]

    def results(self, sample: int) -> Results:
        """The results of a sample, counted from 1."""
        return Results(self.directory / f"sample-{int(sample):04d}")
