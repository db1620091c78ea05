# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures to scale: the footprint and the deformed section."""

import matplotlib.pyplot as plt
import numpy as np

from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.ticker import MaxNLocator

from .curved import curved_line
from .drawing import legend_below, shades

# For pressures: no color is white, and all of them print well
PRESSURE_COLORS = plt.get_cmap("YlOrRd")

# Sections longer than this many times their height are not drawn to scale
SLENDER = 12

# Sections drawn at most
MAXIMUM_SECTIONS = 6


# ---------------------------------------------------------------- footprint


def frame(*footprints):
    """What a picture of some footprints shows: the order of the axes, the longer side
    of the zone first, and the lower and upper limits."""
    points = np.concatenate([part for footprint in footprints for part in
                             (*footprint.outline,
                              footprint.nodes[footprint.active])])
    order = [0, 1] if np.ptp(points[:, 0]) >= np.ptp(points[:, 1]) else [1, 0]
    low, high = points[:, order].min(0), points[:, order].max(0)
    margin = 0.05 * (high - low).max()
    return order, low - margin, high + margin


def draw_footprint(footprint, units, shown=None, maximum=None):
    """The contact pressure, the outline of the zone and its principal axes. shown: a
    frame(); maximum: the pressure at the end of the color bar."""
    order, low, high = shown or frame(footprint)
    spread = high - low
    width = 5.6
    height = np.clip(width * spread[1] / spread[0], 1.5, 6) + 1.6
    figure, axes = plt.subplots(figsize=(width, height))
    triangulation = footprint.triangulation()
    triangulation.x, triangulation.y = footprint.points[:, order].T
    colors = axes.tripcolor(triangulation, footprint.fine_pressure,
                            shading="gouraud", cmap=PRESSURE_COLORS, vmin=0,
                            vmax=maximum)
    edge = PathPatch(Path.make_compound_path(
        *(Path(line[:, order], closed=True) for line in footprint.outline)),
        facecolor="none", edgecolor="black", linewidth=1.3)
    axes.add_patch(edge)
    colors.set_clip_path(edge)
    axes.plot(*footprint.nodes[footprint.active][:, order].T, ".",
              color="0.25", markersize=2.5)
    draw_principal_axes(axes, footprint, order)
    axes.set_aspect("equal")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.grid(False)
    names = [footprint.axis_names[i] for i in order]
    axes.set(xlabel=units.label(names[0], "length"),
             ylabel=units.label(names[1], "length"))
    figure.colorbar(colors, ax=axes, orientation="horizontal", aspect=35,
                    pad=0.16 if height > 4 else 0.28,
                    label=units.label("contact pressure", "pressure"))
    return figure


def draw_principal_axes(axes, footprint, order):
    """Both axes, as long as the zone."""
    points = np.concatenate(footprint.outline) - footprint.center
    for axis in footprint.principal:
        along = points @ axis
        ends = footprint.center + np.outer([along.min(), along.max()], axis)
        axes.plot(*ends[:, order].T, color="black", linewidth=0.8,
                  linestyle=(0, (8, 3, 2, 3)))


# ---------------------------------------------------------------- section


def chosen_steps(steps):
    """The first step, the last one, and some in between."""
    count = min(len(steps), MAXIMUM_SECTIONS)
    places = np.round(np.linspace(0, len(steps) - 1, count)).astype(int)
    return [steps[i] for i in places]


def draw_sections(plane, profiles, labels, grounds, units, colors=None):
    """Both faces of the section in several steps, or of several shells.

    profiles, labels and grounds are lists with one item per step; an unknown
    ground is None. A section too slender to be seen to scale is stretched.
    Returns the figure, whether it is to scale, and whether it shows a
    ground."""
    figure, axes = plt.subplots(figsize=(5.6, 4.6))
    sections = [[curved_line(plane.project(profile.positions(f"{face}_")))
                 for face in ("outer", "inner")] for profile in profiles]
    last = sections[-1:] if colors is None else sections
    colors = shades(len(profiles)) if colors is None else colors
    for faces, label, color in zip(sections, labels, colors):
        width = 2 if any(faces is other for other in last) else 1.1
        axes.plot(*faces[0].T, color=color, linewidth=width, label=label)
        axes.plot(*faces[1].T, color=color, linewidth=width)
    # the ground widens the picture only as far as it is near the shell
    limits = np.reshape(axes.axis(), (2, 2)).T
    shell_limits = limits.copy()
    has_ground = False
    for faces, ground, color in zip(sections, grounds, colors):
        if ground is None:
            continue
        for line, nearest in near_traces(plane, ground, faces[0],
                                         shell_limits):
            axes.plot(*line.T, color=color, linewidth=0.9,
                      linestyle=(0, (7, 3)), zorder=1)
            margin = 0.03 * np.ptp(shell_limits[:, 0])
            limits[0] = np.minimum(limits[0], nearest - margin)
            limits[1] = np.maximum(limits[1], nearest + margin)
            has_ground = True
    (left, low), (right, high) = limits
    names, is_down = plane.labels()
    axes.set(xlim=(left, right), ylim=(low, high),
             xlabel=units.label(names[0], "length"),
             ylabel=units.label(names[1], "length"))
    sides = sorted((right - left, high - low))
    is_to_scale = sides[1] < SLENDER * sides[0]
    if is_to_scale:
        axes.set_aspect("equal")
        # as many ticks as there is room for
        scale = min(4.6 / (right - left), 3.4 / (high - low))
        for axis, length, room in ((axes.xaxis, right - left, 0.6),
                                   (axes.yaxis, high - low, 0.4)):
            axis.set_major_locator(
                MaxNLocator(nbins=int(np.clip(scale * length / room, 1, 9))))
    if is_down:
        # upward on paper is toward smaller values
        axes.yaxis.set_major_formatter(
            lambda value, _: f"{0 - value:g}".replace("-", "−"))
    legend_below(axes)
    return figure, is_to_scale, has_ground


def near_traces(plane, ground, face, limits):
    """Polylines in which a ground cuts the plane of the section, not farther
    from the shell than its size, and the point of each that is nearest to a
    face."""
    size = np.ptp(limits, axis=0).max()
    traces = plane.trace(ground, limits[0] - size, limits[1] + size)
    result = []
    for line in traces:
        distances = np.linalg.norm(line[:, None] - face[None], axis=-1).min(1)
        result.append((line, line[np.argmin(distances)]))
    return result
