# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entries of parameter files, as the program documents them."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass

from .errors import BifaceError
from .program import call, find_program


@dataclass(frozen=True)
class EntryDescription:
    """An entry of parameter files.

    name           with its sections, as in "Stage 1/Pressure"
    type           float, int, bool, or str for all others, such as lists
    default        of this type; None for a float with a word as the default
    documentation  the text of the program
    unit           "length", "force/area" and so on; None if it has none
    choices        the words that are allowed; empty if any text or number is
    """

    name: str
    type: type
    default: object
    documentation: str
    unit: str | None
    choices: tuple[str, ...]


def entries(program: str | os.PathLike | None = None) -> dict[str, EntryDescription]:
    """All entries of parameter files by name. Sections that exist once for each
    material or stage have the names "Material cord" and "Stage 1".

    Raises BifaceError if the program is not found."""
    try:
        declared = json.loads(call(program, "--print-parameters=json"))
    except json.JSONDecodeError:
        raise BifaceError(f"{find_program(program)} does not list the entries of "
                          "parameter files: it is not biface.") from None
    return {entry.name: entry for entry in describe(declared, "")}


def describe(section: dict, prefix: str) -> Iterator[EntryDescription]:
    """The entries of a section and its subsections."""
    for name, declared in section.items():
        if "default_value" not in declared:
            yield from describe(declared, f"{prefix}{name}/")
            continue
        kind, words = kind_of(declared["pattern_description"])
        text = declared["default_value"]
        unit = re.search(r"\bUnit: ([^.]*)\.", declared["documentation"])
        yield EntryDescription(prefix + name, kind, value_of(text, kind),
                               declared["documentation"], unit and unit[1], words)


def kind_of(pattern: str) -> tuple[type, tuple[str, ...]]:
    """The type and the allowed words of a pattern of deal.II's ParameterHandler."""
    match = re.match(r"\[(\w+) ?(.*?)\s*\]$", pattern.strip())
    name, rest = match.groups() if match else ("", "")
    kind = {"Double": float, "Number": float, "Integer": int, "Bool": bool}.get(
        name, str)
    return kind, tuple(map(str.strip, rest.split("|"))) if name == "Selection" else ()


def value_of(text: str, kind: type) -> object:
    """The text of a value as the type."""
    if kind is bool:
        return text == "true"
    try:
        return kind(text)
    except ValueError:
        return None
