# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a study: main effects, responses, and the table of samples."""

import textwrap
from html import escape

import matplotlib.pyplot as plt
import numpy as np

from biface.parameters import read_parameters

from .drawing import BLUE, GRAY, RED, STYLE, embed, plain
from .page import (TOLERANCE, LeftOut, Section, count, details, figure, missing, number,
                   page, paragraph, plain_number, table)
from .units import Units

# More charts of one row or column would be too small
MAXIMUM_CHARTS = 6
# Why there are no responses
TOO_FEW = ("It needs outputs that vary, and two more samples than variables that "
           "vary.")
# A quadratic response needs more samples than it has coefficients, by this factor
SPARE = 2


def report(study):
    """The page of a study."""
    plt.rcParams.update(STYLE)
    parts = [main_effects(study), responses(study), scatter(study),
             failures(study), samples(study)]
    sections = [part for part in parts if isinstance(part, Section)]
    absent = [part for part in parts if isinstance(part, LeftOut)]
    if absent:
        sections.append(missing(absent))
    name = study.directory.resolve().name
    n = len(study)
    failed = n - int(study.is_ok.sum())
    text = (f"Study in the directory {escape(name)}, {count(n, 'sample')}"
            + (f", {failed} of them failed" if failed else "") + ".")
    facts = [text, units_of_study(study).sentence()]
    constant = [output for output in study.outputs if output not in drawn(study)]
    if constant and study.is_ok.any():
        facts.append("Without charts, since they do not vary beyond the tolerance of "
                     f"the iteration: {escape(', '.join(constant))}.")
    return page(f"biface: study {name}",
                "".join(paragraph(fact, "facts") for fact in facts), sections)


def units_of_study(study):
    """The units of its base file."""
    path = study.directory / "base.prm"
    entry = read_parameters(path).entries.get("Units") if path.exists() else None
    return Units(entry and entry.value)


def drawn(study):
    """The outputs that vary beyond the tolerance of the iteration."""
    return [output for output in study.outputs if study.is_ok.any()
            and not np.ptp(study.values(output))
            <= TOLERANCE * np.abs(study.values(output)).max()]


# ---------------------------------------------------------------- effects


class Response:
    """The least-squares fit of an output by a polynomial of the variables, scaled
    to [-1, 1]: linear, and with squares and products if there are samples
    enough."""

    def __init__(self, inputs, output):
        self.low, self.high = inputs.min(0), inputs.max(0)
        self.degree = 2 if len(output) >= SPARE * self._terms(2) else 1
        matrix = self._matrix(inputs)
        self.coefficients = np.linalg.lstsq(matrix, output, rcond=None)[0]
        rest = output - matrix @ self.coefficients
        spread = ((output - output.mean())**2).sum()
        self.explained = 1 - (rest**2).sum() / spread if spread > 0 else 1.

    def _terms(self, degree):
        n = len(self.low)
        return 1 + n if degree == 1 else 1 + n + n * (n + 1) // 2

    def _matrix(self, inputs):
        size = np.where(self.high > self.low, self.high - self.low, 1)
        x = 2 * (inputs - self.low) / size - 1
        n = x.shape[1]
        terms = [np.ones(len(x))] + [x[:, i] for i in range(n)]
        if self.degree == 2:
            terms += [x[:, i] * x[:, j] for i in range(n) for j in range(i, n)]
        return np.stack(terms, -1)

    def along(self, variable, values):
        """The output over one variable, the others in the middle of their ranges."""
        points = np.tile((self.low + self.high) / 2, (len(values), 1))
        points[:, variable] = values
        return self._matrix(points) @ self.coefficients

    def effect(self, variable):
        """The change of the output as the variable goes through its range."""
        ends = np.array([self.low[variable], self.high[variable]])
        return float(np.diff(self.along(variable, ends))[0])


def fits(study):
    """The response of each output, or None if there are too few samples."""
    varying = [name for name in study.variables
               if np.ptp(study.values(name) if study.is_ok.any() else [0]) > 0]
    if study.is_ok.sum() < len(varying) + 2 or not varying or not drawn(study):
        return None
    inputs = np.stack([study.values(name) for name in varying], -1)
    return varying, {name: Response(inputs, study.values(name))
                     for name in drawn(study)}


def main_effects(study):
    """Bars and a table of the changes of outputs over the ranges of variables."""
    name = "Main effects"
    found = fits(study)
    if found is None:
        return LeftOut(name, TOO_FEW)
    varying, responses_of = found
    rows = []
    for output, response in responses_of.items():
        rows.append([escape(output)]
                    + [number(response.effect(i), 4,
                              np.abs(study.values(output)).max())
                       for i in range(len(varying))]
                    + [number(study.values(output).mean()),
                       plain_number(100 * response.explained, 3) + "\u00a0%"])
    html = table("Main effects", ["Output"] + [escape(v) for v in varying]
                 + ["Mean", "Explained"], rows)
    shown = list(responses_of)[:MAXIMUM_CHARTS]
    drawing, axes = plt.subplots(
        1, len(shown), squeeze=False, sharey=True,
        figsize=(1.2 + 2.1 * len(shown), 0.9 + 0.42 * len(varying)))
    for each, output in zip(axes[0], shown):
        mean = abs(study.values(output).mean()) or 1
        effects = [100 * responses_of[output].effect(i) / mean
                   for i in range(len(varying))]
        each.barh(range(len(varying)), effects, height=0.6,
                  color=[RED if e < 0 else BLUE for e in effects])
        each.axvline(0, color="0.3", linewidth=0.8)
        each.set_title(label(output), fontsize=10)
        each.set_xlabel("% of the mean", fontsize=10)
        each.grid(axis="y", visible=False)
    axes[0][0].set_yticks(range(len(varying)), map(plain, varying))
    axes[0][0].invert_yaxis()
    text = paragraph(
        "The change of each output while one variable goes through its range and "
        "the others stay in the middle of their ranges, by a polynomial of the "
        "variables fitted to all samples, of the second degree where there are "
        "enough of them. Explained: the part of the variance of the output that the "
        "polynomial describes.")
    return Section("effects", name, figure(
        embed(drawing), "Bar charts of the main effects of the variables on the "
        "outputs.") + html + text, True)


def label(name):
    """The name of a column, broken into short lines."""
    return plain(textwrap.fill(name.replace("_", " "), 14))


def grid_of_charts(rows, columns):
    """Axes in rows and columns, which share their scales."""
    return plt.subplots(len(rows), len(columns), squeeze=False, sharex="col",
                        sharey="row",
                        figsize=(1 + 2.1 * len(columns), 0.6 + 1.6 * len(rows)))


def responses(study):
    """Each output against each variable."""
    name = "Responses"
    found = fits(study)
    if found is None:
        return LeftOut(name, TOO_FEW)
    varying, responses_of = found
    rows, columns = list(responses_of)[:MAXIMUM_CHARTS], varying[:MAXIMUM_CHARTS]
    drawing, axes = grid_of_charts(rows, columns)
    for line, output in zip(axes, rows):
        for i, (each, variable) in enumerate(zip(line, columns)):
            x = study.values(variable)
            each.plot(x, study.values(output), ".", color=GRAY, markersize=3)
            at = np.linspace(x.min(), x.max(), 40)
            each.plot(at, responses_of[output].along(i, at), color=BLUE)
            each.tick_params(labelsize=8)
        line[0].set_ylabel(label(output), fontsize=9)
    for each, variable in zip(axes[-1], columns):
        each.set_xlabel(plain(variable), fontsize=10)
    text = ("Dots: samples. Lines: the fitted polynomial, with the other variables "
            "in the middle of their ranges.")
    return Section("responses", name, figure(
        embed(drawing), "Charts of each output against each variable.", text), True)


def scatter(study):
    """Outputs against each other."""
    name = "Outputs against each other"
    outputs = drawn(study)[:MAXIMUM_CHARTS]
    if len(outputs) < 2 or study.is_ok.sum() < 2:
        return LeftOut(name, "It needs two outputs that vary and two samples.")
    drawing, axes = grid_of_charts(outputs[1:], outputs[:-1])
    for i, line in enumerate(axes):
        for j, each in enumerate(line):
            if j > i:
                each.set_visible(False)
                continue
            each.plot(study.values(outputs[j]), study.values(outputs[i + 1]), ".",
                      color=BLUE, markersize=3)
            each.tick_params(labelsize=8)
        line[0].set_ylabel(label(outputs[i + 1]), fontsize=9)
    for each, output in zip(axes[-1], outputs):
        each.set_xlabel(label(output), fontsize=9)
    return Section("scatter", name, figure(
        embed(drawing), "Charts of the outputs against each other.",
        "One dot per sample."), True)


def failures(study):
    """The samples that failed, and why."""
    name = "Samples that failed"
    failed = np.flatnonzero(~study.is_ok)
    if len(failed) == 0:
        return LeftOut(name, "There are none.")
    rows = [[f"{int(study['sample'][i])}"]
            + [number(study[v][i]) for v in study.variables]
            + [escape(study["status"][i])] for i in failed]
    return Section("failures", name, table(
        name, ["Sample"] + [escape(v) for v in study.variables] + ["Reason"],
        rows).replace('class="scroll"', 'class="scroll words"', 1), True)


def samples(study):
    """The table, and the cost."""
    names = study.variables + study.outputs + ["iterations", "seconds"]
    rows = [[f"{int(study['sample'][i])}"]
            + [number(study[name][i]) for name in names]
            for i in range(len(study))]
    seconds = study["seconds"]
    iterations = study["iterations"]
    text = paragraph(
        f"{count(len(rows), 'sample')} took {plain_number(seconds.sum(), 4)} s and "
        f"{int(iterations.sum())} Newton iterations in all.")
    return Section("samples", "Samples", text + details(
        "All samples, from study.csv",
        table("All samples", ["Sample"] + [escape(n) for n in names], rows)), True)
