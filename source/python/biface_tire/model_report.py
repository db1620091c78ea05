# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a tire model."""

import html

import numpy as np

from biface_report.drawing import DISTINCT, STYLE, embed, plt
from biface_report.page import Section, figure, page, paragraph, table
from biface_report.tire_test import tire_test
from biface_tire_model.picture import curves, ranges_of
from .protocol import STEADY

# Tables that have load and deflection, and those drawn over the load
LOADED = ("radial_stiffness", "transversal_bar", "longitudinal_bar")
MOVED = ("lateral_stiffness", "longitudinal_stiffness", "torsional_stiffness")


def write_report(outcome, title, words, path):
    """Writes the page: the summary as text, the fit, the standing tire, the points of the
    rolling one."""
    plt.rcParams.update(STYLE)
    sections = [Section("summary", "Summary", f"<pre>{html.escape(words)}</pre>", True)]
    if outcome.fit:
        formula = outcome.fit.formula
        drawing = curves(formula, ranges_of(outcome.data, outcome.data), outcome.data)
        sections.append(Section("fit", "Magic Formula", figure(
            embed(drawing),
            "Lateral force and aligning moment over the slip angle, longitudinal force over "
            "the longitudinal slip, and both forces at combined slip.",
            "Points: computed states of the upright tire at the nominal pressure. Curves: "
            f"the fitted formula {formula.name}."), True))
        leaning = of_camber(outcome)
        if leaning:
            sections.append(leaning)
    standing = of_standing(outcome.tables)
    if standing:
        sections.append(standing)
    for run in outcome.series.runs:
        results = outcome.series.results.get(run.name)
        section = tire_test(results) if run.kind == STEADY and results else None
        if section:
            sections.append(section._replace(
                name=f"{section.name}-{run.name}", title=f"Rolling: {run.name}"))
    path.write_text(page(title, paragraph(
        f"Computed by biface for {html.escape(str(outcome.tire.path))}. Forces are those of "
        "the ground on the tire in the axes of ISO 8855."), sections), encoding="utf-8")


def numbers(rows, column):
    """The numbers of a column of a table, NaN where it is empty."""
    return np.array([float(row[column] or "nan") for row in rows])


def of_camber(outcome):
    """F_y of the wheel that rolls straight ahead over its inclination; None if there are
    fewer than two inclinations."""
    data, formula = outcome.data, outcome.fit.formula
    straight = data.where(data.is_lateral & data.is_longitudinal)
    angles = straight.levels("inclination_angle")[0]
    if len(angles) < 2:
        return None
    drawing, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    range_of = np.linspace(angles.min(), angles.max(), 101)
    for load, color in zip(straight.levels("F_z")[0], DISTINCT):
        chosen = np.abs(straight["F_z"] / load - 1) < 0.03
        if formula.nominal_pressure:
            chosen &= np.abs(straight["pressure"] / formula.nominal_pressure - 1) < 0.03
        axes.plot(np.degrees(straight["inclination_angle"][chosen]), straight["F_y"][chosen],
                  "o", color=color, markerfacecolor="none")
        axes.plot(np.degrees(range_of), formula.evaluate(load, gamma=range_of).F_y,
                  color=color, label=f"{load:.0f} N")
        axes.plot(np.degrees(range_of), -load * np.tan(range_of), ":", color=color,
                  linewidth=0.9)
    axes.set(xlabel="inclination angle [degrees]", ylabel="$F_y$ [N]")
    axes.legend(fontsize=8)
    return Section("camber", "Leaning wheel", figure(
        embed(drawing), "Lateral force over the inclination angle at zero slip.",
        "Lateral force of the wheel that rolls straight ahead; points: computed, curves: "
        "fitted, dots: load times the tangent of the inclination."))


def of_standing(tables):
    """Charts of the tables of standing tires, and these tables; None without any."""
    if not tables:
        return None
    drawing, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4), layout="constrained")
    colors = iter(DISTINCT * 4)
    drawn = [False, False]
    for name, found in tables.items():
        plain = name.removeprefix("leaning_")
        if plain.startswith(LOADED):
            draw_radial(left, name, found, colors)
            drawn[0] = True
        elif plain in MOVED and not plain.startswith("torsional"):
            label = name.replace("_", " ")
            columns = [column.partition(" [")[0] for column in found.columns]
            for pressure in sorted({row[columns.index("pressure")] for row in found.rows}):
                rows = [row for row in found.rows
                        if row[columns.index("pressure")] == pressure]
                right.plot(numbers(rows, columns.index("load")),
                           numbers(rows, columns.index("first_secant")) / 1000, "o-",
                           color=next(colors), markersize=4,
                           label=f"{label}, {float(pressure) / 1e6:.4g} MPa")
            drawn[1] = True
    left.set(xlabel="deflection [mm]", ylabel="load [N]")
    right.set(xlabel="load [N]", ylabel="stiffness [N/mm]")
    right.set_ylim(bottom=0)
    # room for the legend
    left.set_ylim(0, 1.4 * left.get_ylim()[1])
    parts = []
    if any(drawn):
        for axes, is_drawn in zip((left, right), drawn):
            if is_drawn:
                axes.legend(fontsize=8)
            else:
                axes.set_visible(False)
        parts.append(figure(embed(drawing), "Load over deflection, and stiffnesses in the "
                            "plane of the ground over the load.",
                            "Standing tire, pressed on the ground without friction; lateral "
                            "and longitudinal stiffness of the glued footprint."))
    plt.close(drawing)
    parts += [table(found.title, found.columns, [list(map(rounded, row))
                                                 for row in found.rows])
              for found in tables.values()]
    return Section("standing", "Standing tire", "\n".join(parts), True)


def draw_radial(axes, name, found, colors):
    """Load over deflection, a curve for each pressure and inclination."""
    columns = [column.partition(" [")[0] for column in found.columns]
    place = columns.index("pressure")
    leaning = [row[0].partition(" leaning by ")[2].partition(" degree")[0]
               for row in found.rows]
    for pressure, angle in sorted({(row[place], lean)
                                   for row, lean in zip(found.rows, leaning)}):
        rows = [row for row, lean in zip(found.rows, leaning)
                if row[place] == pressure and lean == angle]
        label = name.removeprefix("leaning_").replace("_", " ").replace(
            "radial stiffness", "plane")
        axes.plot(1000 * numbers(rows, columns.index("deflection")),
                  numbers(rows, columns.index("load")), "o-", markersize=3,
                  color=next(colors), label=f"{label}, {float(pressure) / 1e6:.4g} MPa"
                  + (f", leaning by {angle}°" if angle else ""))


def rounded(cell):
    """A cell with five digits, if it is a number."""
    try:
        return f"{float(cell):.5g}"
    except ValueError:
        return html.escape(str(cell))
