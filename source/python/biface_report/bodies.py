# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ground and other rigid bodies for views: grids of points on them, and by
how much they have moved in each step."""

import re

import numpy as np

from biface.results import CONTACT_COLUMNS
from biface.tables import read_csv

from .ground import (PATCH_CELLS, Ground, ground_in_step, ground_of,
                     unit)
from .view_data import packed

# How far a body is drawn beyond the shell, relative to the size of the shell
MARGIN = 0.1
# A body whose clearances are off by more, relative to this size, is somewhere else
TOLERANCE = 1e-3

# Shapes in parameters.prm, and what a Ground calls them
SHAPES = {"plane": "plane", "cylinder": "drum", "sphere": "sphere"}


def bodies_of(run, labels, points):
    """The rigid bodies of a run as view.js reads them, and the names of those that
    are not drawn since their shape or their place is not known.

    labels: what the steps are called; points: those of the undeformed shell."""
    drawn, others = [], []
    ground = ground_of(run)
    travels = {step: found for step in labels if ground is not None
               and (found := ground_in_step(run, step)) is not None}
    if travels:
        drawn.append(as_dict(ground, {
            labels[step]: -found.travel * found.direction
            for step, found in travels.items()}, points))
    for name in names_of_bodies(run):
        contacts = {step: contact for step in labels
                    if (contact := contact_with(run, name, step)) is not None}
        places = {labels[step]: place for step, contact in contacts.items()
                  if (place := place_of(run, name, contact, travels.get(step), points))
                  is not None}
        if places:
            drawn.append(as_dict(body_of(run, name), places, points))
        elif contacts:
            others.append(name)
    return drawn, others


def as_dict(body, places, points):
    """A body as view.js reads it: points of its surface, and its places."""
    axes = body.patch_axes()
    margin = MARGIN * np.ptp(points, axis=0).max()
    grid = body.patch((points @ axes.T).min(0) - margin,
                      (points @ axes.T).max(0) + margin)
    return {"grid": packed(grid.astype("<f4")), "shape": 2 * [PATCH_CELLS + 1],
            "is_flat": body.shape == "plane",
            "places": {label: list(place) for label, place in places.items()}}


def names_of_bodies(run):
    """The names in the entry 'Bodies'."""
    return [name.strip() for name in run.setting("Bodies", "").split(",")
            if name.strip()]


def contact_with(run, name, step):
    """The nodes near a body, or None in steps without it."""
    path = run.path("contact-" + name.replace(" ", "_"), step)
    return read_csv(path, CONTACT_COLUMNS)[0] if path.exists() else None


def translation(run, name):
    """The first direction in which a body is moved, or None if it never is."""
    number = r"\s+(-?[\d.]+(?:[eE][+-]?\d+)?)"
    found = re.findall(":" + 3 * number, run.setting(f"Body {name}/Motions", ""))
    moved = [vector for vector in np.array(found, dtype=float) if np.any(vector)]
    return moved[0] if moved else None


def tread_on(run, name):
    """The height of the tread between a body and the shell: it is drawn where the
    tread touches it, as is the ground."""
    height = run.numbers("Contact/Tread/Height", 1)
    return (height[0] if height is not None
            and run.setting(f"Body {name}/Moves with") == "foundation" else 0)


def body_of(run, name, shift=0, sign=1):
    """A body, moved by a vector, or None if its shape is not known here. Its
    direction, times the sign, is that in which it moves, or the normal of a plane."""
    shape = SHAPES.get(run.setting(f"Body {name}/Shape"))
    point, direction, axis = (run.numbers(f"Body {name}/{entry}", 3)
                              for entry in ("Point", "Direction", "Axis"))
    if shape is None or any(vector is None for vector in (point, direction, axis)):
        return None
    if shape == "plane":
        return Ground(shape, direction, point + shift
                      - tread_on(run, name) * unit(direction))
    radius = run.numbers(f"Body {name}/Radius", 1)
    if radius is None:
        return None
    radius = radius[0] + tread_on(run, name)
    moved = translation(run, name)
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    direction = across if moved is None else sign * moved
    if shape == "drum":
        direction = direction - direction @ unit(axis) * unit(axis)
    if not np.any(direction):
        direction = across
    # the point of a Ground is on its surface
    point = point + shift - radius * unit(direction)
    return Ground(shape, direction, point, radius, axis)


def place_of(run, name, contact, ground, points):
    """By how much a body has moved, or None where that is not known: the clearances
    of the nodes near it tell."""
    shift = np.zeros(3)
    if run.setting(f"Body {name}/Moves with") == "foundation":
        if ground is None:
            return None
        shift = (tread_on(run, name) - ground.travel) * ground.direction
    found = [body_of(run, name, shift, sign) for sign in (1, -1)]
    if found[0] is None:
        return None
    is_moved = bool(run.setting(f"Body {name}/Motions"))
    if len(contact) == 0:
        return None if is_moved else shift
    near, clearances = contact.positions(), contact["clearance"]
    if is_moved:
        # each node may be on either side of it
        found = [body.at_clearances(near[i:i + 1], clearances[i:i + 1])
                 for body in found for i in range(0, len(near), len(near) // 9 + 1)]
    errors = [np.abs(body.clearance(near) - clearances).max() for body in found]
    best = found[int(np.argmin(errors))]
    if min(errors) > TOLERANCE * np.ptp(points, axis=0).max():
        return None
    return shift - best.travel * best.direction
