#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generate the manual page biface.1 from the output of --help."""

import argparse
import re
import subprocess
from pathlib import Path

HEAD = r""".\" SPDX-License-Identifier: LGPL-2.1-or-later
.\" written by doc/parameters/manual.py
.TH BIFACE 1 "" biface
.SH NAME
biface \- finite element analysis of layered shells in contact
.SH SYNOPSIS
.B biface
.RI [ options ]
.I FILE.prm
.br
.B mpirun \-n
.I N
.B biface
.RI [ options ]
.I FILE.prm
.SH DESCRIPTION
"""

TAIL = r""".SH ENVIRONMENT
.TP
.B OPENBLAS_NUM_THREADS, OMP_NUM_THREADS
Threads of OpenBLAS per rank; by default one.
.SH FILES
.TP
.I /usr/share/doc/biface/README.md
An introduction.
.TP
.I /usr/share/doc/biface/examples
Example parameter files.
.SH SEE ALSO
.BR mpirun (1),
.BR paraview (1)
"""


def roff(text):
    """Text escaped for troff."""
    return text.replace("\\", "\\e").replace("-", "\\-")


def sentence(words):
    """Words as a sentence."""
    return re.sub(" +", " ", words[0].upper() + words[1:] + ".")


def page(help_text):
    """The manual page for the output of --help."""
    paragraphs = help_text.strip().split("\n\n")
    lines = [HEAD.rstrip("\n")]
    for paragraph in paragraphs[1:]:
        # join the lines of each description
        paragraph = re.sub(r"\n {10,}", "  ", paragraph)
        options = re.findall(r"^  (-\S.*?)  +(\S.*)$", paragraph, re.M)
        if options:
            lines.append(".SH OPTIONS")
            for option, meaning in options:
                lines += [".TP", ".B " + roff(option).replace('"', '\\(dq'),
                          roff(sentence(meaning))]
        elif paragraph.startswith("Exit codes:"):
            lines.append(".SH EXIT STATUS")
            codes = paragraph.replace("\n", " ")[len("Exit codes:"):]
            for code, meaning in re.findall(r"(\d) (.*?)(?:, (?=\d)|\.$)", codes):
                lines += [".TP", f".B {code}",
                          roff(sentence(meaning))]
        else:
            lines.append(roff(paragraph))
    return "\n".join(lines) + "\n" + TAIL


def main():
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="the program biface")
    parser.add_argument("page", type=Path, help="the file to write")
    arguments = parser.parse_args()
    text = subprocess.run([arguments.program, "--help"], check=True,
                          capture_output=True, text=True).stdout
    arguments.page.write_text(page(text), encoding="utf-8")


if __name__ == "__main__":
    main()
