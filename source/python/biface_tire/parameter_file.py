# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameter file of a tire, with comments."""

import math
import textwrap

from . import nasa
from .design import FRICTION, RUBBER_DENSITY

NAME, PROFILE, RESULTS = "tire.prm", "tire_profile.csv", "results"
MADE_BY = "Made by: "

# The mass of a tread of bristles, which have none, is that of a thin ply in their place
THINNER = 40

TOUCH = 0.4    # of the deflection, by which the ground is pressed on before the load
CORNER = 0.06  # least radius of curvature at the edge of the belts, over the tire's
GROWTH = 1.1   # of the cells around the axle from the footprint on
MODES = 10
TURN = 0.2     # degrees
LOADS, INCLINATIONS = (0.5, 0.75, 1), "0, 4"
SLIP_ANGLES = "-8, -4, -1.5, 1.5, 4, 8"
SLIP_RATIOS = "-0.15, -0.06, -0.02, 0.02, 0.06, 0.15"


class Mesh:
    """The mesh of a tire: what `Mesh` says, and how large it is.

    along, around   the intervals of alpha_1 and alpha_2
    cells           their numbers of cells
    """

    def __init__(self, design, density=1):
        """density: the number of cells along each direction over that of the rules."""
        footprint = nasa.footprint_length(design.diameter, design.deflection) / 2
        half = math.degrees(math.asin(min(1, 2 * footprint / design.diameter)))
        half = min(60, math.ceil(1.05 * half))
        fine = 2 * max(2, round(12 * density))
        first = 2 * half / fine
        rest = 180 - half
        # the cells grow geometrically
        growth = 1 + (GROWTH - 1) / density
        coarse = max(4, math.ceil(math.log(1 + rest * (growth - 1) / (first * growth))
                                  / math.log(growth)))
        self.around = (f"-180:-{half}:{coarse}:smooth, -{half}:{half}:{fine}, "
                       f"{half}:180:{coarse}:smooth")
        if design.is_radial:
            intervals = [part.rsplit(":", 1) for part in design.tire.mesh().split(", ")]
        else:
            # turn-ups end at a quarter of the sidewall's lines, at 0.7
            intervals = [("-end:-0.6*end", 8), ("-0.6*end:0.6*end", 24),
                         ("0.6*end:end", 8)] if design.contour is None else [
                             ("0:0.2*end", 8), ("0.2*end:0.8*end", 24), ("0.8*end:end", 8)]
        counts = []
        for _, count in intervals:
            count = int(count)
            step = 4 if not design.is_radial and count == 8 else 1
            counts.append(max(step, step * round(count * density / step)))
        self.along = ", ".join(f"{places}:{count}" for (places, _), count
                               in zip(intervals, counts))
        self.cells = sum(counts), fine + 2 * coarse

    def unknowns(self, faces):
        """Number of unknowns with faces of the wall, 2 for one layer; both ends are
        held."""
        return 3 * faces * (self.cells[0] - 1) * self.cells[1]


def section(name, *entries):
    """A section: entries are pairs, with values that are longer than a line broken at
    commas, or lines of comment."""
    width = max(len(entry[0]) for entry in entries if not isinstance(entry, str))
    lines = [f"subsection {name}"]
    for entry in entries:
        if isinstance(entry, str):
            lines += [f"  # {line}" for line in textwrap.wrap(entry, 84)]
            continue
        line = f"  set {entry[0]:{width}} = {entry[1]}"
        if len(line) > 96:
            line = f"  set {entry[0]:{width}} = \\\n    " + ", \\\n    ".join(
                split_at_commas(str(entry[1])))
        lines.append(line)
    return "\n".join([*lines, "end"])


def nested(name, entries, inner):
    """A section with another one at its end."""
    lines = section(name, *entries).split("\n")
    return "\n".join(lines[:-1] + ["  " + line for line in inner.split("\n")] + ["end"])


def split_at_commas(text):
    """The parts of a list whose commas are not in parentheses."""
    parts, depth = [""], 0
    for letter in text:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def comment(text):
    """Lines of comment."""
    return "\n".join("# " + line for line in textwrap.wrap(text, 86))


class ParameterFile:
    """The text of the file of a design.

    tread      "bristles", on which it can roll, or "layer", a ply that shears in series
    is_test    whether a tire test takes the place of the single stages
    """

    def __init__(self, design, tread="bristles", density=1, is_test=False):
        self.design, self.tread, self.is_test = design, tread, is_test
        self.mesh = Mesh(design, density)

    @property
    def faces(self):
        """Number of faces of the wall."""
        return 2 if self.tread == "bristles" else 3

    @property
    def unknowns(self):
        """Number of unknowns."""
        return self.mesh.unknowns(self.faces)

    def text(self, command, directory, facts):
        """The file. command is the command line that makes it, directory where it will
        be, facts the lines of the summary."""
        size = self.design.size
        parts = [
            "\n".join([
                f"# A {'radial' if size.is_radial else 'bias'} tire {size.text}, when "
                "inflated, from its size.", "#", f"# {MADE_BY}{command}", "#",
                *[("# " + fact).rstrip() for fact in facts], "#",
                "# Where no source is named, an entry is a rule of doc/tire_from_size.md.",
                "#", "# Units: mm, N, s, MPa, degrees; masses in tonnes.", "#",
                f"# Run:    biface {directory / NAME}",
                f"# Judge:  biface-tire judge {directory}"]),
            "set Units = mm, N, s",
            *self.surface(), self.mesh_section(), *self.materials(), *self.laminate(),
            "# The flanges of the rim hold both ends.\n" + section(
                "Supports", ("alpha_1 min", "fixed"), ("alpha_1 max", "fixed")),
            section("Loads", ("Pressure type", "follower")),
            *self.contact(), *self.stages(),
            section("Output", ("Directory", directory / RESULTS),
                    ("Profile alpha_2", 0), ("Write VTU", "true"))]
        return "\n\n".join(parts) + "\n"

    # --------------------------------------------------------------- the shell

    def surface(self):
        """The meridian."""
        tire = self.design.tire
        if self.design.contour is not None:
            yield "# The measured contour, the outer side of the carcass.\n" + nested(
                "Surface", [("Type", "surface of revolution"), ("Meridian", "spline")],
                section("Spline", ("File", PROFILE)))
            return
        if self.design.is_radial:
            words = comment("The outer side of the carcass: an arc under the belts, and "
                            "beside it the curve in which cords along the meridian carry "
                            "the pressure.")
            corner = ([("Corner radius", f"{CORNER * tire.radius:.4g}")]
                      if abs(tire.kink) > 15 else [])
            yield words + "\n" + nested(
                "Surface", [("Type", "surface of revolution"), ("Meridian", "spline")],
                section("Spline", ("File", PROFILE), *corner))
            return
        angle = ([("Crown cord angle", f"{tire.curve.degrees:.10g}")]
                 if self.design.is_bicycle else
                 [("Crown cord angle", "from end half width"),
                  ("End half width", f"{tire.end_half_width:.10g}")])
        inner = section(
            "Cord equilibrium", ("Crown radius", f"{tire.crown:.10g}"),
            ("Half width", f"{tire.half_width:.10g}"), ("End radius", f"{tire.end:.10g}"),
            *angle)
        words = comment("The middle of the carcass. Its crossed cords carry the pressure, so "
                      "that its shape follows from its radius and width, and the angle of "
                      "the cords from where it must end, at the flange."
                      if not self.design.is_bicycle else
                      "The middle of the casing, in which crossed cords carry the "
                      "pressure. It leaves the flange where it is as wide as the rim.")
        yield words + "\n" + nested(
            "Surface", [("Type", "surface of revolution"),
                        ("Meridian", "cord equilibrium")], inner)

    def mesh_section(self):
        """The mesh."""
        return comment(
            "Fine where the tire touches the ground, and from there on around the axle "
            f"with cells that grow by a factor of {GROWTH:g}. Plies end at mesh "
            "lines.") + "\n" + section(
                "Mesh", ("Intervals alpha_1", self.mesh.along),
                ("Intervals alpha_2", self.mesh.around), ("Closed in alpha_2", "true"))

    def cord_material(self, name, cord, pitch, rubber, *more):
        """The section of a ply of cords."""
        entries = [(f"{cord.name}: {cord.source}"), ("Type", "cord and rubber"),
                   ("E_cord", f"{cord.modulus:g}"), ("Cord diameter", f"{cord.diameter:g}"),
                   ("Cord pitch", f"{pitch:.6g}"), ("E_rubber", f"{rubber:g}"), *more]
        if cord.compression < 1:
            entries.append(("E_L compression", f"E_L/{1 / cord.compression:g}   # cords "
                                               "buckle"))
        return section(f"Material {name}", *entries, ("Density", f"{cord.density:.4g}"))

    def rubber_material(self, name, modulus, density, *remark):
        """The section of a rubber."""
        return section(f"Material {name}", *remark, ("Type", "isotropic"),
                       ("E", f"{modulus:.4g}"), ("nu", 0.49), ("Density", f"{density:.4g}"))

    @property
    def tread_modulus(self):
        """Young's modulus of the tread with its grooves, MPa."""
        rules = self.design.rules
        if not self.design.is_radial:
            return rules.rubber
        return 3.35 if rules.land == 0.67 else 5 * rules.land

    @property
    def bristle_height(self):
        """Height of the bristles, mm."""
        tire = self.design.tire
        return (tire.tread_height - 0.5 if self.design.is_radial
                else tire.tread - tire.rules.sidewall)

    def thin_tread(self):
        """The material of the ply that is the mass of the bristles."""
        return self.rubber_material(
            "mass of tread", self.tread_modulus, THINNER * self.design.tread_density,
            "Bristles have no mass: a ply of a fortieth of their height has it.")

    def materials(self):
        """All materials."""
        rules, tire = self.design.rules, self.design.tire
        has_mass = self.tread == "bristles"
        if not self.design.is_radial:
            yield "set Materials = cord, rubber" + ", mass of tread" * has_mass
            yield self.cord_material("cord", rules.cord, rules.cord.pitch, rules.rubber)
            yield self.rubber_material("rubber", rules.rubber, RUBBER_DENSITY)
            if has_mass:
                yield self.thin_tread()
            return
        yield ("set Materials = liner, carcass, apex, belt, " + "cap, " * (tire.cap > 0)
               + "sidewall, " + ("mass of tread" if has_mass else "tread"))
        pitch = rules.carcass.pitch * tire.crown / tire.rim_radius
        yield self.cord_material("carcass", rules.carcass, pitch, 4)
        yield self.cord_material("belt", rules.belt, rules.belt.pitch, 10,
                                 ("Ply thickness", "as given"))
        if tire.cap:
            yield self.cord_material("cap", rules.cap, rules.cap.pitch, 4,
                                     ("Ply thickness", "as given"))
        for name, modulus in (("liner", 2), ("apex", 40), ("sidewall", 3)):
            yield self.rubber_material(name, modulus, RUBBER_DENSITY)
        yield (self.thin_tread() if has_mass else self.rubber_material(
            "tread", self.tread_modulus, self.design.tread_density,
            f"rubber of 5 MPa, of which the pattern leaves {rules.land:g}"))

    def plies(self):
        """The entry 'Laminate/Plies'."""
        tire, is_layer = self.design.tire, self.tread == "layer"
        if not self.design.is_radial:
            height = self.bristle_height / THINNER
            plies = tire.layup() if is_layer else (
                tire.layup(tread=0).rsplit(" + 0*", 1)[0] + " @ 0, mass of tread: "
                f"0.01 + {height:.6g}*min(1, max(0, 3 - 5*abs(alpha_1)/end)) @ 0")
            return plies if self.design.contour is None else self.from_end(plies)
        lines = tire.plies(is_layer)
        words = [f"{line[0]}: {line[1]} @ {line[2]}"
                 + (f" from {line[3]} to {line[4]}" if len(line) > 3 else "")
                 for line in lines]
        if not is_layer:
            tread = tire.plies(True)[-1][1].split("*", 1)[1]
            words.append("mass of tread: "
                         f"0.01 + {self.bristle_height / THINNER:.6g}*{tread} @ 0")
        return ", ".join(words)

    def from_end(self, plies):
        """Plies on a meridian whose length counts from one end, not from the crown."""
        for old, new in (("from -end to -0.7*end", "from 0 to 0.15*end"),
                         ("from 0.7*end to end", "from 0.85*end to end"),
                         ("abs(alpha_1)/end", "abs(2*alpha_1/end - 1)"),
                         ("beta_c", f"{self.design.tire.curve.degrees:.6g}")):
            plies = plies.replace(old, new)
        return plies

    def laminate(self):
        """Plies and layers."""
        tire = self.design.tire
        if self.design.is_radial:
            words, reference = ("liner, carcass, filler and turn-up at both ends, belts, "
                                "cap, sidewall"), f"ply {1 + tire.carcass_plies}"
        else:
            words, reference = "liner, carcass, turn-ups, sidewall", \
                f"ply {1 + tire.plies // (2 if self.design.contour is None else 1)}"
        layers = f"{tire.inner_plies}, {2 if self.design.is_radial else 1}" \
            if self.tread == "layer" else "one"
        if self.tread == "layer":
            words += " and tread, which shears with it in series with all plies inside them"
        yield comment(f"Inner ply first: {words}.") + "\n" + section(
            "Laminate", ("Angle reference", "circumference"),
            ("Reference surface", reference), ("Layers", layers), ("Plies", self.plies()))

    # --------------------------------------------------------------- ground and stages

    def contact(self):
        """The ground."""
        if self.tread == "layer":
            yield section("Contact", ("Direction", "1, 0, 0"),
                          ("Friction", f"{FRICTION:g}"), ("Regularization", "1e4   # MPa/mm"),
                          ("Tangential regularization", "100   # MPa/mm"))
            return
        yield comment("The tread is bristles between the carcass and the ground, on which "
                      "the tire can roll.") + "\n" + nested(
            "Contact", [("Direction", "1, 0, 0"), ("Friction", f"{FRICTION:g}"),
                        ("Multiplier mass", "lumped"), ("Rolling friction", "bristles")],
            section("Tread", ("Height", f"{self.bristle_height:.6g}"),
                    ("Modulus", f"{self.tread_modulus:.4g}")))

    def stages(self):
        """Inflation, vibration, and the loaded tire, or a tire test."""
        design, is_layer = self.design, self.tread == "layer"
        pressure = ("Pressure", f"{design.pressure:.6g}")
        force = f"{design.load:.6g}"
        slide = f"{max(design.deflection / 100, 1e-3):.4g}"
        count = 2 if self.is_test else 7 if is_layer else 8
        yield f"set Number of stages = {count}"
        yield "# Finds the tensions; the shape is that under pressure.\n" + section(
            "Stage 1", ("Name", "inflation"), pressure)
        yield "# In it, the tire vibrates on the fixed rim.\n" + section(
            "Stage 2", ("Name", "vibration"), ("Start from prestress", "true"), pressure,
            ("Modes", 0 if self.is_test else MODES))
        if self.is_test:
            loads = ", ".join(f"{part * design.load:.6g}" for part in LOADS)
            yield comment("Rolls at all combinations; a point that does not converge is "
                          "left out.") + "\n" + section(
                "Tire test", ("Loads", loads), ("Inclination angles", INCLINATIONS),
                ("Slip angles", SLIP_ANGLES), ("Slip ratios", SLIP_RATIOS),
                ("Slip", "combined"), ("Ground velocity", f"{design.speed / 0.0036:.6g}"))
            yield section("Step control", ("Maximum cuts", 2))
            return
        friction = [] if is_layer else [
            "A wheel that rolls later has no history of friction.", ("Friction", 0)]
        yield ("# The ground is pressed on, by a part of what it will go, then by the "
               "load.\n" + section(
                   "Stage 3", ("Name", "touch"), ("Contact", "true"),
                   ("Travel", f"{TOUCH * design.deflection:.4g}"), ("Steps", 2), *friction))
        yield section(
            "Stage 4", ("Name", "load"), ("Contact", "true"),
            ("Control", "foundation force"), ("Force", force), ("Steps", 3))
        words = comment("Stiffnesses without slip: the ground slides across and along by "
                        f"1 % of the deflection, and turns by {TURN:g}°.") + "\n"
        for number, (name, motion) in enumerate((
                ("lateral", ("Slide", f"0, {slide}, 0")),
                ("longitudinal", ("Slide", f"0, 0, {slide}")),
                ("turn", ("Turn", f"{TURN:g}"))), start=5):
            yield words + section(
                f"Stage {number}", ("Name", name), ("Start from", 4), ("Contact", "true"),
                ("Glued", "true"), motion)
            words = ""
        if not is_layer:
            yield f"# Rolls freely at {design.speed:g} km/h under the load.\n" + section(
                "Stage 8", ("Name", "rolling"), ("Start from", 4), ("Contact", "true"),
                ("Friction", f"{FRICTION:g}"),
                ("Control", "foundation force and axle moment"), ("Force", force),
                ("Ground velocity", f"{design.speed / 0.0036:.6g}   # mm/s"))
