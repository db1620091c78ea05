# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong."""


class BifaceError(Exception):
    """What is wrong with the input, as one sentence for the user."""


class RunError(BifaceError):
    """A run that failed: its text is the message of the program.

    code     the exit code of the program, None for a sample of a study
    results  the Results of the steps before; None if there are none
    """

    def __init__(self, message, code=None, results=None):
        super().__init__(message)
        self.code, self.results = code, results


class NotConverged(RunError):
    """A run with a step that did not converge (exit code 2)."""
