# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measured contour of an inflated tire: the outer side of its carcass."""

from pathlib import Path

import numpy as np

from biface.errors import BifaceError

COLUMNS = ("radius", "axial coordinate")
FEWEST = 9


def read_contour(path):
    """The points (radius, axial coordinate) in mm of a CSV file, from one flange over the
    crown to the other. Raises BifaceError."""
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise BifaceError(f"{path} cannot be read ({error.strerror}).") from error
    except UnicodeDecodeError as error:
        raise BifaceError(f"{path} is not a text file.") from error
    points = []
    for number, line in enumerate(text.splitlines(), start=1):
        words = [word.strip() for word in line.split(",")]
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        if not points and words[0].lower() == COLUMNS[0]:
            continue
        try:
            radius, axial = map(float, words)
        except ValueError as error:
            raise BifaceError(f"{path}, line {number}: this is '{line.strip()}', but must "
                              "be a radius and an axial coordinate in mm, separated by a "
                              "comma.") from error
        if not (0 < radius < 1e4 and abs(axial) < 1e4):
            raise BifaceError(f"{path}, line {number}: the point ({words[0]}, {words[1]}) "
                              "must have a radius above 0 and both coordinates below "
                              "10000 mm.")
        if points and points[-1] == (radius, axial):
            raise BifaceError(f"{path}, line {number}: the point ({words[0]}, {words[1]}) "
                              "is the same as the one before, but must be another one.")
        points.append((radius, axial))
    if len(points) < FEWEST:
        raise BifaceError(f"{path} has {len(points)} points, but must have at least "
                          f"{FEWEST}, from one flange to the other.")
    result = np.array(points)
    if result[0, 1] > result[-1, 1]:
        result = result[::-1]
    if not result[0, 1] < 0 < result[-1, 1]:
        raise BifaceError(f"{path} must go from one side of the axial coordinate 0, the "
                          f"middle of the rim, to the other, but goes from {result[0, 1]:g} "
                          f"to {result[-1, 1]:g} mm.")
    if result[:, 0].argmax() in (0, len(result) - 1):
        raise BifaceError(f"{path} has its largest radius at an end, but must go over the "
                          "crown.")
    return result
