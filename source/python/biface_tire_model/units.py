# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of units, and their size in SI units."""

import math

from biface.errors import BifaceError

LENGTH = {"m": 1, "meter": 1, "meters": 1, "metre": 1, "mm": 1e-3, "millimeter": 1e-3,
          "cm": 1e-2, "centimeter": 1e-2, "km": 1e3, "kilometer": 1e3, "in": 0.0254,
          "inch": 0.0254, "ft": 0.3048, "foot": 0.3048, "mile": 1609.344}
FORCE = {"n": 1, "newton": 1, "newtons": 1, "kn": 1e3, "knewton": 1e3,
         "kilonewton": 1e3, "dan": 10, "mN": 1e-3, "MN": 1e6, "lbf": 4.4482216152605,
         "pound_force": 4.4482216152605, "kpound_force": 4448.2216152605,
         "kgf": 9.80665, "kg_force": 9.80665, "dyne": 1e-5}
TIME = {"s": 1, "sec": 1, "second": 1, "seconds": 1, "ms": 1e-3, "millisecond": 1e-3,
        "milli": 1e-3, "min": 60, "minute": 60, "h": 3600, "hour": 3600}
ANGLE = {"rad": 1, "radian": 1, "radians": 1, "deg": math.pi / 180,
         "degree": math.pi / 180, "degrees": math.pi / 180}
MASS = {"kg": 1, "kilogram": 1, "g": 1e-3, "gram": 1e-3, "t": 1e3, "tonne": 1e3,
        "lb": 0.45359237, "pound_mass": 0.45359237, "slug": 14.593902937206}
PRESSURE = {"pa": 1, "pascal": 1, "kpa": 1e3, "kpascal": 1e3, "kilopascal": 1e3,
            "mPa": 1e-3, "mpa": 1e6, "megapascal": 1e6, "bar": 1e5, "mbar": 100, "hpa": 100,
            "n/mm2": 1e6, "n/mm²": 1e6, "kgf/cm2": 98066.5, "kgf/cm²": 98066.5,
            "psi": 6894.757293168}

# Of length, force and time of a table, if nothing tells them
DEFAULT = "m, N, s"

# The entries of the section [UNITS] of a .tir file
OF_FILE = {"LENGTH": LENGTH, "FORCE": FORCE, "ANGLE": ANGLE, "MASS": MASS, "TIME": TIME,
           "PRESSURE": PRESSURE}

# Units behind a column of a table: of each kind of quantity
OF_COLUMN = {
    "slip": {"-": 1, "": 1, "1": 1, "none": 1, "%": 0.01},
    "angle": {**ANGLE, "°": math.pi / 180, "º": math.pi / 180},
    "length": LENGTH,
    "pressure": PRESSURE,
    "velocity": {"m/s": 1, "km/h": 1 / 3.6, "kph": 1 / 3.6, "kmh": 1 / 3.6,
                 "mph": 0.44704, "mm/s": 1e-3},
    "force": {**FORCE, "lb": FORCE["lbf"]},
    "moment": {"nm": 1, "n m": 1, "n*m": 1, "n-m": 1, "n.m": 1, "n·m": 1,
               "knm": 1e3, "kn-m": 1e3, "danm": 10, "dan.m": 10, "dan-m": 10, "nmm": 1e-3, "n mm": 1e-3, "n-mm": 1e-3,
               "lbf ft": 1.3558179483314, "lbf-ft": 1.3558179483314,
               "lb-ft": 1.3558179483314, "ft-lb": 1.3558179483314},
}


def one_of(names):
    """Names as a list in a sentence."""
    names = list(names)
    return ", ".join(names[:-1]) + " or " + names[-1] if len(names) > 1 else names[0]


def factor(table, name, what):
    """The size of a unit in SI units, from one of the tables of this file; @p what is
    the beginning of the sentence if there is no such unit. Upper and lower case are the
    same but where they differ in the table, as in mN and MN."""
    name = name.strip()
    try:
        return table[name] if name in table else table[name.lower()]
    except KeyError:
        raise BifaceError(f"{what} is '{name}', but must be "
                          f"{one_of(filter(None, table))}.") from None


class System:
    """The units of a table: those of length, force and time, as in the entry `Units` of a
    parameter file, and of angles; pressures and moments follow. Without them they are SI
    units and degrees, and is_given and is_angle_given are false."""

    def __init__(self, text=None, angle=None):
        self.is_given, self.is_angle_given = text is not None, angle is not None
        text, angle = text or DEFAULT, angle or "deg"
        names = [name.strip() for name in text.split(",")]
        if len(names) != 3:
            raise BifaceError(f"the units are '{text}', but must be those of length, "
                              "force and time, such as 'mm, N, s'.")
        length = factor(LENGTH, names[0], "the unit of length")
        force = factor(FORCE, names[1], "the unit of force")
        time = factor(TIME, names[2], "the unit of time")
        self.text, self.angle = ", ".join(names), angle
        self.factors = {"slip": 1, "angle": factor(ANGLE, angle, "the unit of angles"),
                        "length": length, "force": force, "time": time,
                        "moment": force * length,
                        "pressure": force / length ** 2, "velocity": length / time}

    def __getitem__(self, kind):
        """The unit of a kind of quantity in SI units."""
        return self.factors[kind]
