#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design a radial passenger tire from its size, and write its meridian and plies.

All that is known of the tire is the size: outer radius and section width when
inflated, radius and width of the rim. The rules of biface_tire.radial give the rest.
Nothing is fitted to a stiffness or a load.

    python3 doc/measured_tires/radial_tire.py --output prm

writes radial_tire_profile.csv, the points of the outer side of the carcass, and
radial_tire_plies.csv for prm/radial_tire.prm, which is a 205/60 R15, and prints the entries
that depend on the size, too. Options give other sizes.
"""

import argparse
import sys
from dataclasses import fields
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))
from biface_tire.radial import RadialTire


def write(tire, directory, name="radial_tire", tread=True):
    """Writes the two files of a tire; without its tread if that is to be bristles."""
    tire.write_profile(directory / f"{name}_profile.csv", [
        "The outer side of the carcass of prm/radial_tire.prm when inflated, from",
        "the left flange over the crown to the right one, by",
        "doc/measured_tires/radial_tire.py. Unit: mm."])
    with open(directory / f"{name}_plies.csv", "w", encoding="utf-8") as file:
        file.write(
            "# The plies of prm/radial_tire.prm from the inside, by\n"
            "# doc/measured_tires/radial_tire.py. Angles from the circumference. Units:\n"
            "# mm, degrees.\n"
            "material, thickness, angle, from, to\n")
        for line in tire.plies(tread):
            file.write(", ".join(map(str, line)) + "\n")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--output", type=Path, required=True,
                        help="where to write the two files")
    sizes = [field for field in fields(RadialTire) if field.type in (float, "float")]
    for field in sizes:
        parser.add_argument("--" + field.name.replace("_", "-"), type=float,
                            default=field.default, help=f"by default {field.default:g}")
    arguments = parser.parse_args()
    tire = RadialTire(**{field.name: getattr(arguments, field.name) for field in sizes})
    write(tire, arguments.output)
    for entry, value in tire.settings().items():
        print(f"{entry} = {value}")
