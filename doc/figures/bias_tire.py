#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and tables of the bias tire pressed on a rigid ground.

Reads the results of runs of prm/bias_tire.prm, as it is and with other
readings of the paper, and the paper's Table 1, and writes

    load_deflection.png   force against approach (Fig. 3 of the paper)
    profile.png           deformed meridian in the plane phi = 0 (Fig. 4)
    pressure.png          contact pressure along that meridian (Fig. 5)
    table_1.png           pressures against those of Table 1, node by node
    asymmetry.png         q(psi, phi) - q(psi, -phi) over the contact zone

and the tables of doc/bias_tire.md. Units are those of the parameter file: mm,
N, MPa, degrees.
"""

import argparse
import csv
import re
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save, shades

# Force (N) at an approach (mm), from the independent program
INDEPENDENT_FORCES = {4: 236, 12: 975, 20: 1951}

# Approaches (mm) in Figs. 3 to 5
APPROACHES = (4, 12, 20)

# Readings of the paper: directory of the results, what is different
READINGS = {
    "nonlinear": "as shipped",
    "lumped": "lumped mortar matrix",
    "asymmetric": "law of the thickness strain `asymmetric`",
    "prestress": "inflated state as initial resultants",
    "undeformed": "Δ from the tire before inflation",
    "true_pressure": "true pressure",
    "linear": "linear about the inflated tire",
    "linear_stages": "inflation linear, then linear about its result",
    "linear_unstressed": "linear about the unstressed tire",
}

# The middle surface of the torus: radius of the meridian, and distance of
# the meridian's center from the axle (mm)
MERIDIAN_RADIUS, CENTER_RADIUS = 52.4, 200

# Length of a degree of psi over that of a degree of phi, at the equator
ASPECT = MERIDIAN_RADIUS / (MERIDIAN_RADIUS + CENTER_RADIUS)

# ---------------------------------------------------------------- results


def read_history(directory):
    """The steps of the contact stage."""
    return Results(directory).stage("contact").history


def step_at(directory, approach):
    """The number of the contact step with an approach (mm)."""
    history = read_history(directory)
    return history["step"][np.argmin(np.abs(history["approach"] - approach))]


def force_at(directory, approach):
    """The force (N) at an approach (mm)."""
    history = read_history(directory)
    return history["force"][np.argmin(np.abs(history["approach"] - approach))]


def read_profile(directory, approach):
    """The deformed meridian at an approach (mm); 0 is the inflated tire."""
    return Results(directory).profile(
        1 if approach == 0 else step_at(directory, approach))


def node_key(psi, three_phi):
    """The coordinates of a node in Table 1 without round-off, in degrees."""
    return round(float(psi), 3), round(float(three_phi), 3)


def read_table(path):
    """The paper's Table 1: pressure (MPa) at each node in contact."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if line[0] != "#"))
    columns = rows[0][1:]
    return {
        node_key(row[0], column): float(value) / 10
        for row in rows[1:]
        for column, value in zip(columns, row[1:])
        if value
    }


def read_pressures(directory, approach):
    """The computed pressure (MPa) at each node in contact, like read_table()."""
    nodes = Results(directory).contact(step_at(directory, approach)).where(active=1)
    return {
        node_key(node["alpha_1"], 3 * node["alpha_2"]): float(node["pressure"])
        for node in nodes.rows()
    }


def relative_deviations(computed, paper):
    """(computed - paper) / paper at the nodes in contact in both."""
    return {
        node: computed[node] / paper[node] - 1
        for node in paper
        if node in computed
    }


def is_interior(node):
    """Whether a node is well inside the contact zone of Table 1."""
    return abs(node[0]) <= 20 and abs(node[1]) <= 25


class NodalAreas:
    """The area that belongs to each node about the contact zone, a quarter of
    each cell around it, on the middle surface."""

    def __init__(self, directory, approach):
        """Reads the lines of the mesh from a contact-NNNN.csv."""
        nodes = Results(directory).contact(step_at(directory, approach))
        self.psi = np.unique(np.round(nodes["alpha_1"], 6))
        self.phi = np.unique(np.round(nodes["alpha_2"], 6))

    def area(self, node):
        """The area (mm^2) of a node."""
        i = np.argmin(np.abs(self.psi - node[0]))
        j = np.argmin(np.abs(self.phi - node[1] / 3))
        psi = np.radians(self.psi[i - 1:i + 2])
        phi = np.radians(self.phi[j - 1:j + 2])
        middle = (psi[:-1] + psi[1:]) / 2
        radius = CENTER_RADIUS + MERIDIAN_RADIUS * np.cos(middle)
        return (MERIDIAN_RADIUS * np.sum(radius * np.diff(psi))
                * (phi[-1] - phi[0]) / 4)

    def integrate(self, pressures):
        """The force (N) of pressures at nodes."""
        return sum(pressure * self.area(node)
                   for node, pressure in pressures.items())


def asymmetry(pressures):
    """q(psi, phi) - q(psi, -phi) at each node; the pressure of a node that is
    not in contact is 0."""
    nodes = set(pressures) | {(psi, -phi) for psi, phi in pressures}
    return {(psi, phi): pressures.get((psi, phi), 0) -
            pressures.get((psi, -phi), 0) for psi, phi in nodes}


def central_asymmetry(pressures):
    """The largest |q(psi, phi) - q(-psi, -phi)|."""
    return max(abs(pressure - pressures.get((-psi, -phi), 0))
               for (psi, phi), pressure in pressures.items())


def rms(values):
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(list(values)))))


# ---------------------------------------------------------------- figures


def approach_colors(approaches):
    """One color per approach, darker for larger ones."""
    return dict(zip(approaches, shades(len(approaches))))


def plot_curve(axes, directory, **style):
    """The force against the approach of one run, starting at the origin."""
    history = read_history(directory)
    axes.plot(np.append(0, history["approach"]), np.append(0, history["force"]),
              **style)


def mark_ratio(axes, runs, approach):
    """A double arrow from the nonlinear to the linear force, with their ratio."""
    low = force_at(runs.nonlinear, approach)
    high = force_at(runs.linear, approach)
    x = approach + 0.55
    axes.annotate("", xy=(x, low), xytext=(x, high),
                  arrowprops={"arrowstyle": "<->", "color": GRAY,
                              "shrinkA": 0, "shrinkB": 0})
    axes.text(x + 0.25, (low + high) / 2, f"ratio\n{high / low:.2f}",
              va="center", color="0.25")


def draw_load_deflection(runs, output):
    """Fig. 3: the force by the nonlinear and by the linear theory."""
    figure, axes = plt.subplots(figsize=(7, 4.6))
    plot_curve(axes, runs.linear, color=RED, label="linear theory")
    plot_curve(axes, runs.nonlinear, color=BLUE, label="nonlinear theory")
    plot_curve(axes, runs.lumped, color="black", linewidth=0.9, linestyle="--",
               label="nonlinear theory, lumped mortar matrix")
    axes.plot(list(INDEPENDENT_FORCES), list(INDEPENDENT_FORCES.values()), "o",
              markersize=7, markerfacecolor="white", markeredgecolor=BLUE,
              markeredgewidth=1.6,
              label="nonlinear theory, independent program")
    mark_ratio(axes, runs, 20)
    paper = NodalAreas(runs.nonlinear, 20).integrate(read_table(runs.table))
    axes.plot(20, paper, "D", color="black", markersize=6,
              label="paper, Table 1 (pressures times areas)")
    axes.set(xlabel="approach of the ground Δ (mm)",
             ylabel="force on the ground P (N)",
             xlim=(0, 22.5), ylim=(0, 4000), xticks=range(0, 21, 4))
    axes.legend(loc="upper left", fontsize=10)
    save(figure, output / "load_deflection.png")


def draw_ground(axes, height, width):
    """The ground: a line, hatched on its solid side."""
    axes.plot([-width, width], [height, height], color="0.2", linewidth=1.2)
    axes.fill_between([-width, width], height, height + 4, facecolor="none",
                      edgecolor="0.6", hatch="////", linewidth=0)
    axes.text(0, height + 5, "ground at the first touch", ha="center",
              va="top", fontsize=10, color="0.3")


def draw_wall(axes, profile, label):
    """The wall between the two faces, and its fixed edges."""
    axes.fill(np.append(profile["outer_y"], profile["inner_y"][::-1]),
              np.append(profile["outer_x"], profile["inner_x"][::-1]),
              color="0.88", zorder=1, label=label)
    for end, name in ((0, "fixed edges"), (-1, None)):
        axes.plot([profile["outer_y"][end], profile["inner_y"][end]],
                  [profile["outer_x"][end], profile["inner_x"][end]],
                  color="black", linewidth=4, zorder=3, label=name)


def draw_profile(runs, output):
    """Fig. 4: the outer contour in the plane phi = 0, ground below."""
    figure, axes = plt.subplots(figsize=(7, 6))
    inflated = read_profile(runs.nonlinear, 0)
    ground = inflated["outer_x"].max()
    colors = approach_colors(APPROACHES)

    axes.plot(inflated["outer_y"], inflated["outer_x"], color="black",
              linewidth=1.4, linestyle=(0, (5, 2)),
              label="Δ = 0 (inflated)")
    for approach in APPROACHES:
        profile = read_profile(runs.nonlinear, approach)
        axes.plot(profile["outer_y"], profile["outer_x"],
                  color=colors[approach], label=f"Δ = {approach} mm")
        axes.plot([-78, 78], [ground - approach] * 2, color=colors[approach],
                  linewidth=0.7, zorder=1)
    draw_wall(axes, read_profile(runs.nonlinear, APPROACHES[-1]),
              f"wall at Δ = {APPROACHES[-1]} mm")
    draw_ground(axes, ground, 78)
    axes.set(xlabel="distance from the wheel's middle plane y (mm)",
             ylabel="distance from the axle x (mm)",
             xlim=(-80, 80), ylim=(167, 265))
    axes.set_aspect("equal")
    axes.invert_yaxis()
    axes.legend(loc="upper center", fontsize=10)
    save(figure, output / "profile.png")


def draw_pressure(runs, output):
    """Fig. 5: the contact pressure along the meridian phi = 0."""
    figure, axes = plt.subplots(figsize=(7, 4.6))
    colors = approach_colors(APPROACHES)
    for approach in APPROACHES:
        profile = read_profile(runs.nonlinear, approach)
        axes.plot(profile["alpha_1"], profile["pressure"], "o-", markersize=3.5,
                  color=colors[approach], label=f"Δ = {approach} mm")
    smooth = read_profile(runs.lumped, 20)
    axes.plot(smooth["alpha_1"], smooth["pressure"], color="black",
              linewidth=0.9, linestyle="--",
              label="Δ = 20 mm, lumped\nmortar matrix")
    column = {psi: value for (psi, three_phi), value
              in read_table(runs.table).items() if three_phi == 0}
    axes.plot(list(column), list(column.values()), "o", markersize=8,
              markerfacecolor="none", markeredgecolor=RED, markeredgewidth=1.3,
              label="Δ = 20 mm, paper's\nTable 1")
    axes.axhline(0.15, color=GRAY, linewidth=1, linestyle=":", zorder=1)
    axes.text(-54.5, 0.153, "inflation\npressure", color="0.3", va="bottom",
              fontsize=10)
    axes.set(xlabel="meridional angle ψ (degrees)",
             ylabel="contact pressure (MPa)", xlim=(-55, 55), ylim=(0, None))
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))
    save(figure, output / "pressure.png")


def cell_edges(coordinates):
    """Edges of cells around sorted nodes: halfway between them."""
    inner = (coordinates[1:] + coordinates[:-1]) / 2
    return np.concatenate([[2 * coordinates[0] - inner[0]], inner,
                           [2 * coordinates[-1] - inner[-1]]])


def draw_map(axes, values, nodes, title, **style):
    """Nodal values as colored cells in the (phi, psi) plane."""
    psi = np.array(sorted({node[0] for node in nodes}))
    three_phi = np.array(sorted({node[1] for node in nodes}))
    grid = np.array([[values.get((p, f), np.nan) for f in three_phi]
                     for p in psi])
    mesh = axes.pcolormesh(cell_edges(three_phi) / 3, cell_edges(psi), grid,
                           edgecolor="white", linewidth=0.4, **style)
    axes.set(title=title, xlabel="φ (degrees)", ylabel="ψ (degrees)",
             xlim=(-24, 24), ylim=(-46, 46),
             xticks=range(-20, 21, 5), yticks=range(-40, 41, 20))
    axes.set_aspect(ASPECT)
    axes.grid(False)
    return mesh


def mark_unmatched(axes, computed, paper):
    """Nodes that are in contact only in the paper or only in the computation."""
    for nodes, marker, text, psi in (
            (set(paper) - set(computed), "x", "× only in Table 1", 39),
            (set(computed) - set(paper), "o", "○ only computed", -39)):
        axes.plot([node[1] / 3 for node in nodes], [node[0] for node in nodes],
                  marker, color="0.2", markersize=4.5, markerfacecolor="none",
                  linestyle="none")
        axes.text(-23.7, psi, text, va="center", fontsize=9)


def draw_asymmetry(runs, output):
    """q(psi, phi) - q(psi, -phi), by Table 1 and as computed."""
    pressures = {"Table 1": read_table(runs.table),
                 "computed": read_pressures(runs.nonlinear, 20)}
    figure, axes = plt.subplots(2, 2, figsize=(10, 5.8), layout="constrained")
    nodes = set().union(*map(asymmetry, pressures.values()))
    for i, (name, values) in enumerate(pressures.items()):
        mesh = draw_map(axes[0, i], asymmetry(values), nodes,
                        f"({'ab'[i]}) q(ψ, φ) − q(ψ, −φ), {name}",
                        cmap="RdBu_r", vmin=-0.04, vmax=0.04)
    figure.colorbar(mesh, ax=axes[0, :], orientation="horizontal", shrink=0.5,
                    aspect=35, pad=0.02, label="difference (MPa)")
    for i, psi in enumerate((35, -35)):
        draw_row(axes[1, i], pressures, psi)
        axes[1, i].set_title(f"({'cd'[i]}) the row ψ = {psi}°".replace("-", "−"))
    axes[1, 0].legend(loc="lower center", fontsize=10)
    save(figure, output / "asymmetry.png", dpi=110)


def draw_row(axes, pressures, psi):
    """The pressures of Table 1 and as computed along one row of nodes."""
    for (name, values), color, style in zip(
            pressures.items(), (RED, BLUE),
            ({"marker": "o", "linestyle": "none", "markersize": 7,
              "markerfacecolor": "none", "zorder": 3},
             {"marker": "o", "markersize": 3.5})):
        row = sorted((node[1] / 3, value) for node, value in values.items()
                     if node[0] == psi)
        axes.plot(*np.array(row).T, color=color, label=name, **style)
    axes.axvline(0, color=GRAY, linewidth=0.8)
    axes.set(xlabel="φ (degrees)", ylabel="q (MPa)", xlim=(-12, 12),
             ylim=(0, 0.42))


def draw_scatter(axes, computed, paper):
    """Computed against printed pressures."""
    interior = [node for node in paper if node in computed and is_interior(node)]
    border = [node for node in paper if node in computed and not is_interior(node)]
    limits = np.array([0, 0.4])
    axes.fill_between(limits, 0.95 * limits, 1.05 * limits, color="0.9",
                      linewidth=0, label="± 5 %")
    axes.plot(limits, limits, color="0.6", linewidth=0.8)
    for nodes, color, label in ((border, RED, "other nodes"),
                                (interior, BLUE, "inner nodes")):
        axes.plot([paper[node] for node in nodes],
                  [computed[node] for node in nodes], "o", markersize=3.5,
                  color=color, alpha=0.7, markeredgewidth=0, label=label)
    axes.set(title="(d) node by node", xlabel="Table 1 (MPa)",
             ylabel="computed (MPa)", xlim=limits, ylim=limits,
             xticks=np.arange(0, 0.41, 0.1), yticks=np.arange(0, 0.41, 0.1))
    axes.set_aspect("equal")
    legend = axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1),
                         fontsize=10, handlelength=1, handletextpad=0.4,
                         borderaxespad=0)
    legend.set_in_layout(False)


def table_caption(computed, paper):
    """The result of the comparison."""
    deviations = relative_deviations(computed, paper)
    interior = [d for node, d in deviations.items() if is_interior(node)]
    return (f"Δ = 20 mm: {len(deviations)} of the {len(paper)} nodes of "
            f"Table 1 are in contact, RMS relative deviation "
            f"{rms(deviations.values()):.3f};\n{rms(interior):.3f} at the "
            f"{len(interior)} inner nodes (|ψ| ≤ 20° and |3φ| ≤ 25°)")


def draw_table(runs, output):
    """Table 1 of the paper and the computed pressures at the same nodes."""
    paper = read_table(runs.table)
    computed = read_pressures(runs.nonlinear, 20)
    percent = {node: 100 * deviation for node, deviation
               in relative_deviations(computed, paper).items()}
    nodes = set(paper) | set(computed)

    figure, axes = plt.subplots(2, 2, figsize=(10, 7),
                                constrained_layout=True)
    scale = {"cmap": "viridis", "vmin": 0.1, "vmax": 0.35}
    bar = {"orientation": "horizontal", "aspect": 35, "pad": 0.02}
    draw_map(axes[0, 0], paper, nodes, "(a) paper, Table 1", **scale)
    mesh = draw_map(axes[0, 1], computed, nodes, "(b) computed", **scale)
    figure.colorbar(mesh, ax=axes[0, :], shrink=0.5, extend="both",
                    label="contact pressure (MPa)", **bar)
    mesh = draw_map(axes[1, 0], percent, nodes, "(c) relative deviation",
                    cmap="RdBu_r", vmin=-20, vmax=20)
    figure.colorbar(mesh, ax=axes[1, 0], extend="both",
                    label="(b) less (a), in percent of (a)", **bar)
    mark_unmatched(axes[1, 0], computed, paper)
    draw_scatter(axes[1, 1], computed, paper)
    figure.suptitle(table_caption(computed, paper), fontsize=12)
    save(figure, output / "table_1.png")


# ---------------------------------------------------------------- program


def parse_arguments():
    """The directories of the runs, the paper's table, the page, the output."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name, text in (("results", "directory with the results of each run"),
                       ("table", "the paper's Table 1 (tests/data/table_1.csv)"),
                       ("page", "doc/bias_tire.md, whose tables are rewritten"),
                       ("output", "directory the figures are written to")):
        parser.add_argument(f"--{name}", type=Path, required=True, help=text)
    runs = parser.parse_args()
    for name in READINGS:
        setattr(runs, name, runs.results / name)
    return runs


def replace_table(page, name, header, rows):
    """Rewrites the table of a page between its two comments."""
    ruler = ["---" if i == 0 else "---:" for i in range(len(header))]
    lines = ["| " + " | ".join(row) + " |" for row in [header, ruler, *rows]]
    text, count = re.subn(
        rf"(<!-- table: {name} -->\n).*?(<!-- end of table -->)",
        lambda match: match[1] + "\n".join(lines) + "\n" + match[2],
        page.read_text(encoding="utf-8"), flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{page} must have the table '{name}' once")
    page.write_text(text, encoding="utf-8")


def write_forces(runs):
    """The forces at the approaches of the paper."""
    rows = []
    for approach, independent in INDEPENDENT_FORCES.items():
        nonlinear, linear, lumped = (
            force_at(directory, approach)
            for directory in (runs.nonlinear, runs.linear, runs.lumped))
        rows.append([f"{approach}", f"{nonlinear:.1f}", f"{independent}",
                     f"{linear:.1f}", f"{linear / nonlinear:.2f}",
                     f"{lumped:.1f}"])
    replace_table(runs.page, "forces",
                  ["Δ (mm)", "P (N)", "Independent program (N)",
                   "P, linear theory (N)", "Linear to nonlinear",
                   "P, lumped (N)"], rows)


def write_readings(runs):
    """Force, contact zone and deviation from Table 1 of every reading."""
    paper, rows = read_table(runs.table), []
    for name, text in READINGS.items():
        history = read_history(runs.results / name)
        computed = read_pressures(runs.results / name, history["approach"][-1])
        deviations = relative_deviations(computed, paper)
        inner = [d for node, d in deviations.items() if is_interior(node)]
        rows.append([text, f"{history['force'][-1]:.1f}", f"{len(deviations)}",
                     f"{len(computed) - len(deviations)}",
                     f"{rms(deviations.values()):.3f}", f"{rms(inner):.3f}"])
    replace_table(runs.page, "readings",
                  ["Reading", "P (N)", "Nodes of Table 1 in contact, of "
                   f"{len(paper)}", "Other nodes in contact", "RMS deviation",
                   "RMS deviation, inner nodes"], rows)


def print_comparison(runs):
    """The comparison with Table 1, beyond the caption of its figure."""
    paper = read_table(runs.table)
    computed = read_pressures(runs.nonlinear, 20)
    deviations = relative_deviations(computed, paper)
    inner = [abs(d) for node, d in deviations.items() if is_interior(node)]
    print(table_caption(computed, paper))
    print(f"largest {max(map(abs, deviations.values())):.2f}, "
          f"median at the inner nodes {np.median(inner):.3f}; "
          f"{len(set(computed) - set(paper))} nodes more than in Table 1")
    areas = NodalAreas(runs.nonlinear, 20)
    table, common, others = map(areas.integrate, (
        paper, {node: computed[node] for node in paper if node in computed},
        {node: computed[node] for node in computed if node not in paper}))
    print(f"force at the nodes of Table 1: {table:.1f} N by its pressures, "
          f"{common:.1f} N computed; at other nodes {others:.1f} N")
    for name, values in (("Table 1", paper), ("computed", computed)):
        common = [value for (psi, phi), value in asymmetry(values).items()
                  if (psi, phi) in values and (psi, -phi) in values]
        print(f"{name}: |q(psi, phi) - q(-psi, -phi)| up to "
              f"{central_asymmetry(values):.1e} MPa, |q(psi, phi) - "
              f"q(psi, -phi)| up to {max(common):.3f} MPa where both nodes are "
              f"in contact; maximum pressure {max(values.values()):.3f} MPa")


def print_inflation(runs):
    """The radius of the inflated equator with dead and with true pressure."""
    for name in ("nonlinear", "true_pressure"):
        profile = read_profile(runs.results / name, 0)
        radius = profile["outer_x"][np.argmin(np.abs(profile["alpha_1"]))]
        print(f"{name}: radius of the outer face after inflation "
              f"{radius:.3f} mm")


def main():
    """Draw all figures."""
    runs = parse_arguments()
    runs.output.mkdir(parents=True, exist_ok=True)
    plt.rcParams.update(STYLE)
    draw_load_deflection(runs, runs.output)
    draw_profile(runs, runs.output)
    draw_pressure(runs, runs.output)
    draw_table(runs, runs.output)
    draw_asymmetry(runs, runs.output)
    write_forces(runs)
    write_readings(runs)
    print_inflation(runs)
    print_comparison(runs)


if __name__ == "__main__":
    main()
