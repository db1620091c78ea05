# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of biface-report."""

import atexit
import contextlib
import csv
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path

BUILD, SOURCE, RUNS = (Path(os.environ[f"BIFACE_{name}"])
                       for name in ("BUILD", "SOURCE", "RUNS"))
PACKAGE = SOURCE / "source/python"

# HTML elements without an end tag
VOID = ("meta", "img", "br", "link", "input", "hr")


def require(*modules):
    """Skips the test if a Python module is missing."""
    for module in modules:
        if not find_spec(module):
            print(f"skipped: {module} for Python is missing")
            sys.exit(77)


def require_three():
    """Skips the test if the library of the view is missing."""
    if not Path("/usr/share/javascript/three/three.min.js").exists():
        print("skipped: three.js is missing (Debian: libjs-three)")
        sys.exit(77)


def scratch():
    """A directory that is removed when the test ends."""
    directory = tempfile.mkdtemp(dir=RUNS)
    atexit.register(shutil.rmtree, directory, ignore_errors=True)
    return Path(directory)


def run_command(name, *words):
    """Runs a command of the build directory; returns its exit code, its output, its error
    messages."""
    done = subprocess.run([BUILD / name, *words], capture_output=True, text=True,
                          check=False)
    return done.returncode, done.stdout, done.stderr


def run_here(main, *words):
    """Runs the main function of a program without the time that a new process takes;
    returns its exit code, its output, its error messages."""
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            code = main([str(word) for word in words])
        except SystemExit as end:
            code = end.code
    return code, output.getvalue(), errors.getvalue()


def run_alone_here(main, name, *words):
    """The same for a main function that reads the words of the command line itself."""
    before, sys.argv = sys.argv, [name, *map(str, words)]
    try:
        return run_here(lambda _: main())
    finally:
        sys.argv = before


def check_refused_by(name, outcome, sentence, what):
    """Checks that a program has refused its words with one sentence.
    outcome: see run_here(); what: the words."""
    code, output, errors = outcome
    check(code == 1 and output == "",
          f"{what}: the exit code is {code}: {output}{errors}")
    check(sentence in errors and errors.startswith(f"{name}: ")
          and errors.count("\n") == 1 and errors.endswith(".\n"),
          f"{what}: '{sentence}' is not told in one sentence: {errors}")


def copy_of(run):
    """A copy of the results of a run that the test may change."""
    target = scratch() / run
    shutil.copytree(RUNS / run, target)
    return target


def report(directory, *words, launcher=None, target=None):
    """Runs biface-report, without the time that a new process takes if there is no
    launcher; returns its exit code, its error messages, the page."""
    target = target or scratch() / "page.html"
    words = directory, "-o", target, *words
    if launcher or not find_spec("matplotlib"):
        done = subprocess.run([launcher or BUILD / "biface-report", *words],
                              capture_output=True, text=True, check=False)
        code, errors = done.returncode, done.stderr
    else:
        if str(PACKAGE) not in sys.path:
            sys.path.insert(0, str(PACKAGE))
        from biface_report.__main__ import main
        code, _, errors = run_alone_here(main, "biface-report", *words)
    page = target.read_text(encoding="utf-8") if target.exists() else ""
    return code, errors, page


def page_of(directory, *words, **options):
    """The parsed page of a directory, which must succeed."""
    code, errors, page = report(directory, *words, **options)
    check(code == 0, f"the exit code is {code}: {errors}")
    return Page(page)


def complaint(directory, *words):
    """The error message about a directory that cannot be reported."""
    code, errors, page = report(directory, *words)
    check(code == 1, f"the exit code is {code}, not 1: {errors}")
    check(page == "", "a page was written")
    check(errors.count("\n") == 1 and errors.endswith(".\n"),
          f"this is not one sentence: {errors}")
    return errors


def read_csv(path):
    """The lines of a CSV file as dictionaries by column names."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def check(fact, message):
    """Fails the test with a message unless a condition holds."""
    if not fact:
        print(message)
        sys.exit(1)


def check_equal(computed, expected, what):
    """Checks that numbers agree to the digits of the files."""
    check(math.isclose(computed, expected, rel_tol=1e-10, abs_tol=1e-300),
          f"{what} is {computed}, not {expected}")


class Page(HTMLParser):
    """The contents of the page: text, pictures, rows of tables, scripts. The
    parser fails if elements are not closed in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows, self.images, self.text = [], [], [], ""
        self.addresses, self.headings, self.scripts = [], [], []
        self.source = text
        self.feed(text)
        self.close()
        check(not self.open, f"these are not closed: {self.open}")

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.addresses += [value for name, value in attributes.items()
                           if name in ("src", "href", "srcset", "poster",
                                       "action", "data")]
        if tag == "img":
            self.images.append(attributes)
        if tag == "tr":
            self.rows.append(([], []))
        if tag == "data":
            self.rows[-1][1].append(float(attributes["value"]))
        if tag in ("th", "td"):
            self.rows[-1][0].append("")
        if tag in ("h1", "h2", "h3"):
            self.headings.append("")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        check(self.open and self.open[-1] == tag,
              f"</{tag}> closes {self.open[-1:]} in line {self.getpos()[0]}")
        self.open.pop()

    def handle_data(self, data):
        if "script" in self.open:
            self.scripts.append(data)
            return
        self.text += data
        if self.open and self.open[-1] in ("h1", "h2", "h3"):
            self.headings[-1] += data
        if "tr" in self.open and self.rows[-1][0]:
            self.rows[-1][0][-1] += data

    def numbers(self, head):
        """The numbers of the first row with a given heading."""
        for cells, values in self.rows:
            if cells[0] == head:
                return values
        check(False, f"there is no row '{head}'")
        return []
