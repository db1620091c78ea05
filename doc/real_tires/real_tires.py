#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute aircraft tires from the entries of a databook, and write real_tires.md.

Each row of a table of tires becomes a run of prm/aircraft_tire.prm with --set,
by rules that are the same for all rows; see Construction. The page compares the
forces with the rated loads and the footprints with NASA's formulas.

With --tires another table is used, with --only some of its rows; then nothing
but the table of results is printed.
"""

import argparse
import csv
import math
import statistics
import sys
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import biface, table
from biface_tire import nasa as formulas
from biface_tire.bias import AIRCRAFT, BURST, BiasTire
from biface_tire.size import read_databook

# ------------------------------------------------------- rules of construction

TURN = 0.2  # degrees, of the ground in the parameter file
FRICTION = 0.8  # of the tire that stands and of that which rolls
SLIP_ANGLE = 1  # degrees
DEFLECTIONS = (0.5, 0.75, 1, 1.25)  # over the rated one
# what the laminate is, by entries beside those of the rules
WALLS = {
    "two layers": {},
    "one layer": {"Laminate/Layers": "one"},
    "equilibrium": {"Laminate/Transverse shear": "equilibrium"},
}
# a tire of which the databook has load (kN) and radius (mm) at bottoming, and its
# rim: flanges over which the sidewall folds, and what the inner face meets
BOTTOMING = {"name": "49x17 26PR", "load": 528.4, "radius": 342.9}
OUTER_RIM = ("-180 297 15, -180 240, 180 240, 180 297 15, 240 297 10, 240 200, "
             "-240 200, -240 297 10, -180 297")
INNER_RIM = ("-145 290 8, -145 254, 145 254, 145 290 8, 240 290, 240 200, "
             "-240 200, -240 290, -145 290")
# of which the cornering power is computed with other inputs
STUDIED = ("32x8.8 14PR", "18x4.4 6PR", "18x5.5 10PR", "49x17 26PR")


def read_table(path):
    """The rows of a CSV file with comments."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def find_row(rows, name):
    """The row of a tire."""
    return next(row for row in rows if row["name"] == name)


class Construction(BiasTire):
    """A tire by the rules, from a row of the table."""

    def __init__(self, row, diameter=None, plies=None):
        self.row = row
        number = {key: float(value) for key, value in row.items()
                  if key != "name" and value}
        self.load = number["rated_load_kN"]
        self.deflection = number["deflection_mm"]
        super().__init__(diameter or number["D_mm"], number["W_mm"],
                         number["flange_diameter_mm"] / 2, number["rim_width_mm"],
                         number["pressure_MPa"], plies)

    def slide(self):
        """The motion of the ground by which stiffnesses are computed."""
        return self.deflection / 100

    def settings(self):
        """The entries marked by a star in the parameter file."""
        meridian = "Surface/Cord equilibrium/"
        return {
            meridian + "Crown radius": f"{self.crown:.10g}",
            meridian + "Half width": f"{self.half_width:.10g}",
            meridian + "End radius": f"{self.end:.10g}",
            meridian + "End half width": f"{self.end_half_width:.10g}",
            "Laminate/Reference surface": f"ply {1 + self.plies // 2}",
            "Laminate/Plies": self.layup(),
            "Laminate/Layers": self.layers(),
            "Contact/Friction": f"{FRICTION}",
            "Stage 1/Pressure": f"{self.pressure:.10g}",
            "Stage 2/Pressure": f"{self.pressure:.10g}",
            "Stage 2/Travel": f"{self.deflection:.10g}",
            "Stage 3/Slide": f"0, {self.slide():.10g}, 0",
            "Stage 4/Slide": f"0, {self.slide():.10g}, {self.slide():.10g}",
        }

    def cornering_settings(self, deflection=1):
        """Those by which the loaded tire rolls freely, then with slip angles to
        both sides, at a deflection over the rated one. The tread is no ply but
        bristles."""
        settings = {
            **self.settings(),
            "Laminate/Plies": self.layup(tread=0),
            "Laminate/Layers": "one",
            "Contact/Tread/Height": f"{self.tread - AIRCRAFT.sidewall:.6g}",
            "Contact/Tread/Modulus": f"{AIRCRAFT.rubber}",
            "Contact/Regularization": "automatic",
            "Contact/Tangential regularization": "automatic",
            "Contact/Rolling friction": "bristles",
            "Stage 2/Friction": "0",
            "Stage 2/Travel": f"{deflection * self.deflection:.10g}",
            "Stage 3/Slide": "0, 0, 0",
            "Stage 4/Slide": "0, 0, 0",
            "Stage 5/Turn": "0",
            "Number of stages": "5",
        }
        stages = (("free", {"Ground velocity": "1"}),
                  ("left", {"Slip angle": f"{SLIP_ANGLE}"}),
                  ("right", {"Slip angle": f"{-SLIP_ANGLE}", "Start from": "3"}))
        for number, (name, entries) in enumerate(stages, start=3):
            for entry, value in {
                    "Name": name, "Contact": "true", "Glued": "false",
                    "Strain theory": "nonlinear", "Control": "axle moment",
                    **entries}.items():
                settings[f"Stage {number}/{entry}"] = value
        return settings


# ------------------------------------------------------------------ NASA TR R-64


def nasa(tire):
    """The formulas for force (kN), footprint length and width (mm), rolling
    radius (mm), lateral and fore-and-aft stiffness (kN/mm) and torsional
    stiffness (kN m per degree) at the rated pressure and deflection."""
    d, w, delta, p = tire.diameter, tire.width, tire.deflection, tire.pressure
    return (formulas.force(d, w, delta, p), formulas.footprint_length(d, delta),
            formulas.footprint_width(w, delta), formulas.rolling_radius(d, delta),
            formulas.lateral_stiffness(w, delta, p),
            formulas.longitudinal_stiffness(d, delta, p),
            formulas.torsional_stiffness(d, w, delta, p))


def nasa_cornering_power(tire, deflection=1):
    """Side force per slip angle, kN per degree, at the rated pressure."""
    return formulas.cornering_power(tire.diameter, tire.width,
                                    deflection * tire.deflection, tire.pressure)


# ---------------------------------------------------------------------- results


def run(arguments, name, settings):
    """The results of a run, which may stop early; None if it has no step. With
    --keep, those of an earlier run in which the tire was loaded."""
    directory = arguments.scratch / name.replace(" ", "_")
    if arguments.keep and (directory / "history.csv").exists():
        results = biface.Results(directory)
        if is_loaded(results, settings):
            return results
    try:
        results = biface.run(
            arguments.template, {"Output/Write VTU": False, **settings}, directory,
            program=arguments.program, may_stop=True)
    except biface.RunError as error:
        print(f"{name}: {error}", file=sys.stderr)
        return None
    if results.stopped:
        print(f"{name}: {results.stopped}", file=sys.stderr)
    return results


def load(arguments, name, settings):
    """The same, None if the tire could not be loaded."""
    results = run(arguments, name, settings)
    return results if results and is_loaded(results, settings) else None


def is_loaded(results, settings):
    """Whether the stage 'contact' has reached its end."""
    return ("contact" in results.stages and results.stage("contact").last("approach")
            > float(settings["Stage 2/Travel"]) * (1 - 1e-9))


def last_force(results):
    """The force of the loaded tire, in kN."""
    return results.stage("contact").last("force") / 1000


def stiffnesses(results, slide):
    """Lateral and fore-and-aft (kN/mm) and torsional (kN m per degree): changes
    from stage to stage, see the parameter file. NaN if a stage has failed."""
    lines = {line["stage"]: line
             for line in results.forces().where(body="foundation").rows()}
    log = (results.directory / "run.log").read_text(encoding="utf-8")
    if "did not converge" in log:
        # the last steps of the stage are missing
        lines.pop(list(lines)[-1])

    def change(stage, before, column):
        if stage not in lines or before not in lines:
            return math.nan
        return abs(lines[stage][column] - lines[before][column])

    return (change("lateral", "contact", "F_y") / slide / 1000,
            change("fore-aft", "lateral", "F_z") / slide / 1000,
            change("torsion", "fore-aft", "M_x") / TURN / 1e6)


def footprint(results):
    """Length and width of the contact zone."""
    contact = results.stage("contact")
    return [contact.last(f"footprint_{which}") for which in ("length", "width")]


def rolling_radius(results):
    """Of the tire that rolls freely; NaN if this stage has failed."""
    if results is None or results.rolling() is None:
        return math.nan
    free = results.rolling().where(stage="free")
    return free["rolling_radius"][0] if len(free) > 0 else math.nan


def cornering_power(results):
    """The slope of the secant between both slip angles, in kN per degree; NaN if
    a stage has failed."""
    if results is None or results.rolling() is None:
        return math.nan
    rolling = results.rolling()
    forces = dict(zip(rolling["slip_angle"], rolling["F_y"]))
    if not {-SLIP_ANGLE, SLIP_ANGLE} <= set(forces):
        return math.nan
    return (forces[-SLIP_ANGLE] - forces[SLIP_ANGLE]) / (2 * SLIP_ANGLE) / 1000


def compute_cornering(arguments, rows, varied):
    """For each row: construction, rolling radius and cornering power; then, for
    the row to be varied, the latter at each deflection."""
    def one(case):
        row, deflection = case
        tire = Construction(row)
        results = load(arguments, f"{row['name']} cornering {deflection:g}",
                       tire.cornering_settings(deflection))
        power = cornering_power(results)
        print(f"{row['name']:16} {deflection:g} of the deflection: cornering "
              f"power {power / nasa_cornering_power(tire, deflection):.3f} of "
              "NASA's", flush=True)
        return tire, rolling_radius(results), power

    cases = [(row, 1) for row in rows]
    cases += [(varied, deflection) for deflection in DEFLECTIONS]
    with ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(one, cases))
    return results[:len(rows)], [power for *_, power in results[len(rows):]]


def compute_bottoming(arguments, rows):
    """For each wall and rim of the tire of BOTTOMING: words, and how far it is
    pressed, the force, and that of the rim on the outer face, in mm and kN."""
    row = find_row(rows, BOTTOMING["name"])
    rim = {"Bodies": "rim, rim inside", "Stage 2/Bodies": "rim, rim inside",
           "Body rim inside/Face": "inner"}
    for body, profile in (("rim", OUTER_RIM), ("rim inside", INNER_RIM)):
        rim |= {f"Body {body}/Shape": "revolved", f"Body {body}/Axis": "0, 1, 0",
                f"Body {body}/Profile": profile}
    cells = []
    for name, words, entries in (
            ("no rim", "two layers", {}),
            ("stiffer cords", "two layers, cords with a tenth of their stiffness "
             "in compression", {"Material cord/E_L compression": "E_L/10"}),
            ("rim", "two layers, flanges", rim)):
        results = run(arguments, f"bottoming {name}", {
            **Construction(row).settings(), **entries, "Number of stages": "2",
            "Stage 2/Travel": "280", "Stage 2/Steps": "28"})
        on_rim = results.forces().where(body="rim")["F_x"] / 1000
        cells.append([words, f"{results.stage('contact').last('approach'):.0f}",
                      f"{last_force(results):.0f}",
                      f"{on_rim[-1]:.0f}" if len(on_rim) > 0 else ""])
    return cells


def bottoming_section(tire, cells):
    return "\n\n".join([
        "## Toward bottoming",
        fill(f"""
        The databook also has the load at which a tire bottoms: for {tire.row['name']}
        {BOTTOMING['load']:.0f} kN, three times the rated load, at a deflection of
        {tire.diameter / 2 - BOTTOMING['radius']:.0f} mm. Pressed on by 280 mm instead of
        {tire.deflection:.0f} mm in steps of 10 mm, also with a rim (`Bodies`) of two flanges, on
        whose edges the sidewall folds, and which the inner face can meet, the runs end at
        """),
        table(["Wall", "Deflection, mm", "Force, kN", "of it on the flanges, kN"],
              cells),
        fill("""
        None bottoms, and the crown does not meet the rim. The sidewall folds at its
        widest place beside the footprint: its inner face is compressed there by strains
        of -0.40 to -0.48, where a linear material has no stiffness left
        ([limits](limits.md)). With two layers and flanges the soft rubber of the sidewall is crushed
        before, between the flange and the clamped edge, by three quarters of its thickness. The
        last steps that were tried are 0.3 mm and less.
        """)])


def vary_cornering(arguments, rows):
    """For each case of other inputs: words, and for each tire of STUDIED force
    over rated load and cornering power over NASA's."""
    shear = {"Laminate/Transverse shear": "equilibrium"}
    cases = [
        ("by the rules", {}),
        ("cords as stiff in compression as in tension",
         {"Material cord/E_L compression": "E_L"}),
        ("cords with a tenth of their stiffness in compression",
         {"Material cord/E_L compression": "E_L/10"}),
        ("transverse shear from equilibrium", shear),
        ("rubber of 4 instead of 6 MPa", {"Material cord/E_rubber": "4",
                                          "Material rubber/E": "4",
                                          "Contact/Tread/Modulus": "4"})]

    def one(case):
        words, settings = case
        cells = [words]
        for name in STUDIED:
            tire = Construction(find_row(rows, name))
            results = load(
                arguments, f"{name} {words}",
                {**tire.cornering_settings(), **settings})
            power = cornering_power(results)
            cells.append(
                "failed" if math.isnan(power) else
                f"{power / nasa_cornering_power(tire):.2f} "
                f"({last_force(results) / tire.load:.2f})")
        print(" | ".join(cells), flush=True)
        return cells

    with ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(one, cases))


def mean_and_deviation(values):
    return statistics.mean(values), statistics.pstdev(values)


def fill(text):
    return "\n\n".join(textwrap.fill(" ".join(part.split()), 88)
                       for part in text.strip().split("\n\n"))


def compute(arguments, rows, wall="two layers"):
    """For each row: the construction, force, and footprint, rolling radius and
    stiffnesses; None where the run fails."""
    def one(row):
        tire = Construction(row)
        loaded = load(arguments, f"{row['name']} {wall}",
                        {**tire.settings(), **WALLS[wall]})
        if loaded is None:
            return tire, None, None
        result = (last_force(loaded),
                  [*footprint(loaded),
                   *stiffnesses(loaded, tire.slide())])
        print(f"{row['name']:16} {wall}, {tire.plies:3} plies, "
              f"{tire.curve.degrees:.1f} degrees, "
              f"{result[0] / tire.load:.3f} of the rated load", flush=True)
        return tire, *result

    with ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(one, rows))


def vary(arguments, row):
    """Lines of what-if: what one input does to the force of a tire."""
    tire = Construction(row)
    meridian = "Surface/Cord equilibrium/"
    cases = [("by the rules", tire.settings())]
    for column, words in (("D_min_mm", "least diameter of the databook"),
                          ("D_max_mm", "largest diameter")):
        cases.append((words, Construction(
            row, diameter=float(row[column])).settings()))
    for factor, words in ((0.5, "half the cord modulus"),
                          (2, "twice the cord modulus")):
        cases.append((words, {**tire.settings(), "Material cord/E_cord":
                              f"{factor * AIRCRAFT.cord.modulus}"}))
    for plies in (6, 12):
        cases.append((f"{plies} plies instead of {tire.plies}",
                      Construction(row, plies=plies).settings()))
    for angle in (35, 45):
        cases.append((f"crown cord angle of {angle}° instead of "
                      f"{tire.curve.degrees:.1f}°",
                      {**tire.settings(),
                       meridian + "Crown cord angle": f"{angle}",
                       meridian + "End half width": "from crown cord angle"}))
    cases.append(("dead instead of true pressure",
                  {**tire.settings(), "Loads/Pressure type": "dead"}))

    def one(case):
        results = load(arguments, "what if " + case[0].replace("°", ""),
                        case[1])
        return [case[0], "failed" if results is None else
                f"{last_force(results) / tire.load:.2f}"]

    with ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(one, cases))


def results_table(results, singles):
    lines = []
    for (tire, force, sizes), (_, single, _) in zip(results, singles):
        name = tire.row["name"]
        if force is None:
            lines.append([name, f"{tire.plies}", f"{tire.curve.degrees:.1f}",
                          f"{tire.load:.1f}", "failed", "", "", "", "", ""])
            continue
        nasa_force, length, width = nasa(tire)[:3]
        lines.append([
            name, f"{tire.plies}", f"{tire.curve.degrees:.1f}",
            f"{tire.load:.1f}", f"{force:.1f}", f"{force / tire.load:.3f}",
            "failed" if single is None else f"{single / tire.load:.3f}",
            f"{nasa_force / tire.load:.3f}",
            f"{sizes[0]:.0f} ({sizes[0] / length:.2f})",
            f"{sizes[1]:.0f} ({sizes[1] / width:.2f})"])
    return table(["Tire", "Plies", "Angle", "Rated load, kN", "Force, kN",
                  "Ratio", "One layer", "NASA", "Length, mm", "Width, mm"],
                 lines)


def stiffness_table(results, singles):
    def ratio(tire, sizes, i):
        return ("failed" if sizes is None or math.isnan(sizes[i]) else
                f"{sizes[i] / nasa(tire)[i + 2]:.2f}")

    lines = []
    for (tire, force, sizes), (_, _, single) in zip(results, singles):
        if force is not None:
            lines.append([tire.row["name"]] + [
                "failed" if math.isnan(sizes[i]) else
                f"{sizes[i]:.3g} ({ratio(tire, sizes, i)}; "
                f"{ratio(tire, single, i)})"
                for i in (2, 3, 4)])
    return table(["Tire", "Lateral, kN/mm", "Fore-and-aft, kN/mm",
                  "Torsional, kN m per degree"], lines)


def cornering_table(cornering):
    lines = []
    for tire, radius, power in cornering:
        law = nasa_cornering_power(tire)
        lines.append([
            tire.row["name"], f"{tire.deflection / tire.diameter:.4f}",
            "failed" if math.isnan(radius) else
            f"{radius:.1f} ({radius / nasa(tire)[3]:.3f})",
            "failed" if math.isnan(power) else f"{power:.3g}", f"{law:.3g}",
            "" if math.isnan(power) else f"{power / law:.2f}"])
    return table(["Tire", "Deflection/D", "Rolling radius, mm",
                  "Cornering power, kN per degree", "NASA", "Ratio"], lines)


def deflection_table(tire, powers):
    """What the deflection does to the cornering power."""
    lines = []
    for deflection, power in zip(DEFLECTIONS, powers):
        law = nasa_cornering_power(tire, deflection)
        lines.append([
            f"{deflection:g}",
            f"{deflection * tire.deflection / tire.diameter:.4f}",
            "failed" if math.isnan(power) else f"{power:.3g}", f"{law:.3g}",
            "" if math.isnan(power) else f"{power / law:.2f}"])
    return table(["Over the rated deflection", "Deflection/D",
                  "Cornering power, kN per degree", "NASA", "Ratio"], lines)


def cornering_inputs(studied):
    """What an input does to the cornering power, see vary_cornering()."""
    return "\n\n".join([
        fill("""
        What the cornering power depends on, as the ratio to NASA's; in parentheses
        the force over the rated load:
        """),
        table(["Input", *STUDIED], studied),
        fill("""
        Cords in compression do most: in the footprint, where the carcass bends flat,
        some are compressed, and if they are as stiff as in tension, the tire is too
        stiff for a side force. Their modulus in compression is not known from the
        databook; with a tenth of that in tension in place of a hundredth the
        cornering power is 13 to 21 % larger. The modulus of the rubber is an estimate, too.
        """)])


def cornering_section(cornering, powers, studied, varied):
    """The section on the rolling tire, and the words that sum it up."""
    tire = next(tire for tire, *_ in cornering if tire.row["name"] == varied)
    good = [(tire, radius, power) for tire, radius, power in cornering
            if not math.isnan(power)]
    ratios = [power / nasa_cornering_power(tire) for tire, _, power in good]
    within = sum(abs(ratio - 1) <= 0.25 for ratio in ratios)
    radii = in_words([radius / nasa(tire)[3] for tire, radius, _ in good], 3)
    return "\n\n".join([
        "## Rolling radius and cornering power",
        fill(f"""
        The loaded tire rolls freely, then with the slip angles {SLIP_ANGLE}° and
        -{SLIP_ANGLE}°, without inertia. Its tread is bristles (`Contact/Tread`) of
        the same height and rubber instead of a ply, and the coefficient of friction
        is {FRICTION} as above: no number is added to the rules. {len(good)} of
        {len(cornering)} runs converge.

        The rolling radius is {radii} of NASA's, D/2 less a third of the deflection,
        in parentheses. It is that of the outer face of the carcass, on which the
        bristles stand. The cornering power, the difference of the side forces over
        that of the angles, is {in_words(ratios)} of NASA's
        C (p + 0.44 p_r) W² (1.2 δ/D - 8.8 (δ/D)²) with C = 57 per radian and the
        rated pressure p_r: {within} of {len(good)} tires are within 25 %. Beyond
        δ/D = 0.0875 the law continues along its tangent. Tires with a large ratio
        have one of the lateral stiffness above, too: a side force bends the same
        carcass.
        """),
        cornering_table(cornering),
        cornering_inputs(studied),
        fill(f"""
        With the deflection of {varied} the cornering power first grows and then
        falls. NASA's law has its maximum at δ/D = 0.068:
        """),
        deflection_table(tire, powers)])


def in_words(values, digits=2):
    """Mean and deviation."""
    mean, deviation = mean_and_deviation(values)
    return f"{mean:.{digits}f} ± {deviation:.{digits}f}"


def stiffness_ratio(results, i):
    """Mean and deviation, in words, of the ratio of a stiffness to NASA's."""
    return in_words([sizes[i] / nasa(tire)[i + 2] for tire, force, sizes in results
                     if force is not None and not math.isnan(sizes[i])])


def summary(results):
    """Mean and deviation of the ratios, in words."""
    good = [(tire, force, sizes) for tire, force, sizes in results
            if force is not None]
    ratio = mean_and_deviation([force / tire.load for tire, force, _ in good])
    law = mean_and_deviation([nasa(tire)[0] / tire.load for tire, _, _ in good])
    length = mean_and_deviation(
        [sizes[0] / nasa(tire)[1] for tire, _, sizes in good])
    width = mean_and_deviation(
        [sizes[1] / nasa(tire)[2] for tire, _, sizes in good])
    return len(good), ratio, law, length, width


def page(results, singles, equilibrium, variations, cornering, varied, bottoming):
    _, single_ratio, _, _, _ = summary(singles)
    n_equilibrium, equilibrium_ratio, _, _, _ = summary(equilibrium)
    n, ratio, law, length, width = summary(results)
    failed = [tire.row["name"] for tire, force, _ in results if force is None]
    least = min((f / t.load, t.row["name"]) for t, f, _ in results if f)
    most = max((f / t.load, t.row["name"]) for t, f, _ in results if f)
    return "\n\n".join([
        "<!-- Written by doc/real_tires/real_tires.py: cmake --build build "
        "--target real_tires -->",
        "# Real tires",
        fill(f"""
        A databook says little about a tire: outside diameter and width when
        inflated, rim, ply rating, pressure, rated load and loaded radius.
        [aircraft_tire.prm](../prm/aircraft_tire.prm) computes a bias-ply aircraft
        tire from these words. This page does it for the {len(results)} tires of
        [aircraft_tires.csv](../source/python/biface_tire/aircraft_tires.csv) and compares the
        force at the rated deflection with the rated load. The rules below are
        the same for all tires, and none of them is fitted to a load.
        """),
        "## Rules",
        "\n".join("- " + textwrap.fill(" ".join(rule.split()), 86,
                                       subsequent_indent="  ")
                  for rule in (
            """The middle of the carcass is the meridian `cord equilibrium`: its
            crown radius is D/2 less the tread and half the carcass, its half
            width W/2 less the sidewall and half the carcass. It ends at the
            radius of the rim flange, at half the rim width less half the carcass
            and 2 mm. The cord angle follows.""",
            f"""The smallest even number of plies for which the force of a cord at the
            burst pressure, {BURST} times the rated one, is at most
            {AIRCRAFT.cord.strength} N, by the netting formula of
            [theory.md](theory.md), section 1.""",
            f"""Nylon 840/2 cords: modulus {AIRCRAFT.cord.modulus} MPa, diameter
            {AIRCRAFT.cord.diameter} mm, distance {AIRCRAFT.cord.pitch} mm at the crown, in
            plies of {AIRCRAFT.cord.ply} mm; rubber of {AIRCRAFT.rubber} MPa. Cords buckle: in compression
            a ply has a hundredth of its stiffness along them.""",
            f"""Liner {AIRCRAFT.liner} mm, sidewall {AIRCRAFT.sidewall} mm, tread 4 mm + 0.022 W over the
            middle 40 % of the section, tapering to the sidewall at 60 %.""",
            """Two layers: the sidewall with the tread, and all plies inside it. The
            tread shears in series with the carcass.""",
            """Turn-ups: half the plies again on the outer 30 % of each side. The
            ends are clamped.""",
            f"""The known shape is that under pressure (`Start from prestress`).
            True pressure; the ground is pressed on with the coefficient of friction
            {FRICTION}. Without it, rubber of this modulus, which is a linear material,
            is squeezed out of the footprint of the smallest tires at high pressure:
            18x4.4 12PR then stops short of its deflection.""")),
        "## Results",
        fill(f"""
        The force over the rated load is {ratio[0]:.3f} in the mean, with a
        standard deviation of {ratio[1]:.3f}, from {least[0]:.2f} ({least[1]}) to
        {most[0]:.2f} ({most[1]}); {n} of {len(results)} runs
        {'converge' if not failed else 'converge, not ' + ', '.join(failed)}. The
        empirical formulas of [NASA TR R-64](references.bib#SmileyHorne1958) give
        {law[0]:.3f} and {law[1]:.3f} for the same tires. The length of the
        footprint is {length[0]:.2f} ± {length[1]:.2f} and its width
        {width[0]:.2f} ± {width[1]:.2f} of theirs, which are in parentheses in
        the table; they are measured to the line of zero clearance. The width depends on the
        profile of the tread, of which the databook says nothing.
        """),
        fill(f"""
        With all plies in one layer (`Laminate/Layers = one`), the ratio beside it in
        the table, it is {single_ratio[0]:.3f} and {single_ratio[1]:.3f}; with two
        layers and `Transverse shear = equilibrium` {equilibrium_ratio[0]:.3f} and
        {equilibrium_ratio[1]:.3f}, where {n_equilibrium} of {len(equilibrium)} runs
        converge.
        """),
        results_table(results, singles),
        "## Stiffness of the loaded tire",
        fill(f"""
        The ground slides by 1 % of the deflection along the axle, then along the
        tread, and turns by 0.2°; the nodes in contact do not slip. In parentheses: relative to
        NASA's formulas, and the same with all plies in one layer. The mean ratios are
        {stiffness_ratio(results, 2)} (lateral), {stiffness_ratio(results, 3)}
        (fore-and-aft) and {stiffness_ratio(results, 4)} (torsional); with one layer
        {stiffness_ratio(singles, 2)}, {stiffness_ratio(singles, 3)} and
        {stiffness_ratio(singles, 4)}; with the shear strains from equilibrium
        {stiffness_ratio(equilibrium, 2)}, {stiffness_ratio(equilibrium, 3)} and
        {stiffness_ratio(equilibrium, 4)}. A tread in series with the carcass turns more
        easily. That the layers hardly change the other two has two reasons: the
        tread is in series, but it keeps its shear modulus G under the
        contact pressure p, where that of a single layer of a linear material is G - p.
        Measured stiffnesses are secants
        over larger displacements, in which a part of the footprint slips, so
        that they are lower than those without slip. A stage that does not
        converge would be marked as failed.
        """),
        stiffness_table(results, singles),
        cornering_section(*cornering, varied),
        bottoming_section(next(tire for tire, *_ in results
                               if tire.row["name"] == BOTTOMING["name"]), bottoming),
        "## What an input does",
        fill(f"""
        The databook has ranges instead of numbers, and says nothing about the
        inside. For {varied} the force over the rated load is
        """),
        table(["Input", "Ratio"], variations),
        fill("""
        With the diameter the number of plies may change, too.
        """),
        "## Another tire",
        fill("""
        A row of the same columns in another file is computed by the same rules:
        """),
        "```sh\npython3 doc/real_tires/real_tires.py --program build/biface "
        "--tires my_tires.csv\n```",
    ]) + "\n"


def main():
    here = Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--template", default=here.parents[1] /
                        "prm/aircraft_tire.prm")
    parser.add_argument("--tires", type=Path, help="another table of tires")
    parser.add_argument("--only", action="append", default=[],
                        help="only rows of this name")
    parser.add_argument("--scratch", type=Path, default=Path("real_tires_runs"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", action="store_true",
                        help="use complete results of earlier runs")
    parser.add_argument("--output", type=Path,
                        help="where to write real_tires.md")
    arguments = parser.parse_args()
    arguments.scratch = arguments.scratch.resolve()
    arguments.scratch.mkdir(parents=True, exist_ok=True)

    rows = read_table(arguments.tires) if arguments.tires else read_databook()
    if arguments.only:
        rows = [row for row in rows if row["name"] in arguments.only]
    results = compute(arguments, rows)
    if any(force is not None for _, force, _ in results):
        n, ratio, _, length, width = summary(results)
        print(f"{n} of {len(results)} runs converge; force over rated load "
              f"{ratio[0]:.3f} +- {ratio[1]:.3f}, footprint length "
              f"{length[0]:.3f} +- {length[1]:.3f}, width {width[0]:.3f} +- "
              f"{width[1]:.3f} of NASA's")
    if arguments.output:
        varied = "32x8.8 14PR"
        row = find_row(rows, varied)
        variations = vary(arguments, row)
        cornering = (*compute_cornering(arguments, rows, row),
                     vary_cornering(arguments, rows))
        (arguments.output / "real_tires.md").write_text(
            page(results, compute(arguments, rows, "one layer"),
                 compute(arguments, rows, "equilibrium"), variations, cornering,
                 varied, compute_bottoming(arguments, rows)), encoding="utf-8")
    return 0 if all(force is not None for _, force, _ in results) else 1


if __name__ == "__main__":
    sys.exit(main())
