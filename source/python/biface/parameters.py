# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads parameters.prm as the program writes it.

A comment '# default: VALUE' follows each value that differs from the default. The
first line is a comment that names the program and the parameter file.
"""

import re
from collections import namedtuple

# An entry: section/name, its value, and its default if that differs
Entry = namedtuple("Entry", "name value default")

ENTRY = re.compile(r"set\s+(.*?)\s*=\s*(.*?)\s*(?:#\s*default:\s*(.*?)\s*)?$")
# Entries that had other names in older files
OLD_NAMES = {"Direction": "Plane normal", "Named points": "Points",
             "Start from prestress": "Begin from prestress"}

ORIGIN = re.compile(r"#\s*biface\s+(\S+?)(?:,\s*from\s+(.+?))?\s*$")


class Parameters:
    """All entries by name, the text, and its origin if it names one."""

    def __init__(self, text):
        self.text = text
        self.entries = {}
        self.version = self.source = None

    def find(self, name):
        """An entry by its name, or by its older one; None if it is missing."""
        section, slash, entry = name.rpartition("/")
        return self.entries.get(name) or self.entries.get(
            section + slash + OLD_NAMES.get(entry, entry))

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


def read_parameters(text):
    """Parses the text of a file."""
    result = Parameters(text)
    origin = ORIGIN.match(text.split("\n", 1)[0])
    if origin:
        result.version, result.source = origin.groups()
    sections = []
    for line in map(str.strip, text.split("\n")):
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end" and sections:
            sections.pop()
        elif match := ENTRY.match(line):
            name, value, default = match.groups()
            name = "/".join(sections + [name])
            result.entries[name] = Entry(name, value, default)
    return result


def stages(parameters):
    """The numbers and names of all stages, in order."""
    count = parameters.entries.get("Number of stages")
    n_stages = int(count.value) if count and count.value.isdigit() else 1
    return [(i, parameters.entries[f"Stage {i}/Name"].value)
            for i in range(1, n_stages + 1)
            if f"Stage {i}/Name" in parameters.entries]
