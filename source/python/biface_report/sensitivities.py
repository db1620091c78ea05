# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives of results by numbers of the parameter file: a tornado chart and the
table."""

import textwrap
from html import escape

import matplotlib.pyplot as plt
import numpy as np

from .drawing import BLUE, RED, embed, plain
from .page import (TOLERANCE, LeftOut, Section, count, details, figure, number,
                   paragraph, table)

# More would be too small to read
MAXIMUM_PANELS = 8
MAXIMUM_BARS = 12
# Panels in a row
COLUMNS = 2
# Of forces, moments and displacements
AXES = ("x", "y", "z", "1", "2", "3")
# Characters in a line of a label
LABEL_WIDTH = 22


def sensitivities(run):
    """The chart for each stage in sensitivities.csv, and the table."""
    name = "Sensitivities"
    found = run.sensitivities()
    if found is None:
        return LeftOut(name, "No stage asks for 'Sensitivities'.")
    if len(found) == 0:
        return LeftOut(name, "No stage with 'Sensitivities' is complete, or a warning "
                             "in run.log says why its derivatives are left out.")
    parts = []
    for step in dict.fromkeys(found["step"]):
        here = found.where(found["step"] == step)
        noise = round_off(run, here)
        shown = here.where(~np.isin(here["output"], noise))
        if len(shown) and bars_of(shown):
            parts.append(chart(shown))
        if noise:
            parts.append(paragraph(
                "Without bars, since they are zero within round-off: "
                f"{escape('; '.join(noise))}."))
        parts += [paragraph(text) for text in omissions(shown)]
    parts.append(paragraph(
        "The logarithmic derivative is the relative change of the output by that of "
        "the entry: at 0.5, one percent more of the entry is half a percent more of "
        "the output. The whole loading follows the changed entry; the nodes in "
        "contact are held."))
    rows = [[escape(found["stage"][i]), escape(found["entry"][i]),
             number(found["entry_value"][i]), escape(found["output"][i]),
             number(found["output_value"][i]), number(found["derivative"][i]),
             number(found["logarithmic_derivative"][i])] for i in range(len(found))]
    parts.append(details("All derivatives", table(
        "Derivatives, from sensitivities.csv",
        ["Stage", "Entry", "Value", "Output", "Value", "Derivative",
         "Logarithmic derivative"], rows), not bars_of(found)))
    return Section("sensitivities", name, "\n".join(parts), True)


def round_off(run, found):
    """The outputs of a stage that are not zero but round-off, relative to the
    largest force, moment or displacement of the step."""
    tables = {"F": run.forces(), "M": run.forces(), "u": run.probes()}
    result = []
    for output, value in dict(zip(found["output"], found["output_value"])).items():
        letter, _, axis = output.rpartition(" ")[2].partition("_")
        table_of = tables.get(letter)
        if table_of is None or axis not in AXES or value == 0:
            continue
        here = table_of.where(table_of["step"] == found["step"][0])
        largest = max((np.abs(here[f"{letter}_{i}"]).max() for i in AXES
                       if f"{letter}_{i}" in here and len(here)), default=0)
        if abs(value) < TOLERANCE * largest:
            result.append(output)
    return result


def bars_of(found):
    """For each output the entries with finite logarithmic derivatives, the largest
    magnitude first: pairs of the entry and the derivative. Outputs without any are
    left out."""
    result = {}
    for output in dict.fromkeys(found["output"]):
        rows = found.where((found["output"] == output)
                           & np.isfinite(found["logarithmic_derivative"]))
        order = np.argsort(-np.abs(rows["logarithmic_derivative"]), kind="stable")
        if len(rows):
            result[output] = [(rows["entry"][i],
                               float(rows["logarithmic_derivative"][i]))
                              for i in order]
    return result


def omissions(found):
    """Sentences about what the chart does not show."""
    sentences = []
    is_missing = ~np.isfinite(found["logarithmic_derivative"])
    if is_missing.any():
        pairs = [f"{found['output'][i]} by {found['entry'][i]}"
                 for i in np.flatnonzero(is_missing)]
        sentences.append("Without a bar, since there is no logarithmic derivative: "
                         + escape("; ".join(pairs)) + ".")
    bars = bars_of(found)
    more = max(len(bars) - MAXIMUM_PANELS, 0)
    if more:
        sentences.append(f"The chart shows the first {MAXIMUM_PANELS} outputs; "
                         f"{count(more, 'more is', 'more are')} in the table.")
    if any(len(entries) > MAXIMUM_BARS for entries in bars.values()):
        sentences.append(f"The chart shows the {MAXIMUM_BARS} largest derivatives of "
                         "each output; the others are in the table.")
    return sentences


def chart(found):
    """The tornado chart of a stage."""
    bars = bars_of(found)
    words = "; ".join(
        f"{output}: " + ", ".join(f"{entry} {plain_text(value)}"
                                  for entry, value in entries[:MAXIMUM_BARS])
        for output, entries in list(bars.items())[:MAXIMUM_PANELS])
    return figure(
        embed(draw(bars)), f"Bar charts of logarithmic derivatives. {words}.",
        "Logarithmic derivatives at the end of the stage "
        f"{escape(found['stage'][0])}, of each output by each entry, the largest "
        "first. Blue: the output grows with the entry; red: it falls.")


def plain_text(value):
    """A derivative with its sign and at least two digits."""
    text = f"{value:+.0f}" if abs(value) >= 100 else f"{value:+.2g}"
    return text.replace("-", "−") if value else "0"


def draw(bars):
    """A panel for each output, with its bars from the top."""
    shown = {output: entries[:MAXIMUM_BARS]
             for output, entries in list(bars.items())[:MAXIMUM_PANELS]}
    columns = min(len(shown), COLUMNS)
    lines = -(-len(shown) // columns)
    n_bars = max(map(len, shown.values()))
    drawing, panels = plt.subplots(
        lines, columns, squeeze=False, layout="constrained",
        figsize=(4.5 * columns, lines * (0.9 + 0.34 * n_bars)))
    for axes in panels.flat[len(shown):]:
        axes.set_visible(False)
    for axes, (output, entries) in zip(panels.flat, shown.items()):
        values = [value for _, value in entries]
        labels = [plain(textwrap.fill(entry, LABEL_WIDTH)) for entry, _ in entries]
        drawn = axes.barh(range(len(values)), values, height=0.6,
                          color=[RED if value < 0 else BLUE for value in values])
        axes.bar_label(drawn, map(plain_text, values), padding=3, fontsize=9)
        axes.set_yticks(range(len(values)), labels, fontsize=9)
        # as many places in all panels, so that bars are equally high
        axes.set_ylim(n_bars - 0.5, -0.5)
        # room for the numbers on both sides
        low, high = min(0, *values), max(0, *values)
        room = 0.32 * (high - low)
        if room > 0:
            axes.set_xlim(low - (room if low < 0 else 0),
                          high + (room if high > 0 else 0))
        axes.axvline(0, color="0.3", linewidth=0.8)
        axes.set_title(plain(output), fontsize=10)
        axes.locator_params(axis="x", nbins=6)
        axes.tick_params(axis="x", labelsize=9)
        axes.tick_params(axis="y", length=0)
        axes.grid(axis="y", visible=False)
        axes.spines["left"].set_visible(False)
    return drawing
