#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare tires and cylinders with published values, and write measured_tires.md."""

import json
import math
import os
import re
import subprocess
import sys
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
sys.path.insert(0, str(HERE.parent / "real_tires"))
from example_page import EXAMPLES, biface, parse_arguments, table
import radial_tire
from biface_tire.radial import RadialTire
from biface_tire.size import read_databook
from real_tires import Construction, find_row, read_table

QUIET = {"Output/Write VTU": False}


class Enough(Exception):
    """A step is the last one that is needed."""


def run_until(file, entries, directory, program, may_stop, until):
    """The results of a run, which ends early after a step whose line fits."""
    def watch(line):
        if until(line):
            raise Enough

    try:
        return biface.run(file, entries, directory, program=program, may_stop=may_stop,
                          progress=watch if until else False)
    except Enough:
        return biface.Results(directory)


# ------------------------------------------------------------------- the radial tire

# MF-Tyre's example of a 205/60 R15, 0.22 MPa, 4000 N [TNO2013]: stiffnesses in N/mm,
# N m per rad and frequencies in Hz as in the file, the rest evaluated from it
PUBLISHED = {
    "deflection": {0.18: 23.12, 0.22: 20.31, 0.26: 18.12},
    "vertical": {0.18: 185.7, 0.22: 209.7, 0.26: 233.6},
    "lateral": 157.6, "longitudinal": 381.9, "turn": 5000,
    "length": 136.8, "width": 142.8, "mass": 9.3,
    "frequencies": {"lateral": 41.47, "yaw": 53.46, "wind-up": 67.73,
                    "longitudinal": 76.63},
    "cornering": 930, "other cornering": 803}
LOAD, PRESSURE = 4000, 0.22
SHORT_CELLS = {"Mesh/Intervals alpha_2": "-180:-22:48:smooth, -22:22:48, 22:180:48:smooth"}
SLIP_ANGLE = 0.5


def radial_settings(tire, directory, tread=True):
    """The entries of prm/radial_tire.prm for a tire by the rules."""
    directory.mkdir(parents=True, exist_ok=True)
    radial_tire.write(tire, directory, tread=tread)
    return {"Surface/Spline/File": directory / "radial_tire_profile.csv",
            "Laminate/Plies file": directory / "radial_tire_plies.csv",
            **tire.settings()}


def secant(results, stage):
    """The stiffness of the glued footprint in a stage; NaN if there is none."""
    rows = results.stiffness().where(stage=stage)
    return rows["secant"][-1] if len(rows) > 0 else math.nan


def name_modes(modes):
    """Frequencies of the ring that moves as one: by the waves around the axle, the
    effective masses, and the order of the rest. For the tire by the rules
    biface-tire-model finds the same by the shapes."""
    total = modes["total_mass"][0]
    along = {axis: modes[f"effective_mass_{axis}"] / total for axis in "xyz"}
    waves = modes["circumferential_waves"]
    radial = along["x"] + along["z"] > 0.5

    def first(chosen):
        return modes["frequency"][chosen][0] if chosen.any() else math.nan

    lateral = along["y"] > 0.5
    return {"lateral": first(lateral),
            "yaw": first((waves == 1) & ~radial),
            "wind-up": first((waves == 0) & ~lateral),
            "longitudinal": first(radial)}


def loaded_tire(run, name, entries, loaded="load"):
    """What is compared, of a run of the shipped stages."""
    results = run(name, "radial_tire.prm", entries)
    stage = results.stage(loaded)
    vertical = results.stiffness().where(stage=loaded, motion="approach")
    result = {"deflection": stage.last("approach"),
              "force": stage.last("force"),
              "vertical": vertical["tangent"][-1],
              "length": stage.last("footprint_length"),
              "width": stage.last("footprint_width"),
              "area": stage.last("footprint_area"),
              "curve": [list(stage.history["approach"]), list(stage.history["force"])],
              "lateral": secant(results, "lateral"),
              "longitudinal": secant(results, "longitudinal"),
              # from N mm per degree
              "turn": math.degrees(secant(results, "turn")) / 1000}
    modes = results.modes()
    if modes is not None and len(modes) > 0:
        result["frequencies"] = name_modes(modes)
        result["mass"] = modes["total_mass"][0] * 1000
    return result


def at_pressure(run, pressure):
    """The tire loaded at another pressure than that of its shape."""
    return loaded_tire(run, f"radial {pressure}", {
        "Number of stages": 4, "Stage 2/Modes": 0,
        "Stage 3/Name": "pressure", "Stage 3/Contact": False, "Stage 3/Control": "load",
        "Stage 3/Force": 0, "Stage 3/Pressure": pressure, "Stage 3/Steps": 1,
        "Stage 4/Name": "load", "Stage 4/Contact": True, "Stage 4/Glued": False,
        "Stage 4/Control": "foundation force", "Stage 4/Force": LOAD,
        "Stage 4/Slide": "unchanged", "Stage 4/Steps": 4})


# resonances of a 205/60 R15 at 0.16 MPa that hangs free with its rim [Vervoort2007], Hz
HUNG = (114, 137, 165, 196, 228, 260)
WAVES = range(2, 8)


def hung(run):
    """Frequencies in Hz of the radial modes by the waves around the axle. A wheel that
    waves twice or more often around exerts no force on its rim, fixed or free."""
    modes = run("radial hung", "radial_tire.prm", {
        # fine enough for the waves, and for a stable state
        "Mesh/Intervals alpha_2": "-180:180:144",
        "Number of stages": 3, "Stage 2/Modes": 0,
        "Stage 3/Name": "hung", "Stage 3/Contact": False, "Stage 3/Glued": False,
        "Stage 3/Control": "load", "Stage 3/Force": 0, "Stage 3/Slide": "unchanged",
        "Stage 3/Pressure": 0.16, "Stage 3/Steps": 1, "Stage 3/Modes": 40}).modes()
    # sidewalls and tread move in turn, both sides alike
    return {str(n): float(modes.where(circumferential_waves=n,
                                 meridional_half_waves=3)["frequency"][0]) for n in WAVES}


def with_bristles(scratch):
    """The entries of the tire by the rules whose tread is bristles in place of a ply."""
    tire = RadialTire()
    return {**radial_settings(tire, scratch / "no tread", tread=False),
            "Laminate/Layers": "one", "Contact/Tread/Height": tire.tread_height - 0.5,
            "Contact/Tread/Modulus": 3.35}


def cornering(run, bristles):
    """N per degree: the secant of the side force at two slip angles. Rolling has no
    inertia."""
    entries = {
        **bristles, "Number of stages": 6, "Stage 2/Modes": 0,
        "Contact/Regularization": "automatic",
        "Contact/Tangential regularization": "automatic",
        "Contact/Multiplier mass": "lumped", "Contact/Rolling friction": "bristles",
        "Stage 3/Friction": 0}
    free = {"Contact": True, "Glued": False, "Friction": "", "Slide": "unchanged",
            "Turn": "unchanged", "Control": "foundation force and axle moment",
            "Force": LOAD}
    for number, (name, more) in enumerate((
            ("free", {"Ground velocity": 1, "Start from": 3}),
            ("left", {"Slip angle": SLIP_ANGLE, "Start from": 4}),
            ("right", {"Slip angle": -SLIP_ANGLE, "Start from": 4})), start=4):
        for entry, value in {"Name": name, **free, **more}.items():
            entries[f"Stage {number}/{entry}"] = value
    rolling = run("radial cornering", "radial_tire.prm", entries).rolling()
    force = dict(zip(rolling["stage"], rolling["F_y"]))
    return {"cornering": (force["right"] - force["left"]) / (2 * SLIP_ANGLE),
            "radius": rolling.where(stage="free")["rolling_radius"][-1]}


# of the tire tests from which the .tir files are: degrees, and slip ratios
SLIP = {"Slip angles": "-8, -4, -1.5, 1.5, 4, 8",
        "Slip ratios": "-0.15, -0.06, -0.02, 0.02, 0.06, 0.15", "Slip": "combined"}
# parts of the nominal load, and degrees
RADIAL_TEST = {"Loads": (0.5, 0.75, 1), "Inclination angles": (0, 4)}
# the tire of prm/aircraft_tire.prm, and parts of its rated load
AIRCRAFT = "49x17 26PR"
AIRCRAFT_TEST = {"Loads": (0.5, 0.75), "Inclination angles": (0,)}


def tested(test, load, velocity, entries):
    """The entries of a tire test of a tire with a tread of bristles, after two stages."""
    return {**entries, "Number of stages": 2,
            "Contact/Regularization": "automatic",
            "Contact/Tangential regularization": "automatic",
            "Contact/Multiplier mass": "lumped", "Contact/Rolling friction": "bristles",
            "Contact/Friction": 0.8,
            # a point that is not reached is left out
            "Step control/Maximum cuts": 2,
            "Tire test/Loads": ", ".join(f"{part * load:.6g}" for part in test["Loads"]),
            "Tire test/Inclination angles":
                ", ".join(str(angle) for angle in test["Inclination angles"]),
            "Tire test/Ground velocity": velocity,
            **{f"Tire test/{entry}": value for entry, value in SLIP.items()}}


def fit(test, structure, load, path):
    """Writes a .tir file, and returns what the fit prints."""
    return subprocess.run(
        [sys.executable, "-m", "biface_tire_model", "fit", test.directory,
         "--format", "6.1", "--nominal-load", f"{load:.6g}", "--output", path,
         *(word for part in structure for word in ("--structure", part.directory))],
        env={**os.environ, "PYTHONPATH": str(HERE.parents[1] / "source/python")},
        check=True, stdout=subprocess.PIPE, text=True).stdout


def radial_model(run, bristles, output):
    """The fit of the .tir file of the radial tire."""
    bristles = {**bristles, "Stage 2/Modes": 0}
    test = run("test radial", "radial_tire.prm",
               tested(RADIAL_TEST, LOAD, 16700, bristles), may_stop=True)
    # stiffnesses of the same tread, and frequencies with its mass
    structure = [run("radial standing", "radial_tire.prm", bristles),
                 # short cells all around: long ones split the pairs of modes
                 run("radial vibrating", "radial_tire.prm",
                     {"Number of stages": 2, "Output/Write VTU": True, **SHORT_CELLS})]
    return fit(test, structure, LOAD, output / "radial_tire.tir")


def aircraft_tire():
    """The tire of the .tir file, and its entries with a tread of bristles in place of
    a ply, in the shape under pressure."""
    tire = Construction(find_row(read_databook(), AIRCRAFT))
    return tire, {**{entry: value for entry, value in tire.cornering_settings().items()
                     if not entry.startswith("Stage") or entry == "Stage 1/Pressure"},
                  "Stage 2/Pressure": f"{tire.pressure:.10g}"}


def aircraft_model(run, output):
    """The fit of the .tir file of an aircraft tire. Rolling has no inertia."""
    tire, bristles = aircraft_tire()
    # N, at which the stiffnesses are taken
    load = 1000 * tire.load * AIRCRAFT_TEST["Loads"][-1]
    test = run("test aircraft", "aircraft_tire.prm",
               tested(AIRCRAFT_TEST, 1000 * tire.load, 10000,
                      {**bristles, "Stage 2/Name": "inflated", "Stage 2/Contact": False,
                       "Stage 2/Travel": "unchanged", "Stage 2/Steps": 1}),
               may_stop=True)
    standing = run("aircraft standing", "aircraft_tire.prm", {
        **bristles, "Stage 2/Control": "foundation force", "Stage 2/Force": f"{load:.6g}",
        "Stage 2/Travel": "unchanged"})
    return fit(test, [standing], load, output / "aircraft_tire.tir")


def radial_variants(run, scratch):
    """What other inputs do."""
    cords = {"Material carcass/E_L compression": "E_L"}
    cases = [
        ("by the rules", {}, {}),
        ("carcass cords of 2000 instead of 1289 N", {}, {"Material carcass/E_cord": 6845}),
        ("carcass cords as stiff in compression as in tension", {}, cords),
        ("rubber of the sidewall 6 instead of 3 MPa", {}, {"Material sidewall/E": 6}),
        ("sidewall 4 instead of 2.5 mm", {"sidewall": 4}, {}),
        ("apex 50 instead of 30 mm over the rim", {"apex": 49.9}, {}),
        ("belts at 20 instead of 24°", {"belt_angle": 20}, {}),
        ("tread of 8 instead of 5 MPa", {}, {"Material tread/E": 5.36}),
        ("cells half as long around the axle", {}, SHORT_CELLS)]
    results = []
    for words, rules, entries in cases:
        directory = scratch / "radial" / words.replace(" ", "_")
        tire = RadialTire(**rules)
        results.append((words, loaded_tire(run, f"radial {words}", {
            **radial_settings(tire, directory), **entries})))
        print(words, flush=True)
    return results


# ------------------------------------------------------------ aircraft tires, deeper


def deep_tires(run):
    """Tires of the databook under twice the rated load."""
    results = []
    bottoming = {row["name"]: row for row in read_table(HERE / "bottoming.csv")}
    for row in read_databook():
        tire = Construction(row)

        def is_enough(line, load=2000 * tire.load):
            force = re.search(r"force ([0-9.e+]+)", line)
            return force is not None and float(force[1]) >= load

        radius = float(bottoming[row["name"]]["radius_mm"])
        loaded = run(f"twice {row['name']}", "aircraft_tire.prm", {
            **tire.settings(), "Number of stages": 2,
            "Stage 2/Travel": f"{tire.diameter / 2 - radius:.10g}", "Stage 2/Steps": 20},
            may_stop=True, until=is_enough)
        history = loaded.history
        force = history["force"] / 1000
        last = min(force[-1], 2 * tire.load)
        results.append({
            "name": row["name"], "rated": tire.load, "deflection": tire.deflection,
            "bottoming load": float(bottoming[row["name"]]["load_kN"]),
            "bottoming": tire.diameter / 2 - radius,
            "force": last, "approach": float(np.interp(last, force, history["approach"])),
            "at rated": float(np.interp(tire.load, force, history["approach"]))})
        print(row["name"], f"{results[-1]['force'] / tire.load:.2f} of the rated load, "
              f"{results[-1]['approach']:.1f} mm", flush=True)
    return results


# ------------------------------------------------------------------------ cylinders

# of the shipped file: what is a step of the shortening, in mm
SHORTENING, STEPS, CUTS = 0.5, 10, 4
STIFFNESS = 74  # kN/mm, of the perfect one
WALL = 0.5
DAMPING = 1e-5  # MPa/mm
FINE = {"Mesh/Intervals alpha_1": "0:510:108", "Mesh/Intervals alpha_2": "-180:180:288"}
NO_IMPERFECTION = {"Surface/Imperfection/Formula": "0"}
PREDICTION = {**NO_IMPERFECTION, "Stage 1/Load factor": 0.02, "Stage 1/Steps": 1,
              "Stage 1/Buckling": 2}


def is_unstable(line):
    """Whether the step of a line has passed a critical point."""
    return "negative pivot" in line


def axial_force(results):
    """kN, in each step."""
    return -results.forces().where(body="alpha_1 max")["F_y"] / 1000


def cylinder(run):
    """Forces in kN: predicted for the perfect cylinder, and the largest with each
    imperfection."""
    result = {}
    for name, mesh in (("coarse", {}), ("fine", FINE)):
        predicted = run(f"cylinder {name}", "imperfect_cylinder.prm",
                        {**PREDICTION, **mesh})
        result[name] = axial_force(predicted)[0] * predicted.buckling()["factor"][0]
        if name == "coarse":
            waves = predicted.buckling()
            result["waves"] = [int(waves["circumferential_waves"][0]),
                               int(waves["meridional_half_waves"][0])]
            shape = predicted.directory / "buckling-0001-001.csv"
    inside_out = run("cylinder inside out", "imperfect_cylinder.prm", {
        **PREDICTION, "Laminate/Plies": "carbon: 0.125 @ -+41, carbon: 0.125 @ -+24"})
    result["inside out"] = (axial_force(inside_out)[0]
                            * inside_out.buckling()["factor"][0])

    def collapse(name, entries):
        steps = run(f"cylinder {name}", "imperfect_cylinder.prm", {
            "Stage 1/Steps": STEPS, "Stage 1/Load factor": 1,
            "Stage 1/Critical points": "locate", "Stage 1/Buckling": 0,
            "Newton/Maximum iterations": 10, "Step control/Maximum cuts": CUTS, **entries},
            may_stop=True, until=is_unstable)
        print(f"cylinder {name}: {axial_force(steps).max():.2f} kN", flush=True)
        return axial_force(steps).max()

    result["shape"] = [(part, collapse(f"shape {part}", {
        "Surface/Imperfection/Tables": f"shape: {shape}",
        "Surface/Imperfection/Formula": f"{part * WALL}*shape"}))
        for part in (0.05, 0.5)]
    dent = "exp(-((alpha_1 - 255)^2 + (250*pi/180*alpha_2)^2)/325)"
    result["dent"] = [(part, collapse(f"dent {part}", {
        "Surface/Imperfection/Formula": f"{-part * WALL}*{dent}"}))
        for part in (0.2, 0.5, 1)]

    def pushed(force, compression):
        """The entries of a run in which a force comes before the compression."""
        return {**NO_IMPERFECTION, "Named points": "middle: 255 0",
                "Loads/Point forces": f"middle: {-force} 0 0",
                "Number of stages": 2, "Stage 1/Name": "push", "Stage 1/Steps": 2,
                "Stage 1/Load factor": 0, "Stage 1/Load factors": "point forces: 1",
                "Stage 2/Name": "compression", "Stage 2/Steps": STEPS,
                "Stage 2/Load factor": 1, "Stage 2/Load factors": "point forces: 1",
                **{f"Stage 2/{entry}": value for entry, value in compression.items()}}

    result["push"] = [(force, collapse(f"push {force}",
                                       pushed(force, {"Critical points": "locate"})))
                      for force in (2, 5, 10)]
    # beyond the first instability, with damping, up to a shortening at which
    # the perfect cylinder carries 20 kN
    result["beyond"] = []
    for force in (5, 10):
        steps = run(f"cylinder beyond {force}", "imperfect_cylinder.prm", {
            **pushed(force, {"Load factor": 0.55, "Steps": 22, "Damping": DAMPING}),
            "Stage 1/Buckling": 0, "Stage 1/Critical points": "report",
            "Newton/Maximum iterations": 15, "Step control/Maximum cuts": 6},
            may_stop=True)
        result["beyond"].append((force, axial_force(steps).max()))
        print(f"cylinder beyond {force}: {result['beyond'][-1][1]:.2f} kN", flush=True)
    return result


# ----------------------------------------------------------------------------- page

# MF-Tyre's example: deflections in mm under 2, 3 and 4 kN, evaluated from the file
CURVES = {0.18: (11.98, 17.64, 23.12), 0.22: (10.49, 15.47, 20.31),
          0.26: (9.32, 13.78, 18.12)}


def fill(text):
    """Paragraphs of lines; links are not broken."""
    text = re.sub(r"\[[^\]]*\]\([^)]*\)",
                  lambda link: " ".join(link[0].split()).replace(" ", "\0"), text)
    return "\n\n".join(textwrap.dedent(part) if part.lstrip().startswith("|") else
                       textwrap.fill(" ".join(part.split()), 100, break_on_hyphens=False,
                                     break_long_words=False)
                       for part in textwrap.dedent(text).strip().split("\n\n")).replace("\0", " ")


def compared(words, computed, published, form=".0f"):
    return [words, format(computed, form), format(published, form),
            f"{100 * (computed / published - 1):+.0f} %"]


def draw(path, data):
    """The section of the tire, and load over deflection."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, (section, curve) = plt.subplots(1, 2, figsize=(9.5, 3.9))
    tire = RadialTire()
    points, lengths = tire.profile()
    section.plot(points[:, 1], points[:, 0], "k", linewidth=1, label="carcass")
    normals = np.gradient(points, axis=0)
    normals = np.column_stack([normals[:, 1], -normals[:, 0]])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    at = np.abs(lengths - lengths[-1] / 2)
    on_tread = np.clip((tire.tread_edge + tire.taper - at) / tire.taper, 0, 1)
    belts = np.where(at < tire.half_belts()[0], 2 * tire.belt + tire.cap, 0)
    outer = tire.sidewall + 0.2 + (tire.tread_height - tire.sidewall - 0.2) * on_tread
    for height, color, name in ((belts, "C3", "belts and cap"),
                                (belts + outer, "0.6", "sidewall, tread")):
        shifted = points + height[:, None] * normals
        section.plot(shifted[:, 1], shifted[:, 0], color=color, linewidth=1, label=name)
    section.set_aspect("equal")
    section.set_xlabel("y, mm")
    section.set_ylabel("radius, mm")
    section.legend(fontsize=8)
    curves = {0.22: data["variants"][0][1]["curve"],
              0.18: data["pressures"][0]["curve"], 0.26: data["pressures"][1]["curve"]}
    for number, (pressure, (approach, force)) in enumerate(sorted(curves.items())):
        curve.plot([0, *approach], [0, *np.array(force) / 1000], color=f"C{number}",
                   label=f"{pressure} MPa")
        curve.plot(CURVES[pressure], (2, 3, 4), "o", color=f"C{number}", markersize=4)
    curve.set_xlabel("deflection, mm")
    curve.set_ylabel("load, kN")
    curve.legend(fontsize=8, title="dots: published", title_fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def radial_section(data):
    rules = data["variants"][0][1]
    published = PUBLISHED
    lower, higher = data["pressures"]
    at_rules = [pressure["force"] for pressure in (lower, higher)]
    assert np.allclose(at_rules, LOAD, rtol=1e-4)

    def load_at(case, deflection):
        return np.interp(deflection, [0, *case["curve"][0]], [0, *case["curve"][1]])

    deflection = higher["deflection"]
    slope = (load_at(higher, deflection) - load_at(lower, deflection)) / 0.08
    part = slope * PRESSURE / load_at(rules, deflection)
    rows = [
        compared("deflection, mm", rules["deflection"], published["deflection"][0.22], ".1f"),
        compared("vertical stiffness, N/mm", rules["vertical"], published["vertical"][0.22]),
        compared("lateral stiffness, N/mm", rules["lateral"], published["lateral"]),
        compared("longitudinal stiffness, N/mm", rules["longitudinal"],
                 published["longitudinal"]),
        compared("torsional stiffness, N m/rad", rules["turn"], published["turn"]),
        compared("length of the footprint, mm", rules["length"], published["length"]),
        compared("width of the footprint, mm", rules["width"], published["width"]),
        *(compared(f"frequency, {name}, Hz", rules["frequencies"][name], frequency, ".1f")
          for name, frequency in published["frequencies"].items()),
        compared("cornering stiffness, N/degree", data["cornering"]["cornering"],
                 published["cornering"]),
        compared("mass, kg", rules["mass"], published["mass"], ".1f"),
        compared("deflection at 0.18 MPa, mm", lower["deflection"],
                 published["deflection"][0.18], ".1f"),
        compared("deflection at 0.26 MPa, mm", higher["deflection"],
                 published["deflection"][0.26], ".1f")]
    variants = []
    for words, case in data["variants"]:
        frequencies = case["frequencies"]
        variants.append([
            words, f"{case['deflection']:.1f}", f"{case['vertical']:.0f}",
            f"{case['lateral']:.0f}", f"{case['longitudinal']:.0f}",
            f"{case['turn']:.0f}",
            *(f"{frequencies[name]:.1f}" for name in published["frequencies"])])
    short = data["variants"][-1][1]
    stiffer = max(100 * (of_rules / of_short - 1) for of_rules, of_short in [
        *((rules[name], short[name]) for name in ("lateral", "longitudinal", "turn")),
        *((rules["frequencies"][name], short["frequencies"][name])
          for name in published["frequencies"])])
    variants.append(["**published**", f"{published['deflection'][0.22]}",
                     f"{published['vertical'][0.22]:.0f}", f"{published['lateral']:.0f}",
                     f"{published['longitudinal']:.0f}", f"{published['turn']}",
                     *(f"{frequency:.1f}"
                       for frequency in published["frequencies"].values())])
    return "\n\n".join([
        "## A radial tire",
        fill("""
        [radial_tire.prm](../prm/radial_tire.prm) is a 205/60 R15 on a rim 6J x 15, designed from its
        size by [radial_tire.py](measured_tires/radial_tire.py); [biface-tire](tire_from_size.md)
        takes other sizes. The values published for this size are those of an example file
        of MF-Tyre ([TNO 2013](references.bib#TNO2013)), the coefficients of a tire and no record of a
        measurement; its torsional stiffness is a round default. **Nothing here is fitted to them.**
        """),
        table(["Rule", "Value", "Source"], [
            ["outer radius, section width", "313.5 mm, 208 mm", "TNO 2013; usual for the size"],
            ["tread", "0.75 of the section width, drop 8.5 mm at its edge",
             "a design of a 195/55 R20 ([Tire Industry](references.bib#TireIndustry2024))"],
            ["groove, rubber below, land", "7.5 mm, 2 mm, 67 %", "the same; estimate"],
            ["carcass", "1 ply of polyester 1440/2, 105 cords per dm on the drum, 0.61 mm, "
             "E = 4411 MPa", "58 N at 4.5 % ([cord maker](references.bib#DITPolyester))"],
            ["belts", "2 plies of steel 2+2x0.25, 80 per dm, ±24°, 190 GPa; 0.95 and 0.89 of the "
             "tread's width", "the same tire; estimate"],
            ["cap", "1 ply of nylon 940/2, 80 per dm, E = 1953 MPa", "[cord maker](references.bib#FTCNylon); estimate"],
            ["apex, turn-up", "to 30 and 50 mm over the rim's radius; 8 mm at the base",
             "estimate"],
            ["liner, sidewall", "1 mm, 2.5 mm", "a cut 245/45 R18 ([Smithers](references.bib#Smithers9120)); estimate"],
            ["rubber, E", "tread 5, sidewall 3, carcass 4, belts 10, apex 40, liner 2 MPa",
             "estimate"]]),
        fill(f"""
        The shape of the carcass under pressure follows: an arc under the belts, concentric with the
        tread, and beside it the curve in which cords along the meridian carry the pressure, as in
        [theory.md](theory.md), section 1, through the widest point and the flange of the rim, 5 mm
        beside it. It leaves the arc {RadialTire().shoulder:.0f} mm from the middle, a few millimeters
        inside the edge of the belts at {RadialTire().half_belts()[0]:.0f} mm, though nothing prescribes
        this place. The widest point is at
        {RadialTire().widest:.0f} mm, about half the height of the section. Two layers: sidewall and tread,
        and all inside them. Cords of textile buckle in compression.
        """),
        "![Section of the tire with carcass, belts and outer surface; load over deflection at three "
        "pressures](figures/radial_tire.png)",
        "Under 4000 N at 0.22 MPa, unless said otherwise:",
        table(["", "Computed", "Published", ""], rows),
        fill(f"""
        Stiffnesses are without slip, secants of 1 mm, 0.5 mm and 0.2°; frequencies those of the
        inflated tire on a fixed rim, not loaded: lateral, yaw (a pair, out of the plane of the wheel), wind-up (about
        the axle) and longitudinal (a pair). The cornering stiffness is that of a tread of bristles at
        ±{SLIP_ANGLE}°; the coefficients of the same size in [Pacejka 2006](references.bib#Pacejka2006) give
        {published['other cornering']} N per degree. At the same deflection, {100 * (1 - part):.0f} % of the
        load does not depend on the pressure; in TNO's file it is 29 %.
        """),
        fill(f"""
        So the tire by these rules is too soft, most where the sidewall shears: around the axle and
        along the ground; and too light. What inputs that nobody published could explain is in the
        table. Fillers of the bead do most: those 20 mm higher alone raise the frequencies of the lateral
        and the yaw mode above the published ones, and give more than a third of what lacks in the
        lateral stiffness. No single input explains the wind-up mode and the longitudinal
        stiffness.

        The cells of the shipped mesh are up to 15 degrees long behind the axle. With the last row, they make the tire
        up to {stiffer:.0f} % too stiff where it turns and shifts as a whole.
        """),
        table(["Input", "Deflection, mm", "Vertical, N/mm", "Lateral, N/mm",
               "Longitudinal, N/mm", "Torsional, N m/rad", "Lateral, Hz", "Yaw, Hz",
               "Wind-up, Hz", "Longitudinal, Hz"], variants),
        fill("""
        A 205/60 R15 of unknown make at 0.16 MPa that hung in elastic strips has six resonances between 114 and 260 Hz
        ([Vervoort 2007](references.bib#Vervoort2007)). Beside them are the radial modes of the tire by the rules at this pressure,
        with n waves around the axle, both sides alike; from two waves on they exert no force on the rim, so that it is all the same whether it is fixed
        or free. The first resonance is taken as the mode of two waves.
        """),
        table(["n", "Computed, Hz", "Measured, Hz", ""],
              [[str(n), *compared("", data["hung"][str(n)], HUNG[n - 2])[1:]] for n in WAVES]),
        fill("""
        They are lower still than the modes above, beside those of MF-Tyre's example. If the first resonance were
        that of three waves, they would be too low by 10 % and more.
        """)])


def model_section(data):
    def words(values):
        *first, last = (f"{value:g}" for value in values)
        return ", ".join(first) + " and " + last

    def points(test):
        slips = [1 + len(SLIP[f"Slip {kind}s"].split(",")) for kind in ("angle", "ratio")]
        return slips[0] * slips[1] * len(test["Loads"]) * len(test["Inclination angles"])

    def states(printed):
        return int(re.search(r"(\d+) states", printed)[1])

    loads = words(RADIAL_TEST["Loads"])
    angles = words(RADIAL_TEST["Inclination angles"])
    loads_of_aircraft = words(AIRCRAFT_TEST["Loads"])
    tire, _ = aircraft_tire()
    return "\n\n".join([
        "## .tir files",
        fill(f"""
        [radial_tire.tir](measured_tires/radial_tire.tir) is the fit to a [tire test](tire_test.md) of
        the radial tire under {loads} times 4000 N with inclination angles of {angles}°, and with all combinations of
        {len(SLIP["Slip angles"].split(","))} slip angles and {len(SLIP["Slip ratios"].split(","))} slip
        ratios, with the stiffnesses of its tread and the frequencies on short cells. The tread is bristles of its
        height and modulus on a carcass of
        one layer, with the coefficient of friction 0.8; it rolls at 16.7 m/s, with the centrifugal forces of
        the carcass. Radii are those up to the base of the tread. {states(data["model"])} of
        {points(RADIAL_TEST)} points converge.
        """),
        "```\n" + data["model"].rstrip() + "\n```",
        fill(f"""
        [aircraft_tire.tir](measured_tires/aircraft_tire.tir) is that of the {AIRCRAFT} of
        [real_tires.md](real_tires.md), upright, under {loads_of_aircraft} times the rated {tire.load:.0f} kN, in the same
        way. Rolling has no inertia. {states(data["aircraft"])} of {points(AIRCRAFT_TEST)} points
        converge; under the rated load combined slip winds its one layer up until
        steps hardly converge. Two loads are few for coefficients that vary with the load: beyond them the file
        is a guess.
        """),
        "```\n" + data["aircraft"].rstrip() + "\n```"])


def deep_section(data):
    rows, ratios, reached = [], [], 0
    for tire in data["deep"]:
        load, rated = tire["force"], tire["rated"]
        interpolated = tire["deflection"] + (tire["bottoming"] - tire["deflection"]) * (
            (2 * rated - rated) / (tire["bottoming load"] - rated))
        whole = load > 1.999 * rated
        reached += whole
        if whole:
            ratios.append(tire["approach"] / interpolated)
        rows.append([tire["name"], f"{rated:.1f}",
                     f"{tire['at rated']:.1f} ({tire['at rated'] / tire['deflection']:.2f})",
                     f"{tire['approach']:.1f}" if whole else
                     f"ends at {load / rated:.2f} times, {tire['approach']:.1f}",
                     f"{interpolated:.1f}",
                     f"{tire['approach'] / interpolated:.2f}" if whole else "",
                     f"{tire['bottoming load']:.0f}, {tire['bottoming']:.1f}"])
    return "\n\n".join([
        "## Aircraft tires under twice the rated load",
        fill(f"""
        [real_tires.md](real_tires.md) presses tires of a databook to their rated deflection; {len(rows)} of them are
        pressed further here. The databook has one more point, load and radius at which a tire bottoms on the rim
        ([bottoming.csv](measured_tires/bottoming.csv)). Neither is a measurement of one tire: the
        load is three times the rated one in all rows but two, and the rated deflection 32 % of the height
        over the flange. So the deflection under twice the rated load lies somewhere near the line
        between both points. {reached} of {len(rows)} runs reach this load, with
        {np.mean(ratios):.2f} ± {np.std(ratios):.2f} of the deflection on the line; the others end before. In
        parentheses: relative to the rated deflection.
        """),
        table(["Tire", "Rated load, kN", "Deflection, mm", "at twice the load, mm",
               "on the line, mm", "Ratio", "Bottoming, kN, mm"], rows),
        fill("""
        How far a tire can be pressed beyond is in [real_tires.md](real_tires.md#toward-bottoming): the
        sidewall folds until its linear material has no stiffness left, before the crown meets the rim.
        """)])


def cylinder_section(data):
    forces = data["cylinder"]
    perfect = forces["coarse"]

    def rows(name, words):
        return [[words.format(part), f"{force:.1f}", f"{force / perfect:.2f}"]
                for part, force in forces[name]]

    return "\n\n".join([
        "## A composite cylinder with imperfections",
        fill(f"""
        [imperfect_cylinder.prm](../prm/imperfect_cylinder.prm) is the cylinder Z07 of tests at DLR: radius
        250 mm, 510 mm long, four plies of 0.125 mm at 24, -24, 41, -41 degrees to the axis from the
        inside, both ends clamped, with the constants of [DESICOS 2015](references.bib#DESICOS2015). The
        perfect cylinder buckles at {perfect:.1f} kN by the linear prediction, in {forces['waves'][0]} waves around
        and {forces['waves'][1]} half waves along it; with cells 2/3 as long, at {forces['fine']:.1f} kN. (With the plies
        inside out it would be {forces['inside out']:.1f} kN.) A cylinder with a stress-free
        [imperfection](theory.md#imperfections), or pushed from the side, is compressed until the
        equilibrium becomes unstable or none is found in its neighborhood, at
        """),
        table(["Imperfection", "Force, kN", "over the perfect one"],
              rows("shape", "shape of buckling, {:g} of the wall")
              + rows("dent", "dent of 30 mm, {:g} of the wall")
              + rows("push", "force of {:g} N from the side")
              + rows("beyond", "force of {:g} N from the side, beyond the first instability")),
        fill(f"""
        Where the wall is pushed, the first instability is a local one: under 5 N it snaps at the
        force, under 10 N the dent has formed before. Beyond it, [damping](theory.md#through-a-snap-by-damping) of
        {DAMPING:g} MPa/mm lets the dent grow in a few steps, and the cylinder carries more,
        until it buckles as a whole and the force falls.

        The database has a limit of 16.2 kN for this cylinder, and lists pushing forces of 1 to 10 N; which of them it belongs to it
        does not say. Ten cylinders of the same layup by [Degenhardt et al. 2010](references.bib#Degenhardt2010)
        failed between 21.3 and 25.7 kN, by a summary of their report; [cylinders.md](cylinders.md) computes them
        with their measured shapes. The lower bound of
        [NASA SP-8007](references.bib#NASASP8007) for R/t = 500 is 0.32 of the perfect cylinder,
        {0.32 * perfect:.1f} kN: it covers larger imperfections than these, and all that is not known of them.
        Steps are {SHORTENING / STEPS} mm of shortening, halved up to four times, so that a force is at
        most {math.ceil(10 * SHORTENING / STEPS / 2**CUTS * STIFFNESS) / 10:.1f} kN too low.
        """)])


def write(directory, data):
    draw(directory / "figures/radial_tire.png", data)
    text = "\n\n".join([
        "<!-- Written by doc/measured_tires/measured_tires.py: cmake --build build --target "
        "measured_tires -->",
        "# Tires and shells beside published values",
        fill("""
        What is given, what was assumed, and what came out, also where it disagrees. Nothing is fitted
        unless it is said.
        """),
        radial_section(data), model_section(data), deep_section(data),
        cylinder_section(data),
        "## Closed solutions",
        fill("""
        Three cases of pressurized walls, as tests:

        | Case | Exact | Within | Test |
        | --- | ---: | ---: | --- |
        | sphere under pressure and a point force, stiffness ([Vella et al. 2012](references.bib#Vella2012)) | 1694 N/mm | 0.3 %, with a wall that is rigid in shear; with another it is softer, without limit on finer meshes | `verification/sphere_under_pressure` |
        | braided tube at 25°, 0.3 MPa, radius 10 mm: axial force by netting ([Chou and Hannaford 1996](references.bib#ChouHannaford1996)) | 866.9 N | 0.1 % | `model/braided_tube` |
        | Mylar balloon: radius, half its thickness, over the radius of the disks ([Paulsen 1994](references.bib#Paulsen1994)) | 0.7628, 0.4569 | 0.1 %, 0.2 % | `model/mylar_balloon` |

        ## What is not compared

        No measured stiffnesses of the aircraft tires 40x12 and 32x8.8 were at hand. Load and deflection of a 335/65 R22.5 at four pressures in Project Chrono's data
        are no measurements of it: the file of 60 psi is an interpolation between others.
        """)])
    (directory / "measured_tires.md").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    arguments = parse_arguments("measured_tires", __doc__.split("\n", 1)[0])

    def run(name, example, entries, may_stop=False, until=None):
        return run_until(EXAMPLES / example, {**QUIET, **entries},
                         arguments.scratch / name.replace(" ", "_").replace("°", ""),
                         arguments.program, may_stop, until)

    def cached(name, compute):
        """Results of a part of the page; those of an earlier run if newer than all
        that they come from."""
        path = arguments.scratch / f"{name}.json"
        sources = [Path(arguments.program), *HERE.glob("*.py"), *HERE.glob("*.csv"),
                   *(EXAMPLES / f"{example}.prm" for example in (
                       "radial_tire", "aircraft_tire", "imperfect_cylinder"))]
        if not (path.exists() and path.stat().st_mtime
                > max(source.stat().st_mtime for source in sources)):
            path.write_text(json.dumps(compute(), indent=1), encoding="utf-8")
        return json.loads(path.read_text(encoding="utf-8"))

    bristles = with_bristles(arguments.scratch)
    models = arguments.output / "measured_tires"
    # the longest ones first
    parts = {"deep": lambda: deep_tires(run),
             "cylinder": lambda: cylinder(run),
             "model": lambda: radial_model(run, bristles, models),
             "aircraft": lambda: aircraft_model(run, models),
             "variants": lambda: radial_variants(run, arguments.scratch),
             "hung": lambda: hung(run),
             "pressures": lambda: [at_pressure(run, pressure)
                                   for pressure in (0.18, 0.26)],
             "cornering": lambda: cornering(run, bristles)}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        write(arguments.output,
              dict(zip(parts, pool.map(cached, parts, parts.values()))))
