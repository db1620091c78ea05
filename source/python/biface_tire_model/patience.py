# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines about work that takes long."""

import sys
import time

# Seconds after which such work says what it does
QUIET = 10


class Patience:
    """Says what is done once QUIET seconds have passed since its last line.

    say  a function that takes a line; by default one that prints it to standard error, if
         that is a terminal"""

    def __init__(self, say=None):
        self.say, self.last = say or to_terminal, time.monotonic()

    def __call__(self, what):
        now = time.monotonic()
        if now - self.last > QUIET:
            self.last = now
            self.say(f"  {what} ...")


def to_terminal(line):
    """Prints a line where someone waits for it."""
    if sys.stderr.isatty():
        print(line, file=sys.stderr, flush=True)
