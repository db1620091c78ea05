# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of biface-report."""

import sys
from pathlib import Path

from .command_line import Arguments, complain, missing_module

# Required modules, and the Debian packages that provide them
NEEDED = {"numpy": "python3-matplotlib", "matplotlib": "python3-matplotlib"}


def parse_arguments():
    """The directories, the step and the file to write."""
    parser = Arguments(
        prog="biface-report",
        description="Writes one self-contained HTML page about a directory "
                    "of biface results, or a comparison of two.")
    parser.add_argument("directories", metavar="OUTPUT_DIR", type=Path, nargs="+",
                        help="directory with history.csv and the other results, "
                             "or with study.csv; two with history.csv are compared")
    parser.add_argument("--step", type=int, metavar="N",
                        help="the step to show (default: the last one)")
    parser.add_argument("-o", "--output", metavar="FILE", type=Path,
                        help="the page (default: report.html, or comparison.html "
                             "of two, in the first OUTPUT_DIR)")
    return parser.parse_intermixed_args()


def page_about(first, others, step):
    """The page about a directory, or about two."""
    from biface import BifaceError, Results, Study

    from . import comparison, study
    from .content import report

    if len(others) > 1:
        raise BifaceError("Two directories at most can be compared, not "
                          f"{1 + len(others)}.")
    studies = [directory for directory in (first, *others)
               if (directory / "study.csv").exists()]
    if studies and others:
        raise BifaceError(f"Two runs can be compared, but {studies[0]} holds a "
                          "study.")
    if studies and step is not None:
        raise BifaceError(f"--step belongs to a run, but {first} holds a study.")
    if studies:
        return study.report(Study(first))
    if others:
        return comparison.report(Results(first, step), Results(others[0], step))
    return report(Results(first, step))


def main():
    """Writes the page. The exit code is 1 if that is not possible."""
    arguments = parse_arguments()
    missing = missing_module(NEEDED)
    if missing:
        return complain("biface-report", missing)

    from biface import BifaceError

    first, *others = arguments.directories
    path = arguments.output or first / (
        "comparison.html" if others else "report.html")
    try:
        path.write_text(page_about(first, others, arguments.step),
                        encoding="utf-8")
    except BifaceError as error:
        return complain("biface-report", error)
    except OSError as error:
        return complain("biface-report",
                        f"{error.filename or path} cannot be read or written "
                        f"({error.strerror}).")
    print(f"Report in {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
