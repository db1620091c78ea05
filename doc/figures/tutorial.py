#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of doc/tutorial.md: the tube of cords at several angles beside
laminate theory, and section, force and footprint of the tire."""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface import Results

BLUE, ORANGE, GRAY = "#0072b2", "#d55e00", "0.6"


def tube_strains(angle, n_1=0.25, n_2=0.5, thickness=1.2):
    """Strains along and around the tube of step 2, of plies in plane stress at
    +-angle in degrees."""
    e_l, e_t, g, nu = 510.45, 6.91, 2.33, 0.46
    d = 1 - nu**2 * e_t / e_l
    ply = np.array([[e_l / d, nu * e_t / d, 0], [nu * e_t / d, e_t / d, 0],
                    [0, 0, g]])
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    turn = np.array([[c * c, s * s, c * s], [s * s, c * c, -c * s],
                     [-2 * c * s, 2 * c * s, c * c - s * s]])
    stiffness = thickness * (turn.T @ ply @ turn)[:2, :2]
    return np.linalg.solve(stiffness, [n_1, n_2])


def draw_tube(axes, runs):
    """Radius and length of the tube against the angle of the cords."""
    angles = np.linspace(42, 66, 97)
    strains = np.array([tube_strains(angle) for angle in angles])
    axes.plot(angles, 50 * strains[:, 1], color=BLUE, label="radius")
    axes.plot(angles, 100 * strains[:, 0], color=ORANGE, label="length")
    for run in runs:
        angle = run.plies(1)["angle"][0]
        rows = {row["name"]: row for row in run.probes().rows()}
        radius, length = rows["middle"]["u_3"], rows["end"]["u_1"]
        axes.plot(angle, radius, "o", color=BLUE)
        axes.plot(angle, length, "o", color=ORANGE)
        theory = tube_strains(angle) * [100, 50]
        print(f"{angle:5.1f} degrees: radius {radius:7.3f} ({theory[1]:7.3f}), "
              f"length {length:7.3f} ({theory[0]:7.3f}) mm")
    axes.axvline(np.degrees(np.arctan(np.sqrt(2))), color=GRAY, linewidth=1)
    axes.axhline(0, color=GRAY, linewidth=1)
    axes.legend(frameon=False)
    axes.set(xlabel="angle of the cords from the axis (degrees)",
             ylabel="increase (mm)")


def middle(rows, component):
    """Positions of the middle of the wall."""
    return (rows["inner_" + component] + rows["outer_" + component]) / 2


def draw_section(axes, torus, tire):
    """The section as built, inflated, and pressed against the ground."""
    psi = np.radians(np.linspace(-120, 120, 121))
    axes.plot(52.4 * np.sin(psi), 200 + 52.4 * np.cos(psi), "--", color=GRAY,
              label="as built")
    for run, step, color, label in ((torus, 1, BLUE, "inflated (step 3)"),
                                    (tire, 11, ORANGE, "at 20 mm (step 5)")):
        rows = run.profile(step)
        axes.plot(middle(rows, "y"), middle(rows, "x"), color=color, label=label)
    axes.set_aspect("equal")
    axes.legend(frameon=False, loc="lower center", fontsize="small")
    axes.set(xlabel="y (mm)", ylabel="x (mm)", title="middle of the wall",
             ylim=(160, 258))


def draw_force(axes, coarse, tire):
    """The force against the approach."""
    for run, style, color, label in ((coarse, "s-", GRAY, "coarse (step 4)"),
                                     (tire, "o-", ORANGE, "step 5")):
        contact = run.stage("contact")
        axes.plot(np.append(0, contact.history["approach"]),
                  np.append(0, contact.history["force"]), style, color=color,
                  markersize=4, label=label)
        print(f"{label}: {contact.last('force')} N on "
              f"{contact.last('contact_area')} mm^2")
    axes.legend(frameon=False)
    axes.set(xlabel="approach (mm)", ylabel="force (N)", title="load-deflection",
             xlim=(0, None), ylim=(0, None))


def draw_footprint(figure, axes, tire):
    """The contact pressure at the nodes in contact."""
    nodes = tire.contact(11).where(active=1)
    dots = axes.scatter(nodes["z"], nodes["y"], c=nodes["pressure"], s=14)
    figure.colorbar(dots, ax=axes, label="pressure (MPa)")
    axes.set_aspect("equal")
    axes.set(xlabel="z (mm)", ylabel="y (mm)", title="footprint at 20 mm")


def main():
    """Draw both pictures."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("torus", "coarse", "tire"):
        parser.add_argument(name, type=Results, help="a directory of results")
    parser.add_argument("output", type=Path, help="where the PNG files go")
    parser.add_argument("tubes", type=Results, nargs="+",
                        help="directories of results, one for each angle")
    arguments = parser.parse_args()

    figure, axes = plt.subplots(figsize=(6, 3.6), dpi=100, layout="constrained")
    draw_tube(axes, arguments.tubes)
    figure.savefig(arguments.output / "tutorial_tube.png")

    figure, axes = plt.subplots(1, 3, figsize=(12, 3.7), dpi=100,
                                layout="constrained")
    draw_section(axes[0], arguments.torus, arguments.tire)
    draw_force(axes[1], arguments.coarse, arguments.tire)
    draw_footprint(figure, axes[2], arguments.tire)
    figure.savefig(arguments.output / "tutorial_tire.png")


if __name__ == "__main__":
    main()
