# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radial tires from outer dimensions, rim and rules, with the shape of the carcass in
equilibrium with the pressure between the rim and the belts.

Nothing is fitted to a stiffness or a load; doc/measured_tires.md has the sources of the
rules for passenger tires, and compares the 205/60 R15 of the defaults with published
values. Lengths in mm, angles in degrees from the circumference."""

import warnings
from dataclasses import dataclass

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, fsolve

POINTS = 81  # of the profile, on each side of the crown
# where a smooth sidewall may leave the arc, and where it does otherwise, over half the
# width of the tread
SMOOTH, KINKS = (0.7, 1.05), (0.92, 1, 0.84)


@dataclass
class RadialTire:
    """A tire by the rules, when inflated. Lengths in mm, angles in degrees from the
    circumference, cords per dm. Raises ValueError if no carcass fits."""

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
    carcass_plies: int = 1
    turn_up: float = 50            # over the radius of the rim
    apex: float = 30               # likewise
    apex_base: float = 8
    belt: float = 1.2
    belt_angle: float = 24
    belts: tuple = (0.95, 0.89)    # widths over that of the tread, the widest first
    cap: float = 0.8               # 0 for none
    bead: float = 5                # from the carcass to the flange

    def __post_init__(self):
        self.measured = None
        self.tread_height = self.groove + self.under_groove
        self.crown = (self.radius - self.tread_height - self.cap
                      - len(self.belts) * self.belt)
        self.tread_edge = self.tread_width * self.width / 2
        # concentric with the outer surface of the tread
        outer_arc = ((self.tread_edge**2 + self.tread_drop**2)
                     / (2 * self.tread_drop))
        self.arc = outer_arc - (self.radius - self.crown)
        self.end = self.rim_radius + self.flange
        self.end_half_width = self.rim_width / 2 - self.bead
        self.half_width = (self.width / 2 - self.sidewall - self.carcass_plies
                           * self.carcass_at((self.radius + self.rim_radius) / 2))
        self.fit()

    def fit(self):
        """Finds the widest radius, and where the sidewall leaves the arc of the crown as
        its tangent. Where that is far from the edge of the tread, as in tires with high
        sidewalls, the sidewall leaves the arc at one of KINKS at an angle that the belts
        hold."""
        if not 0 < self.end_half_width < self.half_width or self.crown <= self.end:
            raise ValueError("no room for the carcass")
        middle = (self.radius + self.rim_radius) / 2
        self.projection = None
        if self.solve(self.misfit, (self.tread_edge * 0.9, middle)):
            self.shoulder, self.widest = self.solution
            if (SMOOTH[0] < self.shoulder / self.tread_edge < SMOOTH[1]
                    and self.is_section()):
                return
        def misfit(unknowns):
            self.projection = unknowns[0]
            return self.misfit((self.shoulder, unknowns[1]))

        for place in KINKS:
            self.shoulder = place * self.tread_edge
            start = self.first_guess()
            if start is not None and self.solve(misfit, start):
                self.projection, self.widest = map(float, self.solution)
                if 0 < self.projection < 1 and self.is_section():
                    return
        raise ValueError("no meridian leads from the belts to the flange")

    def first_guess(self):
        """Axial projection of the sidewall's direction at the belts and widest radius,
        nearly, of a sidewall from a given place on the arc; None if there is none."""
        start = self.junction(self.shoulder)[1]
        nodes, weights = np.polynomial.legendre.leggauss(24)

        def width(widest, scale, angle):
            """From a place to the widest one, without its sign."""
            t = angle * (nodes + 1) / 2
            return abs(angle / 2 * np.sum(weights * scale * np.sin(t) / (
                2 * np.sqrt(widest**2 + scale * np.sin(t)))))

        def half_width(projection, widest):
            """Of the sidewall at its widest place, less the given one."""
            scale = (start**2 - widest**2) / projection
            return (self.shoulder + width(widest, scale, np.arcsin(projection))
                    - self.half_width)

        def end_half_width(widest):
            """Of the sidewall at the flange, less the given one, and the projection."""
            if half_width(1e-3, widest) > 0 or half_width(1, widest) < 0:
                return np.nan, np.nan
            projection = brentq(half_width, 1e-3, 1, (widest,))
            scale = (start**2 - widest**2) / projection
            last = (self.end**2 - widest**2) / scale
            if last < -0.985:
                return np.nan, np.nan
            return (self.half_width - width(widest, scale, np.arcsin(last))
                    - self.end_half_width), projection

        before = np.nan
        for widest in np.linspace(self.end, start, 42)[-2:0:-1]:
            excess, projection = end_half_width(widest)
            if before * excess <= 0:
                return projection, widest
            before = excess
        return None

    def solve(self, misfit, start):
        """Whether the two equations have a solution near a start; it is the solution."""
        with np.errstate(invalid="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.solution, _, code, _ = fsolve(misfit, start, full_output=True)
        return code == 1

    def is_section(self):
        """Whether the sidewall reaches the flange before it turns parallel to the axis."""
        if not self.end < self.widest < self.junction(self.shoulder)[1]:
            return False
        self.misfit((self.shoulder, self.widest))
        return abs((self.end**2 - self.widest**2) / self.scale) < 0.99

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
        scale = (start**2 - widest**2) / (self.projection or np.cos(slope))

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
        if self.measured is not None:
            steps = np.linalg.norm(np.diff(self.measured, axis=0), axis=1)
            return self.measured, np.concatenate([[0], np.cumsum(steps)])
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
        edges = [f"{half:.2f}" for half in
                 dict.fromkeys(sorted(self.half_belts(), reverse=True))]
        left = [f"end/2-{edge}" for edge in edges]
        right = [f"end/2+{edge}" for edge in reversed(edges)]
        steps = [1] * (len(edges) - 1)
        places = ["0", turn_up, *left, *right, f"end-{turn_up}", "end"]
        cells = [8, 12, *steps, 20, *steps, 12, 8]
        return ", ".join(f"{start}:{stop}:{count}" for start, stop, count in
                         zip(places, places[1:], cells))

    def plies(self, tread=True):
        """Lines of the file of plies: material, thickness, angle, from, to.

        tread: whether it is a ply; else it is left to `Contact/Tread`."""
        apex, turn_up = self.lengths()
        carcass = f"{self.carcass_at(self.crown):.4f}"
        halves = self.half_belts()
        lines = [("liner", f"{self.liner:g}", 0),
                 *[("carcass", carcass, 90)] * self.carcass_plies]
        for start, stop, place in (
                ("0", "{:.2f}", "alpha_1"), ("end - {:.2f}", "end", "(end - alpha_1)")):
            part = (start.format(turn_up), stop.format(turn_up))
            lines.append(("apex", f"0.3 + {self.apex_base - 0.3:g}"
                          f"*max(0, 1 - {place}/{apex:.2f})", 0, *part))
            lines += [("carcass", carcass, 90, *part)] * self.carcass_plies
        for i, half in enumerate(halves):
            lines.append(("belt", f"{self.belt:g}",
                          f"{'-' if i % 2 else ''}{self.belt_angle:g}",
                          f"end/2 - {half:.2f}", f"end/2 + {half:.2f}"))
        if self.cap:
            lines.append(("cap", f"{self.cap:g}", 0, f"end/2 - {halves[0]:.2f}",
                          f"end/2 + {halves[0]:.2f}"))
        on_tread = (f"max(0, min(1, ({self.tread_edge + self.taper:.2f} - "
                    f"abs(alpha_1 - end/2))/{self.taper:g}))")
        lines.append(("sidewall", f"{self.sidewall:g} - "
                      f"{self.sidewall - 0.3:g}*{on_tread}", 0))
        if tread:
            lines.append(("tread", f"0.2 + {self.tread_height - 0.5:g}*"
                          + on_tread, 0))
        return lines

    def settings(self):
        """The entries of prm/radial_tire.prm that depend on the size, beside the files."""
        pitch = 100 / self.carcass_density * self.crown / self.rim_radius
        return {"Mesh/Intervals alpha_1": self.mesh(),
                "Material carcass/Cord pitch": f"{pitch:.4f}"}

    def write_profile(self, path, comment):
        """Writes the points of the profile as CSV, below lines of comment."""
        write_profile(path, self.profile()[0], comment)

    def use_profile(self, points):
        """Replaces the profile, as by a measured one: belts, turn-ups and mass follow."""
        self.measured = points

    @property
    def kink(self):
        """By how many degrees the sidewall turns away from the arc; 0 if it is smooth."""
        if self.projection is None:
            return 0.0
        slope = self.junction(self.shoulder)[0]
        return float(np.degrees(np.arccos(self.projection) - slope))

    @property
    def inner_plies(self):
        """Number of lines of plies inside the sidewall."""
        return (1 + self.carcass_plies + 2 * (1 + self.carcass_plies) + len(self.belts)
                + (self.cap > 0))

    def cord_tension(self, pressure):
        """Force in N of a cord of the carcass between rim and belts under a pressure in
        MPa, of all plies together. It is the same all along the cord."""
        self.misfit((self.shoulder, self.widest))
        # N_m = p scale/(2 r), and the distance of the cords is proportional to r
        return (pressure * abs(self.scale) / 2 * 100
                / (self.carcass_density * self.rim_radius * self.carcass_plies))

    def mass(self, carcass, belt, cap, rubber, tread):
        """In t, from rim flange to rim flange, without beads; densities in t/mm^3."""
        points, lengths = self.profile()
        steps = np.diff(lengths)
        radius = (points[1:, 0] + points[:-1, 0]) / 2
        at = np.abs((lengths[1:] + lengths[:-1]) / 2 - lengths[-1] / 2)
        from_end = lengths[-1] / 2 - at
        apex, turn_up = self.lengths()
        is_turned = from_end < turn_up
        # cords and rubber of a ply keep their volume
        plies = carcass * self.carcass_plies * self.carcass_at(radius) * (1 + is_turned)
        filler = is_turned * rubber * (0.3 + (self.apex_base - 0.3)
                                       * np.maximum(0, 1 - from_end / apex))
        belts = sum(belt * self.belt * (at < half) for half in self.half_belts())
        cover = cap * self.cap * (at < max(self.half_belts()))
        on_tread = np.clip((self.tread_edge + self.taper - at) / self.taper, 0, 1)
        outside = (rubber * (self.liner + self.sidewall - (self.sidewall - 0.3) * on_tread)
                   + tread * (0.2 + (self.tread_height - 0.5) * on_tread))
        return float(np.sum(2 * np.pi * radius * steps
                            * (plies + filler + belts + cover + outside)))


def write_profile(path, points, comment):
    """Writes points (radius, axial coordinate) as CSV, below lines of comment."""
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"# {line}\n" for line in comment)
        file.write("radius, axial coordinate\n")
        for radius, axial in points:
            file.write(f"{radius:.4f}, {axial:.4f}\n")
