# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs biface and reads its results.

    import biface
    results = biface.run("prm/bias_tire.prm", {"Stage 2/Travel": 30})
    results.last("force")                       # in the last step
    results.history["force"]                    # a NumPy array, a number per step
    results.history.to_pandas()                 # a DataFrame, with pandas
    results.stage("contact").contact()          # the nodes in contact at its end

    biface.sweep("prm/bias_tire.prm", {"Stage 2/Travel": [10, 20]}, ["force"])

Everything that goes wrong raises a BifaceError, whose text is one sentence. Names of
entries are "Section/Entry", those of results are the columns of doc/output.md; units
are those of the parameter file. doc/python.md is a tutorial.

    running     run, sweep, run_study: start the program
    model       Model: values and gradients for optimizers
    results     Results: the files of a run
    study       Study: the table of a sweep
    tables      Table: columns by name
    vtu         read_vtu: files for ParaView
    parameters  read and write parameter files
    entry_list  what entries there are
    program     finds and starts the program
    errors      BifaceError and its kinds
"""

from .entry_list import EntryDescription, entries
from .errors import BifaceError, NotConverged, RunError
from .model import Model
from .parameters import Parameters, read_parameters, write_parameters
from .program import find_program
from .results import Results
from .running import run, run_study, sweep
from .study import Study
from .tables import Table, read_table
from .vtu import read_vtu

__all__ = ["BifaceError", "EntryDescription", "Model", "NotConverged", "Parameters",
           "Results", "RunError", "Study", "Table", "entries", "find_program",
           "read_parameters", "read_table", "read_vtu", "run", "run_study",
           "sweep", "write_parameters"]
