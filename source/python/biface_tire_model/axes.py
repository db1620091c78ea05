# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signs of forces, moments and slips in the axes that tire models use.

iso          ISO 8855, the W axes of TYDEX: x forward, y to the left, z up. The slip
             angle is positive if the wheel moves to the left, and then F_y is negative;
             the inclination angle is positive if the top leans to the right.
sae          SAE J670e: x forward, y to the right, z down, that is, the ISO axes turned
             about x by 180 degrees; F_z is negative under load.
adapted-iso  as ISO, but with slip angle and inclination angle of the other sign, so that
             all slip stiffnesses are positive (Besselink, Shimmy of Aircraft Main
             Landing Gears, 2000).
adapted-sae  as SAE, but with the slip angle and F_z of the other sign, so that loads and
             all slip stiffnesses are positive (Pacejka, Tire and Vehicle Dynamics, 2012,
             Appendix 1).

The longitudinal slip is -1 for a locked wheel in all of them.
"""

import re

from biface.errors import BifaceError

# Signs relative to ISO; +1 where there is no entry
SIGNS = {
    "iso": {},
    "sae": {"slip_angle": -1, "F_y": -1, "F_z": -1, "M_y": -1, "M_z": -1},
    "adapted-iso": {"slip_angle": -1, "inclination_angle": -1},
    "adapted-sae": {"F_y": -1, "M_y": -1, "M_z": -1},
}

# What changes its sign if the tire is seen in a mirror, that is, between a tire on the
# left and the same one on the right
MIRRORED = ("slip_angle", "inclination_angle", "F_y", "M_x", "M_z")


def named(text):
    """The key of SIGNS for axes as a tire test of biface names them."""
    return text.lower().replace(" ", "-")


_NAMES = re.compile(r"\b(adapted[ -])?(iso|sae)\b", re.IGNORECASE)
_ABOUT = re.compile(r"\b(ax[ie]s|coordinates?|conventions?|system|signs?)\b|J ?670|8855",
                    re.IGNORECASE)


def mentioned(text):
    """The axes that a sentence mentions, such as 'SAE J670 coordinates': a set of keys of
    SIGNS."""
    if not _ABOUT.search(text):
        return set()
    return {("adapted-" if adapted else "") + name.lower()
            for adapted, name in _NAMES.findall(text)}


def slope_of_lateral_force(axes):
    """The sign of the slope of F_y over the slip angle."""
    signs = SIGNS[axes]
    return -signs.get("F_y", 1) * signs.get("slip_angle", 1)


def convert(values, source, target):
    """Quantities in other axes.

    values          a dictionary of arrays or numbers by the names of channels.py
    source, target  the axes, keys of SIGNS

    Returns a new dictionary. Raises BifaceError for unknown axes."""
    for axes in (source, target):
        if axes not in SIGNS:
            raise BifaceError(f"the axes are '{axes}', but must be "
                              f"{', '.join(list(SIGNS)[:-1])} or {list(SIGNS)[-1]}.")
    return {name: value * (SIGNS[source].get(name, 1) * SIGNS[target].get(name, 1))
            for name, value in values.items()}


def mirror(values):
    """The same quantities for the tire mounted on the other side of the vehicle: a new
    dictionary, in the same axes, whichever they are."""
    return {name: -value if name in MIRRORED else value
            for name, value in values.items()}
