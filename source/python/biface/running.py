# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs and sweeps of parameter files."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from .errors import BifaceError, NotConverged, RunError
from .parameters import to_text, write_parameters
from .program import NOT_CONVERGED, STOPPED, execute
from .results import Results
from .study import Study

Progress = Callable[[str], object]


def run(file: str | os.PathLike, settings: Mapping[str, object] | None = None,
        output: str | os.PathLike = "output", *, ranks: int = 1,
        program: str | os.PathLike | None = None,
        progress: bool | Progress = False, may_stop: bool = False,
        restart: bool = False) -> Results:
    """Runs a parameter file and returns its results.

    file      the parameter file
    settings  entries with other values than in the file, such as
              {"Stage 2/Travel": 30}: numbers, booleans, texts, or lists of these
    output    the directory of the results; files of an earlier run that this one
              does not write stay there
    ranks     number of MPI ranks, by mpirun if more than one
    program   the program; see find_program() for the default
    progress  True prints a line for each step; a function is called with it
    may_stop  whether a run with a step that does not converge returns the steps
              before it, with the message in the attribute `stopped`
    restart   continues the run in the directory from its last checkpoint

    Raises NotConverged if a step does not converge, with the steps before it in
    its attribute `results`, and RunError if the program refuses the input or fails
    otherwise. Ctrl-C stops the program, which keeps the steps done."""
    words = [file, "--output", output, *overrides(settings)]
    if restart:
        words.append("--restart")
    code, message = execute(words, ranks, program, printing(progress))
    if code == 0:
        return Results(output)
    results = None
    if code == NOT_CONVERGED or code in STOPPED:
        try:
            results = Results(output)
        except BifaceError:  # not a single step
            pass
    if code != NOT_CONVERGED:
        raise RunError(message, code, results)
    if results is None or not may_stop:
        raise NotConverged(message, code, results)
    results.stopped = message
    return results


def sweep(file: str | os.PathLike, variables: Mapping[str, Sequence[float]],
          outputs: Sequence[str], settings: Mapping[str, object] | None = None,
          output: str | os.PathLike = "study", *, samples: int | None = None,
          options: Mapping[str, object] | None = None, ranks: int = 1,
          program: str | os.PathLike | None = None,
          progress: bool | Progress = False, restart: bool = False) -> Study:
    """Runs a parameter file with other values of some of its numbers, as a study of
    the program, and returns the table of the samples; see doc/studies.md.

    file       the parameter file
    variables  the values of each variable: an entry such as "Stage 2/Travel", or
               several numbers with a name, such as
               "angle: Laminate/Plies[2], -Laminate/Plies[4]" (see `Study/Variables`)
    outputs    the results to collect: columns of the history, displacements of
               named points and so on, also at the end of a stage, such as
               "force @ inflation" (see `Study/Outputs`)
    settings   entries with other values in all samples, as in run()
    output     the directory of the study
    samples    None for every combination of the values; or the number of random
               samples (a Latin hypercube) within ranges, two values per variable
    options    other entries of the section `Study`, such as {"Warm start": False}
    ranks, program, progress, restart
               as in run(); each rank runs samples of its own unless
               options={"Group size": ...} has more of them share one

    The samples that fail have NaN in place of outputs, and the reason in the column
    "status", which is "ok" for the others. Raises RunError if the program refuses
    the input."""
    for variable, values in variables.items():
        if isinstance(values, str) or not hasattr(values, "__iter__"):
            raise BifaceError(f"The values of '{variable}' are {values!r}, but must be a "
                              "list of numbers.")
    output = Path(output)
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BifaceError(f"{output} cannot be created ({error.strerror}).") from None
    separator = ", " if samples is None else ":"
    study = {"Base file": Path(file).resolve(),
             "Variables": "; ".join(variables),
             "Values": "; ".join(
                 f"{name_of(variable)}: {separator.join(map(to_text, values))}"
                 for variable, values in variables.items()),
             "Outputs": outputs}
    if samples is not None:
        study.update({"Sampling": "Latin hypercube", "Number of samples": samples})
    study_file = output / "sweep.prm"
    write_parameters(study_file, {
        f"Study/{name}": value for name, value in {**study, **(options or {})}.items()})
    return run_study(study_file, settings, output, ranks=ranks, program=program,
                     progress=progress, restart=restart)


def run_study(file: str | os.PathLike, settings: Mapping[str, object] | None = None,
              output: str | os.PathLike = "study", *, ranks: int = 1,
              program: str | os.PathLike | None = None,
              progress: bool | Progress = False, restart: bool = False) -> Study:
    """Runs the study that a file with a section `Study` describes, and returns the
    table of the samples. The arguments and errors are those of sweep()."""
    words = [file, "--study", "--output", output, *overrides(settings)]
    if restart:
        words.append("--restart")
    code, message = execute(words, ranks, program, printing(progress))
    # without a sample that succeeds, the table still has the reasons
    if code not in (0, NOT_CONVERGED):
        raise RunError(message, code)
    return Study(output)


def name_of(variable):
    """The name of a variable of a study."""
    name, colon, _ = variable.partition(":")
    return name.strip() if colon else variable.strip()


def overrides(settings):
    """The words of the command line that set entries."""
    return [word for name, value in (settings or {}).items()
            for word in ("--set", f"{name}={to_text(value)}")]


def printing(progress):
    """The function to be called with each line of progress."""
    return (lambda line: print(line, flush=True)) if progress is True else progress
