# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands of this directory have in common."""

import argparse
import sys
from importlib.util import find_spec


class Arguments(argparse.ArgumentParser):
    """Exits with 1, as for any wrong input."""

    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(1, f"{self.prog}: {message}\n")


def complain(command, message):
    """Prints an error; returns the exit code."""
    print(f"{command}: {message}", file=sys.stderr)
    return 1


def missing_module(needed):
    """One sentence on the first missing module of a dictionary of modules and the
    Debian packages that provide them, or None."""
    for module, package in needed.items():
        if not find_spec(module):
            return f"{module} for Python is missing (Debian: {package})."
    return None
