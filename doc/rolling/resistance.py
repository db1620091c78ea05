#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the tables of rolling.md about rolling_resistance.prm, and draw its
figure.

Usage: resistance.py --program build/biface [--scratch DIRECTORY]
         [--figures DIRECTORY]
"""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, table

PRM = "rolling_resistance.prm"
GIVEN = {"Heat/Temperatures": "given"}
# to 10 m/s only
ONE_SPEED = {"Number of stages": 3, "Stage 3/Ground velocity": 10000}
# a loss factor that hardly depends on the frequency, so small that the shape
# is that without losses
SMALL_PART = 1e-3
SMALL = {"Material cord/Relaxation times":
         ", ".join(f"1e{i}" for i in range(-8, 3)),
         "Material cord/Relaxation moduli": ", ".join(11 * [f"{SMALL_PART}"]),
         "Material cord/Temperature shift": "none",
         "Material cord/Reference temperature": 0,
         "Material cord/WLF C1": 17.44, "Material cord/WLF C2": 51.6}
ELASTIC = {"Stage 1/Duration": 0, "Stage 2/Duration": 0,
           "Material cord/Relaxation times": "",
           "Material cord/Relaxation moduli": "",
           "Material cord/Temperature shift": "none",
           "Material cord/Reference temperature": 0,
           "Material cord/WLF C1": 17.44, "Material cord/WLF C2": 51.6}


def temperatures(results, step):
    values = results.heat(step)["temperature"]
    return values.min(), values.max()


def per_thousand(line):
    """The rolling resistance over the load: in lb per 1000 lb."""
    return 1000 * line["rolling_resistance"] / line["F_z"]


def over_speed(runs):
    coupled = runs.run("coupled", PRM, {})
    given = runs.run("given", PRM, GIVEN)
    travel = dict(zip(coupled.history["step"], coupled.history["approach"]))
    rows = []
    for warm, cold in zip(coupled.rolling().rows(), given.rolling().rows()):
        low, high = temperatures(coupled, warm["step"])
        rows.append([f"{warm['ground_velocity'] / 1000:.0f}",
                     f"{-warm['F_x']:.2f}", f"{warm['rolling_resistance']:.2f}",
                     f"{per_thousand(warm):.2f}",
                     f"{-warm['M_y'] / warm['F_z']:.2f}",
                     f"{travel[warm['step']]:.2f}",
                     f"{low:.1f} to {high:.1f}", f"{per_thousand(cold):.2f}"])
    return table(["speed, m/s", "drag, N", "rolling resistance, N",
                  "lb per 1000 lb", "shift of the pressure, mm", "travel, mm",
                  "plies, °C", "all at 25 °C: lb per 1000 lb"], rows)


def over_load(runs):
    rows = []
    for load in (950, 1425, 1900, 2375, 2850):
        line = runs.run(f"load_{load}", PRM, {
            **ONE_SPEED, "Stage 2/Force": load, "Stage 3/Force": load,
        }).rolling().row(-1)
        rows.append([f"{load}", f"{-line['F_x']:.2f}",
                     f"{line['rolling_resistance']:.2f}",
                     f"{per_thousand(line):.2f}"])
    return table(["load, N", "drag, N", "rolling resistance, N",
                  "lb per 1000 lb"], rows)


def beside_loss_factor(runs):
    """A small relaxation with terms in all decades beside the loss factor that
    it has."""
    rows = []
    for name, cells in (
            ("28 × 36", "-180:-16:10:smooth, -16:16:16, 16:180:10:smooth"),
            ("28 × 72", "-180:-16:20:smooth, -16:16:32, 16:180:20:smooth")):
        changes = {**ONE_SPEED, **GIVEN, "Mesh/Intervals alpha_2": cells}
        relaxing = runs.run(f"small_{name.split()[-1]}", PRM,
                            {**changes, **SMALL}).rolling().row(-1)
        speed = relaxing["angular_velocity"]
        loss = storage = 0
        for i in range(-8, 3):
            x = speed * 10.0**i
            loss += SMALL_PART * x / (1 + x * x)
            storage -= SMALL_PART / (1 + x * x)
        factor = loss / (1 + storage)
        elastic = runs.run(
            f"elastic_{name.split()[-1]}", PRM,
            {**changes, **ELASTIC, "Material cord/Loss factor": factor},
        ).rolling().row(-1)
        rows.append([name, f"{factor:.3e}",
                     f"{1000 * relaxing['rolling_resistance']:.2f}",
                     f"{1000 * elastic['rolling_resistance']:.2f}"])
    return table(["cells", "loss factor", "relaxation, mN", "loss factor, mN"],
                 rows)


def pressure(results):
    """Along the equator: the angle, degrees, and the pressure, MPa."""
    contact = results.contact(results.rolling()["step"][-1])
    equator = contact.where(abs(contact["alpha_1"]) < 1e-6)
    order = equator["alpha_2"].argsort()
    return equator["alpha_2"][order], equator["pressure"][order]


def draw(runs, figures):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    for name, settings, label in (
            ("coupled", {}, "plies heated by their losses"),
            ("given", GIVEN, "plies at 25 °C")):
        lines = runs.run(name, PRM, settings).rolling()
        axes[0].plot(lines["ground_velocity"] / 1000, per_thousand(lines), "o-",
                     label=label)
    axes[0].set(xlabel="speed, m/s", ylabel="resistance, lb per 1000 lb",
                ylim=(0, None))
    axes[0].legend(frameon=False)
    strong = {**ONE_SPEED, **GIVEN}
    for settings, label in ((strong, "with relaxation"),
                            ({**strong, **ELASTIC,
                              "Material cord/Loss factor": 0.1},
                             "without")):
        results = runs.run("pressure_" + label.split()[0], PRM, settings)
        axes[1].plot(*pressure(results), "o-", markersize=3, label=label)
    axes[1].set(xlabel="angle around the axle, degrees; it rolls to the right",
                ylabel="pressure on the equator, MPa", xlim=(-24, 24),
                ylim=(0, None))
    axes[1].legend(frameon=False)
    figure.tight_layout()
    figure.savefig(figures / "rolling_resistance.png", dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--scratch", type=Path,
                        default=Path("rolling_resistance_runs"))
    parser.add_argument("--figures", type=Path)
    arguments = parser.parse_args()
    runs = Runs(arguments)
    runs.scratch.mkdir(parents=True, exist_ok=True)
    for make in (over_speed, over_load, beside_loss_factor):
        print(make(runs), end="\n\n", flush=True)
    if arguments.figures:
        draw(runs, arguments.figures)


if __name__ == "__main__":
    main()
