# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bias tires from outer dimensions, rim and pressure, by rules. Lengths in mm, pressures
in MPa, angles in degrees from the circumference.

The rules are those of doc/real_tires.md, where 28 aircraft tires are compared with their
rated loads. They are estimates but for the shape of the meridian and the force of the
cords, which follow from the netting theory (@cite Purdy1963, doc/theory.md, section 1)."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from .cords import NYLON_840, NYLON_CASING, Cord

BURST = 4  # pressure at which the cords may break, over the rated one


def change_of_sign(function, low, high):
    """The place where an increasing function changes its sign, or the end next to it; NaN
    counts as positive."""
    def without_nan(x):
        value = function(x)
        return high - low if math.isnan(value) else value

    if without_nan(high) < 0:
        return high
    if without_nan(low) >= 0:
        return low
    return brentq(without_nan, low, high, xtol=1e-15 * (high - low))


class Netting:
    """The meridian 'cord equilibrium' of doc/theory.md: inextensible crossed cords that
    carry the pressure.

    crown       largest radius
    half_width  largest distance from the plane of symmetry
    degrees     cord angle at the crown
    widest      radius at which the section is widest
    """

    def __init__(self, crown, half_width, end, end_half_width):
        """The curve that reaches end_half_width at the radius end, by its cord angle.
        Raises ValueError if no angle between 25 and 90 degrees does."""
        self.crown, self.half_width = crown, half_width

        def excess(degrees):
            self.set_angle(degrees)
            width = self.width_at(end)
            return -crown if math.isnan(width) else width - end_half_width

        # the end moves outward with the angle
        low, high = 25, 90
        if excess(high) < 0:
            raise ValueError("no cord angle reaches the flange")
        self.set_angle(change_of_sign(excess, low, high))
        if abs(excess(self.degrees)) > 1e-3 * half_width:
            raise ValueError("no cord angle reaches the flange")

    @classmethod
    def with_angle(cls, crown, half_width, degrees):
        """The curve with a given cord angle."""
        curve = cls.__new__(cls)
        curve.crown, curve.half_width = crown, half_width
        curve.set_angle(degrees)
        return curve

    def set_angle(self, degrees):
        """Changes the cord angle, and with it the widest radius."""
        self.degrees = degrees
        self.cosine = math.cos(math.radians(degrees))
        self.sine = math.sin(math.radians(degrees))
        least = self.crown * math.sqrt(max(0, 3 - 2 / self.cosine**2))

        def excess(widest):
            self.widest = widest
            return self.half_width - self.width_at(widest)

        self.widest = change_of_sign(excess, least + 1e-6 * self.crown,
                                     self.crown * (1 - 1e-6))

    def width_at(self, radius, points=200):
        """The integral of tan(phi) over the radius, by the midpoint rule; with
        r_c - r = depth t^2 it is regular at the crown."""
        depth = self.crown - radius
        t = (np.arange(points) + 0.5) / points
        lack = self.lack(depth * t * t * (2 * self.crown - depth * t * t))
        if not ((0 < lack) & (lack < 2)).all():
            return math.nan
        return float(np.sum((1 - lack) / np.sqrt(lack * (2 - lack)) * t)
                     * 2 * depth / points)

    def lack(self, drop):
        """1 - sin(phi), where r_c^2 - r^2 is the drop: 0 at the crown, 1 at the widest
        place, 2 where the meridian would be parallel to the axis again."""
        a = drop / (self.crown**2 - self.widest**2)
        q = drop * (self.cosine / (self.crown * self.sine))**2
        b = q / (1 + np.sqrt(1 + q))
        return a - b + a * b

    def points(self, end, count=60):
        """Points (radius, axial coordinate) from the crown to the radius end, denser at
        the crown."""
        radii = [self.crown - (self.crown - end) * (i / count)**2
                 for i in range(count + 1)]
        return [(radius, self.width_at(radius) if i else 0.0)
                for i, radius in enumerate(radii)]

    def angle_at(self, radius):
        """The cord angle at a radius: the cosine is proportional to it."""
        return math.degrees(math.acos(min(1, radius * self.cosine / self.crown)))

    def cord_force(self, pressure, pitch, plies):
        """The force of a cord at the crown, N."""
        return (pressure * pitch * (self.crown**2 - self.widest**2)
                / (2 * plies * self.crown * self.sine**2))


@dataclass(frozen=True)
class BiasRules:
    """What the rules add to the outer dimensions. Thicknesses in mm, moduli in MPa."""

    cord: Cord = NYLON_840
    liner: float = 1.5
    sidewall: float = 2.5
    rubber: float = 6            # Young's modulus of all rubber
    clearance: float = 2         # from the carcass to half the rim width
    tread_base: float = 4        # tread: this ...
    tread_slope: float = 0.022   # ... and this part of the section width
    source: str = "doc/real_tires.md"

    def tread(self, width):
        """Thickness of the tread, with the sidewall below, at a section width."""
        return self.tread_base + self.tread_slope * width


AIRCRAFT = BiasRules()
BICYCLE = BiasRules(cord=NYLON_CASING, liner=0.1, sidewall=0.3, rubber=4, clearance=0,
                    tread_base=1.5, tread_slope=0.02, source="estimate")

CASING_ANGLE = 45  # degrees, of bicycles; estimate


class BiasTire:
    """A bias tire by the rules, when inflated.

    diameter, width       outer dimensions
    end                   radius at which the sidewall leaves the flange
    rim_width             between the flanges
    pressure              the rated one
    tread                 thickness of tread and sidewall at the crown
    plies                 number of plies, the smallest even one whose cords hold BURST
                          times the pressure, or as given
    crown, half_width, end_half_width
                          of the middle of the carcass
    curve                 its Netting
    """

    def __init__(self, diameter, width, end, rim_width, pressure, plies=None,
                 rules=AIRCRAFT, angle=None):
        """Raises ValueError if no meridian of crossed cords fits. With an angle in
        degrees the sidewall leaves the flange where it follows from the width of the rim,
        and `end` changes."""
        self.diameter, self.width = diameter, width
        self.rim_width, self.pressure, self.rules = rim_width, pressure, rules
        self.end = end
        self.tread = rules.tread(width)
        cord = rules.cord
        self.plies = plies or 2
        while True:
            carcass = self.plies * cord.ply
            self.crown = self.diameter / 2 - self.tread - carcass / 2
            self.half_width = self.width / 2 - rules.sidewall - carcass / 2
            self.end_half_width = self.rim_width / 2 - rules.clearance - carcass / 2
            if not 0 < self.end_half_width < self.half_width or self.crown <= end:
                raise ValueError("no room for the carcass")
            if angle is None:
                self.curve = Netting(self.crown, self.half_width, self.end,
                                     self.end_half_width)
            else:
                self.curve = Netting.with_angle(self.crown, self.half_width, angle)
                self.end = self.end_of(self.curve)
            force = BURST * self.curve.cord_force(self.pressure, cord.pitch, self.plies)
            if plies or force <= cord.strength:
                break
            self.plies += 2

    def end_of(self, curve):
        """The radius below the widest place at which a curve has the half width of the
        end."""
        low = curve.widest - 2 * (curve.crown - curve.widest)

        def excess(radius):
            width = curve.width_at(radius)
            return -1 if math.isnan(width) else width - self.end_half_width

        if excess(curve.widest) < 0:
            raise ValueError("the rim is wider than the carcass")
        return change_of_sign(excess, low, curve.widest)

    @property
    def cord_tension(self):
        """Force of a cord at the crown under the rated pressure, N."""
        return self.curve.cord_force(self.pressure, self.rules.cord.pitch, self.plies)

    @property
    def burst_factor(self):
        """The pressure at which the cords break, over the rated one."""
        return self.rules.cord.strength / self.cord_tension

    def layup(self, tread=None):
        """The entry 'Laminate/Plies': liner, carcass, turn-ups of half its
        plies, sidewall and tread.

        tread: its thickness over that of the sidewall, by the rules if not
        given."""
        if tread is None:
            tread = self.tread - self.rules.sidewall
        cord = f"cord: {self.rules.cord.ply:g} @ "
        turn_up = [f"{self.plies // 4} x ({cord}+-lift(beta_c) RANGE)"]
        if self.plies % 4:
            turn_up.append(f"{cord}lift(beta_c) RANGE")
        if self.plies < 4:
            turn_up = turn_up[1:]
        return ", ".join(
            [f"rubber: {self.rules.liner:g} @ 0",
             f"{self.plies // 2} x ({cord}+-lift(beta_c))"]
            + [ply.replace("RANGE", part) for part in
               ("from -end to -0.7*end", "from 0.7*end to end")
               for ply in turn_up]
            + [f"rubber: {self.rules.sidewall:g} + {tread:.6g}"
               "*min(1, max(0, 3 - 5*abs(alpha_1)/end)) @ 0"])

    @property
    def turn_ups(self):
        """Number of plies of each turn-up."""
        return 2 * (self.plies // 4) + (self.plies % 4 > 0)

    @property
    def inner_plies(self):
        """Number of lines of plies inside the sidewall."""
        return 1 + self.plies + 2 * self.turn_ups

    def layers(self):
        """The entry 'Laminate/Layers': the tread and the sidewall, which shear in
        series with all other plies."""
        return f"{self.inner_plies}, 1"

    def mass(self, density):
        """In t, from rim flange to rim flange, without beads; density of the rubber in
        t/mm^3."""
        rules, curve = self.rules, self.curve
        points = curve.points(self.end)
        lengths = [0.0]
        for (r_0, y_0), (r_1, y_1) in zip(points, points[1:]):
            lengths.append(lengths[-1] + math.hypot(r_1 - r_0, y_1 - y_0))
        total = 0
        for i in range(len(points) - 1):
            radius = (points[i][0] + points[i + 1][0]) / 2
            at = (lengths[i] + lengths[i + 1]) / 2 / lengths[-1]
            # rubber and cords of a ply keep their volume
            closer = (curve.crown * curve.sine
                      / (radius * math.sin(math.radians(curve.angle_at(radius)))))
            cords = (self.plies + (self.turn_ups if at > 0.7 else 0)) * rules.cord.ply
            rubber = rules.liner + rules.sidewall + (self.tread - rules.sidewall) * min(
                1, max(0, 3 - 5 * at))
            total += (4 * math.pi * radius * (lengths[i + 1] - lengths[i])
                      * (cords * closer * rules.cord.density + rubber * density))
        return total
