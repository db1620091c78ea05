# SPDX-License-Identifier: LGPL-2.1-or-later
"""TYDEX files, release 1.3: one measurement of a tire in each.

The format is that of Unrau and Zamow, TYDEX-Format, Description and Reference Manual,
1997: lines of text in fixed columns below keywords that begin with **. Names of channels
have up to 8 characters, the axes are the W axes of ISO 8855.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from biface.errors import BifaceError
from biface.text_file import text_of_file
from . import units
from .channels import CHANNELS, OUTPUTS
from .table import Measurements, check, check_slopes, to_float, to_iso

BY_TYDEX = {channel.tydex: channel.name for channel in CHANNELS.values()
            if channel.tydex}

# Names that other programs write for the same
BY_TYDEX["FXW"] = "F_x"

# Columns of a line of a constant or of a channel: name, comment, unit, numbers
NAME, COMMENT, UNIT = slice(0, 10), slice(10, 40), slice(40, 50)
NUMBERS = (slice(50, 60), slice(60, 70), slice(70, 80))

# Width of a column of data
WIDTH = 10

# What stands for a value that was not measured
MISSING = "NOTAVAIL"

KEYWORDS = ("HEADER", "COMMENTS", "CONSTANTS", "MEASURCHANNELS", "MEASURDATA",
            "MODELDEFINITION", "MODELPARAMETERS", "MODELCOEFFICIENTS", "MODELCHANNELS",
            "MODELOUTPUTS", "MODELEND", "END")

# Quantities that a measurement holds constant
HELD = ("F_z", "inclination_angle", "pressure", "velocity")


def size_of(name, unit, place):
    """The unit of a channel in SI units."""
    return units.factor(units.OF_COLUMN[CHANNELS[name].kind], unit,
                        f"{place}: the unit of {CHANNELS[name].tydex}")


def line_of(name, comment, unit, *values):
    """A line of a constant or a channel."""
    return (f"{name[:10]:10}{comment[:29]:30}{unit[:9]:10}"
            + "".join(f"{value:10}" for value in values)).rstrip()


def number(value):
    """A number in as many digits as a column has room for, with a blank before it."""
    if np.isnan(value):
        return f" {MISSING:>{WIDTH - 1}}"
    for digits in range(WIDTH - 1, 0, -1):
        text = f"{value + 0.0:.{digits}g}"
        if len(text) < WIDTH:
            return f"{text:>{WIDTH}}"
    raise BifaceError(f"the number {value:g} has no room in a TYDEX file.")


# ---- writing

def split(data):
    """The measurements that a table contains: pairs of a kind, cornering, braking or
    combined, and the numbers of their rows. In each the quantities of HELD are constant;
    cornering has no longitudinal slip, braking no slip angle, and combined a constant
    one."""
    keys = np.stack([data.levels(name)[1] for name in HELD])
    kinds = np.where(data.is_lateral, 0, np.where(data.is_longitudinal, 1, 2))
    angles = np.where(kinds == 2, data.levels("slip_angle")[1], 0)
    # a state without any slip belongs to both sweeps
    without = data.is_lateral & data.is_longitudinal
    result = []
    for key in np.unique(np.vstack([keys, kinds, angles]).T, axis=0):
        same = (keys.T == key[:4]).all(axis=1)
        chosen = same & (kinds == key[4]) & (angles == key[5])
        if key[4] == 1:
            chosen |= same & without
        if key[4] == 0 and not (chosen & ~without).any() \
                and (same & (kinds == 1)).any():
            continue
        result.append((("cornering", "braking", "combined")[key[4]],
                       np.flatnonzero(chosen)))
    return result


def text_of(data, identity, constants=()):
    """A TYDEX file as text.

    data       Measurements of one measurement
    identity   a name for it, of up to 11 characters
    constants  further lines of constants: name, comment, unit, value"""
    names = [name for name in CHANNELS if CHANNELS[name].tydex and name in data.columns
             and not np.isnan(data[name]).all()]
    sizes = {name: size_of(name, CHANNELS[name].tydex_unit, identity) for name in names}
    # what is exactly constant need not stand in each line, which has 80 characters
    varied = [name for name in names if name == "F_z" or name not in HELD
              or np.ptp(data[name]) > 1e-9 * np.abs(data[name]).max()]
    lines = ["**HEADER",
             line_of("RELEASE", "Release of TYDEX-Format", "", "1.3"),
             line_of("MEASID", "Measurement ID", "", identity),
             line_of("SUPPLIER", "Data supplier", "", "biface"), "",
             "**COMMENTS", "Written by biface-tire-model. W axes of ISO 8855.", "",
             "**CONSTANTS"]
    lines += [line_of(name, comment, unit, number(value).strip())
              for name, comment, unit, value in constants]
    lines += [line_of(CHANNELS[name].tydex, CHANNELS[name].meaning + ", mean",
                      CHANNELS[name].tydex_unit,
                      number(data[name].mean() / sizes[name]).strip())
              for name in HELD if name in names]
    lines += ["", "**MEASURCHANNELS"]
    lines += [line_of(CHANNELS[name].tydex, CHANNELS[name].meaning,
                      CHANNELS[name].tydex_unit, "1", "0", "0") for name in varied]
    lines += ["", "**MEASURDATA"]
    lines += ["".join(number(data[name][i] / sizes[name]) for name in varied)
              for i in range(len(data))]
    return "\n".join(lines) + "\n\n**END\n"


def write_tydex(data, directory, constants=()) -> list[Path]:
    """Writes a file for each measurement of a table, such as cornering_01.tdx, with as
    many digits as the columns have room for, five to eight. Returns the files.

    data       Measurements
    directory  where to; it is made if it is missing
    constants  lines of constants for all files: name, comment, unit, value"""
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    counts, paths = {}, []
    for kind, rows in split(data):
        counts[kind] = counts.get(kind, 0) + 1
        path = directory / f"{kind}_{counts[kind]:02d}.tdx"
        slip = "slip_ratio" if kind != "cornering" else "slip_angle"
        states = data.where(rows)
        states = states.where(np.argsort(states[slip], kind="stable"))
        path.write_text(text_of(states, f"{kind}{counts[kind]:02d}", constants),
                        encoding="ascii")
        paths.append(path)
    return paths


# ---- reading

def sections_of(path):
    """The lines of a file below each keyword, with their numbers."""
    result, current = {}, None
    for place, line in enumerate(text_of_file(path).splitlines(), 1):
        if line.startswith("**"):
            keyword = line[2:].strip().upper()
            if keyword not in KEYWORDS:
                raise BifaceError(f"{path}, line {place}: the keyword is "
                                  f"**{keyword}, but must be one of "
                                  f"**{', **'.join(KEYWORDS)}.")
            if keyword in result:
                raise BifaceError(f"{path}, line {place}: **{keyword} occurs twice.")
            current = result.setdefault(keyword, [])
            if keyword == "END":
                break
        elif line.strip() and not line.startswith("!"):
            if current is None:
                raise BifaceError(f"{path}, line {place}: text before the first keyword, "
                                  "which is **HEADER.")
            current.append((place, line.expandtabs()))
    for keyword in ("HEADER", "MEASURCHANNELS", "MEASURDATA", "END"):
        if keyword not in result:
            raise BifaceError(f"{path} has no **{keyword}: it is not a complete TYDEX "
                              "file.")
    return result


def channels_of(path, lines):
    """The channels: for each its name in channels.py, or None, and how its data become
    SI values: offset, factor, offset."""
    result, seen = [], set()
    for line_number, line in lines:
        place = f"{path}, line {line_number}"
        name = line[NAME].strip().upper()
        known = BY_TYDEX.get(name)
        if known in seen:
            raise BifaceError(f"{place}: the channel {name} occurs twice.")
        seen |= {known} - {None}
        size = size_of(known, line[UNIT].strip() or "-", place) if known else 1
        words = [line[columns].strip() for columns in NUMBERS]
        factor, before, after = (
            to_float(word or default, place, f"the {what} of {name}")
            for word, default, what in zip(words, "100", ("factor", "offset", "offset")))
        result.append((known, before, factor * size, after * size))
    return result


def words_of(line, count):
    """The fields of a line of data, separated by blanks or else of fixed width."""
    words = line.split()
    columns = [line[i:i + WIDTH] for i in range(0, len(line.rstrip()), WIDTH)]
    return columns if len(columns) == count != len(words) else words


def read_file(path):
    """The columns of one file in SI units, by the names of channels.py, the places of the
    states, and the names of other channels, which are left out. Constants fill the columns
    that have no channel or no value."""
    sections = sections_of(path)
    channels = channels_of(path, sections["MEASURCHANNELS"])
    rows, places = [], []
    for line_number, line in sections["MEASURDATA"]:
        places.append(f"{path}, line {line_number}")
        words = words_of(line, len(channels))
        if len(words) != len(channels):
            raise BifaceError(f"{places[-1]}: the line has {len(words)} numbers where "
                              f"{len(channels)} channels are named.")
        rows.append([(value_of(word, places[-1], "a value") + before) * factor + after
                     if name else 0.0
                     for word, (name, before, factor, after) in zip(words, channels)])
    if not rows:
        raise BifaceError(f"{path} has no data.")
    columns = {name: np.array(values) for (name, *_), values
               in zip(channels, np.array(rows).T)
               if name and not np.isnan(values).all()}
    for line_number, line in sections.get("CONSTANTS", ()):
        name = BY_TYDEX.get(line[NAME].strip().upper())
        if name and name not in columns and line[50:].strip().upper() != MISSING:
            place = f"{path}, line {line_number}"
            value = to_float(line[50:].strip(), place, f"the constant {name}")
            columns[name] = np.full(len(rows), value * size_of(
                name, line[UNIT].strip() or "-", place))
    unused = [line[NAME].strip() for (known, *_), (_, line)
              in zip(channels, sections["MEASURCHANNELS"]) if known is None]
    return *complete(path, columns, places), unused


def value_of(word, place, what):
    """A number of a file; NaN where there is none."""
    return np.nan if word.strip().upper() == MISSING else to_float(word, place, what)


def complete(path, columns, places):
    """The columns and places of the states whose slips, load, pressure and velocity are
    all known. Forces and moments may be missing."""
    known = np.all([~np.isnan(values) for name, values in columns.items()
                    if name not in OUTPUTS] or [np.ones(len(places), bool)], axis=0)
    if not known.any():
        raise BifaceError(f"{path} has no data: some input is {MISSING} in each line.")
    return ({name: values[known] for name, values in columns.items()},
            [place for place, is_known in zip(places, known) if is_known])


def read_tydex(paths, axes: str = "iso") -> Measurements:
    """The states of TYDEX files, all in one table.

    paths  files, or one file or directory, whose files *.tdx are read
    axes   those of the files, see axes.py; the format has the ones of ISO

    Raises BifaceError with file and line if one is not complete, if the files do not have
    the same forces and moments, or if these contradict the axes."""
    if isinstance(paths, (str, Path)):
        path = Path(paths)
        paths = sorted(file for file in path.iterdir()
                       if re.search(r"\.tdx$", file.name, re.IGNORECASE)) \
            if path.is_dir() else [path]
        if not paths:
            raise BifaceError(f"{path} has no files .tdx.")
    tables, places, unused = zip(*(read_file(path) for path in paths))
    names = [name for name in CHANNELS if any(name in table for table in tables)]
    for name in names:
        for path, table in zip(paths, tables):
            if name not in table:
                if name in ("pressure", "velocity", "F_z"):
                    raise BifaceError(f"{path} has no {CHANNELS[name].tydex}, which other "
                                      "files have.")
                count = len(next(iter(table.values())))
                table[name] = np.full(count, np.nan if name[0] in "FM" else 0.0)
    result = Measurements(to_iso({name: np.concatenate([table[name] for table in tables])
                                  for name in names}, axes),
                          dict.fromkeys(sum(unused, [])))
    check(result, sum(places, []))
    check_slopes(result, axes, paths[0])
    return result
