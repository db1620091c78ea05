# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of biface in Python.

    errors      wrong input
    tables      files with lines of numbers
    parameters  parameters.prm
    vtu         files for ParaView
    results     the files of a run
    study       the files of a study
"""

from .errors import BifaceError
from .results import Results
from .study import Study
from .tables import Table
from .vtu import read_vtu

__all__ = ["BifaceError", "Results", "Study", "Table", "read_vtu"]
