# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong input."""


class BifaceError(Exception):
    """What is wrong with the input, as one sentence for the user."""
