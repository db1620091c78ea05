# SPDX-License-Identifier: LGPL-2.1-or-later

# Constants that contradict the units of a .tir file, and slopes that contradict its axes,
# are named by check and evaluate.

from tire_model_test import MADE, check, require, tire_model_here, write

require("numpy", "scipy")

import re

SOURCE = MADE.read_text(encoding="utf-8")


def with_entry(name, value):
    """The file with another value of an entry."""
    text, count = re.subn(rf"(?m)^({name} *=) *\S+", rf"\g<1> {value}", SOURCE)
    check(count == 1, f"{name} is not there once")
    return text


for text, sentence in (
        (SOURCE.replace("'meter'", "'mm'"), "UNLOADED_RADIUS is 0.00032 m by the section "
                                            "[UNITS], but usually lies between 0.01 and 3 m."),
        (with_entry("FNOMIN", "4"), "FNOMIN is 4 N by the section [UNITS]"),
        (with_entry("NOMPRES", "2.2"), "NOMPRES is 2.2 Pa by the section [UNITS]"),
        (with_entry("PKY1", "22"), "F_y")):
    path = write("tire.tir", text)
    for words in (["check"], ["evaluate", "--fz", "4000"]):
        code, output, errors = tire_model_here(words[0], path, *words[1:])
        found = output if words == ["check"] else errors
        check(sentence in found, f"{words[0]} does not say '{sentence}': {found}")
code, output, errors = tire_model_here("evaluate", path, "--fz", "4000")
check("F_y rises with the slip angle at 4200 N, but must fall in ISO axes" in errors, errors)
check(tire_model_here("evaluate", MADE, "--fz", "4000")[2] == "", "the file is in order")
