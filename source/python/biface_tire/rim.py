# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rims: width, diameter and height of the flanges from their names, or by rules."""

import re
from dataclasses import dataclass

from biface.errors import BifaceError

INCH = 25.4

# Height in mm of the flange over the seat of the bead by the letters of the contour;
# J is that of radial_tire.prm, the others are estimates: the usual ones of their kind
FLANGES = {"A": 11, "B": 14, "C": 16, "D": 17.5, "E": 20, "F": 22, "G": 28, "H": 34,
           "I": 19, "J": 17.5, "JJ": 18, "JK": 18, "K": 19.5, "L": 21.5, "S": 33, "T": 38,
           "V": 44}
DROP_CENTER_FLANGE = 12.7  # of rims with seats at 15 degrees
WIDE_FLANGE = 25.4         # of agricultural rims W and DW
BICYCLE_FLANGE = 6.0       # of crotchet type rims
AIRCRAFT_FLANGE = (10.0, 0.083)  # a line over the section width: see flange_of()

# Widths in inches of rims with seats at 15 degrees
TRUCK_WIDTHS = (5.25, 6, 6.75, 7.5, 8.25, 9, 9.75, 10.5, 11.75, 13, 14, 15, 16, 17)

FORMS = ("a rim is a width in inches with the letter of its contour (6J, 2.50C, 8.25), "
         "with its diameter (6Jx15, 13.25x20), or in mm (17C of a bicycle, 152mm)")


@dataclass(frozen=True)
class Rim:
    """A rim. Lengths in mm.

    width     between the flanges
    diameter  at the seats of the beads; None if the name does not say it
    contour   its letter, or an empty text
    """

    width: float
    diameter: float | None
    contour: str


def parse_rim(text, is_bicycle=False):
    """A rim from its name. That of a bicycle is in mm, `17C`, `17x622` or `622x17C`,
    all others in inches unless `mm` is said. Raises BifaceError."""
    words = re.sub(r"\s+", "", text.upper().replace("×", "X").replace(",", "."))
    number = r"(\d+(?:\.\d+)?)"
    if match := re.fullmatch(number + "MM", words):
        return checked(Rim(float(match[1]), None, ""), text)
    if is_bicycle:
        if match := re.fullmatch(r"(\d{1,3})(?:TC|C|TSS)?(?:[X-](\d{3}))?", words):
            width, diameter = match[1], match[2]
        elif match := re.fullmatch(r"(\d{3})[X-](\d{1,3})(?:TC|C|TSS)?", words):
            width, diameter = match[2], match[1]
        else:
            raise BifaceError(f"the rim '{text}' is not understood: that of a bicycle is "
                              "its inner width in mm, such as 17C, 17x622 or 622x17C.")
        return checked(Rim(float(width), float(diameter) if diameter else None, ""), text)
    match = re.fullmatch(r"(?:W|DW)?" + number + r"([A-Z]{0,2})(?:[X-]" + number + ")?",
                         words)
    if not match:
        raise BifaceError(f"the rim '{text}' is not understood: {FORMS}.")
    contour = "W" if words[0] in "WD" else match[2].removesuffix("B") or match[2]
    if contour and contour != "W" and contour not in FLANGES:
        raise BifaceError(f"the rim '{text}' has the contour {contour}, but must have one "
                          f"of {', '.join(FLANGES)}.")
    diameter = float(match[3]) * INCH if match[3] else None
    return checked(Rim(float(match[1]) * INCH, diameter, contour), text)


def checked(rim, text):
    """The rim, if it is of this world."""
    if not 10 <= rim.width <= 1200:
        raise BifaceError(f"the rim '{text}' is {rim.width:.4g} mm wide, but must be 10 to "
                          "1200 mm wide (0.4 to 47 inches).")
    return rim


def flange_of(contour, kind, width):
    """The height of the flange in mm, and where it is from: by the contour, else by the
    kind of the tire and, for aircraft, its section width in mm."""
    if contour == "W":
        return WIDE_FLANGE, "contour W, estimate"
    if contour:
        return FLANGES[contour], f"contour {contour}, " + (
            "radial_tire.prm" if contour == "J" else "estimate")
    if kind == "bicycle":
        return BICYCLE_FLANGE, "estimate"
    if kind == "truck":
        return DROP_CENTER_FLANGE, "15° drop center, estimate"
    if kind == "agricultural":
        return WIDE_FLANGE, "contour W, estimate"
    if kind == "aircraft":
        base, slope = AIRCRAFT_FLANGE
        return base + slope * width, "line through the tires of the databook"
    if kind == "passenger":
        return FLANGES["J"], "contour J"
    # of contours from C for small to G for large ones
    return min(28.0, max(14.0, 4 + 0.115 * width)), "estimate"
