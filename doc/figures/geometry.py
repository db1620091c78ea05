#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of the geometry: Figs. 1 and 2 of the paper.

Reads a shell-NNNN.vtu of prm/tutorial/4_contact.prm and one of
prm/bias_tire.prm, takes the displacements off, and writes

    shell_element.png     an element of the coarse mesh: coordinates, faces,
                          nodal displacements, and the angle of a ply (Fig. 1)
    tire_geometry.png     the tire, its section and the plane (Fig. 2)

Needs VTK to read the files, but no display.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface_report.drawing import BLUE, DISTINCT, GRAY, RED, STYLE, save

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from deformed_tire import CENTER_RADIUS, Face, local_basis, subdivide

# The element that is drawn: between these lines of the mesh (degrees)
PSI, PHI = (45, 60), (0, 3.75)

# Angle of the innermost ply from the meridian (degrees)
PLY_ANGLE = 52

GREEN, ORANGE = DISTINCT[2], DISTINCT[1]

ARROW = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.5,
         "mutation_scale": 12}


# ---------------------------------------------------------------- geometry


def undeformed(path, outer):
    """One face of the shell without its displacements."""
    face = Face(path, outer)
    face.displacement[:] = 0
    return face


def point(face, psi, phi):
    """A point of a face, psi and phi in degrees."""
    return face.positions(np.radians([psi]), np.radians([phi]))[0, 0]


class View:
    """Orthographic projection: positions to the plane of the drawing."""

    def __init__(self, toward_viewer, up):
        """Directions need not be of unit length, nor normal to each other."""
        self.depth = np.array(toward_viewer) / np.linalg.norm(toward_viewer)
        right = np.cross(up, self.depth)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.depth, self.right)

    def __call__(self, positions):
        """Coordinates in the drawing, right and up."""
        return np.stack([positions @ self.right, positions @ self.up], -1)


def arrow(axes, start, end, color="black", **style):
    """An arrow between two points of the drawing."""
    axes.annotate("", xy=end, xytext=start, annotation_clip=False,
                  arrowprops=ARROW | {"color": color} | style)


def arc(center, radius, start, end):
    """Points of a circle, between two angles from x toward y (degrees)."""
    angles = np.radians(np.linspace(start, end, 60))
    return (np.asarray(center)[:, None] +
            radius * np.stack([np.cos(angles), np.sin(angles)])).T


def curved_arrow(axes, points, color):
    """A line through points of the drawing with an arrow at its end."""
    axes.plot(*points[:-1].T, color=color, linewidth=1.5, zorder=4)
    arrow(axes, points[-4], points[-1], color)


def label(axes, text, place, shift, color="black", **style):
    """A text beside a place of the drawing, shifted by points."""
    axes.annotate(text, place, shift, textcoords="offset points", color=color,
                  annotation_clip=False,
                  **({"ha": "center", "va": "center"} | style))


def bare(axes, title):
    """Axes of a drawing: equal scales, nothing but a title."""
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, fontsize=11)


# ---------------------------------------------------------------- element


def element_side(face, psi, phi):
    """A side of the element on a face: one of psi and phi is an interval."""
    psi = np.linspace(*psi, 20) if np.ndim(psi) else np.array([psi])
    phi = np.linspace(*phi, 20) if np.ndim(phi) else np.array([phi])
    return face.positions(np.radians(psi), np.radians(phi)).reshape(-1, 3)


def outline(face):
    """The four sides of the element on a face, one after another."""
    return np.concatenate([
        element_side(face, PSI, PHI[0]), element_side(face, PSI[1], PHI),
        element_side(face, PSI, PHI[1])[::-1],
        element_side(face, PSI[0], PHI)[::-1]])


def frame(psi, phi):
    """Unit vectors e_1, e_2, e_3 at a place (degrees)."""
    return local_basis(np.radians(psi), np.radians(phi))


def draw_faces(axes, view, inner, outer):
    """Both faces of the element, and the sides between them."""
    axes.fill(*view(outline(inner)).T, color="#9fc3e6", alpha=0.75, zorder=1)
    axes.fill(*view(outline(outer)).T, color="0.75", alpha=0.4, zorder=2)
    for face, color in ((inner, BLUE), (outer, "0.2")):
        axes.plot(*view(outline(face)).T, color=color, linewidth=1.6, zorder=3)
    for psi in PSI:
        for phi in PHI:
            nodes = view(np.stack([point(face, psi, phi)
                                   for face in (inner, outer)]))
            axes.plot(*nodes.T, color="0.2", linewidth=1.1, zorder=3)
            axes.plot(*nodes.T, "o", color="black", markersize=5, zorder=5)


def draw_displacements(axes, view, faces):
    """The six displacement components of one node, three on each face."""
    psi, phi = PSI[1], PHI[0]
    offsets = ({1: (14, -4), 2: (14, -7), 3: (-13, -3)},
               {1: (14, -4), 2: (14, 4), 3: (0, 13)})
    for face, sign, color, offset in zip(faces, "−+", (BLUE, RED), offsets):
        start = point(face, psi, phi)
        for i, direction in enumerate(frame(psi, phi), 1):
            end = view(start + (2.6 if i == 3 else 3.6) * direction)
            arrow(axes, view(start), end, color, linewidth=1.8)
            label(axes, f"$v_{i}^{sign}$", end, offset[i], color, fontsize=14)


def draw_coordinates(axes, view, inner, outer):
    """The coordinate lines through a node of the reference surface."""
    psi, phi = PSI[0], PHI[0]
    start = point(inner, psi, phi)
    lines = {
        1: element_side(inner, (psi, psi + 8.5), phi),
        2: element_side(inner, psi, (phi, phi + 2.2)),
        3: np.linspace(start, start + 9.5 * frame(psi, phi)[2], 20)}
    shifts = {1: (0, -15), 2: (-14, 10), 3: (-15, 2)}
    for i, line in lines.items():
        line = view(line)
        axes.plot(*line.T, color=GREEN, linewidth=2.6, zorder=4)
        arrow(axes, line[-3], line[-1], GREEN, linewidth=2.2)
        label(axes, rf"$\alpha_{i}$", line[-1], shifts[i], GREEN, fontsize=16)


def draw_element(axes, path):
    """An element: its faces, coordinates, nodes and their displacements."""
    inner, outer = undeformed(path, 0), undeformed(path, 1)
    middle = np.mean(PSI), np.mean(PHI)
    e_1, e_2, e_3 = frame(*middle)
    view = View(0.42 * e_1 - 0.72 * e_2 + 0.55 * e_3, e_3)
    draw_faces(axes, view, inner, outer)
    draw_coordinates(axes, view, inner, outer)
    draw_displacements(axes, view, (inner, outer))

    middle = np.mean(PSI)
    label(axes, r"outer face: $\alpha_3=\delta^+$",
          view(point(outer, middle, PHI[1])), (40, 22))
    label(axes, r"inner face: $\alpha_3=\delta^-$",
          view(point(inner, PSI[1], PHI[1])), (10, -8), BLUE, ha="left")
    thickness = view(np.stack([point(face, *place) for face, place in
                               ((inner, (PSI[0], PHI[1])),
                                (outer, (PSI[0], PHI[1])))])) - [1.0, 0]
    axes.annotate("", xy=thickness[1], xytext=thickness[0],
                  arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0})
    label(axes, "$h$", thickness.mean(0), (-11, 0), fontsize=13)
    bare(axes, "(a) an element, and the unknowns of one of its nodes")


def draw_ply_angle(axes):
    """A patch of the shell as seen from outside, with the cords of two plies."""
    size = 1.0
    turn = np.radians(PLY_ANGLE)
    patch = plt.Rectangle((-size, -size), 2 * size, 2 * size, facecolor="0.95",
                          edgecolor="0.6")
    axes.add_patch(patch)
    for angle, color, alpha in ((-turn, GRAY, 0.35), (turn, ORANGE, 0.9)):
        along = np.array([np.cos(angle), np.sin(angle)])
        across = np.array([-along[1], along[0]])
        for shift in np.arange(-8, 9) * 0.22:
            ends = shift * across + np.outer([-3, 3], along)
            line, = axes.plot(*ends.T, color=color, alpha=alpha,
                              linewidth=1.8 if shift == 0 else 1)
            line.set_clip_path(patch)
    for end, text, place in (((1.45, 0), r"$\mathbf{e}_1$  (along $\alpha_1$,"
                              "\nthe meridian)", (1.5, 0)),
                             ((0, 1.35), r"$\mathbf{e}_2$  (along $\alpha_2$)",
                              (0, 1.42))):
        arrow(axes, (0, 0), end, GREEN, linewidth=2.2)
        axes.text(*place, text, color=GREEN, fontsize=12,
                  ha="left" if end[0] else "center",
                  va="center" if end[0] else "bottom")
    axes.plot(0, 0, "o", markersize=11, markerfacecolor="white",
              markeredgecolor=GREEN, markeredgewidth=2, zorder=6)
    axes.plot(0, 0, "o", markersize=3.5, color=GREEN, zorder=7)
    axes.text(-0.1, -0.12, r"$\mathbf{e}_3$", color=GREEN, fontsize=12,
              ha="right", va="top", zorder=7,
              bbox={"facecolor": "0.95", "edgecolor": "none", "pad": 0.5})
    curved_arrow(axes, arc((0, 0), 0.46, 0, PLY_ANGLE), "black")
    axes.text(0.49, 0.24, r"$\gamma > 0$", fontsize=13, va="center",
              bbox={"facecolor": "0.95", "edgecolor": "none", "pad": 0.5})
    axes.text(0, -1.12, f"cords at γ = +{PLY_ANGLE}°", color=ORANGE,
              ha="center", va="top", fontsize=11)
    axes.text(0, -1.34, f"next ply, γ = −{PLY_ANGLE}°", color="0.45",
              ha="center", va="top", fontsize=11)
    bare(axes, "(b) seen from outside, $\\mathbf{e}_3$ toward you")
    axes.set(xlim=(-1.2, 2.35), ylim=(-1.6, 1.65))


def draw_shell_element(path, output):
    """Fig. 1: the element and the angle of a ply."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.6),
                                gridspec_kw={"width_ratios": (1.35, 1)},
                                layout="constrained")
    draw_element(axes[0], path)
    draw_ply_angle(axes[1])
    save(figure, output / "shell_element.png", dpi=120)


# ---------------------------------------------------------------- tire


def quadrilaterals(points):
    """The cells of a grid of points, as rows of four corners."""
    return np.stack([points[:-1, :-1], points[1:, :-1], points[1:, 1:],
                     points[:-1, 1:]], 2).reshape(-1, 4, 3)


def shaded(cells, color, view):
    """Colors of cells, darker where they are seen at an angle."""
    normal = np.cross(cells[:, 2] - cells[:, 0], cells[:, 3] - cells[:, 1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    light = view.depth + 0.35 * view.up - 0.45 * view.right
    share = 0.42 + 0.58 * np.abs(normal @ light) / np.linalg.norm(light)
    return np.clip(share[:, None] * np.array(color), 0, 1)


def draw_half_tire(axes, faces, view):
    """The half of the tire with negative phi, and its mesh."""
    cells, colors = [], []
    for face, color in zip(faces, ((0.93, 0.93, 0.94), (0.66, 0.72, 0.80))):
        psi = subdivide(face.psi, np.radians(2.5))
        phi = subdivide(np.radians([-180, 0]), np.radians(2.5))
        part = quadrilaterals(face.positions(psi, phi))
        cells.append(part)
        colors.append(shaded(part, color, view))
    inner, outer = faces
    for end in (0, -1):
        phi = subdivide(np.radians([-180, 0]), np.radians(2.5))
        rim = np.stack([face.positions(face.psi[[end]], phi)[0]
                        for face in faces])
        part = quadrilaterals(rim)
        cells.append(part)
        colors.append(shaded(part, (0.5, 0.5, 0.5), view))
    psi = subdivide(inner.psi, np.radians(2.5))
    for angle in (0, np.pi):
        section = np.stack([face.positions(psi, np.array([angle]))[:, 0]
                            for face in faces])
        part = quadrilaterals(section)
        cells.append(part)
        colors.append(np.tile((0.12, 0.37, 0.66), (len(part), 1)))
    cells, colors = np.concatenate(cells), np.concatenate(colors)
    order = np.argsort(cells.mean(1) @ view.depth)
    axes.add_collection(PolyCollection(
        view(cells[order]), facecolors=colors[order], edgecolors=colors[order],
        linewidths=0.4, zorder=2))


def draw_axis(axes, view, start, end, text, shift):
    """A coordinate axis as an arrow with its name."""
    start, end = view(np.array(start)), view(np.array(end))
    arrow(axes, start, end, zorder=5)
    label(axes, text, end, shift, fontsize=13)


def draw_wheel(axes, faces):
    """The tire cut in half, the axes, the plane and the angle phi."""
    view = View((-0.33, 0.62, 1), (-1, 0, 0))
    top = 254.8
    plane = np.array([[top, y, z] for y, z in
                      ((-100, -150), (-100, 190), (130, 190), (130, -150))])
    axes.fill(*view(plane).T, facecolor="#dbe6f1", edgecolor="0.5", zorder=1)
    axes.text(*view(np.array([top, 105, 150])), "plane", ha="right",
              color="0.3", fontsize=11)
    draw_half_tire(axes, faces, view)
    draw_axis(axes, view, (0, -150, 0), (0, 190, 0), "$y$  (axle)", (28, 6))
    draw_axis(axes, view, (0, 0, 0), (205, 0, 0), "$x$", (-12, 4))
    draw_axis(axes, view, (0, 0, 0), (0, 0, 190), "$z$", (-12, -2))
    angles = np.radians(np.linspace(0, 62, 60))
    line = 120 * np.stack([np.cos(angles), 0 * angles, np.sin(angles)], -1)
    curved_arrow(axes, view(line), GREEN)
    label(axes, r"$\varphi = \alpha_2$", view(line[30]), (-16, -10), GREEN,
          fontsize=13, ha="right")
    axes.autoscale_view()
    bare(axes, r"(a) the tire, its half $-180° \leq \varphi \leq 0$")


def in_section(positions):
    """The section phi = 0 in the drawing: y to the right, x downward."""
    return np.stack([positions[..., 1], -positions[..., 0]], -1)


def draw_walls(axes, faces):
    """The wall, the lines of the mesh across it, and the fixed edges."""
    psi = subdivide(faces[0].psi, np.radians(1))
    inner, outer = (in_section(face.positions(psi, np.zeros(1))[:, 0])
                    for face in faces)
    axes.fill(*np.concatenate([inner, outer[::-1]]).T, color="0.86", zorder=1)
    axes.plot(*inner.T, color=BLUE, linewidth=1.6)
    axes.plot(*outer.T, color="0.2", linewidth=1.2)
    lines = np.stack([in_section(face.positions(face.psi, np.zeros(1))[:, 0])
                      for face in faces])
    axes.plot(*lines.transpose(2, 0, 1), color="0.45", linewidth=0.6)
    for end in (0, -1):
        axes.plot(*lines[:, end].T, color="black", linewidth=4.5,
                  solid_capstyle="butt", zorder=4)


def draw_section(axes, faces):
    """The section in the plane phi = 0 with its measures, to scale."""
    draw_walls(axes, faces)
    center = np.array([0, -CENTER_RADIUS])
    axes.plot([-68, 78], [0, 0], color="0.3", linewidth=1,
              linestyle=(0, (9, 3, 2, 3)))
    axes.text(78, 5, "axle, $y$", ha="right", va="bottom", fontsize=11)

    double = {"arrowstyle": "<|-|>", "shrinkA": 0, "shrinkB": 0,
              "mutation_scale": 11, "color": "0.15"}
    axes.annotate("", xy=(0, -250), xytext=(0, 0), arrowprops=double)
    axes.text(-5, -110, "$R_0$", fontsize=13, ha="right")
    tip = center + 50 * np.array([np.sin(np.radians(-50)),
                                  -np.cos(np.radians(-50))])
    arrow(axes, center, tip, "0.15")
    axes.text(-24, -209, "$R_1$", fontsize=13, ha="right")
    axes.plot(*center, "o", color="0.15", markersize=4)

    curved_arrow(axes, arc(center, 32, -90, -36), GREEN)
    ray = center + np.outer([0, 50], [np.sin(np.radians(54)),
                                      -np.cos(np.radians(54))])
    axes.plot(*ray.T, color=GREEN, linewidth=1, linestyle="--")
    axes.text(16, -238, r"$\psi = \alpha_1$", color=GREEN, fontsize=12,
              ha="center", va="center")
    axes.text(18, -30, "$R_0$ = 250 mm\n$R_1$ = 50 mm\n$h$ = 4.8 mm", va="top",
              fontsize=11, linespacing=1.5)
    axes.text(18, -92, "reference surface:\ninner face", color=BLUE, va="top",
              fontsize=11)

    for psi, text, place in ((120, "ψ = 120°,\nfixed", (60, -160)),
                             (-120, "ψ = −120°,\nfixed", (-60, -160))):
        axes.text(*place, text, fontsize=10, va="center",
                  ha="left" if psi > 0 else "right")

    start = point(faces[1], 75, 0)
    e_1, _, e_3 = frame(75, 0)
    for direction, text, shift in ((e_1, r"$\mathbf{e}_1$", (8, 4)),
                                   (e_3, r"$\mathbf{e}_3$", (9, -2))):
        end = in_section(start + 24 * direction)
        arrow(axes, in_section(start), end, GREEN)
        label(axes, text, end, shift, GREEN, fontsize=12)
    wall = in_section(point(faces[0], -68, 0) + point(faces[1], -68, 0)) / 2
    axes.annotate("$h$", wall, (-72, -226), fontsize=13, ha="center",
                  va="center", arrowprops={"arrowstyle": "-", "shrinkB": 0,
                                           "color": "0.3"})

    ground = -268
    axes.plot([-78, 78], [ground] * 2, color="0.2", linewidth=1.4)
    axes.fill_between([-78, 78], ground - 6, ground, facecolor="none",
                      edgecolor="0.6", hatch="////", linewidth=0)
    arrow(axes, (62, ground), (62, ground + 20), RED)
    axes.text(66, ground + 11, "Δ", color=RED, fontsize=13, va="center")
    arrow(axes, (0, ground - 7), (0, ground - 29))
    axes.text(5, ground - 20, r"normal $\mathbf{e}_x$", fontsize=11,
              va="center")
    axes.set(xlim=(-92, 92), ylim=(-300, 22))
    bare(axes, r"(b) section $\varphi = 0$, to scale")


def draw_tire(path, output):
    """Fig. 2: the tire and the plane."""
    faces = undeformed(path, 0), undeformed(path, 1)
    figure, axes = plt.subplots(1, 2, figsize=(9, 6.4),
                                gridspec_kw={"width_ratios": (1.25, 1)},
                                layout="constrained")
    draw_wheel(axes[0], faces)
    draw_section(axes[1], faces)
    save(figure, output / "tire_geometry.png", dpi=120)


# ---------------------------------------------------------------- program


def main():
    """Draw both figures."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("coarse", type=Path,
                        help="shell-NNNN.vtu of prm/tutorial/4_contact.prm")
    parser.add_argument("tire", type=Path,
                        help="shell-NNNN.vtu of prm/bias_tire.prm")
    parser.add_argument("output", type=Path, help="where the PNG files go")
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE | {"axes.titlepad": 10})
    draw_shell_element(arguments.coarse, arguments.output)
    draw_tire(arguments.tire, arguments.output)


if __name__ == "__main__":
    main()
