# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures to scale: the footprint and the deformed section."""

import matplotlib.pyplot as plt
import numpy as np

from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import ScaledTranslation

from .drawing import shades
from .section import points_of

# Pressures: none is white, and paper shows all of them
PRESSURE_COLORS = plt.get_cmap("YlOrRd")

# Sections longer than this times their height are not drawn to scale
SLENDER = 12

# Sections drawn at most
GREATEST_NUMBER_OF_SECTIONS = 6


# ---------------------------------------------------------------- footprint


def draw_footprint(footprint):
    """The contact pressure, the outline of the zone and its principal axes. The
    longer side of the zone lies horizontally."""
    order = [0, 1]
    chosen = footprint.outline_points()
    if np.ptp(chosen[:, 1]) > np.ptp(chosen[:, 0]):
        order = [1, 0]
    spread = np.ptp(footprint.points[:, order], axis=0)
    width = 5.6
    height = np.clip(width * spread[1] / spread[0], 1.5, 6) + 1.6
    figure, axes = plt.subplots(figsize=(width, height))
    triangulation = footprint.triangulation()
    triangulation.x, triangulation.y = footprint.points[:, order].T
    colors = axes.tripcolor(triangulation, footprint.fine_pressure,
                            shading="gouraud", cmap=PRESSURE_COLORS, vmin=0)
    for line in footprint.outline:
        axes.plot(*line[:, order].T, color="black", linewidth=1.3)
    axes.plot(*footprint.nodes[footprint.active][:, order].T, ".",
              color="0.25", markersize=2.5)
    draw_principal_axes(axes, footprint, order)
    axes.set_aspect("equal")
    axes.margins(0.03)
    axes.grid(False)
    names = [footprint.axis_names[i] for i in order]
    axes.set(xlabel=f"{names[0]} [length]", ylabel=f"{names[1]} [length]")
    figure.colorbar(colors, ax=axes, orientation="horizontal", aspect=35,
                    pad=0.16 if height > 4 else 0.28,
                    label="contact pressure [force/length²]")
    return figure


def draw_principal_axes(axes, footprint, order):
    """Both axes, as long as the zone."""
    points = footprint.outline_points() - footprint.center
    for axis in footprint.principal:
        along = points @ axis
        ends = footprint.center + np.outer([along.min(), along.max()], axis)
        axes.plot(*ends[:, order].T, color="black", linewidth=0.8,
                  linestyle=(0, (8, 3, 2, 3)))


# ---------------------------------------------------------------- section


def chosen_steps(steps):
    """The first step, the last, and some between them."""
    count = min(len(steps), GREATEST_NUMBER_OF_SECTIONS)
    places = np.round(np.linspace(0, len(steps) - 1, count)).astype(int)
    return [steps[i] for i in places]


def draw_sections(plane, profiles, labels, foundation):
    """Both faces of the section in several steps.

    profiles and labels are lists of one for each step; foundation holds a line
    for each step, see SectionPlane.foundation(), or None. A section of which
    nothing would be seen to scale is stretched. Returns the figure, and whether
    it is to scale."""
    figure, axes = plt.subplots(figsize=(5.6, 4.6))
    colors = shades(len(profiles))
    for profile, label, color in zip(profiles, labels, colors):
        is_last = profile is profiles[-1]
        for face in ("outer", "inner"):
            line = plane.project(points_of(profile, face))
            axes.plot(*line.T, color=color, linewidth=2 if is_last else 1.1,
                      label=label if face == "outer" else None)
    # the lines of the foundation must not widen the picture
    left, right, low, high = axes.axis()
    for line, color in zip(foundation, colors):
        if line is not None:
            point, direction = line
            axes.axline(point, point + direction, color=color, linewidth=0.9,
                        linestyle=(0, (7, 3)), zorder=1)
            low = min(low, point[1] - 0.03 * (right - left))
    names, is_down = plane.labels()
    axes.set(xlim=(left, right), ylim=(low, high), xlabel=f"{names[0]} [length]",
             ylabel=f"{names[1]} [length]")
    sides = sorted((right - left, high - low))
    is_to_scale = sides[1] < SLENDER * sides[0]
    if is_to_scale:
        axes.set_aspect("equal")
        # as many numbers as there is room for
        scale = min(4.6 / (right - left), 3.4 / (high - low))
        for axis, length, room in ((axes.xaxis, right - left, 0.6),
                                   (axes.yaxis, high - low, 0.4)):
            axis.set_major_locator(
                MaxNLocator(nbins=int(np.clip(scale * length / room, 1, 9))))
    if is_down:
        # upward on paper is toward smaller values
        axes.yaxis.set_major_formatter(
            lambda value, _: f"{0 - value:g}".replace("-", "−"))
    # as far below the axes in points, however flat they are
    below = ScaledTranslation(0, -42 / 72, figure.dpi_scale_trans)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0), ncol=2,
                fontsize=10, bbox_transform=axes.transAxes + below)
    return figure, is_to_scale
