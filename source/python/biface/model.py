# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as functions of numbers of the parameter file, with their derivatives."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from .errors import BifaceError, RunError
from .results import Results
from .running import name_of, sweep


class Model:
    """Results of a parameter file as functions of some of its numbers, with
    gradients, for optimizers such as SciPy's:

        model = Model("tire.prm", ["Stage 1/Pressure"], ["force", "max_pressure"])
        minimize(model.value, [0.2], args="max_pressure", jac=model.gradient)

    The program runs once at each point; all outputs and derivatives are of this run.
    """

    def __init__(self, file: str | os.PathLike, variables: Sequence[str],
                 outputs: Sequence[str], settings: Mapping[str, object] | None = None,
                 output: str | os.PathLike = "model", *, derivatives: bool = True,
                 ranks: int = 1, program: str | os.PathLike | None = None):
        """The variables and outputs are those of sweep(), and the other arguments
        those of run(); results are in numbered directories in `output`. Without
        `derivatives` there are values only."""
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
        self.runs: dict[tuple[float, ...], tuple[dict, Results]] = {}

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
        return self._run(point)[1]

    def _run(self, point):
        key = tuple(map(float, point))
        if len(key) != len(self.variables):
            raise BifaceError(f"The point has {len(key)} numbers, but the model has "
                              f"{len(self.variables)} variables.")
        if key not in self.runs:
            study = sweep(self.file, {variable: [x] for variable, x
                                      in zip(self.variables, key)},
                          self.outputs, self.settings,
                          self.output / f"{len(self.runs) + 1:04d}",
                          options={"Group size": self.ranks}, ranks=self.ranks,
                          program=self.program)
            if not study.is_ok[0]:
                raise RunError(study["status"][0])
            self.runs[key] = study.row(0), study.results(1)
        return self.runs[key]


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
