# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a run beside what formulas, ratings and other tires say."""

import math
import shlex
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from biface import Results
from biface.errors import BifaceError
from . import nasa
from .parameter_file import MADE_BY, NAME

# Ranges of ratios beyond which a number deserves a look. Those to NASA's formulas hold
# all 28 tires of doc/real_tires.md, whose tread is a layer; on bristles, which do not
# bend, a tire is a little softer. The others are estimates.
FORCE = {"layer": (0.85, 1.2), "bristles": (0.75, 1.1)}
LENGTH, WIDTH = (0.8, 1.05), (0.8, 1.1)
LATERAL, LONGITUDINAL, TORSIONAL = (0.6, 1.5), (0.7, 2.4), (0.5, 3.2)
ROLLING_RADIUS = 0.92, 1.01
# bristles are pressed also where the wall is not yet flat
LOAD_RATIO = {"layer": (1, 1.4), "bristles": (0.85, 1.4)}
DEFLECTION = {"aircraft": (0.2, 0.4), "bicycle": (0.08, 0.35)}
USUAL_DEFLECTION = 0.1, 0.3
INFLATED_CORDS, LOADED_CORDS = 0.3, 0.45
MASS = 0.6, 1.15

# kg of a 205/60 R15 @cite TNO2013, and its D and S in mm
PASSENGER_MASS, PASSENGER_SIZE = 9.3, (627, 205)


@dataclass
class Line:
    """A number beside another one.

    name, unit      of the quantity
    value           as computed
    other           what it is compared with, NaN if there is nothing
    source          where that is from
    range           of value/other that is usual, None if nothing is known
    remark          a sentence for the case that it is beyond
    """

    name: str
    unit: str
    value: float
    other: float = math.nan
    source: str = ""
    range: tuple | None = None
    remark: str = ""

    @property
    def ratio(self):
        """Of both numbers."""
        return self.value / self.other if self.other else math.nan

    @property
    def is_unusual(self):
        """Whether the ratio is known and beyond the range."""
        return (self.range is not None and math.isfinite(self.ratio)
                and not self.range[0] <= self.ratio <= self.range[1])


def command_of(directory):
    """The words of the command that made the file in a directory."""
    path = Path(directory) / NAME
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise BifaceError(f"{path} cannot be read ({error.strerror}): judge needs the "
                          "directory that biface-tire new has written.") from error
    except UnicodeDecodeError as error:
        raise BifaceError(f"{path} is not a text file.") from error
    for line in text.splitlines():
        if line.startswith("# " + MADE_BY):
            try:
                return shlex.split(line.removeprefix("# " + MADE_BY))
            except ValueError as error:
                raise BifaceError(f"{path}: the line '{MADE_BY}' is damaged.") from error
    raise BifaceError(f"{path} has no line '{MADE_BY}biface-tire new ...': judge reads the "
                      "size from it.")


class Judgment:
    """The comparison of a design with the results of its run.

    lines      what is compared
    warnings   sentences on what is unusual
    """

    def __init__(self, design, results, tread="bristles"):
        """results: a biface.Results; tread: that of the parameter file. Raises BifaceError
        if the tire was not loaded."""
        self.design, self.results, self.tread = design, results, tread
        self.lines, self.warnings = [], []
        if "load" not in results.stages:
            raise BifaceError(f"{results.directory} has no step of the stage 'load': it "
                              f"has {', '.join(results.stages)}.")
        self.loaded = results.stage("load")
        self.force = float(self.loaded.last("force"))
        self.deflection = float(self.loaded.last("approach"))
        self.pressure = float(self.loaded.last("pressure"))
        if self.force < 0.999 * design.load:
            self.warnings.append(f"the run ends at {self.force:.4g} N of the load of "
                                 f"{design.load:.4g} N.")
        self.add_load()
        self.add_cords()
        self.add_stiffness()
        self.add_rolling()
        self.add_mass()
        for line in self.lines:
            if line.is_unusual:
                self.warnings.append(
                    f"{line.name} is {line.ratio:.2f} of {line.source}; usual is "
                    f"{line.range[0]:g} to {line.range[1]:g}"
                    + (f": {line.remark}" if line.remark else "."))

    def add(self, *values):
        """Adds a line, if there is something to compare."""
        line = Line(*values)
        if math.isfinite(line.value):
            self.lines.append(line)

    @property
    def is_bias(self):
        """Whether the tire has crossed plies."""
        return not self.design.is_radial

    @property
    def has_formulas(self):
        """Whether NASA's formulas hold: not for sections as slender as a bicycle's."""
        return self.is_bias and not self.design.is_bicycle

    def add_load(self):
        """Deflection, force and footprint."""
        design, loaded = self.design, self.loaded
        kind = design.size.kind
        height = (design.height - design.flange if kind == "aircraft" else design.height)
        self.add("deflection", "mm", self.deflection, height,
                 "the height over the flange" if kind == "aircraft"
                 else "the section height", DEFLECTION.get(kind, USUAL_DEFLECTION),
                 "load, pressure or the stiffness of the wall are not those of this size.")
        length, width = (float(loaded.last(f"footprint_{which}"))
                         for which in ("length", "width"))
        if self.has_formulas:
            shape = design.diameter, design.width
            self.add("force", "N", self.force, 1000 * nasa.force(
                *shape, self.deflection, self.pressure),
                "NASA TR R-64 at this deflection", FORCE[self.tread], self.remark_on_force())
            self.add("footprint length", "mm", length,
                     nasa.footprint_length(design.diameter, self.deflection),
                     "NASA TR R-64", LENGTH)
            self.add("footprint width", "mm", width,
                     nasa.footprint_width(design.width, self.deflection),
                     "NASA TR R-64", WIDTH)
        else:
            self.add("footprint length", "mm", length, design.diameter, "the diameter",
                     (0.08, 0.4))
            self.add("footprint width", "mm", width, design.width, "the section width",
                     (0.4, 0.95))
        area = float(loaded.last("footprint_area"))
        self.add("force", "N", self.force, self.pressure * area,
                 "pressure times footprint", LOAD_RATIO[self.tread],
                 "less means that the footprint is not pressed flat, more that the wall "
                 "carries more than that of an inflated tire does.")

    def remark_on_force(self):
        """What a wall that is too stiff or too soft may come from."""
        rating, plies = self.design.size.ply_rating, self.design.tire.plies
        if self.design.options.plies:
            return (f"the wall has {plies} plies as given"
                    + (f"; {rating}PR is a rating, not the number of plies." if rating
                       else "."))
        return "the wall or the dimensions are not those of this size."

    def cord_of(self, ply):
        """The cord of a ply of the wall, 1 at the inner face."""
        rules = self.design.rules
        if self.is_bias:
            return rules.cord
        name = self.design.tire.plies()[int(ply) - 1][0]
        return {"carcass": rules.carcass, "belt": rules.belt, "cap": rules.cap}.get(name)

    def add_cords(self):
        """Tensions over strengths."""
        for stage, limit in (("inflation", INFLATED_CORDS), ("load", LOADED_CORDS)):
            if stage not in self.results.stages:
                continue
            history = self.results.stage(stage).history
            if "max_cord_tension" not in history:
                return
            cord = self.cord_of(history["max_cord_tension_ply"][-1])
            if cord is None:
                continue
            where = "inflated" if stage == "inflation" else "loaded"
            self.add(f"cord tension, {where}", "N", float(history["max_cord_tension"][-1]),
                     cord.strength, f"the strength of {cord.name}", (0, limit),
                     "use more plies or stronger cords, or less pressure.")

    def add_stiffness(self):
        """Stiffnesses of the standing tire without slip."""
        table = self.results.stiffness()
        if table is None:
            return

        def secant(stage):
            rows = table.where(stage=stage)
            return float(rows["secant"][-1]) if len(rows) > 0 else math.nan

        shape = self.design.diameter, self.design.width
        rows = table.where(stage="load", motion="approach")
        if len(rows) > 0:
            self.add("vertical stiffness", "N/mm", float(rows["tangent"][-1]))
        if not self.has_formulas:
            for stage in ("lateral", "longitudinal"):
                self.add(f"{stage} stiffness", "N/mm", secant(stage))
            self.add("torsional stiffness", "N m/degree", secant("turn") / 1000)
            return
        self.add("lateral stiffness", "N/mm", secant("lateral"),
                 1000 * nasa.lateral_stiffness(shape[1], self.deflection, self.pressure),
                 "NASA TR R-64", LATERAL)
        self.add("longitudinal stiffness", "N/mm", secant("longitudinal"),
                 1000 * nasa.longitudinal_stiffness(shape[0], self.deflection,
                                                    self.pressure),
                 "NASA TR R-64", LONGITUDINAL)
        self.add("torsional stiffness", "N m/degree", secant("turn") / 1000,
                 1000 * nasa.torsional_stiffness(*shape, self.deflection, self.pressure),
                 "NASA TR R-64", TORSIONAL)

    def add_rolling(self):
        """The rolling radius, up to the base of the tread."""
        rolling = self.results.rolling()
        if rolling is None or len(rolling.where(stage="rolling")) == 0:
            return
        radius = float(rolling.where(stage="rolling")["rolling_radius"][-1])
        self.add("rolling radius", "mm", radius,
                 nasa.rolling_radius(self.design.diameter, self.deflection),
                 "D/2 less a third of the deflection", ROLLING_RADIUS)

    def add_mass(self):
        """Mass and the lowest frequency."""
        modes = self.results.modes()
        if modes is None or len(modes) == 0:
            return
        usual, source = self.usual_mass()
        self.add("mass without beads", "kg", 1000 * float(modes["total_mass"][0]), usual,
                 source, MASS if math.isfinite(usual) else None,
                 "all plies are of one cord; stronger ones would be fewer and lighter."
                 if self.is_bias else "")
        frequencies = modes["frequency"][modes["frequency"] > 0]
        if len(frequencies) > 0:
            self.add("lowest frequency", "Hz", float(np.min(frequencies)))

    def usual_mass(self):
        """kg with beads, and where it is from; NaN if nothing is known."""
        design = self.design
        if design.is_in_databook and design.row()["weight_kg"]:
            return float(design.row()["weight_kg"]), "the databook, with beads"
        if design.size.kind == "passenger":
            diameter, width = PASSENGER_SIZE
            return (PASSENGER_MASS * design.diameter * design.size.width
                    / (diameter * width), "a 205/60 R15 by D times S, with beads")
        return math.nan, ""


def judge(design, directory, tread="bristles"):
    """The Judgment of the results in a directory."""
    return Judgment(design, Results(directory), tread)
