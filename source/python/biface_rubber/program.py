# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of biface-rubber."""

import math
from pathlib import Path

from biface.errors import BifaceError
from biface_report.command_line import Arguments, complain, missing_module

COMMAND = "biface-rubber"

LAWS = ("neo-Hooke", "Mooney-Rivlin", "Yeoh", "Ogden", "all")


def make_parser():
    """The command line."""
    parser = Arguments(
        prog=COMMAND,
        description="Finds the constants of rubber, from its hardness or from "
                    "measured curves, and prints the section Material of a "
                    "parameter file.")
    parser.add_argument("data", metavar="DATA.csv", type=Path, nargs="?",
                        help="columns test (uniaxial, equibiaxial or planar), stretch "
                             "and stress, the force over the undeformed area")
    parser.add_argument("--shore", type=float, metavar="S",
                        help="the Shore A hardness, in place of a file")
    parser.add_argument("--name", default="rubber",
                        help="the name of the material (default: rubber)")
    parser.add_argument("--nu", type=float, metavar="NU",
                        help="Poisson's ratio, for the bulk modulus (default: 0.499)")
    parser.add_argument("--K", type=float, metavar="K",
                        help="the bulk modulus, in place of --nu")
    curves = parser.add_argument_group("with DATA.csv")
    curves.add_argument("--law", choices=LAWS, default="all",
                        help="the law (default: all, a table)")
    curves.add_argument("--terms", type=int, choices=(1, 2, 3),
                        help="terms of Ogden's law (default: 3)")
    curves.add_argument("--errors", choices=("absolute", "relative"),
                        default="absolute",
                        help="which errors in the stress are made small: absolute "
                             "ones (default), or those relative to the measured "
                             "stress, which weigh small strains more")
    curves.add_argument("--only", metavar="TESTS",
                        help="fits only the tests of this list, such as 'uniaxial, "
                             "planar'; errors are shown of all")
    curves.add_argument("--stable", action="store_true",
                        help="only constants whose signs make the law stable at all "
                             "stretches")
    curves.add_argument("--up-to", type=float, metavar="STRETCH",
                        help="the stretch up to which the stability is checked "
                             "(default: at twice the largest measured strain)")
    curves.add_argument("--plot", metavar="FILE", type=Path,
                        help="writes a picture of data and curves (png, svg or pdf)")
    return parser


def check(parser, arguments):
    """Refuses what does not fit together."""
    if (arguments.data is None) == (arguments.shore is None):
        raise BifaceError("give either DATA.csv or --shore.")
    if arguments.shore is not None:
        for option in ("law", "terms", "errors", "only", "stable", "up_to", "plot"):
            if getattr(arguments, option) != parser.get_default(option):
                raise BifaceError(f"--{option.replace('_', '-')} belongs to curves, "
                                  "not to --shore.")
    if arguments.terms and arguments.law != "Ogden":
        raise BifaceError("--terms belongs to --law Ogden.")
    if arguments.K is not None and arguments.nu is not None:
        raise BifaceError("--K and --nu exclude each other.")
    if arguments.nu is None:
        arguments.nu = 0.499
    if not 0 < arguments.nu < 0.5:
        raise BifaceError(f"--nu is {arguments.nu:g}, but must lie between 0 and 0.5.")
    if arguments.K is not None and not math.isfinite(arguments.K):
        raise BifaceError(f"--K is {arguments.K:g}, but must be a number.")
    if arguments.up_to is not None and not 1 < arguments.up_to <= 100:
        raise BifaceError(f"--up-to is {arguments.up_to:g}, but must be greater than 1 "
                          "and at most 100.")


def fit_curves(arguments):
    """Fits laws to the file; returns what to print."""
    from . import text
    from .data import LARGEST_STRETCH, read
    from .fit import fit
    from .laws import LINEAR
    from .stability import instabilities

    data = read(arguments.data)
    fitted = data
    if arguments.only is not None:
        tests = [test.strip() for test in arguments.only.split(",")]
        for test in tests:
            if test not in data.measured():
                raise BifaceError(f"--only names '{test}', but {arguments.data} has "
                                  f"only points of {', '.join(data.measured())}.")
        fitted = data.only(tests)
    end = arguments.up_to or min(max(2 * data.largest_stretch() - 1, 1.01),
                                 LARGEST_STRETCH)
    measure, options = arguments.errors, {"relative": arguments.errors == "relative",
                                          "stable": arguments.stable}
    material = (arguments.name, arguments.K, arguments.nu)
    if arguments.law != "all":
        law = fit(fitted, arguments.law, arguments.terms or 3, **options)
        laws = [(arguments.law, law)]
        result = text.of_fit(law, data, fitted, measure, instabilities(law, end), end,
                             *material)
    else:
        rows = []
        for name, count in ([(name, 0) for name in LINEAR]
                            + [("Ogden", count) for count in (1, 2, 3)]):
            label = f"Ogden, {count} term{'s' * (count > 1)}" if count else name
            try:
                law = fit(fitted, name, count, **options)
                rows.append((label, law, instabilities(law, end)))
            except BifaceError as error:
                rows.append((label, None, str(error)))
        laws = [(label, law) for label, law, _ in rows if law]
        result = text.of_all(rows, data, fitted, measure, end)
    if arguments.plot and laws:
        missing = missing_module({"matplotlib": "python3-matplotlib"})
        if missing:
            raise BifaceError(missing)
        from .picture import draw
        try:
            draw(laws, data, fitted, arguments.plot)
        except ValueError as error:
            raise BifaceError(f"--plot is {arguments.plot}, but must be a png, svg or "
                              "pdf file.") from error
    return result


def main():
    """Prints the constants. The exit code is 1 if that is not possible."""
    parser = make_parser()
    arguments = parser.parse_args()
    try:
        check(parser, arguments)
        if arguments.shore is None:
            result = fit_curves(arguments)
        else:
            from . import text
            result = text.of_hardness(arguments.shore, arguments.name, arguments.K,
                                      arguments.nu)
    except BifaceError as error:
        return complain(COMMAND, error)
    except OSError as error:
        return complain(COMMAND, f"{error.filename} cannot be read or written "
                                 f"({error.strerror}).")
    print(result, end="")
    return 0
