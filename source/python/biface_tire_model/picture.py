# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a tire model, with the points of a tire test on them."""

import numpy as np
from biface_report.drawing import STYLE, plt, save, shades

from .table import ANGLE_STEP

# Slip angles of the curves of the friction ellipse, in degrees
ANGLES = (0, 2, 4, 8)


def draw(formula, ranges, path, data=None):
    """Writes the figure of curves() to a pdf, svg or png file."""
    save(curves(formula, ranges, data), path)


def ranges_of(columns, data=None):
    """What curves() needs of columns or Measurements: at most six of their loads, and their
    largest slips."""
    loads = np.unique(columns["F_z"]) if data is None else data.levels("F_z")[0]
    ranges = {"loads": loads[np.linspace(0, len(loads) - 1, min(len(loads), 6))
                             .round().astype(int)]}
    for name, otherwise in (("slip_angle", np.radians(12)), ("slip_ratio", 0.25)):
        ranges[name] = np.abs(columns[name]).max() or otherwise
    return ranges


def curves(formula, ranges, data=None):
    """A figure: F_y and M_z over the slip angle and F_x over the longitudinal slip for
    several loads, and F_y over F_x at combined slip.

    formula  a MagicFormula
    ranges   a dictionary: the loads of the curves [N], and the largest slip_angle [rad]
             and slip_ratio
    data     Measurements; those without camber, at the usual pressure, are drawn
    """
    plt.rcParams.update(STYLE)
    figure, panels = plt.subplots(2, 2, figsize=(10.5, 8))
    data = upright(data, formula)
    draw_sweep(panels[0, 0], formula, ranges, data, "slip_angle", "F_y")
    draw_sweep(panels[0, 1], formula, ranges, data, "slip_angle", "M_z")
    draw_sweep(panels[1, 0], formula, ranges, data, "slip_ratio", "F_x")
    draw_ellipse(panels[1, 1], formula, ranges, data)
    panels[0, 0].legend(title="load", fontsize=9)
    panels[1, 1].legend(title="slip angle", fontsize=9, loc="center")
    figure.tight_layout()
    return figure


def upright(data, formula):
    """The states without camber, at the nominal pressure if there is one."""
    if data is None:
        return None
    chosen = np.abs(data["inclination_angle"]) <= ANGLE_STEP
    if data["pressure"] is not None and formula.nominal_pressure:
        chosen &= np.abs(data["pressure"] / formula.nominal_pressure - 1) < 0.03
    return data.where(chosen)


def draw_sweep(panel, formula, ranges, data, slip, force):
    """A panel with a curve for each load."""
    degrees = 180 / np.pi if slip == "slip_angle" else 100
    slips = np.linspace(-1, 1, 401) * ranges[slip]
    argument = "alpha" if slip == "slip_angle" else "kappa"
    for load, color in zip(ranges["loads"], shades(len(ranges["loads"]))):
        values = getattr(formula.evaluate(load, **{argument: slips}), force)
        panel.plot(slips * degrees, values, color=color, linewidth=1.5,
                   label=f"{load:.0f} N")
        if data is not None:
            other = data.is_lateral if slip == "slip_angle" else data.is_longitudinal
            chosen = other & (np.abs(data["F_z"] / load - 1) < 0.03)
            panel.plot(data[slip][chosen] * degrees, data[force][chosen], "o",
                       color=color, markersize=3.5, markerfacecolor="none")
    panel.set_xlabel("slip angle [degrees]" if slip == "slip_angle"
                     else "longitudinal slip [%]")
    panel.set_ylabel(f"${force}$ [N]" if force[0] == "F" else f"${force}$ [N m]")


def draw_ellipse(panel, formula, ranges, data):
    """F_y over F_x, for slip angles on both sides, at the load in the middle."""
    load = ranges["loads"][len(ranges["loads"]) // 2]
    slips = np.linspace(-1, 1, 401) * ranges["slip_ratio"]
    angles = [angle for angle in np.radians(ANGLES) if angle <= ranges["slip_angle"]]
    if data is not None and (~data.is_lateral & ~data.is_longitudinal).any():
        levels = data.where(~data.is_lateral).levels("slip_angle")[0]
        angles = np.radians(np.unique(np.round(np.degrees(np.abs(levels)), 1))[:6])
    for angle, color in zip(angles, shades(len(angles))):
        for side in (1, -1) if angle else (1,):
            forces = formula.evaluate(load, slips, side * angle)
            panel.plot(forces.F_x, forces.F_y, color=color, linewidth=1.5,
                       label=f"{np.degrees(angle):.3g}°" if side == 1 else None)
    if data is not None:
        chosen = (np.abs(data["F_z"] / load - 1) < 0.03) & ~data.is_lateral
        panel.plot(data["F_x"][chosen], data["F_y"][chosen], "o", color="0.4",
                   markersize=3, markerfacecolor="none")
    panel.set_aspect("equal", adjustable="datalim")
    panel.xaxis.set_major_locator(plt.MaxNLocator(5))
    panel.set_xlabel("$F_x$ [N]")
    panel.set_ylabel(f"$F_y$ [N], load {load:.0f} N")
