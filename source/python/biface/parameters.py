# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads and writes parameter files.

In parameters.prm as the program writes it, a comment '# default: VALUE' follows each
value that differs from the default, and the first line is a comment that names the
program and the parameter file.
"""

from __future__ import annotations

import os
import re
from collections import namedtuple
from collections.abc import Mapping
from pathlib import Path

from .errors import BifaceError
from .tables import read_text

# An entry: section/name, its value, and its default if that differs
Entry = namedtuple("Entry", "name value default")

ENTRY = re.compile(r"set\s+(.*?)\s*=\s*(.*?)\s*"
                   r"(?:#\s*(?:default:\s*(.*?)\s*|.*))?$")
ORIGIN = re.compile(r"#\s*biface\s+(\S+?)(?:,\s*from\s+(.+?))?\s*$")


class Parameters:
    """All entries by name, the text, and its origin if it names one."""

    def __init__(self, text):
        self.text = text
        self.entries = {}
        self.version = self.source = None

    def __getitem__(self, name: str) -> str:
        """The value of an entry, as text."""
        return self.entries[name].value

    def changed(self):
        """The entries whose values are not the defaults."""
        return [entry for entry in self.entries.values()
                if entry.default is not None
                and not is_same(entry.value, entry.default)]


def is_same(value, default):
    """Whether two values agree, as numbers if they are (1e4 and 10000)."""
    try:
        return float(value) == float(default)
    except ValueError:
        return value == default


def read_parameters(path: str | os.PathLike) -> Parameters:
    """The entries that a parameter file sets."""
    return parse_parameters(read_text(path))


def parse_parameters(text: str) -> Parameters:
    """The entries that the text of a parameter file sets."""
    result = Parameters(text)
    origin = ORIGIN.match(text.split("\n", 1)[0])
    if origin:
        result.version, result.source = origin.groups()
    for _, name, value, default in scan(text.split("\n")):
        result.entries[name] = Entry(name, value, default)
    return result


def join(lines, first):
    """A line with all that backslashes join with it, at the end of lines or of their
    comments, and the number of the next line. Comments between them are left out."""
    whole, end, goes_on = "", first, True
    while goes_on and end < len(lines):
        line = lines[end].strip()
        end += 1
        if line.startswith("#"):
            if end == first + 1:
                return line, end
            continue
        content, _, comment = (part.rstrip() for part in line.partition("#"))
        goes_on = content.endswith("\\") or comment.endswith("\\")
        if content.endswith("\\"):
            content = content.removesuffix("\\")
        elif goes_on:
            content += " "
        whole += content if goes_on else line
    return whole, end


def scan(lines):
    """For each entry the range of its lines, its name, value and default."""
    sections, first = [], 0
    while first < len(lines):
        line, end = join(lines, first)
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].partition("#")[0].strip())
        elif re.match(r"end\b", line) and sections:
            sections.pop()
        elif match := ENTRY.match(line):
            name, value, default = match.groups()
            yield slice(first, end), "/".join(sections + [name]), value, default
        first = end


def write_parameters(path: str | os.PathLike, settings: Mapping[str, object],
                     base: str | os.PathLike | None = None) -> None:
    """Writes a parameter file: that of the file `base`, if any, with the values of the
    entries `settings` by name. Files that the base file names are sought from the
    folder of the new one."""
    texts = {name: to_text(value) for name, value in settings.items()}
    for name, text in texts.items():
        if "#" in text or "\n" in text or text.endswith("\\"):
            raise BifaceError(f"The value of '{name}' is '{text}', but the values in a "
                              "parameter file cannot contain '#' or more than a line, "
                              "or end with a backslash.")
    lines = [] if base is None else read_text(base).split("\n")
    found = [(place, name) for place, name, _, _ in scan(lines) if name in texts]
    for place, name in reversed(found):  # from the end: numbers of lines remain valid
        lines[place] = [f"set {name.rpartition('/')[2]} = {texts[name]}"]
    present = {name for _, name in found}
    for name, text in texts.items():
        if name in present:
            continue
        *sections, entry = name.split("/")
        lines += [f"subsection {section}" for section in sections]
        lines += [f"set {entry} = {text}"] + ["end"] * len(sections)
    try:
        Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")
    except OSError as error:
        raise BifaceError(f"{path} cannot be written ({error.strerror}).") from None


def to_text(value: object) -> str:
    """The value of an entry as a parameter file has it: a number in all its digits,
    a boolean as true or false, a list with commas."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(map(to_text, value))
    return repr(value)


def stages(parameters):
    """The numbers and names of all stages, in order."""
    count = parameters.entries.get("Number of stages")
    n_stages = int(count.value) if count and count.value.isdigit() else 1
    return [(i, parameters.entries[f"Stage {i}/Name"].value)
            for i in range(1, n_stages + 1)
            if f"Stage {i}/Name" in parameters.entries]
