# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the structure of a tire, for the parameters of other tire models."""

from __future__ import annotations

import math
from collections import namedtuple

import numpy as np

from biface.errors import BifaceError
from .mode_names import MEANINGS, name_modes, unfit
from .structure import MOTIONS

# A table: its name, a line of what it is, names of columns with units, rows of numbers and
# text
StructureTable = namedtuple("StructureTable", "name title columns rows")


class Units:
    """The units of the tables: those of results, a units.System, in which angles are in
    degrees, or SI units with radians, without one."""

    def __init__(self, system=None):
        length, force = system.text.split(", ")[:2] if system else ("m", "N")
        size, weight = (system["length"], system["force"]) if system else (1, 1)
        angle, turn = ("degree", math.pi / 180) if system else ("rad", 1)
        pressure = {("m", "N"): "Pa", ("mm", "N"): "MPa", ("m", "kN"): "kPa"}.get(
            (length, force), f"{force}/{length}^2")
        self.of = {"length": (length, size), "area": (f"{length}^2", size ** 2),
                   "force": (force, weight), "pressure": (pressure, weight / size ** 2),
                   "stiffness": (f"{force}/{length}", weight / size),
                   "angle": (angle, turn),
                   "turn": (f"{force} {length}/{angle}", weight * size / turn),
                   "frequency": ("Hz", 1), "percent": ("%", 0.01)}

    def column(self, name, kind):
        """The name of a column with its unit."""
        return f"{name} [{self.of[kind][0]}]"

    def value(self, value, kind):
        """A value in SI units as text; empty where it is not known."""
        return "" if not math.isfinite(value) else f"{value / self.of[kind][1] + 0.0:.10g}"


def common_system(structure):
    """The units of all results. Raises BifaceError if they differ."""
    systems = structure.systems
    for directory, system in zip(structure.directories, systems):
        if system.factors != systems[0].factors:
            raise BifaceError(f"{directory} has the units {system.text}, but "
                              f"{structure.directories[0]} has {systems[0].text}: --si "
                              "converts both.")
    return systems[0]


def structure_tables(structure, system=None) -> list[StructureTable]:
    """The tables of a Structure that have rows.

    system  the units, a units.System; SI units without one

    Raises BifaceError if there are none."""
    units = Units(system)
    tables = [radial(structure, units), footprints(structure, units),
              *(stiffness(structure, units, motion) for motion in MOTIONS),
              frequencies(structure, units)]
    tables = [table for table in tables if table.rows]
    if not tables:
        raise BifaceError(f"{' and '.join(structure.directories)} have nothing for a table: "
                          "no ground presses on a tire that stands, and no modes are those "
                          "of a tire off the ground.")
    return tables


def make(name, title, units, columns, rows):
    """A table; columns are names and kinds of quantities, "" for text."""
    return StructureTable(
        name, title, [units.column(column, kind) if kind else column
                      for column, kind in columns],
        [[units.value(value, kind) if kind else str(value)
          for value, (_, kind) in zip(row, columns)] for row in rows])


def radial(structure, units):
    """Load over deflection."""
    return make("radial_stiffness",
                "load over deflection of the standing tire; secant from the first touch, "
                "tangent of the step up to this load", units,
                (("stage", ""), ("pressure", "pressure"), ("load", "force"),
                 ("deflection", "length"), ("loaded_radius", "length"),
                 ("secant", "stiffness"), ("tangent", "stiffness")),
                [(press.stage, press.pressure, press.load, press.deflection,
                  press.loaded_radius or math.nan, press.secant, press.tangent)
                 for press in structure.presses])


def footprints(structure, units):
    """Footprints over load."""
    return make("footprint", "footprint of the standing tire", units,
                (("stage", ""), ("pressure", "pressure"), ("load", "force"),
                 ("length", "length"), ("width", "length"), ("area", "area")),
                [(press.stage, press.pressure, press.load, press.length, press.width,
                  press.area) for press in structure.presses
                 if np.isfinite(press.length)])


def stiffness(structure, units, motion):
    """Stiffness in the plane of the ground."""
    kind, amount = ("turn", "angle") if motion == "turn" else ("stiffness", "length")
    name = MOTIONS[motion]
    return make(f"{name}_stiffness",
                f"{name} stiffness of the standing tire under load: secants of the first "
                "step and of the whole motion, tangent at its end", units,
                (("stage", ""), ("pressure", "pressure"), ("load", "force"),
                 ("footprint", ""), ("motion", amount), ("first_secant", kind),
                 ("secant", kind), ("tangent", kind)),
                [(state.stage, state.pressure, state.load, state.grip, state.amount,
                  state.first, state.secant, state.tangent)
                 for state in structure.states if state.motion == motion])


def frequencies(structure, units):
    """Modes of the tire in the air, with the names of those that are certain."""
    rows = []
    for modes in structure.modes:
        if modes.is_on_ground or not modes.is_steady:
            continue
        named = {} if unfit(modes) else name_modes(modes)[0]
        names = {number: MEANINGS[entry] for entry, mode in named.items()
                 for number in mode.modes}
        rows += [(modes.stage, modes.pressure, number, modes.frequency[i],
                  names.get(number, ""), whole(modes.waves[i]), whole(modes.half_waves[i]),
                  *modes.masses[i]) for i, number in enumerate(modes.numbers.tolist())]
    return make("frequencies",
                "modes of the standing tire off the ground, with the parts of the mass that "
                "they hold along each axis", units,
                (("stage", ""), ("pressure", "pressure"), ("mode", ""),
                 ("frequency", "frequency"), ("name", ""), ("circumferential_waves", ""),
                 ("meridional_half_waves", ""), ("mass_x", "percent"),
                 ("mass_y", "percent"), ("mass_z", "percent")), rows)


def whole(number):
    """A number of waves as text."""
    return "" if not math.isfinite(number) else int(number)


def quoted(text):
    """A field of a CSV file."""
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\n') else text


def text_of(table):
    """A table as CSV, with a comment of what it is."""
    return (f"# {table.title}\n" + ",".join(table.columns) + "\n"
            + "".join(",".join(map(quoted, row)) + "\n" for row in table.rows))
