# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong input."""


class RubberError(Exception):
    """Wrong input, told in one sentence."""
