#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generate doc/parameters.md, the page on all entries of a parameter file, from
--print-parameters=json."""

import argparse
import json
import re
import subprocess
from pathlib import Path

HEAD = """# All entries of a parameter file

One table per section. `cmake --build build --target reference` generates this page
from the declarations in the program; `biface --print-parameters` prints the same as a
parameter file. [new_shell.md](new_shell.md) explains what to choose.

```
set Entry = value            # a comment
subsection Section
  set Entry of the section = value
end
```

Any consistent set of units works, such as mm, N and MPa, but angles are always in
degrees. Entries that are not set have their defaults, and unknown ones are refused. On
the command line, `--set "Section/Entry=value"` takes precedence over the file.

A backslash at the end of a line, or of its comment, joins it with the next one; comments
between the lines of an entry are left out. A list must not end with a comma.
"""

# sections whose name the user chooses
NAMED = {
    "Material cord": (
        "Material NAME",
        "One section for each name in `Materials`, by default `cord`."),
    "Body cleat": (
        "Body NAME",
        "One section for each name in `Bodies`."),
    "Stage 1": (
        "Stage N",
        "One section for each of the `Number of stages`, N = 1, 2, ..."),
}


def number(text):
    """A bound of an interval, or an empty string if there is none."""
    if "MAX_" in text or text in ("-2147483648", "2147483647"):
        return ""
    return f"{float(text):g}"


def interval(name, low, high):
    """The range of allowed numbers."""
    low, high = number(low), number(high)
    if low and high:
        return f"{name}, {low} to {high}"
    if low:
        return f"{name}, {low} or more"
    if high:
        return f"{name}, at most {high}"
    return name


def count(low, high):
    """The number of items a list may have."""
    if low == high:
        return low
    if high == "4294967295":
        return "any number of" if low == "0" else f"{low} or more"
    return f"{low} to {high}"


def allowed(pattern):
    """ParameterHandler's description of a pattern, in words."""
    pattern = pattern.strip()
    match = re.fullmatch(r"\[Selection (.*?) ?\]", pattern)
    if match:
        return ", ".join(f"`{word.strip()}`" for word in match[1].split("|"))
    match = re.fullmatch(r"\[Number or (.*)\]", pattern)
    if match:
        return f"a number or `{match[1]}`"
    match = re.fullmatch(r"\[MultipleSelection (.*?) ?\]", pattern)
    if match:
        return "list of: " + ", ".join(
            f"`{word.strip()}`" for word in match[1].split("|"))
    match = re.fullmatch(
        r"\[(Double|Integer)(?: range)?(?: (\S+)\.\.\.(\S+) \(inclusive\))?\]", pattern)
    if match:
        name = {"Double": "number", "Integer": "whole number"}[match[1]]
        return interval(name, match[2], match[3]) if match[2] else name
    match = re.fullmatch(
        r"\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\).*\]", pattern)
    if match:
        return f"list of {count(match[2], match[3])}: {allowed(match[1])}"
    simple = {"[Bool]": "`true`, `false`", "[Anything]": "text",
              "[DirectoryName]": "directory",
              "[FileName (Type: input)]": "file",
              "[FileName (Type: output)]": "file"}
    if pattern not in simple:
        raise SystemExit(f"unknown pattern {pattern}; add it to "
                         "doc/parameters/parameters.py.")
    return simple[pattern]


def cell(text):
    """Text in a Markdown table."""
    text = re.sub(r"'([^']+)'(?!\w)", r"`\1`", text)   # quoted words
    text = re.sub(r"(?<![`\w])((?:\w+_)+\w+)(?!\w)(?=[^`]*(?:`[^`]*`[^`]*)*$)",
                  r"`\1`", text)                        # names such as alpha_1
    return text.replace("|", "\\|").replace("\n", " ")


def table(entries):
    """The entries of one section as a table."""
    lines = ["| Entry | Default | Allowed | Meaning and unit |",
             "| --- | --- | --- | --- |"]
    for name, entry in entries:
        default = entry["default_value"]
        lines.append(f"| `{name}` | {f'`{default}`' if default else 'empty'} | "
                     f"{allowed(entry['pattern_description'])} | "
                     f"{cell(entry['documentation'])} |")
    return lines


def section(name, declared, level):
    """A section with its subsections, as lines of Markdown."""
    entries = [(key, value) for key, value in declared.items()
               if "default_value" in value]
    lines = []
    if name:
        title, remark = NAMED.get(name, (name, ""))
        lines += ["", "#" * level + " " + title]
        if remark:
            lines += ["", remark]
    if entries:
        lines += [""] + table(entries)
    for key, value in declared.items():
        if "default_value" not in value:
            inner = key if level == 1 else f"{name}: {key}"
            lines += section(inner, value, level + 1)
    return lines


def main():
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="the program biface")
    parser.add_argument("page", type=Path, help="the file to write")
    arguments = parser.parse_args()
    declared = json.loads(subprocess.run(
        [arguments.program, "--set", "Bodies=cleat",
         "--print-parameters=json"], check=True,
        capture_output=True, text=True).stdout)
    declared["Bodies"]["default_value"] = ""
    top = ["", "## Outside all sections"]
    top_entries = {k: v for k, v in declared.items() if "default_value" in v}
    sections = {k: v for k, v in declared.items() if "default_value" not in v}
    lines = top + section("", top_entries, 1) + section("", sections, 1)
    arguments.page.write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
