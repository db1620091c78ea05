# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of laws beside the data."""

import numpy as np
from biface_report.drawing import DISTINCT, STYLE, plt, save

from .laws import TESTS

MARKERS = "os^"


def draw(laws, data, fitted, path):
    """Writes a picture with a panel for each labeled law: the points, and the
    curves of all tests, dashed beyond the points that were fitted."""
    plt.rcParams.update(STYLE)
    columns = min(3, len(laws))
    rows = -(-len(laws) // columns)
    figure, panels = plt.subplots(
        rows, columns, squeeze=False, sharex=True, sharey=True,
        figsize=(1.5 + 3.4 * columns if columns > 1 else 6.4, 0.8 + 3.2 * rows))
    for panel, (label, law) in zip(panels.flat, laws):
        draw_law(panel, law, data, fitted)
        panel.set_title(label)
    for panel in panels.flat[len(laws):]:
        panel.set_visible(False)
    for row in panels:
        row[0].set_ylabel("nominal stress")
    for column in range(columns):
        panels[(len(laws) - 1 - column) // columns][column].set_xlabel("stretch")
        for row in panels:
            row[column].xaxis.set_tick_params(labelbottom=True)
    panels[0][0].legend(loc="upper left")
    save(figure, path)


def draw_law(panel, law, data, fitted):
    """A panel."""
    low, high = data.stretches.min(), data.stretches.max()
    margin = 0.15 * (max(high, 1) - min(low, 1))
    low = min(1, low if low >= 1 else low - margin * min(1, low))
    high = max(1, high) + margin
    for (test, color, marker) in zip(TESTS, DISTINCT, MARKERS):
        where, points = data.of(test), fitted.stretches[fitted.of(test)]
        panel.plot(data.stretches[where], data.stresses[where], marker, color=color, markersize=4.5,
                   markerfacecolor="none", linestyle="none")
        inside = (min(1, points.min()), max(1, points.max())) if points.size else (1, 1)
        for start, end, style in ((*inside, "-"), (low, inside[0], "--"),
                                  (inside[1], high, "--")):
            stretches = np.linspace(start, end, 400)
            panel.plot(stretches, law.stress(test, stretches), style, color=color,
                       linewidth=1.6,
                       label=test if style == "-" else None)
    bottom, top = min(0, data.stresses.min()), max(0, data.stresses.max())
    margin = 0.12 * (top - bottom)
    panel.set_xlim(low, high)
    panel.set_ylim(bottom - (margin if bottom < 0 else 0),
                   top + (margin if top > 0 else 0))
