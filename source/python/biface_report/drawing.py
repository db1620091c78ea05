# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of charts, also of those in the documentation, and how they get into
the page."""

import base64
import io
import re
import struct
import textwrap
from collections import namedtuple

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.transforms import ScaledTranslation

# The look of all charts: plt.rcParams.update(STYLE)
STYLE = {
    "font.size": 11,
    "axes.labelsize": 12,
    "axes.titlesize": 12,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.8,
    "axes.grid": True,
    "grid.color": "0.9",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 2,
    "savefig.facecolor": "white",
    "savefig.dpi": 160,
    # powers of ten become part of the labels, see embed()
    "axes.formatter.limits": (-4, 6),
    "axes.formatter.useoffset": False,
}

BLUE, RED, GRAY = "#1f5fa8", "#c0392b", "0.45"

# Colors for different things, distinct for the color-blind too
DISTINCT = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
            "0.35")


# Characters in a line of a legend
LEGEND_WIDTH = 50

# A picture in a page: its address, and its preferred width in pixels
Picture = namedtuple("Picture", "address width")


def shades(count):
    """Colors for consecutive steps, later ones darker."""
    return plt.get_cmap("viridis_r")(np.linspace(0.12, 0.95, count))


def save(figure, target, **options):
    """Writes a figure to a file, without blank margins, and closes it."""
    figure.savefig(target, bbox_inches="tight", pad_inches=0.08, **options)
    plt.close(figure)


def plain(name):
    """A name of the user as text of a figure: no formula between dollars, and shown in
    a legend also if it starts with an underscore."""
    name = name.replace("$", r"\$")
    return "\u200b" + name if name.startswith("_") else name


def embed(figure, kind="svg"):
    """A figure as a picture within the page: SVG for lines, PNG for areas of
    color."""
    move_powers(figure)
    buffer = io.BytesIO()
    # no date and no random names: the same run gives the same page
    with plt.rc_context({"svg.hashsalt": "biface", "savefig.dpi": 150}):
        save(figure, buffer, format=kind,
             metadata={"Date": None} if kind == "svg" else {"Software": None})
    data = buffer.getvalue()
    if kind == "svg":
        points = re.search(rb'<svg [^>]*?width="([0-9.]+)pt"', data).group(1)
        return embed_svg(data, round(float(points) * 96 / 72))
    return embed_png(data, round(struct.unpack(">I", data[16:20])[0] * 96 / 150))


def move_powers(figure):
    """Moves the powers of ten at the ends of axes, where they cover other text, into
    the units of the labels."""
    figure.canvas.draw()
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            power = getattr(axis.get_major_formatter(), "orderOfMagnitude", 0)
            if not axis.get_offset_text().get_text() or not power:
                continue
            axis.get_offset_text().set_visible(False)
            # another one of the axes that share it has the numbers
            if not any(text.get_visible() for text in axis.get_ticklabels()):
                continue
            label, bracket, unit = axis.get_label_text().rpartition("[")
            factor = f"$10^{{{power}}}$"
            axis.set_label_text(f"{label}[{factor} {unit}" if bracket else
                                f"{unit} [{factor}]".strip())


def embed_svg(data, width):
    """The bytes of an SVG file as a picture."""
    return Picture("data:image/svg+xml;base64,"
                   + base64.b64encode(data).decode(), width)


def embed_png(data, width):
    """The bytes of a PNG file as a picture."""
    return Picture("data:image/png;base64," + base64.b64encode(data).decode(),
                   width)


def headroom(axes, share=0.06):
    """Leaves room around the curves drawn so far, but none beyond zero if they start
    or end there."""
    for get, put in ((axes.get_xlim, axes.set_xlim),
                     (axes.get_ylim, axes.set_ylim)):
        values = np.concatenate([
            line.get_xdata() if get == axes.get_xlim else line.get_ydata()
            for line in axes.lines]).astype(float)
        low, high = np.nanmin(values), np.nanmax(values)
        margin = share * (high - low or abs(high) or 1)
        put(0 if low == 0 else low - margin, 0 if high == 0 else high + margin)


def legend_below(axes):
    """A legend below the axes, however long its names are."""
    handles, names = axes.get_legend_handles_labels()
    names = [textwrap.fill(name, LEGEND_WIDTH) for name in names]
    columns = 2 if max(map(len, names)) < LEGEND_WIDTH / 2 else 1
    below = ScaledTranslation(0, -42 / 72, axes.figure.dpi_scale_trans)
    axes.legend(handles, names, loc="upper center", bbox_to_anchor=(0.5, 0),
                ncol=columns, fontsize=10, bbox_transform=axes.transAxes + below)
