# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modulus of rubber from its hardness."""

from biface.errors import BifaceError

# where both relations hold
LOWEST, HIGHEST = 40, 80


def young_modulus(shore):
    """Young's modulus in MPa from Shore A: A. N. Gent, Rubber Chemistry and
    Technology 31, 1958."""
    if not LOWEST <= shore <= HIGHEST:
        raise BifaceError(f"--shore is {shore:g}, but must lie between {LOWEST} and "
                          f"{HIGHEST}, where the relations between hardness and "
                          "modulus hold.")
    return 0.0981 * (56 + 7.62336 * shore) / (0.137505 * (254 - 2.54 * shore))


def young_modulus_of_simulations(shore):
    """The same from simulated tests: H. J. Qi, K. Joyce, M. C. Boyce, Rubber
    Chemistry and Technology 76, 2003."""
    return 10 ** (0.0235 * shore - 0.6403)
