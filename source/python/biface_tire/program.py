# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of biface-tire."""

import math
import re
import shlex
import signal
from pathlib import Path

from biface.errors import BifaceError
from biface_report.command_line import Arguments, complain, missing_module
from biface_tire_model.fitting import WITHOUT_COMBINED
from biface_tire_model.units import one_of
from . import text
from .design import Design, Options
from .judge import command_of, judge
from .parameter_file import NAME, PROFILE, RESULTS, ParameterFile
from .protocol import find, shipped
from .runs import Tire
from .service import STANDARD_GRAVITY
from .size import KINDS

COMMAND = "biface-tire"

PRESSURE_UNITS = {"mpa": 1, "kpa": 1e-3, "bar": 0.1, "psi": 0.00689476}
FORCE_UNITS = {"n": 1, "kn": 1000, "kg": STANDARD_GRAVITY, "lb": 4.44822, "lbf": 4.44822}
TREADS = ("bristles", "layer")


def make_parser():
    """The command line."""
    parser = Arguments(prog=COMMAND, description="Makes tires from their sizes: writes a "
                       "parameter file for biface, judges its results, and makes tire "
                       "models of them.")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    add_new(commands)
    judged = commands.add_parser(
        "judge", help="compares results with NASA TR R-64, ratings and other tires",
        description="Compares the results of the parameter file in a directory with the "
                    "formulas of NASA TR R-64 and with ratings. Exits with 1 if something "
                    "is unusual.")
    judged.add_argument("directory", metavar="DIR", type=Path,
                        help="that 'new' has written")
    judged.add_argument("--results", type=Path, metavar="DIR",
                        help="where the results are (default: DIR/results)")
    add_model(commands)
    return parser


def add_new(commands):
    """The command new."""
    parser = commands.add_parser(
        "new", help="a parameter file from a size",
        description=f"Writes DIR/{NAME} and, for a radial tire or a contour, "
                    f"DIR/{PROFILE}, and prints a summary. Dimensions and ratings "
                    "follow from the size; what it does not say, from rules.")
    parser.add_argument("size", metavar="SIZE", nargs="+",
                        help="in the usual notation, such as 195/65 R15 91V, 4.00-8 4PR, "
                             "49x17 26PR or 700x25C")
    parser.add_argument("-o", "--output", metavar="DIR", type=Path,
                        help="where to write; needed without --check")
    parser.add_argument("--check", action="store_true",
                        help="prints the summary and writes nothing")
    parser.add_argument("--rim", metavar="RIM",
                        help="its width in inches, with contour or diameter (6J, 2.50C, "
                             "13.25x20), of a bicycle in mm (17C)")
    parser.add_argument("--pressure", metavar="P",
                        help="in MPa, or with a unit: 2.5bar, 36psi, 250kPa")
    parser.add_argument("--load", metavar="F",
                        help="in N, or with a unit: 4kN, 615kg, 1356lb")
    parser.add_argument("--plies", type=int, metavar="N",
                        help="number of plies of the carcass, which is not the ply rating")
    parser.add_argument("--diameter", type=float, metavar="D",
                        help="measured overall diameter, mm")
    parser.add_argument("--width", type=float, metavar="W",
                        help="measured section width on this rim, mm")
    parser.add_argument("--contour", type=Path, metavar="FILE.csv",
                        help="measured points of the outer side of the carcass when "
                             "inflated, radius and axial coordinate in mm, from one flange "
                             "to the other")
    parser.add_argument("--kind", choices=KINDS,
                        help="the rules, if not those that follow from the notation")
    parser.add_argument("--speed", type=float, metavar="V",
                        help="at which the tire rolls, km/h")
    parser.add_argument("--tread", choices=TREADS, default="bristles",
                        help="bristles, on which the tire rolls (default), or a layer of "
                             "rubber, on which it stands")
    parser.add_argument("--cells", type=float, default=1, metavar="F",
                        help="factor on the number of cells along each direction "
                             "(default: 1)")
    parser.add_argument("--tire-test", action="store_true",
                        help="a tire test in place of the stiffnesses and free rolling")


def add_model(commands):
    """The command model."""
    parser = commands.add_parser(
        "model", help="a tire model: all runs of a test protocol, a .tir file, TYDEX files, "
                      "tables and a report",
        description="Runs what a test protocol asks for on the tire of a parameter file, "
                    "and makes a tire model of the results: a .tir file, TYDEX files, "
                    "tables of stiffnesses and a report, all in one directory. The same "
                    "command again goes on where it was interrupted.")
    parser.add_argument("tire", metavar="TIRE", type=Path,
                        help="a parameter file, or the directory that 'new' has written")
    parser.add_argument("--protocol", required=True, metavar="NAME",
                        help=f"{one_of(shipped())}, or a CSV file")
    parser.add_argument("-o", "--output", metavar="DIR", type=Path,
                        help="of the results (default: model_NAME beside the file)")
    parser.add_argument("--ranks", type=int, default=1, metavar="N",
                        help="number of MPI ranks of each run (default: 1)")
    parser.add_argument("--load", metavar="F",
                        help="the load of the tire, in N, or with a unit: 4kN, 615kg "
                             "(default: the largest of the file)")
    parser.add_argument("--format", choices=("5.2", "6.1"),
                        help="the version of the Magic Formula (default: 6.1 if the protocol "
                             "has several pressures, else 5.2)")
    parser.add_argument("--without-combined", choices=WITHOUT_COMBINED,
                        default=WITHOUT_COMBINED[0],
                        help="what a protocol without combined slip gives, as in "
                             "biface-tire-model fit")


def number_with_unit(option, words, units, default):
    """A number with a unit, in the first of the units."""
    if words is None:
        return None
    match = re.fullmatch(r"\s*([0-9.eE+-]+)\s*([A-Za-z]*)\s*", words)
    unit = (match[2] or default).lower() if match else ""
    try:
        value = float(match[1]) * units[unit]
    except (TypeError, ValueError, KeyError) as error:
        raise BifaceError(f"{option} is '{words}', but must be a number, with one of the "
                          f"units {', '.join(units)} or in {default}.") from error
    if not 0 < value < math.inf:
        raise BifaceError(f"{option} is '{words}', but must be positive.")
    return value


def check(arguments):
    """Refuses numbers that are not of this world."""
    if arguments.output is None and not arguments.check:
        raise BifaceError("--output is missing: say where to write, or use --check.")
    if arguments.tire_test and arguments.tread == "layer":
        raise BifaceError("--tire-test needs --tread bristles: on a layer the tire does "
                          "not roll.")
    for option, low, high, unit in (
            ("plies", 1, 60, ""), ("diameter", 100, 4500, " mm"), ("width", 10, 1600, " mm"),
            ("speed", 0.1, 500, " km/h"), ("cells", 0.25, 4, "")):
        value = getattr(arguments, option)
        if value is not None and not low <= value <= high:
            raise BifaceError(f"--{option} is {value:g}, but must lie between {low:g} and "
                              f"{high:g}{unit}.")
    if arguments.contour and (arguments.diameter or arguments.width):
        raise BifaceError("--contour has the diameter and the width: leave out --diameter "
                          "and --width.")


def make_design(arguments):
    """The design of the arguments of `new`."""
    check(arguments)
    return Design(" ".join(arguments.size), Options(
        rim=arguments.rim,
        pressure=number_with_unit("--pressure", arguments.pressure, PRESSURE_UNITS, "MPa"),
        load=number_with_unit("--load", arguments.load, FORCE_UNITS, "N"),
        plies=arguments.plies, diameter=arguments.diameter, width=arguments.width,
        contour=arguments.contour, kind=arguments.kind, speed=arguments.speed))


def command_line(arguments):
    """The command that these arguments are from, with all that is not by default."""
    words = [COMMAND, "new", *arguments.size]
    for option in ("rim", "pressure", "load", "plies", "diameter", "width", "contour",
                   "kind", "speed", "tread", "cells"):
        value = getattr(arguments, option)
        if value is not None and (option, value) not in (("tread", "bristles"),
                                                         ("cells", 1)):
            words += [f"--{option}", f"{value:g}" if isinstance(value, float)
                      else str(value)]
    words += ["--tire-test"] * arguments.tire_test + ["--output", str(arguments.output)]
    return shlex.join(words)


def new(arguments):
    """Writes the files of a design; returns what to print."""
    design = make_design(arguments)
    file = ParameterFile(design, arguments.tread, arguments.cells, arguments.tire_test)
    result = text.summary(design, file)
    if arguments.check:
        return result
    directory = arguments.output
    directory.mkdir(parents=True, exist_ok=True)
    if design.has_profile:
        design.write_profile(directory / PROFILE)
    (directory / NAME).write_text(
        file.text(command_line(arguments), directory, text.facts(design, file)),
        encoding="utf-8")
    return (result + f"Wrote {directory / NAME}. Run it, and judge the results:\n"
            f"  biface {directory / NAME}\n  {COMMAND} judge {directory}\n")


def model(arguments):
    """Makes a tire model; returns the exit code."""
    missing = missing_module({"matplotlib": "python3-matplotlib"})
    if missing:
        raise BifaceError(missing)
    from .model import REPORT, STEADY_TABLE, SUMMARY, TABLES, TYDEX, make_model, summary
    from .model_report import write_report
    tire = Tire(arguments.tire, number_with_unit("--load", arguments.load, FORCE_UNITS, "N"))
    protocol = find(arguments.protocol)
    output = arguments.output or tire.path.parent / f"model_{protocol.stem}"

    def say(line):
        print(line, flush=True)

    # as Ctrl-C, which leaves the run that it stops ready to go on
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        outcome = make_model(tire, protocol, output, arguments.format, arguments.ranks,
                             arguments.without_combined, say)
    except KeyboardInterrupt:
        return complain(COMMAND, "interrupted; the same command goes on from here.") + 129
    finally:
        signal.signal(signal.SIGTERM, before)
    files = [name for name in (f"{tire.path.stem}.tir", STEADY_TABLE, TYDEX, TABLES)
             if (output / name).exists()]
    words = summary(outcome, [str(output / name) for name in (*files, REPORT)])
    (output / SUMMARY).write_text(words, encoding="utf-8")
    write_report(outcome, f"Tire model of {tire.path.name}, protocol {protocol.stem}",
                 words, output / REPORT)
    print(words, end="")
    return int(outcome.is_incomplete)


def main(words=None):
    """Runs a command. The exit code is 1 if that is not possible, or if a judgment has
    warnings."""
    parser = make_parser()
    arguments = parser.parse_args(words)
    try:
        if arguments.command == "new":
            print(new(arguments), end="")
            return 0
        if arguments.command == "model":
            return model(arguments)
        given = command_of(arguments.directory)
        if given[:2] != [COMMAND, "new"]:
            raise BifaceError(f"{arguments.directory / NAME} was not made by {COMMAND} new.")
        made = parser.parse_args(given[1:])
        result = judge(make_design(made), arguments.results or
                       arguments.directory / RESULTS, made.tread)
        print(text.judgment(result), end="")
        return 1 if result.warnings else 0
    except BifaceError as error:
        return complain(COMMAND, error)
    except OSError as error:
        return complain(COMMAND, f"{error.filename} cannot be read or written "
                                 f"({error.strerror}).")
