# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tire from its size: dimensions on its rim, pressure, load, plies and mass, each with
the rule or the source it is from."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from biface.errors import BifaceError
from . import nasa
from .bias import AIRCRAFT, BICYCLE, BURST, CASING_ANGLE, BiasTire
from .contour import read_contour
from .cords import (NYLON_CAP, POLYESTER, STEEL_BELT, STEEL_CARCASS, STEEL_TRUCK_BELT,
                    TEXTILE_BELT, Cord)
from .radial import RadialTire, write_profile
from .rim import INCH, flange_of, parse_rim
from .service import STANDARD_GRAVITY
from .size import parse_size

RUBBER_DENSITY = 1.15e-9  # t/mm^3
FRICTION = 0.8
LARGEST_KINK = 35         # degrees, up to which runs have converged
LARGEST_PRESSURE = 1      # MPa, of kinds that never have more
RADIAL_BURST = 8          # of one ply of a radial carcass, over the pressure; estimate

# reference pressures in MPa of standard and reinforced passenger tires @cite ISO4000
PASSENGER_PRESSURES = (0.25, 0.29)
# of light truck tires by ply rating, 50, 65 and 80 psi
LIGHT_TRUCK_PRESSURES = {6: 0.35, 8: 0.45, 10: 0.55}
# deflections under the rated load over the section height, by which a load is estimated
# that neither size nor user gives
DEFLECTION, PASSENGER_DEFLECTION = 0.15, 0.22
# of the databook's tires over the height above the flange
AIRCRAFT_DEFLECTION = 0.32

# of the rim width over the section width: standards have about 0.5 to 0.95
RIM_RANGE = 0.45, 0.97

# section heights in mm of the tires whose fillers and turn-ups are scaled
PASSENGER_HEIGHT, TRUCK_HEIGHT = 123, 240


@dataclass(frozen=True)
class RadialRules:
    """What the rules of a kind of radial tires add to the outer dimensions.

    carcass, belt, cap   cords
    height               section height for which filler and turn_up are
    filler, turn_up      heights over the flange, mm
    drop                 of the tread at its edge, over the section width
    land                 part of the tread that is rubber
    more                 further arguments of RadialTire
    """

    carcass: Cord
    belt: Cord
    cap: Cord
    height: float
    filler: float
    turn_up: float
    drop: float
    land: float
    more: dict = field(default_factory=dict)
    source: str = "estimate"


RADIAL = {
    "passenger": RadialRules(POLYESTER, STEEL_BELT, NYLON_CAP, PASSENGER_HEIGHT, 12.5, 32.5,
                             8.5 / 209, 0.67, source="doc/measured_tires.md"),
    "light truck": RadialRules(
        POLYESTER, STEEL_BELT, NYLON_CAP, PASSENGER_HEIGHT, 15, 35, 8 / 209, 0.65,
        {"groove": 9.5, "under_groove": 2.5, "sidewall": 3.5}),
    "truck": RadialRules(
        STEEL_CARCASS, STEEL_TRUCK_BELT, NYLON_CAP, TRUCK_HEIGHT, 45, 75, 8 / 279, 0.75,
        {"groove": 14, "under_groove": 4, "sidewall": 5, "liner": 2.5, "apex_base": 18,
         "belt_angle": 18, "belts": (0.9, 0.8, 0.65), "cap": 0, "bead": 8, "taper": 25,
         "tread_width": 0.78}),
    "agricultural": RadialRules(
        POLYESTER, TEXTILE_BELT, NYLON_CAP, TRUCK_HEIGHT, 25, 60, 0.08, 0.3,
        {"groove": 35, "under_groove": 8, "sidewall": 6, "liner": 2, "apex_base": 14,
         "belt_angle": 20, "belts": (0.95, 0.9, 0.85, 0.8), "cap": 0, "bead": 8,
         "taper": 30, "tread_width": 0.85}),
}


@dataclass(frozen=True)
class Options:
    """What a user may add to a size. None stands for a rule.

    rim                  name of the rim, such as 2.50C
    pressure, load       MPa, N
    plies                number of plies of the carcass
    diameter, width      measured outer dimensions on this rim, mm
    contour              CSV file of the carcass's outer side, see contour.py
    kind                 of the rules, see size.KINDS
    speed                km/h, at which the tire rolls
    """

    rim: str | None = None
    pressure: float | None = None
    load: float | None = None
    plies: int | None = None
    diameter: float | None = None
    width: float | None = None
    contour: Path | None = None
    kind: str | None = None
    speed: float | None = None


@dataclass(frozen=True)
class Fact:
    """A line of the summary: a quantity, its value in words, and where it is from."""

    name: str
    value: str
    source: str


class Design:
    """A tire on its rim.

    size, options        what was given
    rim_width, rim_diameter, flange
                         mm; the flange over the seat of the bead
    diameter, width      outer dimensions when inflated, mm
    pressure, load       MPa, N
    deflection           under this load by NASA's formula, mm: what the mesh is made for
    speed                km/h
    tire                 a BiasTire or RadialTire
    rules                its BiasRules or RadialRules
    facts, warnings      lines of the summary, and sentences
    """

    def __init__(self, text, options=Options()):
        """Raises BifaceError with one sentence if there is no such tire."""
        self.options = options
        self.size = parse_size(text, options.kind)
        if self.is_radial and self.size.kind == "motorcycle":
            raise BifaceError(f"{self.size.text} is a radial tire of a motorcycle: its "
                              "round tread has no rules here, but its size with '-' in "
                              "place of R is a bias tire.")
        rim = self.prepare()
        if rim is not None:
            self.prepare(rim)
        self.fit_contour()
        self.add_results()

    def prepare(self, rim_width=None):
        """Does all but the summary. rim_width replaces that of the rule; returned is the
        one nearest to it if that of the rule is not possible, else None."""
        self.facts, self.warnings = [], []
        self.find_rim(rim_width)
        self.find_section()
        self.find_pressure()
        self.find_load()
        return self.build()

    @property
    def is_radial(self):
        """Whether the carcass is radial."""
        return self.size.is_radial

    @property
    def is_bicycle(self):
        """Whether the rules of bicycles hold."""
        return self.size.kind == "bicycle"

    def add(self, name, value, source):
        """Adds a fact."""
        self.facts.append(Fact(name, value, source))

    # ------------------------------------------------------------- what is given

    def find_rim(self, possible):
        """Width, diameter and flange of the rim."""
        size = self.size
        contour, diameter = "", size.rim_diameter
        if self.options.rim is None:
            self.rim_width, source = size.measuring_rim, size.rim_rule
            if possible is not None:
                self.rim_width, source = possible, (
                    f"{source}, but as wide as the section needs")
        else:
            rim = parse_rim(self.options.rim, self.is_bicycle)
            self.rim_width, source, contour = rim.width, "given", rim.contour
            if rim.diameter is not None:
                if diameter is not None and abs(rim.diameter - diameter) > 5:
                    raise BifaceError(
                        f"the rim {self.options.rim} has the diameter "
                        f"{rim.diameter:.4g} mm, but {size.text} needs one of "
                        f"{diameter:.4g} mm ({diameter / INCH:.4g} inches).")
                diameter = diameter or rim.diameter
        if diameter is None:
            raise BifaceError(f"the size {size.text} does not say the diameter of its rim, "
                              "and the databook has none such: add it, as in --rim "
                              f"{self.rim_width / INCH:.2f}x20.")
        self.rim_diameter = diameter
        row = size.databook[0] if size.databook and not contour else None
        if row is not None:
            self.flange = (float(self.row()["flange_diameter_mm"]) - diameter) / 2
            flange_source = "databook"
        else:
            self.flange, flange_source = flange_of(contour, size.kind, size.width)
        self.add("rim", f"{self.rim_width:.1f} mm ({self.rim_width / INCH:.3g} inches) wide",
                 source)
        self.add("rim diameter", f"{diameter:.1f} mm", "size" if size.rim_diameter
                 else "given")
        self.add("flange", f"{self.flange:.1f} mm high", flange_source)

    def row(self):
        """The row of the databook of this ply rating, or else the first one."""
        rows = self.size.databook
        return next((row for row in rows
                     if row["ply_rating"] == str(self.size.ply_rating)), rows[0])

    @property
    def is_in_databook(self):
        """Whether the databook has this size with its ply rating."""
        return (bool(self.size.databook)
                and self.row()["ply_rating"] == str(self.size.ply_rating))

    def find_section(self):
        """Outer dimensions."""
        size, options = self.size, self.options
        self.contour = read_contour(options.contour) if options.contour else None
        given = (options.diameter, options.width)
        if self.contour is not None:
            given = self.around(self.contour)
        self.diameter = given[0] or size.diameter
        self.width = given[1] or size.width_on(self.rim_width)
        self.height = (self.diameter - self.rim_diameter) / 2
        if self.height <= self.flange + 5:
            raise BifaceError(
                f"{size.text} would have the diameter {self.diameter:.4g} mm, but must "
                f"have more than {self.rim_diameter + 2 * self.flange + 10:.4g} mm, that of "
                "the flanges of its rim and 5 mm on each side.")
        self.add("overall diameter", f"{self.diameter:.1f} mm",
                 "given" if given[0] else size.dimensions)
        self.add("section width", f"{self.width:.1f} mm", "given" if given[1] else
                 "databook" if size.databook and self.width == size.width else
                 f"{size.width:.4g} mm on a rim of {size.theoretical_rim:.4g} mm, and "
                 "0.4 of the difference (UN R30)")
        self.add("section height", f"{self.height:.1f} mm, "
                 f"{self.height / self.width:.2f} of the width", "(D - d)/2")

    def find_pressure(self):
        """The inflation pressure."""
        size, ply_rating = self.size, self.size.ply_rating
        if self.options.pressure is not None:
            self.pressure, source = self.options.pressure, "given"
        elif size.kind == "passenger":
            self.pressure = PASSENGER_PRESSURES[size.is_reinforced]
            source = "reference pressure of ISO 4000-1"
        elif self.is_bicycle:
            self.pressure, source = 15 / self.width, "15 N/mm over the width (estimate)"
        elif size.kind == "aircraft":
            if not self.is_in_databook:
                ratings = [row["ply_rating"] + "PR" for row in size.databook]
                raise BifaceError(
                    f"{size.text} has no pressure: give --pressure"
                    + (f", or the ply rating {' or '.join(ratings)} of the databook."
                       if ratings else "; the databook has no such size."))
            self.pressure, source = float(self.row()["pressure_MPa"]), "databook"
        elif size.kind == "light truck" and size.is_radial:
            self.pressure = LIGHT_TRUCK_PRESSURES.get(ply_rating, 0.45)
            source = (f"{ply_rating}PR: 50, 65, 80 psi for load ranges C, D, E"
                      if ply_rating in LIGHT_TRUCK_PRESSURES else "estimate")
        elif size.kind in ("truck", "motorcycle") or size.is_radial:
            self.pressure = {"truck": 0.83, "motorcycle": 0.25}.get(size.kind, 0.16)
            source = "estimate"
        elif ply_rating:
            self.pressure = 10.6 * ply_rating / size.width
            source = f"10.6 N/mm x {ply_rating}PR over the width (estimate)"
        else:
            self.pressure, source = 0.3, "estimate: the size has no ply rating"
        if not 0.005 <= self.pressure <= 5:
            raise BifaceError(f"the pressure is {self.pressure:.4g} MPa, but must lie "
                              "between 0.005 and 5 MPa (0.05 to 50 bar).")
        if (self.pressure > LARGEST_PRESSURE
                and size.kind not in ("aircraft", "truck", "bicycle", "utility")):
            raise BifaceError(
                f"the pressure is {self.pressure:.4g} MPa ({10 * self.pressure:.4g} bar), but "
                f"must be at most {LARGEST_PRESSURE:g} MPa ({10 * LARGEST_PRESSURE:g} bar) in "
                f"a tire by the rules for {size.kind}: give the unit, as in --pressure "
                "2.5bar.")
        self.add("pressure", f"{self.pressure:.4g} MPa ({10 * self.pressure:.3g} bar)",
                 source)

    def find_load(self):
        """The load, the deflection that NASA's formula gives with it, and the speed."""
        size = self.size
        shape = (self.diameter, self.width)
        if self.options.load is not None:
            self.load, source = self.options.load, "given"
        elif size.rated_load is not None:
            self.load, source = size.rated_load, f"load index {size.load_index}"
        elif self.is_in_databook:
            self.load, source = 1000 * float(self.row()["rated_load_kN"]), "databook"
        else:
            if size.kind == "aircraft":
                usual = AIRCRAFT_DEFLECTION * (self.height - self.flange)
                words = "0.32 of the height over the flange"
            else:
                part = PASSENGER_DEFLECTION if size.kind == "passenger" else DEFLECTION
                usual, words = part * self.height, f"{part:g} of the section height"
            self.load = 1000 * nasa.force(*shape, usual, self.pressure)
            source = f"NASA TR R-64 at {words} (estimate)"
        self.deflection = nasa.deflection(*shape, self.load / 1000, self.pressure)
        if not 0 < self.deflection < 0.7 * (self.height - self.flange):
            largest = nasa.force(*shape, 0.7 * (self.height - self.flange), self.pressure)
            raise BifaceError(
                f"the load is {self.load:.4g} N, but must lie between 0 and "
                f"{1000 * largest:.3g} N, under which {size.text} at {self.pressure:.4g} "
                "MPa goes down by 0.7 of its height over the rim flange (NASA TR R-64).")
        self.add("load", f"{self.load:.0f} N ({self.load / STANDARD_GRAVITY:.0f} kg)", source)
        speed = 25 if self.is_bicycle else 60
        if size.speed is not None:
            speed = min(speed, size.speed / 2)
        self.speed = self.options.speed or speed
        self.add("speed", f"{self.speed:g} km/h" + (
            f", up to {size.speed:g} km/h by the symbol {size.speed_symbol}"
            if size.speed else ""), "given" if self.options.speed else "estimate")

    # ------------------------------------------------------------- construction

    def build(self):
        """The tire. If its rim is not possible, one sentence with those that are, or the
        nearest one if it was chosen by a rule."""
        try:
            self.tire = self.make(self.rim_width, self.width)
            return None
        except ValueError as error:
            reason = str(error)
        possible = [rim for rim in self.rims() if self.is_possible(rim)]
        words = (f"{self.size.text} does not fit a rim {self.rim_width / INCH:.3g} inches "
                 f"({self.rim_width:.4g} mm) wide, {reason}: it must be")
        if not possible:
            raise BifaceError(
                f"{self.size.text} has no section that carries the pressure between "
                f"flanges {self.flange:.4g} mm high, on a rim of any width: the overall "
                f"diameter {self.diameter:.4g} mm and the width {self.width:.4g} mm must "
                "leave more room over the flange, or the plies be fewer.")
        if self.options.rim is None:
            return min(possible, key=lambda rim: abs(rim - self.rim_width))
        low, high = possible[0], possible[-1]
        raise BifaceError(words + (
            f" {low:.0f} to {high:.0f} mm wide." if self.is_bicycle else
            f" {low / INCH:.3g} to {high / INCH:.3g} inches ({low:.0f} to {high:.0f} mm) "
            "wide."))

    def rims(self):
        """Rim widths to try, mm."""
        step = 1 if self.is_bicycle else max(0.125, round(self.size.width / INCH / 40, 2)) * INCH
        return [step * i for i in range(1, int(1.2 * self.size.width / step) + 1)]

    def is_possible(self, rim):
        """Whether there is a section on a rim of a width."""
        width = (self.width if self.options.width or self.contour is not None
                 else self.size.width_on(rim))
        try:
            self.make(rim, width)
            return True
        except ValueError:
            return False

    def make(self, rim_width, width):
        """The tire on a rim. Raises ValueError with a few words if there is none."""
        least, most = RIM_RANGE
        if not least * width <= rim_width <= most * width:
            raise ValueError(f"which is {rim_width / width:.2f} of the section width, not "
                             f"{least:g} to {most:g}")
        if not self.is_radial:
            return self.make_bias(rim_width, width)
        rules = RADIAL.get(self.size.kind, RADIAL["light truck"])
        self.rules = rules
        more = dict(rules.more)
        # the tread of low sections is wider; estimate
        more["tread_width"] = more.get("tread_width", 0.75) + 0.5 * max(
            0, 0.6 - self.size.section_height / self.size.width)
        scale = self.height / rules.height
        plies = self.options.plies or 1
        # a ply keeps its volume as it is lifted, but not less than around its cords
        ply = max(rules.carcass.ply, 1.15 * rules.carcass.diameter * self.diameter
                  / self.rim_diameter)
        while True:
            tire = RadialTire(
                radius=self.diameter / 2, width=width, rim_radius=self.rim_diameter / 2,
                rim_width=rim_width, flange=self.flange, tread_drop=rules.drop * width,
                carcass=ply, carcass_density=100 / rules.carcass.pitch,
                carcass_plies=plies, belt=rules.belt.ply,
                apex=self.flange + rules.filler * scale,
                turn_up=self.flange + rules.turn_up * scale, **more)
            if (self.options.plies or plies == 6 or tire.cord_tension(self.pressure)
                    * RADIAL_BURST <= rules.carcass.strength):
                return tire
            plies += 1

    def make_bias(self, rim_width, width):
        """A bias tire on a rim."""
        self.rules = BICYCLE if self.is_bicycle else AIRCRAFT
        tire = BiasTire(self.diameter, width, self.rim_diameter / 2 + self.flange,
                        rim_width, self.pressure, self.options.plies, self.rules,
                        CASING_ANGLE if self.is_bicycle else None)
        if not 26 <= tire.curve.degrees <= 70:
            raise ValueError(f"with a cord angle of {tire.curve.degrees:.0f} degrees, which "
                             "is not one of 26 to 70")
        if tire.curve.lack(tire.curve.crown**2 - tire.end**2) > 1.93:
            raise ValueError("where the sidewall would reach the flange along the axle")
        if self.is_bicycle and tire.end < self.rim_diameter / 2 - 1:
            raise ValueError("where the sidewall would end below the seat of the bead")
        return tire

    def fit_contour(self):
        """Takes a measured contour in place of that of the rules."""
        if self.contour is None:
            return
        tire, ends = self.tire, self.contour[[0, -1], 0]
        if (np.abs(ends - tire.end) > 0.25 * self.height).any():
            raise BifaceError(
                f"{self.options.contour} ends at the radii {ends[0]:.4g} and {ends[1]:.4g} "
                f"mm, but must end near the flanges, at the radius {tire.end:.4g} mm.")
        if self.is_radial:
            tire.use_profile(self.contour)
        self.add("contour", f"{len(self.contour)} points", str(self.options.contour))

    def around(self, contour):
        """Outer diameter and width of a tire with a contour of its carcass."""
        crown, width = contour[:, 0].max(), float(np.ptp(contour[:, 1]))
        if not self.is_radial:
            rules = BICYCLE if self.is_bicycle else AIRCRAFT
            width += 2 * rules.sidewall
            return 2 * (crown + rules.tread(width)), width
        tire = RadialTire(**RADIAL.get(self.size.kind, RADIAL["light truck"]).more)
        return (2 * (crown + tire.radius - tire.crown), width + 2 * tire.sidewall)

    @property
    def has_profile(self):
        """Whether the meridian is one of points in a file."""
        return self.is_radial or self.contour is not None

    def write_profile(self, path):
        """Writes these points as CSV."""
        points = self.tire.profile()[0] if self.contour is None else self.contour
        write_profile(path, points, [
            f"The outer side of the carcass of {self.size.text} when inflated, from the",
            "left flange over the crown to the right one. Unit: mm."])

    # ------------------------------------------------------------- summary

    @property
    def burst_factor(self):
        """Pressure at which the cords of the carcass break, over that of the tire."""
        if self.is_radial:
            return self.rules.carcass.strength / self.tire.cord_tension(self.pressure)
        return self.tire.burst_factor

    @property
    def mass(self):
        """In kg, without beads."""
        if self.is_radial:
            rules = self.rules
            return 1000 * self.tire.mass(
                rules.carcass.density, rules.belt.density, rules.cap.density,
                RUBBER_DENSITY, self.tread_density)
        return 1000 * self.tire.mass(RUBBER_DENSITY)

    @property
    def tread_density(self):
        """Of the tread with its grooves, t/mm^3."""
        if not self.is_radial:
            return RUBBER_DENSITY
        # two digits, as in prm/radial_tire.prm, whose land is 0.67
        return (0.85e-9 if self.rules.land == 0.67
                else self.rules.land * RUBBER_DENSITY)

    def add_results(self):
        """What follows from the construction."""
        tire = self.tire
        if self.is_radial:
            self.add("carcass", f"{tire.carcass_plies} x {self.rules.carcass.name}, 90°",
                     "given" if self.options.plies else
                     f"holds {RADIAL_BURST} times the pressure (estimate)")
            self.add("belts", f"{len(tire.belts)} x {self.rules.belt.name}, "
                     f"±{tire.belt_angle:g}°" + (f", cap {self.rules.cap.name}"
                                                 if tire.cap else ""), self.rules.source)
            self.add("widest at", f"radius {tire.widest:.1f} mm",
                     "cords along the meridian")
            if tire.kink > LARGEST_KINK and self.contour is None:
                self.warnings.append(
                    f"the sidewall leaves the belts at an angle of {tire.kink:.0f} degrees, "
                    "which a tire rounds: the inflation may not converge; give a measured "
                    "--contour.")
        else:
            source = ("given" if self.options.plies else
                      f"the smallest even number that holds {BURST} times the pressure")
            self.add("carcass", f"{tire.plies} x {self.rules.cord.name}", source)
            self.add("crown angle", f"{tire.curve.degrees:.1f}°",
                     "estimate" if self.is_bicycle
                     else "netting between crown, widest point and flange")
            self.add("widest at", f"radius {tire.curve.widest:.1f} mm", "netting")
            self.warn_of_plies()
        self.add("between the ends", f"{2 * tire.end_half_width:.1f} mm at the radius "
                 f"{tire.end:.1f} mm", "rim width less beads and half the carcass")
        self.add("burst", f"{self.burst_factor:.1f} times the pressure", "netting; strength "
                 + ("of " + (self.rules.carcass if self.is_radial else self.rules.cord).name))
        self.add("mass", f"{self.mass:.3g} kg without beads", "volume of the plies")
        if self.burst_factor < 3:
            self.warnings.append(
                f"the cords break at {self.burst_factor:.1f} times the pressure; usual is "
                "4 or more: use more plies or less pressure.")

    def warn_of_plies(self):
        """Says that a ply rating is no number of plies."""
        plies, rating = self.tire.plies, self.size.ply_rating
        if rating and self.options.plies is None and rating != plies:
            self.warnings.append(
                f"{rating}PR is a rating of strength, not the number of plies: {plies} "
                f"plies of {self.rules.cord.name} hold {BURST} times the pressure.")
        if self.options.plies:
            needed = BiasTire(self.diameter, self.width, self.tire.end, self.rim_width,
                              self.pressure, None, self.rules,
                              CASING_ANGLE if self.is_bicycle else None).plies
            if self.options.plies > needed:
                self.warnings.append(
                    f"{self.options.plies} plies are more than the {needed} that hold "
                    f"{BURST} times the pressure: the wall is stiffer, and the tire "
                    "carries more at the same deflection"
                    + (f"; {rating}PR is a rating, not the number of plies."
                       if rating else "."))
