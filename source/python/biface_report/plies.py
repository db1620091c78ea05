# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts and numbers of the stresses in the plies at the named points."""

import matplotlib.pyplot as plt
import numpy as np

from .drawing import DISTINCT
from .page import ROUND_OFF

# Columns of plies-NNNN.csv and their names
STRESSES = {
    "s_L": "stress along the fibers",
    "s_T": "stress across the fibers",
    "t_LT": "shear stress in the ply",
}
INDICES = {
    "maximum_stress_index": "failure index, maximum stress",
    "tsai_wu_index": "failure index, Tsai–Wu",
}


def quantities(table):
    """The columns to draw: stresses, and failure indices if there are any."""
    return [*STRESSES, *(name for name in INDICES if name in table
                         and np.isfinite(table[name]).any())]


def points(table):
    """The names of the points, in order."""
    return list(dict.fromkeys(table["name"]))


def material_colors(table):
    """One color for each material."""
    materials = dict.fromkeys(table["material"])
    return {material: DISTINCT[i % len(DISTINCT)]
            for i, material in enumerate(materials)}


def plies_of(rows):
    """The rows of each ply, the innermost first."""
    return [rows.where(rows["ply"] == ply) for ply in np.unique(rows["ply"])]


def scale(rows):
    """The largest absolute stress at a point."""
    return max(np.abs(rows[column]).max() for column in STRESSES)


def draw_quantity(rows, column, colors, units):
    """Chart of one column through the thickness; rows are those of one point."""
    figure, axes = plt.subplots(figsize=(3.3, 3.3))
    low, high = rows["height"].min(), rows["height"].max()
    margin = 0.05 * (high - low) or 1
    axes.set_ylim(low - margin, high + margin)
    for ply in plies_of(rows):
        material = ply["material"][0]
        axes.plot(ply[column], ply["height"], "o-", color=colors[material],
                  markersize=4, linewidth=1.8)
        for side in ply["height"][np.isin(ply["fraction"], (0, 1))]:
            axes.axhline(side, color="0.8", linewidth=0.7, zorder=1)
        if len(ply) == 1 and np.isfinite(ply[column][0]):
            axes.plot([0, ply[column][0]], 2 * [ply["height"][0]],
                      color=colors[material], linewidth=1.2)
    axes.axvline(0, color="0.4", linewidth=0.8, zorder=1)
    axes.locator_params(axis="x", nbins=5)
    if column in INDICES:
        axes.set_xlim(0, None)
        axes.axvline(1, color="0.4", linewidth=1, linestyle="--", zorder=1)
        label = INDICES[column]
    else:
        label = units.label(STRESSES[column] + "\n", "pressure")
        # round-off is drawn as zero
        least = ROUND_OFF * scale(rows)
        if np.abs(rows[column]).max() < least:
            axes.set_xlim(-1e3 * least or -1, 1e3 * least or 1)
            axes.set_xticks([0])
    axes.grid(axis="y", visible=False)
    axes.set_xlabel(label, fontsize=10.5)
    axes.set_ylabel(units.label("height", "length"), fontsize=10.5)
    return figure


def summary(rows, columns):
    """For each ply of a point: number, material, angle, fiber tension, and the
    minimum and maximum of some columns."""
    result = []
    for ply in plies_of(rows):
        line = {"ply": int(ply["ply"][0]), "material": ply["material"][0],
                "angle": ply["angle"][0], "tension": ply["fiber_tension"][0]}
        for column in columns:
            values = ply[column]
            line[column] = (values.min(), values.max())
        result.append(line)
    return result
