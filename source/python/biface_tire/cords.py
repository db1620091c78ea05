# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cords of tires. Lengths in mm, forces in N, moduli in MPa, densities in t/mm^3."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Cord:
    """A cord and the ply that it makes.

    modulus      Young's modulus over the area of a circle of the diameter
    diameter     of a cord
    pitch        distance of the cords: of bias plies at the crown, of the carcass of a
                 radial tire on the drum, which has the radius of its rim, of belts as laid
    ply          thickness of the ply, where the cords have this distance
    strength     force at break
    density      of the ply
    compression  stiffness of the ply along the cords in compression, over that in tension
    source       of the numbers
    """

    name: str
    modulus: float
    diameter: float
    pitch: float
    ply: float
    strength: float
    density: float
    compression: float
    source: str


# the ply of all tires of doc/real_tires.md
NYLON_840 = Cord("nylon 840/2", 2400, 0.6, 1, 1.1, 125, 1.15e-9, 0.01,
                 "doc/real_tires.md; density estimate")
# casing of 60 threads per inch; strength by 0.75 N/tex
NYLON_CASING = Cord("nylon casing, 60 TPI", 2400, 0.2, 25.4 / 60, 0.3, 16, 1.15e-9, 0.01,
                    "estimate")
# prm/radial_tire.prm; strengths by 0.62 N/tex, 0.75 N/tex and 2850 MPa of the wires
POLYESTER = Cord("polyester 1440/2", 4411, 0.61, 100 / 105, 1.1, 195, 1.21e-9, 0.01,
                 "DITPolyester; strength estimate")
NYLON_CAP = Cord("nylon 940/2", 1953, 0.55, 1.25, 0.8, 140, 1.15e-9, 0.01,
                 "FTCNylon; strength estimate")
STEEL_BELT = Cord("steel 2+2x0.25", 190000, 0.5, 1.25, 1.2, 560, 2.03e-9, 1,
                  "radial_tire.prm; strength estimate")
# trucks: 12 and 15 wires, agricultural tires: textile belts
STEEL_CARCASS = Cord("steel 3+9x0.22", 190000, 0.76, 1.8, 2.0, 1250, 2.1e-9, 0.1,
                     "estimate")
STEEL_TRUCK_BELT = Cord("steel 3+9+15x0.22", 190000, 1.14, 2.0, 2.0, 2700, 2.4e-9, 1,
                        "estimate")
TEXTILE_BELT = Cord("polyester 1440/2 belt", 4411, 0.61, 100 / 105, 1.1, 195, 1.21e-9, 1,
                    "estimate")
