# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of biface-tire-model."""

import re
import sys
from pathlib import Path

import numpy as np

from biface import Results
from biface.errors import BifaceError
from biface_report.command_line import Arguments, complain, missing_module
from . import text
from .axes import SIGNS, mirror
from .check import report, wrong_signs, wrong_units
from .fitting import WITHOUT_COMBINED, fit
from .fitted_file import make_tir
from .patience import Patience
from .structural import Structural
from .structure import read_structure
from .structure_tables import common_system, structure_tables, text_of
from .table import (LARGEST_ANGLE, LARGEST_SLIP, doubts, header_of, read_table,
                    write_table)
from .tir_file import SIDES, read_tir
from .tydex import read_tydex, write_tydex
from .units import DEFAULT, System
from .vertical import vertical

COMMAND = "biface-tire-model"

# More values of one quantity are a mistake
MOST_VALUES = 100_000


def make_parser():
    """The command line."""
    parser = Arguments(prog=COMMAND, description="Tire models for vehicle dynamics: "
                       "evaluates, fits and checks the Magic Formula in .tir files, and "
                       "writes TYDEX files and tables of stiffness.")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    add_evaluate(commands)
    add_fit(commands)
    add_stiffness(commands)
    add_tydex(commands)
    checked = commands.add_parser("check", help="what is missing or unusual in a .tir "
                                                "file; exits with 1 if values are unusual")
    checked.add_argument("file", metavar="FILE.tir", type=Path)
    return parser


def add_units(parser, what):
    """The options for units and axes."""
    parser.add_argument("--units", metavar="UNITS",
                        help=f"of length, force and time, {what} (default: "
                             f"'{DEFAULT}'); pressures and moments follow")
    parser.add_argument("--angles", choices=("deg", "rad"),
                        help="the unit of angles (default: deg)")
    parser.add_argument("--axes", choices=tuple(SIGNS),
                        help="the signs (default: iso, the W axes of ISO 8855)")


def add_evaluate(commands):
    """The command evaluate."""
    parser = commands.add_parser(
        "evaluate", help="forces and moments of a .tir file as a table",
        description="Prints a table of forces and moments at all combinations of the "
                    "given values: numbers separated by commas, or FIRST:LAST:STEP.")
    parser.add_argument("file", metavar="FILE.tir", type=Path)
    parser.add_argument("--fz", required=True, metavar="VALUES", help="loads")
    parser.add_argument("--alpha", default="0", metavar="VALUES", help="slip angles")
    parser.add_argument("--kappa", default="0", metavar="VALUES",
                        help="longitudinal slips; -1 is a locked wheel")
    parser.add_argument("--gamma", default="0", metavar="VALUES",
                        help="inclination angles")
    parser.add_argument("--pressure", metavar="VALUES",
                        help="inflation pressures (default: that of the file)")
    parser.add_argument("--velocity", metavar="VALUES",
                        help="forward velocities, for M_y (default: LONGVL)")
    parser.add_argument("--mirror", action="store_true",
                        help="the tire on the other side of the vehicle than in the file, "
                             "where USE_MODE below 0 mirrors it already")
    parser.add_argument("--radius", type=float, metavar="R",
                        help="of the unloaded tire, for moments (default: UNLOADED_RADIUS)")
    parser.add_argument("--starred", action="store_true",
                        help="tan(alpha) and sin(gamma) in place of the angles")
    parser.add_argument("-o", "--output", type=Path, metavar="TABLE.csv",
                        help="where to (default: standard output)")
    parser.add_argument("--picture", type=Path, metavar="FILE",
                        help="draws the curves without camber (pdf, svg or png)")
    add_units(parser, "of the values and the table")


def add_table(parser):
    """The arguments for measured data."""
    parser.add_argument("table", metavar="TABLE.csv", type=Path,
                        help="columns F_z, slip_ratio, slip_angle, "
                             "inclination_angle, pressure, velocity, loaded_radius, F_x, "
                             "F_y, M_x, M_y, M_z; or a directory of TYDEX files, or of the results of "
                             "a tire test")
    add_units(parser, "of columns without one")


def add_fit(commands):
    """The command fit."""
    parser = commands.add_parser("fit", help="a .tir file from measured forces and moments")
    add_table(parser)
    parser.add_argument("--format", required=True, choices=("5.2", "6.1"),
                        help="the version of the Magic Formula")
    parser.add_argument("--output", "-o", required=True, type=Path, metavar="FILE.tir")
    parser.add_argument("--radius", type=float, metavar="R",
                        help="of the unloaded tire, in the unit of length (default: that "
                             "at which the line through the loaded radii has no load)")
    parser.add_argument("--nominal-load", type=float, metavar="F",
                        help="FNOMIN (default: the load near the mean of all)")
    parser.add_argument("--nominal-pressure", type=float, metavar="P",
                        help="NOMPRES (default: the usual pressure of the table)")
    parser.add_argument("--velocity", type=float, metavar="V",
                        help="the reference velocity LONGVL (default: that of the table, "
                             "or 16.7 m/s)")
    parser.add_argument("--side", default="LEFT", choices=SIDES,
                        help="where the tire was mounted (default: LEFT)")
    parser.add_argument("--structure", type=Path, action="append", default=[],
                        metavar="DIRECTORY",
                        help="results of biface with stiffness.csv or modes.csv, for "
                             "stiffnesses, frequencies and relaxation lengths; may be "
                             "repeated")
    parser.add_argument("--without-combined", choices=WITHOUT_COMBINED,
                        default=WITHOUT_COMBINED[0],
                        help="what a table without combined slip gives: typical reductions "
                             "of F_x and F_y by each other (default), none, or no file")
    parser.add_argument("--picture", type=Path, metavar="FILE",
                        help="draws the curves and the points (pdf, svg or png)")


def add_stiffness(commands):
    """The command stiffness."""
    parser = commands.add_parser(
        "stiffness", help="tables of stiffnesses, footprints and frequencies from results",
        description="Prints tables of radial, lateral, longitudinal and torsional "
                    "stiffness, of footprints and of natural frequencies from the results "
                    "of runs of biface.")
    parser.add_argument("directories", metavar="DIRECTORY", type=Path, nargs="+",
                        help="of the results")
    parser.add_argument("-o", "--output", type=Path, metavar="DIRECTORY",
                        help="a CSV file for each table there (default: all on standard "
                             "output)")
    parser.add_argument("--si", action="store_true",
                        help="SI units and radians (default: the units of the results, and "
                             "degrees)")
    parser.add_argument("--units", metavar="UNITS",
                        help="of length, force and time, as in 'mm, N, s', of results that "
                             "do not name theirs")


def add_tydex(commands):
    """The command tydex."""
    parser = commands.add_parser("tydex", help="a table as TYDEX files, one for each sweep")
    add_table(parser)
    parser.add_argument("--output", "-o", required=True, type=Path, metavar="DIRECTORY")


# ---- values of options

def values_of(words, option):
    """The numbers of an option."""
    try:
        if ":" in words:
            first, last, step = (float(word) for word in words.split(":"))
            count = round((last - first) / step, 9)
            if not 0 <= count < MOST_VALUES:
                raise ValueError
            return first + step * np.arange(int(count) + 1)
        result = np.array([float(word) for word in words.split(",")])
        if np.isfinite(result).all():
            return result
    except (ValueError, ZeroDivisionError, OverflowError):
        pass
    raise BifaceError(f"{option} is '{words}', but must be numbers separated by commas, or "
                      "FIRST:LAST:STEP.")


def join_negative(words):
    """Words of the command line where a value such as -10:10:1 is not taken for an
    option."""
    result = []
    for word in words:
        if (re.match(r"-[\d.]", word) and result and result[-1].startswith("--")
                and "=" not in result[-1]):
            result[-1] += "=" + word
        else:
            result.append(word)
    return result


def positive(value, option, unit=1):
    """The value of an option that must be positive, in SI units; None if not given."""
    if value is None:
        return None
    if not 0 < value < float("inf"):
        raise BifaceError(f"{option} is {value:g}, but must be positive.")
    return value * unit


# ---- the commands

def results_table(arguments):
    """The table of a tire test, if it or the directory of the results is given."""
    path = arguments.table
    if path.is_dir():
        path = path / "tire_test.csv"
    is_result = path.name == "tire_test.csv" and path.exists() and all(
        (path.parent / name).exists() for name in ("parameters.prm", "history.csv"))
    return path if is_result else None


def units_of(arguments):
    """The units of the table and of options: those that results name, or the given
    ones."""
    path = results_table(arguments)
    named = path and Results(path.parent).setting("Units")
    if path:
        return System(named or arguments.units, arguments.angles or "deg")
    own = None if is_tydex(arguments.table) else header_of(arguments.table)
    if own and arguments.units is None and arguments.angles is None:
        return own[0]
    return System(arguments.units, arguments.angles)


def is_tydex(path):
    """Whether a path is that of TYDEX files."""
    return path.is_dir() or path.suffix.lower() == ".tdx"


def read_data(arguments, system):
    """The measurements that a command works on."""
    path = results_table(arguments) or arguments.table
    if is_tydex(path):
        return read_tydex(path, arguments.axes or "iso")
    return read_table(path, system, arguments.axes)


def evaluate(arguments):
    """Forces and moments as a table."""
    system = System(arguments.units, arguments.angles)
    axes = arguments.axes or "iso"
    file = read_tir(arguments.file)
    formula = file.formula(arguments.starred)
    radius = positive(arguments.radius, "--radius", system["length"])
    if radius is not None:
        formula = formula.with_coefficients({"UNLOADED_RADIUS": radius})
    given = {"slip_ratio": ("--kappa", "slip"), "slip_angle": ("--alpha", "angle"),
             "inclination_angle": ("--gamma", "angle"),
             "pressure": ("--pressure", "pressure"),
             "velocity": ("--velocity", "velocity"), "F_z": ("--fz", "force")}
    columns = {name: values_of(words, option) * system[kind]
               for name, (option, kind) in given.items()
               for words in [getattr(arguments, option[2:])] if words is not None}
    if np.prod([len(values) for values in columns.values()], dtype=float) > 1e7:
        raise BifaceError("the table would have more than ten million rows.")
    signs = SIGNS[axes]
    for name in columns:
        columns[name] = columns[name] * signs.get(name, 1)
    limits(columns)
    grid = np.meshgrid(*columns.values(), indexing="ij")
    columns = {name: values.ravel() for name, values in zip(columns, grid)}
    warn_outside(file, columns)
    for sentence in wrong_units(file) + wrong_signs(formula, formula.p.FNOMIN):
        print(f"{COMMAND}: warning: {arguments.file}: {sentence}", file=sys.stderr)
    seen = mirror(columns) if arguments.mirror else columns
    forces = formula.evaluate(seen["F_z"], seen["slip_ratio"], seen["slip_angle"],
                              seen["inclination_angle"], seen.get("pressure"),
                              seen.get("velocity"))
    forces = forces._asdict()
    if not formula.has_radius:
        forces = {name: forces[name] for name in ("F_x", "F_y")}
        print(f"{COMMAND}: warning: {arguments.file} has no UNLOADED_RADIUS, which moments "
              "need: they are left out; see --radius.", file=sys.stderr)
    columns.update(mirror(forces) if arguments.mirror else forces)
    table = write_table(columns, system, axes)
    if arguments.output:
        arguments.output.write_text(table, encoding="utf-8")
    else:
        print(table, end="")
    if arguments.picture:
        draw(formula, columns, arguments.picture)
    return 0


def limits(columns):
    """Refuses inputs that are not possible."""
    for name, largest, what in (("slip_ratio", LARGEST_SLIP, "--kappa"),
                                ("slip_angle", LARGEST_ANGLE, "--alpha"),
                                ("inclination_angle", LARGEST_ANGLE, "--gamma")):
        if (np.abs(columns[name]) >= largest).any():
            limit = f"{LARGEST_SLIP}" if what == "--kappa" else "90 degrees"
            raise BifaceError(f"{what} must lie between -{limit} and {limit}.")
    if (columns["F_z"] <= 0).any():
        raise BifaceError("--fz must be positive, in SAE axes negative.")
    for name in ("pressure", "velocity"):
        if name in columns and (columns[name] <= 0).any():
            raise BifaceError(f"--{name} must be positive.")


def warn_outside(file, columns):
    """Tells which values are out of the ranges of the file."""
    for name, low, high in (("slip_ratio", "KPUMIN", "KPUMAX"),
                            ("slip_angle", "ALPMIN", "ALPMAX"),
                            ("inclination_angle", "CAMMIN", "CAMMAX"),
                            ("pressure", "PRESMIN", "PRESMAX"),
                            ("F_z", "FZMIN", "FZMAX")):
        if name not in columns:
            continue
        begin = file.find_number(low, -np.inf)
        end = file.find_number(high, np.inf)
        margin = 1e-9 * max(abs(columns[name]).max(), 1e-9)
        outside = ((columns[name] < begin - margin) | (columns[name] > end + margin)).sum()
        if outside:
            print(f"{COMMAND}: warning: {outside} of {len(columns[name])} rows have a "
                  f"{name} out of the range of the file, {low} to {high}.",
                  file=sys.stderr)


def draw(formula, columns, path, data=None):
    """Writes a picture of curves at the loads and up to the slips of columns."""
    missing = missing_module({"matplotlib": "python3-matplotlib"})
    if missing:
        raise BifaceError(missing)
    from . import picture
    try:
        picture.draw(formula, picture.ranges_of(columns, data), path, data)
    except ValueError as error:
        raise BifaceError(f"--picture is {path}, but must be a pdf, svg or png file.") \
            from error


def fit_table(arguments):
    """A .tir file from a table."""
    system = units_of(arguments)
    radius = positive(arguments.radius, "--radius", system["length"])
    load = positive(arguments.nominal_load, "--nominal-load", system["force"])
    pressure = positive(arguments.nominal_pressure, "--nominal-pressure",
                        system["pressure"])
    velocity = positive(arguments.velocity, "--velocity", system["velocity"])
    data = read_data(arguments, system)
    for sentence in doubts(data):
        print(f"{COMMAND}: warning: {arguments.table}: {sentence}", file=sys.stderr)
    stiffness = vertical(data, pressure)
    structure = None
    if arguments.structure:
        rolling = results_table(arguments)
        structure = read_structure(arguments.structure, arguments.units,
                                   rolling and Results(rolling.parent))
    if radius is None and stiffness is None:
        raise BifaceError("--radius is missing: the table has no column loaded_radius that "
                          "decreases with the load where upright wheels roll straight "
                          "ahead.")
    loaded = data["loaded_radius"]
    if radius and loaded is not None and not 0.5 < radius / loaded.max() < 2:
        raise BifaceError(f"--radius is {radius:.5g} m, but must be near the loaded radii, "
                          f"up to {loaded.max():.5g} m; see --units.")
    result = fit(data, arguments.format, radius or stiffness.radius, load, pressure,
                 velocity, arguments.without_combined, Patience())
    for sentence in text.of_combined(result) if result.typical else ():
        print(f"{COMMAND}: warning: {arguments.table}: {sentence}", file=sys.stderr)
    structural = structure and Structural(structure, result, stiffness)
    make_tir(result, arguments.side, f"From {arguments.table.name}.", stiffness,
             structural).write(arguments.output)
    unused = [] if results_table(arguments) else data.unused
    print(text.of_fit(result) + text.not_used(unused) + text.of_stiffness(stiffness)
          + (text.of_structural(structural) if structural else ""), end="")
    if arguments.picture:
        draw(result.formula, data, arguments.picture, data)
    return 0


def stiffness_tables(arguments):
    """Tables of the structure."""
    structure = read_structure(arguments.directories, arguments.units)
    tables = structure_tables(structure,
                              None if arguments.si else common_system(structure))
    if not arguments.output:
        print("\n".join(text_of(table) for table in tables), end="")
        return 0
    arguments.output.mkdir(parents=True, exist_ok=True)
    for table in tables:
        path = arguments.output / f"{table.name}.csv"
        path.write_text(text_of(table), encoding="utf-8")
        print(path)
    return 0


def tydex(arguments):
    """TYDEX files from a table."""
    paths = write_tydex(read_data(arguments, units_of(arguments)), arguments.output)
    print("\n".join(str(path) for path in paths))
    return 0


def check(arguments):
    """What is to be said of a file."""
    words, is_unusual = report(read_tir(arguments.file))
    print(words, end="")
    return int(is_unusual)


def main(words=None):
    """Runs a command. The exit code is 1 if that is not possible."""
    parser = make_parser()
    arguments = parser.parse_args(join_negative(sys.argv[1:] if words is None else words))
    command = {"evaluate": evaluate, "fit": fit_table, "stiffness": stiffness_tables,
               "tydex": tydex, "check": check}
    try:
        return command[arguments.command](arguments)
    except BifaceError as error:
        return complain(COMMAND, error)
    except BrokenPipeError:
        return 1
    except OSError as error:
        return complain(COMMAND, f"{error.filename} cannot be read or written "
                                 f"({error.strerror}).")
