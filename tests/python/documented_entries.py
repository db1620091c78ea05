# SPDX-License-Identifier: LGPL-2.1-or-later

# Entries have the types, defaults, units and choices that the program documents.

from python_test import biface, check

entries = biface.entries()
radius = entries["Surface/Circular arc/Radius"]
check((radius.type, radius.default, radius.unit) == (float, 50., "length"), f"{radius}")
check(radius.documentation.startswith("Radius R_1 of the arc."), f"{radius}")
check(entries["Stage 1/Steps"].type is int, f"{entries['Stage 1/Steps']}")
check(entries["Stage 1/Contact"].default is False, f"{entries['Stage 1/Contact']}")
travel = entries["Stage 1/Travel"]
check((travel.type, travel.default) == (float, None), f"{travel}")
ground = entries["Contact/Foundation"]
check(ground.choices == ("plane", "drum", "sphere"), f"{ground}")
check(entries["Laminate/Plies"].type is str, f"{entries['Laminate/Plies']}")
