#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design a radial passenger tire from its size, and write its meridian and plies.

All that is known of the tire is the size: outer radius and section width when
inflated, radius and width of the rim. Rules give the rest: the dimensions below,
and the shape of the carcass, which is in equilibrium with the pressure between
the rim and the belts. Nothing is fitted to a stiffness or a load.

    python3 doc/measured_tires/radial_tire.py --output prm

writes radial_tire_profile.csv, the points of the outer side of the carcass, and
radial_tire_plies.csv for prm/radial_tire.prm, which is a 205/60 R15, and prints the entries
that depend on the size, too. Options give other sizes.
"""

import argparse
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from scipy.integrate import quad
from scipy.optimize import fsolve

POINTS = 81  # of the profile, on each side of the crown


@dataclass
class RadialTire:
    """A tire by the rules. Lengths in mm, angles in degrees from the
    circumference, cords per dm."""

    # the size: 205/60 R15 on a rim 6J x 15, under 0.22 MPa
    radius: float = 313.5
    width: float = 209
    rim_radius: float = 190.5
    rim_width: float = 152

    flange: float = 17.5           # height of the contour J
    tread_width: float = 0.75      # over the section width
    tread_drop: float = 8.5        # of the outer surface, at the edge of the tread
    taper: float = 20              # of the tread, beyond its edge
    groove: float = 7.5
    under_groove: float = 2.0
    sidewall: float = 2.5
    liner: float = 1.0
    carcass: float = 1.1           # a ply on the drum, which has the rim's radius
    carcass_density: float = 105   # cords on the drum
    turn_up: float = 50            # over the radius of the rim
    apex: float = 30               # likewise
    apex_base: float = 8
    belt: float = 1.2
    belt_angle: float = 24
    belts: tuple = (0.95, 0.89)    # widths over that of the tread
    cap: float = 0.8
    bead: float = 5                # from the carcass to the flange

    def __post_init__(self):
        self.tread_height = self.groove + self.under_groove
        self.crown = (self.radius - self.tread_height - self.cap
                      - 2 * self.belt)
        self.tread_edge = self.tread_width * self.width / 2
        # concentric with the outer surface of the tread
        outer_arc = ((self.tread_edge**2 + self.tread_drop**2)
                     / (2 * self.tread_drop))
        self.arc = outer_arc - (self.radius - self.crown)
        self.end = self.rim_radius + self.flange
        self.end_half_width = self.rim_width / 2 - self.bead
        self.half_width = self.width / 2 - self.sidewall - self.carcass_at(
            (self.radius + self.rim_radius) / 2)
        self.shoulder, self.widest = fsolve(
            self.misfit, (self.tread_edge * 0.9,
                          (self.radius + self.rim_radius) / 2))

    def carcass_at(self, radius):
        """Thickness of the ply: cords and rubber keep their volume."""
        return self.carcass * self.rim_radius / radius

    def junction(self, shoulder):
        """Slope and radius of the crown's arc at a distance from the middle."""
        slope = np.arcsin(shoulder / self.arc)
        return slope, self.crown - self.arc * (1 - np.cos(slope))

    def misfit(self, unknowns):
        """By how much the sidewall misses the widest point and the rim. Between
        belts and rim, cords along the meridian carry the pressure: the
        projection of their direction on the axis is a quadratic function of the
        radius."""
        shoulder, widest = unknowns
        slope, start = self.junction(shoulder)
        scale = (start**2 - widest**2) / np.cos(slope)

        def height(t):
            """dy along t, by which the radius is regular where the curve is
            parallel to the axis: r^2 = widest^2 + scale sin t."""
            return scale * np.sin(t) / (2 * np.sqrt(widest**2
                                                    + scale * np.sin(t)))

        first = np.arcsin((start**2 - widest**2) / scale)
        last = np.arcsin(np.clip((self.end**2 - widest**2) / scale, -1, 1))
        self.height, self.range, self.scale = height, (first, last), scale
        widest_y = shoulder + quad(height, 0, first)[0]
        end_y = widest_y - abs(quad(height, last, 0)[0])
        return widest_y - self.half_width, end_y - self.end_half_width

    def profile(self):
        """Points from the left end over the crown to the right one: radius and
        axial coordinate, and the length along the polygon."""
        self.misfit((self.shoulder, self.widest))
        slope = self.junction(self.shoulder)[0]
        angles = np.linspace(0, slope, POINTS // 3)[:-1]
        arc = np.column_stack([self.crown - self.arc * (1 - np.cos(angles)),
                               self.arc * np.sin(angles)])
        first, last = self.range
        side = []
        for t in np.linspace(first, last, POINTS - len(arc)):
            side.append([np.sqrt(self.widest**2 + self.scale * np.sin(t)),
                         self.shoulder + quad(self.height, t, first)[0]])
        right = np.vstack([arc, side])
        left = right[:0:-1] * (1, -1)
        points = np.vstack([left, right])
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        return points, np.concatenate([[0], np.cumsum(steps)])

    def place_of(self, radius):
        """The length from the right end at which the sidewall has a radius."""
        points, lengths = self.profile()
        side = slice(len(points) * 3 // 4, None)
        at = np.interp(-radius, -points[side, 0], lengths[side])
        return lengths[-1] - at

    def half_belts(self):
        return [self.tread_edge * part for part in self.belts]

    def lengths(self):
        """From the flange to the ends of the apex and of the turn-up."""
        return [self.place_of(self.rim_radius + height)
                for height in (self.apex, self.turn_up)]

    def mesh(self):
        """The entry `Mesh/Intervals alpha_1`: plies end at mesh lines."""
        turn_up = f"{self.lengths()[1]:.2f}"
        first, second = (f"{half:.2f}" for half in self.half_belts())
        return (f"0:{turn_up}:8, {turn_up}:end/2-{first}:12, "
                f"end/2-{first}:end/2-{second}:1, end/2-{second}:end/2+{second}:20, "
                f"end/2+{second}:end/2+{first}:1, end/2+{first}:end-{turn_up}:12, "
                f"end-{turn_up}:end:8")

    def plies(self, tread=True):
        """Lines of the file of plies: material, thickness, angle, from, to.

        tread: whether it is a ply; else it is left to `Contact/Tread`."""
        apex, turn_up = self.lengths()
        carcass = f"{self.carcass_at(self.crown):.4f}"
        first, second = self.half_belts()
        lines = [("liner", f"{self.liner:g}", 0), ("carcass", carcass, 90)]
        for start, stop, place in (
                ("0", "{:.2f}", "alpha_1"), ("end - {:.2f}", "end", "(end - alpha_1)")):
            lines.append(("apex", f"0.3 + {self.apex_base - 0.3:g}"
                          f"*max(0, 1 - {place}/{apex:.2f})", 0,
                          start.format(turn_up), stop.format(turn_up)))
            lines.append(("carcass", carcass, 90,
                          start.format(turn_up), stop.format(turn_up)))
        for half, sign in ((first, ""), (second, "-")):
            lines.append(("belt", f"{self.belt:g}", f"{sign}{self.belt_angle:g}",
                          f"end/2 - {half:.2f}", f"end/2 + {half:.2f}"))
        lines.append(("cap", f"{self.cap:g}", 0, f"end/2 - {first:.2f}",
                      f"end/2 + {first:.2f}"))
        on_tread = (f"max(0, min(1, ({self.tread_edge + self.taper:.2f} - "
                    f"abs(alpha_1 - end/2))/{self.taper:g}))")
        lines.append(("sidewall", f"{self.sidewall:g} - "
                      f"{self.sidewall - 0.3:g}*{on_tread}", 0))
        if tread:
            lines.append(("tread", f"0.2 + {self.tread_height - 0.5:g}*"
                          + on_tread, 0))
        return lines

    def write(self, directory, name="radial_tire", tread=True):
        points, _ = self.profile()
        with open(directory / f"{name}_profile.csv", "w", encoding="utf-8") as file:
            file.write(
                "# The outer side of the carcass of prm/radial_tire.prm when inflated, from\n"
                "# the left flange over the crown to the right one, by\n"
                "# doc/measured_tires/radial_tire.py. Unit: mm.\n"
                "radius, axial coordinate\n")
            for radius, axial in points:
                file.write(f"{radius:.4f}, {axial:.4f}\n")
        with open(directory / f"{name}_plies.csv", "w", encoding="utf-8") as file:
            file.write(
                "# The plies of prm/radial_tire.prm from the inside, by\n"
                "# doc/measured_tires/radial_tire.py. Angles from the circumference. Units:\n"
                "# mm, degrees.\n"
                "material, thickness, angle, from, to\n")
            for line in self.plies(tread):
                file.write(", ".join(map(str, line)) + "\n")

    def settings(self):
        """The entries of prm/radial_tire.prm that depend on the size, beside the files."""
        pitch = 100 / self.carcass_density * self.crown / self.rim_radius
        return {"Mesh/Intervals alpha_1": self.mesh(),
                "Material carcass/Cord pitch": f"{pitch:.4f}"}


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
    tire.write(arguments.output)
    for entry, value in tire.settings().items():
        print(f"{entry} = {value}")
