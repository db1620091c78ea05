#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of three files of prm/ side by side: the strip that is rolled up, the
roof that snaps through, and the panel whose plies fail."""

import argparse
import csv
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt

BLUE, GREEN, ORANGE = "#0072b2", "#009e73", "#d55e00"


def read(path):
    """The lines of a CSV file, by the names of their columns."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def column(rows, name):
    """A column as numbers."""
    return [float(row[name]) for row in rows]


def draw_strip(axes, results):
    """The strip after every fourth step."""
    for step in (4, 8, 12, 16, 20):
        rows = read(results / f"profile-{step:04d}.csv")
        middle = [[(outer + inner) / 2 for outer, inner
                   in zip(column(rows, "outer_" + i), column(rows, "inner_" + i))]
                  for i in "xz"]
        color = plt.get_cmap("viridis")(1 - step / 20)
        axes.plot(*middle, color=color, linewidth=2)
        if step < 20:
            offset = (4, 2) if step < 12 else (-29, -4)
            axes.annotate(f"{5 * step} %", (middle[0][-1], middle[1][-1]),
                          offset, textcoords="offset points", color=color)
    axes.plot([0, 12], [0, 0], color="0.6", linewidth=1)
    axes.set_aspect("equal")
    axes.set(title="roll_up.prm", xlabel="x (mm)", ylabel="z (mm)",
             xlim=(-5, 13), ylim=(-1, 10))


def draw_roof(axes, results):
    """The force against displacements."""
    rows = [row for row in read(results / "probes.csv")
            if row["face"] == "middle"]
    for name, label, color in (("center", "center", BLUE),
                               ("edge", "middle of the free edge", ORANGE)):
        chosen = [row for row in rows if row["name"] == name]
        axes.plot([0] + [-u for u in column(chosen, "u_x")],
                  [0] + [1000 * f for f in column(chosen, "load_factor")],
                  "o-", markersize=3, color=color, label=label)
    axes.axhline(0, color="0.6", linewidth=1)
    axes.legend(loc="upper left", frameon=False)
    axes.set(title="snap_through_roof.prm", xlabel="deflection (mm)",
             ylabel="force (N)")


def draw_panel(axes, results):
    """The maximum failure indices at three points against the pressure."""
    history = read(results / "history.csv")
    for name, color in (("center", BLUE), ("side", ORANGE), ("quarter", GREEN)):
        maximum = []
        for step in range(1, len(history) + 1):
            rows = read(results / f"plies-{step:04d}.csv")
            maximum.append(max(float(row["tsai_wu_index"]) for row in rows
                                if row["name"] == name))
        axes.plot([0] + column(history, "pressure"), [0] + maximum, "o-",
                  markersize=3, color=color, label=name)
    axes.axhline(1, color="0.6", linewidth=1)
    axes.legend(loc="lower right", frameon=False)
    axes.set(title="composite_panel.prm", xlabel="pressure (MPa)",
             ylabel="failure index (Tsai-Wu)", xlim=(0, None), ylim=(0, None))


def main():
    """Draw the results of three runs."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("strip", "roof", "panel"):
        parser.add_argument(name, type=Path, help="a directory of results")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()

    figure, axes = plt.subplots(1, 3, figsize=(12, 3.9), dpi=100,
                                layout="constrained")
    draw_strip(axes[0], arguments.strip)
    draw_roof(axes[1], arguments.roof)
    draw_panel(axes[2], arguments.panel)
    figure.savefig(arguments.picture)


if __name__ == "__main__":
    main()
