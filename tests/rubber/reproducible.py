# SPDX-License-Identifier: LGPL-2.1-or-later

# Two fits of the same curves print the same, also if the points come in another order.

from rubber_test import TRELOAR, check, entries_of, output_of, require, scratch

require("numpy", "scipy")

words = ("--law", "Ogden")
first = output_of(TRELOAR, *words)
check(output_of(TRELOAR, *words) == first, "the second fit is another")

lines = [line for line in TRELOAR.read_text(encoding="utf-8").splitlines()
         if not line.startswith("#")]
path = scratch() / "reversed.csv"
path.write_text("\n".join([lines[0], *reversed(lines[1:])]), encoding="utf-8")
found = entries_of(first)
for entry, numbers in entries_of(output_of(path, *words)).items():
    if entry != "Type":
        for number, other in zip(numbers, found[entry]):
            check(abs(number - other) < 1e-4 * abs(other), f"{entry}: {number}, {other}")
