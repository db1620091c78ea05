# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as functions of numbers of the parameter file, with their derivatives."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from .errors import BifaceError, RunError
from .parameters import write_parameters
from .results import Results
from .running import Progress, name_of, printing, run_study
from .tables import Table


class Model:
    """Results of a parameter file as functions of some of its numbers, with
    gradients, for optimizers such as SciPy's:

        model = Model("tire.prm", ["Stage 1/Pressure"], ["force", "max_pressure"])
        minimize(model.value, [0.2], args="max_pressure", jac=model.gradient)

    The program runs once at each point; all outputs and derivatives are of this run.
    map() runs several points at once.
    """

    def __init__(self, file: str | os.PathLike, variables: Sequence[str],
                 outputs: Sequence[str], settings: Mapping[str, object] | None = None,
                 output: str | os.PathLike = "model", *, derivatives: bool = True,
                 ranks: int = 1, program: str | os.PathLike | None = None,
                 progress: bool | Progress = False):
        """The variables and outputs are those of sweep(), and the other arguments
        those of run(); results are in numbered directories in `output`. Without
        `derivatives` there are values only. `progress` prints a line for each point, or
        is called with it."""
        if isinstance(variables, str) or isinstance(outputs, str):
            raise BifaceError("Variables and outputs must be lists of names.")
        self.file, self.variables, self.outputs = file, list(variables), list(outputs)
        self.settings = dict(settings or {})
        if derivatives:
            check_factors(self.variables)
            self.settings["Sensitivities/Entries"] = "; ".join(variables)
            self.settings["Sensitivities/Outputs"] = list(dict.fromkeys(
                result_and_stage(output)[0] for output in outputs))
        self.output, self.ranks, self.program = Path(output), ranks, program
        self.progress = printing(progress)
        self.n_studies = 0
        # by point: the row of the table of its study, and where the results are
        self.runs: dict[tuple[float, ...], tuple[dict, Path]] = {}

    def value(self, point: Sequence[float], output: str) -> float:
        """An output at a point, the values of the variables. Raises RunError if the
        run fails."""
        values = {result_and_stage(name): value
                  for name, value in self._run(point)[0].items()}
        found = values.get(result_and_stage(output))
        if found is None:
            raise BifaceError(f"'{output}' is not an output of the model: it has "
                              f"{', '.join(map(repr, self.outputs))}.")
        return float(found)

    def gradient(self, point: Sequence[float], output: str) -> np.ndarray:
        """The derivatives of an output by the variables. Outputs at the end of a
        stage other than the last one need `Sensitivities/Stages` in the settings."""
        result, stage = result_and_stage(output)
        results = self.results(point)
        # those of an earlier stage belong to 'OUTPUT @ STAGE'
        derivatives = results.stage(
            stage or results.last("stage")).derivatives().get(result)
        if derivatives is None:
            raise BifaceError(f"{results.directory} has no derivatives of '{output}'; "
                              "see 'Sensitivities/Stages'.")
        # those by factors are relative
        return np.array([
            derivatives[name_of(variable)] / (x if is_factor(variable) else 1)
            for variable, x in zip(self.variables, point)])

    def results(self, point: Sequence[float]) -> Results:
        """All results at a point."""
        return Results(self._run(point)[1])

    def map(self, points: Sequence[Sequence[float]], at_once: int = 1) -> Table:
        """The outputs at several points, of which `at_once` run at the same time, each
        on the ranks of the model: a table with the columns of the variables, of the
        outputs, and "status". Points that fail have NaN in place of outputs, and the
        reason in the column "status", which is "ok" for the others. value() and
        gradient() do not run these points again."""
        keys = [self._key(point) for point in points]
        if not keys:
            raise BifaceError("There is no point.")
        self._run_all(keys, at_once)
        rows = [self.runs[key][0] for key in keys]
        columns = {name_of(variable): np.array([key[i] for key in keys])
                   for i, variable in enumerate(self.variables)}
        for name in self.outputs:
            columns[name] = np.array([float(row[name]) for row in rows])
        columns["status"] = np.array([row["status"] for row in rows], dtype=object)
        return Table(columns)

    def _key(self, point):
        key = tuple(map(float, point))
        if len(key) != len(self.variables):
            raise BifaceError(f"The point has {len(key)} numbers, but the model has "
                              f"{len(self.variables)} variables.")
        return key

    def _run(self, point):
        key = self._key(point)
        self._run_all([key], 1)
        if self.runs[key][0]["status"] != "ok":
            raise RunError(self.runs[key][0]["status"])
        return self.runs[key]

    def _run_all(self, keys, at_once):
        """Runs the points that are new, as the samples of a study."""
        new = [key for key in dict.fromkeys(keys) if key not in self.runs]
        if not new:
            return
        self.n_studies += 1
        directory = self.output / f"{self.n_studies:04d}"
        try:
            directory.mkdir(parents=True, exist_ok=True)
            with open(directory / "points.csv", "w", encoding="utf-8",
                      newline="") as file:
                lines = csv.writer(file)
                lines.writerow(map(name_of, self.variables))
                lines.writerows([map(repr, key) for key in new])
        except OSError as error:
            raise BifaceError(f"{directory} cannot be written "
                              f"({error.strerror}).") from None
        study_file = directory / "points.prm"
        write_parameters(study_file, {
            "Study/Base file": Path(self.file).resolve(),
            "Study/Variables": "; ".join(self.variables),
            "Study/Sampling": "file", "Study/Samples file": "points.csv",
            "Study/Outputs": self.outputs, "Study/Group size": self.ranks})
        study = run_study(study_file, self.settings, directory,
                          ranks=self.ranks * min(at_once, len(new)),
                          program=self.program)
        for sample, key in enumerate(new):
            row = study.row(sample)
            self.runs[key] = row, study.directory / f"sample-{sample + 1:04d}"
            if self.progress:
                self.progress(f"point {len(self.runs)} at {', '.join(map(str, key))}: " + (
                    ", ".join(f"{name} {row[name]:g}" for name in self.outputs)
                    if row["status"] == "ok" else row["status"]))


def result_and_stage(output):
    """The two parts of 'force @ inflation'; the stage may be empty."""
    result, _, stage = output.partition("@")
    return result.strip(), stage.strip()


def numbers_set_by(variable):
    """The numbers of the file that a variable sets or multiplies."""
    words = variable.rpartition(":")[2].strip()
    words = words.removeprefix("factor of") if is_factor(variable) else words
    names = (word.strip().removeprefix("-").strip() for word in words.split(","))
    return {name if name.endswith("]") else f"{name}[1]" for name in names}


def check_factors(variables):
    """The program takes derivatives by the number in the file, which is not the variable
    where a factor multiplies it."""
    factors = set().union(*map(numbers_set_by, filter(is_factor, variables)))
    for variable in variables:
        common = [] if is_factor(variable) else sorted(numbers_set_by(variable) & factors)
        if common:
            raise BifaceError(f"A factor multiplies '{common[0]}', which the variable "
                              f"'{name_of(variable)}' sets: there is no derivative by it.")


def is_factor(variable):
    """Whether a variable multiplies numbers of the file."""
    return variable.rpartition(":")[2].split()[:2] == ["factor", "of"]
