# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections on named points: displacements and ply stresses."""

from html import escape

from . import plies
from .drawing import embed
from .page import LeftOut, Section, figure, number, paragraph, table
from .units import units_of


def points(run):
    """Displacements of the named points."""
    name = "Named points"
    if run.setting("Named points", "?") == "":
        return LeftOut(name, "The input names no points.")
    probes = run.probes()
    if probes is None:
        return LeftOut(
            name, "probes.csv is missing; it is written if there are named "
            "points.")
    rows = probes.where(probes["step"] == run.step)
    if len(rows) == 0:
        return LeftOut(
            name, f"probes.csv has no line of step {run.step}.")
    scale = max(abs(rows["u_" + axis]).max() for axis in "xyz")
    cells = [[escape(rows["name"][i])]
             + [number(rows["u_" + axis][i], scale=scale) for axis in "xyz"]
             for i in range(len(rows))]
    return Section("points", name, table(
        f"Displacements [{units_of(run)['length']}] of the middle surface in step "
        f"{run.step}",
        ["Point"] + [f"<i>u<sub>{axis}</sub></i>" for axis in "xyz"], cells))


def ply_stresses(run):
    """Stresses through the thickness at the named points."""
    name = "Stresses in the plies"
    if run.setting("Output/Points per ply") == "0":
        return LeftOut(
            name, "Output/Points per ply is 0.")
    if run.setting("Named points", "?") == "":
        return LeftOut(
            name, "The input names no points.")
    values = run.plies()
    if values is None or len(values) == 0:
        return LeftOut(
            name, f"{run.path('plies').name} is missing or empty.")
    colors = plies.material_colors(values)
    columns = plies.quantities(values)
    parts = [paragraph(
        "Second Piola–Kirchhoff stresses in the axes of each ply, over the height "
        "above the reference surface; the inner face is at the bottom. In a "
        "material without fibers, the axes follow the angle of the ply."
        + (" A ply fails at an index of 1 (dashes)."
           if len(columns) > len(plies.STRESSES) else ""))]
    parts.append(material_key(colors))
    units = units_of(run)
    for point in plies.points(values):
        rows = values.where(values["name"] == point)
        charts_of_point = "\n".join(
            figure(embed(plies.draw_quantity(rows, column, colors, units)),
                    f"Chart of the {(plies.STRESSES | plies.INDICES)[column]} "
                    f"through the thickness at {point}.") for column in columns)
        parts += [f"<h3>{escape(point)}</h3>",
                  f'<div class="panels">\n{charts_of_point}\n</div>',
                  ply_table(point, rows, columns, units)]
    return Section("plies", name, "\n".join(parts), True)


def material_key(colors):
    """The legend: the color of each material."""
    return paragraph("Materials: " + ", ".join(
        f'<span style="color:{css_color(color)}" aria-hidden="true">●</span> '
        + escape(material) for material, color in colors.items()) + ".")


def css_color(color):
    """A matplotlib color in CSS."""
    return color if color.startswith("#") else "#595959"


def ply_table(point, rows, columns, units):
    """The numbers of the charts."""
    heads = ["Ply", "Material", "Angle",
             f"Fiber tension<br><small>{units['tension']}</small>"]
    short = {"s_L": "<i>σ<sub>L</sub></i>", "s_T": "<i>σ<sub>T</sub></i>",
             "t_LT": "<i>τ<sub>LT</sub></i>",
             "maximum_stress_index": "Index,<br>maximum stress",
             "tsai_wu_index": "Index,<br>Tsai–Wu"}
    heads += [short[column] for column in columns]
    body = []
    scale = plies.scale(rows)
    for line in plies.summary(rows, columns):
        cells = [str(line["ply"]), escape(line["material"]),
                 number(line["angle"], 4) + "°",
                 number(line["tension"], 4, scale)]
        for column in columns:
            low, high = line[column]
            if column in plies.INDICES:
                cells.append(number(high, 3))
            elif low == high:
                cells.append(number(low, 4, scale))
            else:
                cells.append(f"{number(low, 4, scale)} to "
                             f"{number(high, 4, scale)}")
        body.append(cells)
    return table(f"Plies at {point}, innermost first; stresses "
                 f"[{units['pressure']}], maximum indices", heads, body)
