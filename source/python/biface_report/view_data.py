# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contents of VTU files for the view in three dimensions: joined nodes and
values of 16 bits, compressed, in base64."""

import base64
import zlib

import numpy as np

from biface import BifaceError, read_vtu

# Values are whole numbers up to this, times a scale, and this where there is none
LARGEST, NO_VALUE = 32767, -32768
# Nodes closer than this share of the size are the same
CLOSE = 1e-6

# Arrays of a file that are no fields
MESH = ("Points", "connectivity", "offsets", "types", "outer_face", "ply", "TIME")
# Fields by which the nodes of shapes move
MOTIONS = ("mode", "mode_imaginary")
# Fields that vanish outside the contact zone, and are gray where they do
IN_ZONE = ("contact_pressure", "active", "slipping", "friction", "slip_velocity")
# Kinds of quantities by the beginnings of the names of fields, the first that fits
KINDS = (("displacement", "length"), ("contact_pressure", "pressure"),
         ("friction", "pressure"), ("slip_velocity", "velocity"), ("H_", "tension"),
         ("cord_tension", "force"), ("interlaminar", "pressure"),
         ("cauchy_", "pressure"), ("s_", "pressure"), ("t_", "pressure"),
         ("von_mises", "pressure"))


class Part:
    """A mesh of quadrilaterals with fields in several states: the two faces of the
    shell, or the two sides of each ply."""

    def __init__(self, name, states, paths, units, motion="displacement"):
        """states names what each of the files shows; motion is the field by which
        the points of a file have moved, or None for the shapes of a series."""
        self.name, self.states, self.units, self.fields = name, states, units, []
        data = [read_vtu(path) for path in paths]
        points = [arrays["Points"].astype(float) for arrays in data]
        for path, found in zip(paths, points):
            if len(found) != len(points[0]):
                raise BifaceError(f"{path} has {len(found)} points, but "
                                  f"{paths[0].name} has {len(points[0])}: they "
                                  "are not of the same run.")
        base = points[0] - (data[0][motion] if motion else 0)
        self.quads, self.groups = quads_of(data[0])
        self.first, self.node = join(base, CLOSE * np.ptp(base, axis=0).max())
        if not all(map(self._agrees, points + [
                arrays[name] for arrays in data for name in MOTIONS
                if name in arrays])):
            # edges of the shell part that touched
            self.first = self.node = np.arange(len(base))
        self.base = base[self.first]
        self.motion = motion
        names = dict.fromkeys(name for arrays in data for name in arrays
                              if name not in MESH)
        for name in names:
            self._add(name, [arrays.get(name) for arrays in data])
        moved = [found - base for found in points]
        if not motion or not all(
                np.allclose(found, arrays[motion], atol=1e-4 * np.abs(found).max())
                for found, arrays in zip(moved, data)):
            self.motion = "motion"
            self._add("motion", moved)

    def _agrees(self, values):
        """Whether all points of each node have the same values."""
        return np.allclose(values, values[self.first][self.node], rtol=0,
                           atol=np.abs(np.nan_to_num(values)).max() / LARGEST,
                           equal_nan=True)

    def _add(self, name, values):
        """Adds a field unless it vanishes; values has an array per state, or None
        where a file does not have it."""
        if name not in (self.motion, *MOTIONS) and not any(
                np.nan_to_num(array).any() for array in values
                if array is not None):
            return
        shape = next(array.shape for array in values if array is not None)
        values = [np.full(shape, np.nan) if array is None else
                  array.astype(float) for array in values]
        # one value per node where those of all cells agree
        at_nodes = all(map(self._agrees, values))
        chosen = self.first if at_nodes else self.quads.ravel()
        scales, numbers = zip(*(quantized(array[chosen]) for array in values))
        self.fields.append({
            "name": name, "unit": self.units[kind_of(name)], "at_nodes": at_nodes,
            "components": 1 if len(shape) == 1 else shape[1],
            "colors": "plasma" if name == "contact_pressure" else "viridis",
            "in_zone": name in IN_ZONE, "scales": scales,
            "values": packed(np.concatenate(numbers))})

    def as_dict(self):
        """What view.js reads."""
        return {"name": self.name, "states": self.states, "motion": self.motion,
                "groups": self.groups, "fields": self.fields,
                "base": packed(self.base.astype("<f4")),
                "nodes": packed(self.node[self.quads].astype("<i4"))}


def quads_of(data):
    """The corners of the quadrilaterals, one per row, and groups of them: the name,
    the first one and their number."""
    if "ply" in data:
        cells = data["connectivity"].reshape(-1, 8)
        ply = data["ply"][cells[:, 0]].astype(int)
        order = np.argsort(ply, kind="stable")
        quads = cells[order].reshape(-1, 4)
        groups = [[f"ply {i}", int(2 * (ply < i).sum()), int(2 * (ply == i).sum())]
                  for i in np.unique(ply)]
        return quads, groups
    quads = data["connectivity"].reshape(-1, 4)
    is_outer = data["outer_face"][quads[:, 0]] > 0.5
    n, n_outer = len(quads), int(is_outer.sum())
    groups = [["all faces", 0, n], ["outer face", 0, n_outer]]
    if n_outer < n:
        groups.append(["other faces", n_outer, n - n_outer])
    return np.concatenate([quads[is_outer], quads[~is_outer]]), groups


def join(points, distance):
    """One point of each node, and the node of each point."""
    _, first, which = np.unique(np.round(points / distance), axis=0,
                                return_index=True, return_inverse=True)
    return first, which


def quantized(values):
    """A scale, and whole numbers that give the values if they are multiplied by
    it."""
    finite = np.isfinite(values)
    scale = np.abs(values[finite]).max(initial=0) / LARGEST or 1.0
    return scale, np.where(finite, np.round(np.where(finite, values, 0) / scale),
                           NO_VALUE).astype("<i2")


def packed(array):
    """An array as compressed text."""
    return base64.b64encode(
        zlib.compress(np.ascontiguousarray(array).tobytes(), 9)).decode()


def kind_of(name):
    """The kind of quantity of a field as in doc/output.md, or none."""
    return next((kind for start, kind in KINDS if name.startswith(start)), "")
