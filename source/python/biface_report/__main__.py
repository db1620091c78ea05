# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of biface-report."""

import sys
from pathlib import Path

from .command_line import Arguments, complain, missing_module

# Required modules, and the Debian packages that provide them
NEEDED = {"numpy": "python3-matplotlib", "matplotlib": "python3-matplotlib"}


def parse_arguments():
    """The directory, the step and the file to write."""
    parser = Arguments(
        prog="biface-report",
        description="Writes one self-contained HTML page about a directory "
                    "of biface results.")
    parser.add_argument("directory", metavar="OUTPUT_DIR", type=Path,
                        help="directory with history.csv and the other results, "
                             "or with study.csv")
    parser.add_argument("--step", type=int, metavar="N",
                        help="the step to show (default: the last one)")
    parser.add_argument("-o", "--output", metavar="FILE", type=Path,
                        help="the page (default: OUTPUT_DIR/report.html)")
    return parser.parse_args()


def main():
    """Writes the page. The exit code is 1 if that is not possible."""
    arguments = parse_arguments()
    missing = missing_module(NEEDED)
    if missing:
        return complain("biface-report", missing)

    from biface import BifaceError, Results, Study

    from . import study
    from .content import report

    path = arguments.output or arguments.directory / "report.html"
    try:
        if (arguments.directory / "study.csv").exists():
            if arguments.step is not None:
                raise BifaceError("--step belongs to a run, but "
                                  f"{arguments.directory} holds a study.")
            text = study.report(Study(arguments.directory))
        else:
            text = report(Results(arguments.directory, arguments.step))
        path.write_text(text, encoding="utf-8")
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
