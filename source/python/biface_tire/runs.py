# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of the program that a protocol needs, for the tire of a parameter file."""

from __future__ import annotations

import math
import re
from collections import namedtuple
from pathlib import Path

from biface.errors import BifaceError
from biface.parameters import parse_parameters, scan
from biface.tables import read_text
from biface_tire_model.units import System
from .parameter_file import MODES as COUNT_OF_MODES
from .parameter_file import NAME, TURN, section
from .protocol import BARS, MODES, MOVED, PRESSED, RUN_OVER, STEADY

# Names of runs, which are those of their directories
STANDING, LEANING, VIBRATING = "standing", "leaning", "vibrating"

# The velocity of a tire whose file has none, m/s
VELOCITY = 60 / 3.6

# Steps up to the largest load of a standing tire
STEPS = 6

# The ground slides by this part of the root of load over pressure, which is about the
# length of the footprint
SLIDE = 0.002

# How the names of stages on a bar begin, and steps in which it rises
ON_BAR, RISE = "on the bar:", 4

# Times a step of a tire test that fails is halved
MOST_CUTS = 2

# Sections of a file that a run has of its own, and single entries
DROPPED = re.compile(r"Stage \d+|Tire test|Step control|Output|Checkpoint|Sensitivities|"
                     r"Body .*|Forces on bodies")
ENTRIES = ("Number of stages", "Bodies")

# A run.
# name   of its directory
# kind   STEADY, MODES, one of BARS, or "static"
# text   of its parameter file
# title  what it does, for people
Run = namedtuple("Run", "name kind text title")

# Sentences on what the program cannot do
LEFT_OUT = {
    RUN_OVER: "a bar that a rolling tire runs over, which is not computed: rolling is steady "
              "here, and on plane ground."}


class Tire:
    """A tire as a parameter file describes it.

    path      the file
    system    its units
    base      the number of its stages before the ground comes, of which the last one leaves
              the tire inflated
    pressure  there, Pa
    load      that of the tire, N: given, or the largest of the file
    velocity  at which it rolls, m/s
    text      of the file without what each run has of its own
    files     paths of the files that it names
    """

    def __init__(self, path, load=None):
        """Raises BifaceError if something is missing in the file."""
        self.path = Path(path)
        if self.path.is_dir():
            self.path = self.path / NAME
        self.parameters = parse_parameters(read_text(self.path))
        units = self.get("Units")
        if not units:
            raise BifaceError(f"{self.path}: the entry 'Units' is missing, in which length, "
                              "force and time are, such as 'mm, N, s'.")
        try:
            self.system = System(units)
        except BifaceError as error:
            raise BifaceError(f"{self.path}: {error}") from None
        self.base = self._base()
        self.pressure = self._pressure()
        self.load = load or self._load()
        velocities = self.numbers(r"(Stage \d+|Tire test)/Ground velocity")
        self.velocity = (max(velocities) * self.system["velocity"]
                         if velocities and max(velocities) > 0 else VELOCITY)
        self.files = {}
        self.text = self._text()

    def get(self, name):
        """The value of an entry, "" if the file does not set it."""
        entry = self.parameters.entries.get(name)
        return entry.value if entry else ""

    def numbers(self, pattern):
        """The numbers of all entries whose names match, and those of their lists."""
        result = []
        for name, entry in self.parameters.entries.items():
            if re.fullmatch(pattern, name):
                for word in entry.value.split(","):
                    try:
                        result += [float(part) for part in word.split(":")[:2]]
                    except ValueError:
                        pass
        return result

    def _base(self):
        count = int(self.get("Number of stages") or 1)
        start = self.get("Tire test/Start from")
        if start.isdigit():
            return int(start)
        for number in range(1, count + 1):
            if self.get(f"Stage {number}/Contact") == "true":
                count = number - 1
                break
        return count

    def _pressure(self):
        for number in range(self.base, 0, -1):
            text = self.get(f"Stage {number}/Pressure")
            try:
                if float(text) > 0:
                    return float(text) * self.system["pressure"]
            except ValueError:
                pass
        raise BifaceError(f"{self.path}: no stage before the ground comes has a 'Pressure': "
                          "a tire is inflated before it is tested.")

    def _load(self):
        loads = self.numbers("Tire test/Loads") or [
            value for number in range(1, int(self.get("Number of stages") or 1) + 1)
            if self.get(f"Stage {number}/Control").startswith("foundation force")
            for value in self.numbers(f"Stage {number}/Force")]
        if not loads or max(loads) <= 0:
            raise BifaceError(f"{self.path} names no load: neither 'Tire test/Loads' nor a "
                              "'Force' of a stage with 'Control = foundation force'. Give it "
                              "with --load.")
        return max(loads) * self.system["force"]

    def _text(self):
        """The file without the sections of DROPPED beyond the base stages, and with whole
        paths of the files that it names."""
        lines, depth, dropping = [], 0, False
        for line in self._with_paths().split("\n"):
            word = line.strip()
            if word.startswith("subsection "):
                if depth == 0:
                    name = word.removeprefix("subsection ").partition("#")[0].strip()
                    stage = re.fullmatch(r"Stage (\d+)", name)
                    dropping = bool(DROPPED.fullmatch(name)) and not (
                        stage and int(stage[1]) <= self.base)
                    while dropping and lines and lines[-1].startswith("#"):
                        lines.pop()
                depth += 1
            is_entry = depth == 0 and any(re.match(rf"set\s+{name}\s*=", word)
                                          for name in ENTRIES)
            if not dropping and not is_entry:
                lines.append(line)
            if re.match(r"end\b", word) and depth > 0:
                depth -= 1
                dropping = dropping and depth > 0
        return "\n".join(lines).rstrip() + "\n"

    def _with_paths(self):
        lines = self.parameters.text.split("\n")
        folder = self.path.resolve().parent
        found = list(scan(lines))
        for place, name, value, _ in reversed(found):
            # modes are those of a run of its own
            if re.fullmatch(r"Stage \d+/Modes", name):
                lines[place] = [f"set {name.rpartition('/')[2]} = 0"]
                continue
            words = re.split(r"([,;:]\s*)", value)
            for i, word in enumerate(words):
                if "." in word and (folder / word.strip()).is_file():
                    path = folder / word.strip()
                    self.files[word.strip()] = path
                    words[i] = str(path)
            if "".join(words) != value:
                lines[place] = [f"set {name.rpartition('/')[2]} = {''.join(words)}"]
        return "\n".join(lines)

    def share(self, value, of):
        """A load or pressure of a protocol in SI units: a negative one is a part of that of
        the tire."""
        return -value * of if value < 0 else value

    def own(self, value, kind):
        """A number in SI units as text in the units of the file."""
        return f"{value / self.system[kind]:.10g}"

    def file(self, sections, stages, more="", every=1):
        """The text of the parameter file of a run: stages beyond the base ones, and other
        sections."""
        count = self.base + len(stages)
        parts = [f"# One of the runs of a test protocol, for the tire of {self.path.name}.",
                 self.text + more, f"set Number of stages = {count}",
                 *(section(f"Stage {self.base + i}", *stage)
                   for i, stage in enumerate(stages, start=1)), *sections,
                 section("Output", ("Write VTU", "false"), ("Profile alpha_2", 0),
                         ("Every", every))]
        return "\n\n".join(parts) + "\n"


def degrees(angle):
    """An angle in degrees, without the rounding of its way through radians."""
    return f"{math.degrees(angle):.10g}"


def plan(tire: Tire, rows) -> tuple[list[Run], list[str]]:
    """The runs that the rows of a protocol need, and sentences on rows that are left out."""
    static = [row for row in rows if row.kind in (*PRESSED, *MOVED)]
    runs, left_out = [], [f"{row.place}: {LEFT_OUT[row.kind]}" for row in rows
                          if row.kind in LEFT_OUT]
    left_out += [f"{row.place}: the {row.kind} stiffness of a leaning wheel, which is not "
                 "computed." for row in static if row.kind in MOVED
                 and any(row.inclination_angle)]
    for name, is_chosen, title in (
            (STANDING, lambda angle: angle == 0, "stiffnesses of the standing tire"),
            (LEANING, lambda angle: angle != 0, "stiffnesses of the leaning tire")):
        states = static_states(tire, static, is_chosen)
        if states:
            runs.append(Run(name, "static", tire.file([], static_stages(tire, states)),
                            title))
    if any(row.kind == MODES for row in rows):
        runs.append(Run(VIBRATING, MODES, vibrating(tire, rows), "natural frequencies"))
    for row in rows:
        if row.kind in BARS:
            runs += bars(tire, row, [run.name for run in runs])
    for number, (key, slips) in enumerate(steady_tests(tire, rows).items(), start=1):
        runs.append(Run(f"steady-{number}", STEADY, steady(tire, key, *slips),
                        "steady rolling"))
    return runs, left_out


# ---- the standing tire

def static_states(tire, rows, is_chosen):
    """The motions of the ground by pressure, inclination angle and load, all ascending."""
    states = {}
    for row in rows:
        for pressure in row.pressure:
            for angle in filter(is_chosen, row.inclination_angle):
                for load in row.load:
                    key = (tire.share(pressure, tire.pressure), angle,
                           tire.share(load, tire.load))
                    if row.kind in MOVED and angle:
                        continue
                    motions = states.setdefault(key, [])
                    if row.kind in MOVED and row.kind not in motions:
                        motions.append(row.kind)
    return dict(sorted(states.items()))


def static_stages(tire, states):
    """The stages of a run on which the ground is pressed and then moves."""
    stages, last = [], {}
    largest = {key[:2]: load for *key, load in states for key in [tuple(key)]}
    for (pressure, angle, load), motions in states.items():
        state = pressure, angle
        name = f"{tire.own(load, 'force')}"
        if angle:
            name += f" leaning by {degrees(angle)} degrees"
        name += f" at {tire.own(pressure, 'pressure')}"
        start, before = last.get(state, (None, 0))
        if start is None:
            start = inflated(tire, stages, last, pressure)
        steps = max(1, math.ceil(STEPS * (load - before) / largest[state]))
        stages.append([
            ("Name", f"load {name}"), ("Start from", start), ("Contact", "true"),
            ("Friction", 0), ("Control", "foundation force"),
            ("Force", tire.own(load, "force")), ("Steps", steps),
            *([("Inclination angle", degrees(angle))] if angle else [])])
        start = tire.base + len(stages)
        last[state] = start, load
        slide = tire.own(SLIDE * math.sqrt(load / pressure), "length")
        for motion in motions:
            stages.append([
                ("Name", f"{motion} {name}"), ("Start from", start), ("Contact", "true"),
                ("Glued", "true"),
                {"lateral": ("Slide", f"0, {slide}, 0"),
                 "longitudinal": ("Slide", f"0, 0, {slide}"),
                 "torsional": ("Turn", f"{TURN:g}")}[motion]])
    return stages


def inflated(tire, stages, last, pressure):
    """The number of the stage with a pressure, which is added to the others if need be."""
    if math.isclose(pressure, tire.pressure, rel_tol=1e-9):
        return tire.base
    if pressure not in last:
        text = tire.own(pressure, "pressure")
        stages.append([("Name", f"inflated to {text}"), ("Start from", tire.base),
                       ("Pressure", text)])
        last[pressure] = tire.base + len(stages)
    return last[pressure]


def vibrating(tire, rows):
    """The file of the run of the modes at all their pressures."""
    pressures = sorted({tire.share(pressure, tire.pressure) for row in rows
                        if row.kind == MODES for pressure in row.pressure})
    return tire.file([], [
        [("Name", f"modes at {tire.own(pressure, 'pressure')}"), ("Start from", tire.base),
         ("Pressure", tire.own(pressure, "pressure")), ("Modes", COUNT_OF_MODES)]
        for pressure in pressures]).replace("set Write VTU       = false",
                                            "set Write VTU       = true")


def bars(tire, row, names):
    """The runs of a row with a bar on the ground below the axle. It rises from the plane
    under the first load, since the tire cannot come down on it from above the plane."""
    axis = "0, 1, 0" if row.kind == BARS[0] else "0, 0, 1"
    for height in row.height:
        for pressure in row.pressure:
            pressure = tire.share(pressure, tire.pressure)
            stages, last = [], {}
            start = inflated(tire, stages, last, pressure)
            loads = sorted(tire.share(load, tire.load) for load in row.load)
            before = 0
            for load in loads:
                common = [("Contact", "true"), ("Friction", 0),
                          ("Control", "foundation force"),
                          ("Force", tire.own(load, "force"))]
                steps = max(1, math.ceil(STEPS * (load - before) / loads[-1]))
                name = f"load {tire.own(load, 'force')} at {tire.own(pressure, 'pressure')}"
                if before == 0:
                    stages.append([("Name", f"{name} on the plane"), ("Start from", start),
                                   *common, ("Steps", steps)])
                    stages.append([("Name", f"{ON_BAR} {name}"), *common, ("Bodies", "bar"),
                                   ("Load factors", "bodies bar: 1"), ("Steps", RISE)])
                else:
                    stages.append([("Name", f"{ON_BAR} {name}"), *common, ("Bodies", "bar"),
                                   ("Steps", steps)])
                before = load
            size = tire.own(height, "length")
            body = section("Body bar", ("Shape", "cylinder"), ("Point", f"{size}, 0, 0"),
                           ("Axis", axis), ("Radius", size), ("Moves with", "foundation"),
                           ("Motions", f"rise: -{size} 0 0"))
            name = f"{row.kind.replace(' ', '-')}-{size}"
            while name in names:
                name += "-" + tire.own(pressure, "pressure")
            names.append(name)
            yield Run(name, row.kind, tire.file([body], stages, "\nset Bodies = bar\n"),
                      f"on a {row.kind} of {size}")


# ---- the rolling tire

def steady_tests(tire, rows):
    """The tire tests of the rows that roll: slip angles, slip ratios, and whether both act
    at once, by what they have in common."""
    result = {}
    for row in rows:
        if row.kind != STEADY:
            continue
        angles = [angle for angle in row.slip_angle if angle]
        ratios = [ratio for ratio in row.slip_ratio if ratio]
        is_combined = bool(angles and ratios)
        for velocity in row.velocity or (tire.velocity,):
            key = (tuple(sorted(tire.share(p, tire.pressure) for p in row.pressure)),
                   tuple(sorted(tire.share(f, tire.load) for f in row.load)),
                   row.inclination_angle, velocity,
                   (tuple(angles), tuple(ratios)) if is_combined else None)
            found = result.setdefault(key, (set(), set()))
            found[0].update(angles)
            found[1].update(ratios)
    return result


def steady(tire, key, angles, ratios):
    """The file of a tire test."""
    pressures, loads, inclinations, velocity, combined = key

    def words(values, kind):
        return ", ".join(tire.own(value, kind) for value in values)

    test = section(
        "Tire test", ("Start from", tire.base), ("Loads", words(loads, "force")),
        ("Pressures", words(pressures, "pressure")),
        ("Inclination angles", ", ".join(map(degrees, inclinations))),
        ("Slip angles", ", ".join(map(degrees, sorted(angles)))),
        ("Slip ratios", ", ".join(f"{ratio:.10g}" for ratio in sorted(ratios))),
        ("Slip", "combined" if combined else "pure"),
        ("Ground velocity", tire.own(velocity, "velocity")))
    return tire.file([test, section("Step control", ("Maximum cuts", MOST_CUTS))], [],
                     every=1000000)
