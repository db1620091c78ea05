# SPDX-License-Identifier: LGPL-2.1-or-later

# A table in other axes than those assumed is refused or warned of, and so is one whose
# title names axes; a table of evaluate is read in the axes and units of its first line.

from tire_model_test import MADE, check, check_refused, output_of, require, scratch, write

require("numpy", "scipy")

import numpy as np
from biface.errors import BifaceError
from biface_tire_model import convert, read_table, read_tir
from biface_tire_model.axes import SIGNS
from biface_tire_model.table import doubts

angles = np.radians(np.tile(np.linspace(-9, 9, 13), 3))
cambers = np.radians(np.repeat([-3, 0, 3], 13))
loads = np.full(39, 4000.0)
forces = read_tir(MADE).formula().evaluate(loads, 0, angles, cambers)
STATES = {"slip_angle": np.degrees(angles), "inclination_angle": np.degrees(cambers),
          "F_z": loads, **forces._asdict()}
NAMES = list(STATES)


def table(axes, title="", **changed):
    """A file with the states in some axes; quantities may have other signs."""
    states = convert({name: values * changed.get(name, 1)
                      for name, values in STATES.items()}, "iso", axes)
    return write("table.csv", title + ",".join(NAMES) + "\n" + "".join(
        ",".join(repr(float(states[name][i])) for name in NAMES) + "\n" for i in range(39)))


def refusal(*words):
    """Why a table is refused."""
    try:
        read_table(*words)
    except BifaceError as error:
        return str(error)
    return "nothing"


for axes in SIGNS:
    data = read_table(table(axes), None, axes)
    check(all(np.allclose(data[name], STATES[name] * (np.pi / 180 if "angle" in name else 1),
                          rtol=1e-12) for name in NAMES) and not doubts(data), axes)

# where z points down, a load may be negative
data = read_table(table("adapted-sae", F_z=-1), None, "adapted-sae")
check((data["F_z"] == 4000).all() and not doubts(data), f"{data['F_z']}")

# the slope of F_y tells
for true, assumed, sentence in (
        ("adapted-iso", "iso", "F_y rises with slip_angle, but falls in the axes 'iso': it "
                               "has others, such as 'adapted-iso' or, if y points"),
        ("adapted-sae", "iso", "F_y rises with slip_angle, but falls in the axes 'iso'"),
        ("iso", "adapted-iso", "F_y falls with slip_angle, but rises in the axes "
                               "'adapted-iso': it has others, such as 'iso'"),
        ("sae", "adapted-sae", "such as 'sae'; see --axes"),
        ("sae", "iso", "the load F_z must be positive; in SAE axes it is negative")):
    found = refusal(table(true), None, assumed)
    check(sentence in found, f"{true} as {assumed}: {found}")

# other signs are doubted
for path, sentence in (
        (table("sae", F_z=-1), "F_y pushes a tire that leans to the right to the left"),
        (table("iso", M_z=-1), "M_z turns the wheel away"),
        (table("iso", M_y=-1), "M_y drives a wheel that rolls straight ahead")):
    found = doubts(read_table(path))
    check(any(sentence in doubt for doubt in found), f"{sentence}: {found}")

# a title names axes, and an option decides
for title in ("% SAE J670 coordinates\n", "Tire 1; axes: adapted SAE\n",
              "# sign convention of ISO and SAE\n"):
    found = refusal(table("iso", title))
    check("line 1: '" in found and "seems to name the axes: say --axes iso, sae," in found,
          found)
    check(refusal(table("iso", title), None, "iso") == "nothing", title)
for title in ("% axes of ISO 8855\n", "# SAE paper 870421\n",
              "# designed by SAE\n"):
    check(refusal(table("iso", title)) == "nothing", title)

# the first line of a table of evaluate
words = ["--fz", "4000", "--alpha", "-9:9:1.5", "--gamma", "-3,0,3"]
plain, other = scratch() / "plain.csv", scratch() / "other.csv"
output_of("evaluate", MADE, *words, "-o", plain)
words[3], words[5] = "-0.15:0.15:0.025", "-.05,0,.05"
output_of("evaluate", MADE, *words, "--units", "mm, N, s", "--angles", "rad", "--axes",
          "adapted-iso", "-o", other)
data = read_table(other)
forces = read_tir(MADE).formula().evaluate(data["F_z"], 0, data["slip_angle"],
                                           data["inclination_angle"])
for name in ("F_y", "M_x", "M_z"):
    check(np.allclose(data[name], getattr(forces, name), rtol=1e-8, atol=1e-6), name)
fit = ["--format", "6.1", "--output", scratch() / "x.tir", "--radius"]
output_of("fit", other, *fit, "320", "--without-combined", "neutral")
check(np.isclose(read_tir(fit[3]).find("UNLOADED_RADIUS"), 0.32), "another unit of --radius")
for option, value in (("axes", "sae"), ("angles", "deg"), ("units", "m, N, s")):
    check_refused(["fit", other, *fit, "320", f"--{option}", value],
                  f"as its first line says, but --{option} is '{value}'")
