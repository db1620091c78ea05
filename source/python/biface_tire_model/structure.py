# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs of biface tell of the structure of a tire: its stiffnesses on the ground, its
footprints and its modes of vibration, in SI units."""

from __future__ import annotations

from collections import namedtuple

import numpy as np

from biface import Results
from biface.errors import BifaceError
from biface.parameters import stages
from .table import RELATIVE_STEP, group
from .units import System

# Motions of the ground, and the words for them
MOTIONS = {"lateral": "lateral", "longitudinal": "longitudinal", "turn": "torsional"}

# How the footprint holds on the ground, best first
GRIPS = ("glued", "with friction", "unknown")

# Growth rates that are smaller in parts of the largest angular frequency are rounding: pairs
# of modes then travel instead of standing
STEADY = 1e-6

# A direction is along an axis if its cosine deviates from 1 by less than this
ALONG = 1e-6

# A stage in which the ground moves from a loaded state.
# motion     a key of MOTIONS
# load       [N] and pressure [Pa] at its start
# grip       one of GRIPS
# first      secant stiffness of its first step [N/m], of "turn" [N m/rad]
# secant     that of its last step, and tangent stiffness there
# amount     how far it goes [m], or [rad]
State = namedtuple("State", "stage motion load pressure grip first secant tangent amount")

# A step in which the ground approaches a standing tire: pressure [Pa], load [N] and
# deflection [m] at its end, secant stiffness up to there from the first touch and tangent
# stiffness of the step alone [N/m], the load at its start [N], and loaded radius [m],
# length and width [m], area [m^2] of the footprint; NaN for what is not known
Press = namedtuple("Press", "stage pressure load deflection secant tangent load_before "
                            "loaded_radius length width area")

# The modes of a stage: whether the ground is in contact, pressure [Pa], and arrays
# with a number for each mode.
# frequency  [Hz]
# waves      around the axis; half_waves along the meridian; NaN for what is no full turn
# masses     effective masses along x, y and z in parts of the whole, as rows
# rotations  effective moments of inertia about x, y and z likewise; NaN without the
#            files of the shapes
# is_steady  whether the tire stands and no mode grows
Modes = namedtuple("Modes", "stage is_on_ground pressure numbers frequency waves "
                            "half_waves masses rotations is_steady")


class Structure:
    """What results tell, as lists of the tuples above.

    directories  where they are, as text
    systems      the units of each, a units.System
    unused       a sentence on stiffnesses that are those of another tire; "" if there are
                 none"""

    def __init__(self):
        self.directories, self.systems, self.unused = [], [], ""
        self.states, self.presses, self.modes = [], [], []


def levels(values):
    """The values at which a positive quantity was held, as an array, and the number of
    the level of each value."""
    values = np.asarray(values, float)
    if not len(values):
        return values, np.zeros(0, int)
    return group(values, RELATIVE_STEP * values.max())


def read_structure(directories, units: str | None = None,
                   rolling: Results | None = None) -> Structure:
    """The Structure of directories with results.

    units    those of results whose entry `Units` is empty, as in 'mm, N, s'
    rolling  the results of the tire that rolls; stiffnesses of a tire with another
             `Contact/Tread` are not those of this one, and do not count

    Raises BifaceError for a directory without results, without stiffness.csv and
    modes.csv, or without units."""
    result = Structure()
    for directory in directories:
        results = Results(directory)
        system = system_of(results, units)
        stiffness, modes = results.stiffness(), results.modes()
        if stiffness is None and modes is None:
            raise BifaceError(f"{directory} has neither stiffness.csv nor modes.csv: in no "
                              "stage does the ground move, and none has 'Modes'.")
        result.directories.append(str(directory))
        result.systems.append(system)
        if stiffness is not None and rolling and tread(results) != tread(rolling):
            result.unused = (f"the Contact/Tread of {directory} ({tread(results)}) is not "
                             f"that of {rolling.directory} ({tread(rolling)})")
        elif stiffness is not None:
            add_stiffness(result, results, stiffness, system)
        if modes is not None:
            add_modes(result, results, modes, system)
    return result


def system_of(results, units):
    """The units of results."""
    named = results.setting("Units") or units
    if not named:
        raise BifaceError(f"{results.directory} does not name its units: the entry 'Units' "
                          "of its parameters.prm is empty, and --units is missing.")
    try:
        return System(named)
    except BifaceError as error:
        raise BifaceError(f"{results.directory}: {error}") from None


def tread(results):
    """The tread of bristles of results, as text."""
    if results.setting("Contact/Tread/Height", "none") == "none":
        return "none"
    return ", ".join(f"{name} {results.setting(f'Contact/Tread/{name}', '0')}"
                     for name in ("Height", "Modulus", "Void ratio"))


# ---- stiffness.csv

def add_stiffness(result, results, table, system):
    """The rows of stiffness.csv; a wheel that rolls does not count."""
    rolling = results.rolling()
    if rolling is not None:
        table = table.where(~np.isin(table["step"], rolling["step"]))
    # where other forces change beside those of the motion, there is no stiffness
    table = table.where(np.isfinite(table["secant"]))
    length, force = system["length"], system["force"]
    seen, loads = {}, {}
    for row in table.rows():
        if row["motion"] == "approach":
            add_press(result, results, row, system, loads)
        else:
            seen.setdefault(row["stage"], []).append(row)
    for stage, rows in seen.items():
        first, last = rows[0], rows[-1]
        motion = motion_of(first)
        grip = grip_of(results, stage)
        # without friction the ground does not move the tire
        if motion is None or grip is None or not first["force"] > 0:
            continue
        unit = force / length
        size = length
        if motion == "turn":
            size = np.pi / 180
            unit = force * length / size
        result.states.append(State(
            stage, motion, first["force"] * force, first["pressure"] * system["pressure"],
            grip, first["secant"] * unit, last["secant"] * unit, last["tangent"] * unit,
            last["amount"] * size))


def motion_of(row):
    """The motion of a row of stiffness.csv; None for a slide askew or a turn about another
    axis than the normal of the ground."""
    across = abs(row["direction_y"])
    if row["motion"] == "turn":
        return "turn" if across < ALONG else None
    return "lateral" if across > 1 - ALONG else "longitudinal" if across < ALONG else None


def grip_of(results, stage):
    """How the footprint holds in a stage, one of GRIPS; None if it has no friction."""
    if results.parameters is None:
        return "unknown"
    for number, name in stages(results.parameters):
        if name == stage:
            if results.setting(f"Stage {number}/Glued") == "true":
                return "glued"
            friction = (results.setting(f"Stage {number}/Friction")
                        or results.setting("Contact/Friction", "0"))
            return None if is_zero(friction) else "with friction"
    return "unknown"


def is_zero(text):
    """Whether text is a number that is not positive; a formula is none."""
    try:
        return not float(text) > 0
    except ValueError:
        return False


def add_press(result, results, row, system, loads):
    """A step in which the ground approaches, with what history.csv tells of its end; @p
    loads has the load of each stage so far."""
    history = results.history.row(int(np.searchsorted(results.steps, row["step"])))
    if not history["force"] > 0 or not history["approach"] > 0:
        return

    def value(name, kind):
        return history.get(name, np.nan) * system[kind]

    length, force = system["length"], system["force"]
    load, deflection = history["force"] * force, history["approach"] * length
    before = loads.get(row["stage"], row["force"] * force)
    loads[row["stage"]] = load
    result.presses.append(Press(
        row["stage"], value("pressure", "pressure"), load, deflection, load / deflection,
        row["tangent"] * force / length,
        before, value("loaded_radius", "length"), value("footprint_length", "length"),
        value("footprint_width", "length"),
        history.get("footprint_area", np.nan) * length ** 2))


# ---- modes.csv

def add_modes(result, results, table, system):
    """The stages of modes.csv."""
    for step in dict.fromkeys(table["step"]):
        found = table.where(step=step)
        if not (found["total_mass"] > 0).all():
            raise BifaceError(f"{results.directory / 'modes.csv'} is damaged: the total "
                              "mass is not positive.")
        history = results.history.row(int(np.searchsorted(results.steps, step)))
        count = len(found)
        no_waves = np.full(count, np.nan)
        travel = np.nan_to_num(found.get("travel", np.zeros(count)))
        growth = (np.abs(found["growth_rate"]).max()
                  > STEADY * 2 * np.pi * found["frequency"].max())
        waves = found.get("circumferential_waves", no_waves)
        result.modes.append(Modes(
            found["stage"][0], bool(history["contact_nodes"] > 0),
            history["pressure"] * system["pressure"], found["mode"].astype(int),
            found["frequency"] / system["time"], waves,
            found.get("meridional_half_waves", no_waves),
            np.stack([found[f"effective_mass_{axis}"] / found["total_mass"]
                      for axis in "xyz"], -1),
            np.array([rotations(results, int(step), int(mode)) if waves[i] in (0, 1)
                      else (np.nan,) * 3 for i, mode in enumerate(found["mode"])]),
            not growth and (not travel.any() or stands(results, found["stage"][0]))))


def stands(results, stage):
    """Whether no stage up to this one turns the wheel steadily."""
    if results.parameters is None:
        return False
    for number, name in stages(results.parameters):
        for entry in ("Angular velocity", "Ground velocity"):
            if results.setting(f"Stage {number}/{entry}", "unchanged") not in ("unchanged",
                                                                               "0"):
                return False
        if name == stage:
            return True
    return False


def rotations(results, step, mode):
    """The effective moments of inertia of a mode about axes through the center along x, y
    and z in parts of the whole, from its shape if that was written; the mass is taken as
    even over both faces."""
    shape = results.vtu("modes", step, mode)
    if shape is None:
        return (np.nan,) * 3
    points, motion = shape["Points"], shape["mode"] + 1j * shape.get("mode_imaginary", 0)
    corners = shape["connectivity"].reshape(-1, 4)
    p = points[corners]
    areas = np.linalg.norm(np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]), axis=1) / 2
    weights = np.bincount(corners.ravel(), np.repeat(areas / 4, 4), len(points))
    points = points - weights @ points / weights.sum()
    whole = weights @ (np.abs(motion) ** 2).sum(1)
    result = []
    for axis in np.eye(3):
        turn = np.cross(axis, points)
        result.append(float(np.abs(weights @ (motion * turn).sum(1)) ** 2
                            / (whole * (weights @ (turn ** 2).sum(1)))))
    return tuple(result)
