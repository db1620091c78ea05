# SPDX-License-Identifier: LGPL-2.1-or-later
"""What moves in time, in stages with inertia: displacements, the force on the ground,
energies, and the frequencies in them."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from .charts import MAXIMUM_CURVES
from .drawing import BLUE, DISTINCT, GRAY, embed, headroom, legend_below, plain
from .page import ROUND_OFF, LeftOut, Section, figure, number, paragraph
from .units import units_of

NAME = "Motion in time"

# Small times have long labels
MAXIMUM_TICKS = 6
# Steps without which a spectrum says nothing
MINIMUM_STEPS = 16
# Of the largest energy: a larger error is worth a sentence
REMARKABLE_ERROR = 1e-6

ENERGIES = (("kinetic_energy", "kinetic"), ("strain_energy", "strain"),
            ("contact_energy", "contact"))


def moves(run):
    """Whether there is a stage with inertia."""
    return ("kinetic_energy" in run.history
            and np.isfinite(run.history["kinetic_energy"]).any())


def rows_in_time(run):
    """The rows of the history of stages with inertia."""
    return np.flatnonzero(np.isfinite(run.history["kinetic_energy"]))


def motion(run):
    """The section, or why there is none."""
    if not moves(run):
        return LeftOut(NAME, "No stage has inertia.")
    curves = curves_over_time(run)
    html = figure(embed(draw_energies(run)),
                  "Chart of the energies over time.",
                  "Dissipated: by damping, contact and friction. "
                  + error_in_words(run))
    if curves:
        html = figure(embed(draw_curves(run, curves)),
                      "Chart of displacements and forces over time.",
                      "Displacements of the middle surface: for each named point, "
                      "the component that changes most. The force on the ground is "
                      "that at the end of each step.") + html
        if spectra := [(label, *found) for label, _, values in curves
                       if (found := spectrum(*evenly(run, values))) is not None]:
            html += figure(embed(draw_spectra(run, spectra)),
                           "Chart of the spectra of these curves.",
                           "Amplitudes of the Fourier series of each curve, without "
                           "its straight trend, times a Hann window, relative to the "
                           "largest.")
    else:
        html = paragraph("For displacements over time set 'Named points'.") + html
    return Section("motion", NAME, html)


def error_in_words(run):
    """The balance of energy."""
    rows = rows_in_time(run)
    error = np.max(np.abs(run.history["energy_error"][rows]))
    largest = np.max(sum(np.abs(run.history[column][rows]) for column, _ in ENERGIES))
    if largest == 0 or error <= REMARKABLE_ERROR * largest:
        return "Energies and works balance."
    return ("Energies and works balance up to "
            f"{escape(number(error / largest, 2))} of the largest energy.")


def curves_over_time(run):
    """Names, kinds of units and values of the curves in the rows in time."""
    rows = rows_in_time(run)
    curves = []
    probes = run.probes() if run.setting("Named points", "?") != "" else None
    if probes is not None and len(probes) > 0:
        largest = 0
        found = []
        for name in dict.fromkeys(probes["name"]):
            at = probes.where(probes["name"] == name)
            moved = np.full((len(run.steps), 3), np.nan)
            moved[np.searchsorted(run.steps, at["step"])] = at.positions("u_")
            moved = moved[rows]
            if not np.isfinite(moved).all():
                continue
            i = int(np.argmax(np.ptp(moved, axis=0)))
            largest = max(largest, np.ptp(moved[:, i]))
            found.append((plain(name) + f", $u_{'xyz'[i]}$", "length", moved[:, i]))
        curves = [curve for curve in found
                  if np.ptp(curve[2]) > ROUND_OFF * largest][:MAXIMUM_CURVES]
    force = run.history["force"][rows]
    if force.any():
        curves.append(("force on the ground", "force", force))
    return curves


def draw_curves(run, curves):
    """Displacements above, the force below, if there are both."""
    kinds = list(dict.fromkeys(kind for _, kind, _ in curves))
    units, time = units_of(run), run.history["time"][rows_in_time(run)]
    drawing, panels = plt.subplots(len(kinds), 1, figsize=(5.6, 1 + 2.6 * len(kinds)),
                                   sharex=True, squeeze=False, layout="constrained")
    for axes, kind in zip(panels[:, 0], kinds):
        chosen = [curve for curve in curves if curve[1] == kind]
        for i, (label, _, values) in enumerate(chosen):
            axes.plot(time, values, color=DISTINCT[i % len(DISTINCT)],
                      linewidth=1.5, label=label)
        axes.set(ylabel=units.label("force" if kind == "force" else "displacement",
                                    kind))
        headroom(axes)
        if len(chosen) > 1 or kind == "length":
            axes.legend(fontsize=9)
    panels[-1, 0].set(xlabel=units.label("time", "time"))
    panels[-1, 0].xaxis.set_major_locator(MaxNLocator(MAXIMUM_TICKS))
    return drawing


def draw_energies(run):
    """Energies and what was dissipated since the start of the first stage in
    time."""
    rows, units = rows_in_time(run), units_of(run)
    time = run.history["time"][rows]
    drawing, axes = plt.subplots(figsize=(5.6, 3.6))
    for i, (column, label) in enumerate(ENERGIES):
        values = run.history[column][rows]
        if values.any():
            axes.plot(time, values, color=DISTINCT[i], linewidth=1.5, label=label)
    lost = sum(run.history[column][rows] for column in
               ("damping_work", "numerical_work", "contact_work", "friction_work"))
    # what static stages have dissipated is of no interest here
    lost = lost - (lost[0] if rows[0] > 0 else 0)
    total = sum(run.history[column][rows] for column, _ in ENERGIES)
    if np.max(np.abs(lost)) > ROUND_OFF * np.max(np.abs(total)):
        axes.plot(time, lost, color=GRAY, linewidth=1.5, label="dissipated")
    axes.plot(time, total, color=BLUE, linewidth=1, linestyle="--",
              label="sum of the energies")
    axes.set(xlabel=units.label("time", "time"), ylabel=units.label("energy", "energy"))
    axes.xaxis.set_major_locator(MaxNLocator(MAXIMUM_TICKS))
    headroom(axes)
    legend_below(axes)
    return drawing


def evenly(run, values):
    """The values of the last stage in time at even times, and their distance."""
    rows = rows_in_time(run)
    names = run.history["stage"][rows]
    last = np.flatnonzero(names != names[-1])
    chosen = np.arange(last[-1] + 1 if len(last) else 0, len(rows))
    time = run.history["time"][rows][chosen]
    if len(chosen) < MINIMUM_STEPS or time[-1] <= time[0]:
        return None, None
    # no frequency of a step that is shorter than most is lost
    step = np.median(np.diff(time))
    even = np.linspace(time[0], time[-1], int(round((time[-1] - time[0]) / step)) + 1)
    return np.interp(even, time, values[chosen]), even[1] - even[0]


def spectrum(values, step):
    """Frequencies and relative amplitudes, or None."""
    if values is None or np.ptp(values) == 0:
        return None
    trend = np.linspace(values[0], values[-1], len(values))
    amplitudes = np.abs(np.fft.rfft((values - trend) * np.hanning(len(values))))
    if not amplitudes[1:].any():
        return None
    return np.fft.rfftfreq(len(values), step)[1:], amplitudes[1:] / amplitudes[1:].max()


def draw_spectra(run, spectra):
    """Relative amplitudes over the frequency."""
    drawing, axes = plt.subplots(figsize=(5.6, 3.4))
    for i, (label, frequencies, amplitudes) in enumerate(spectra):
        axes.semilogy(frequencies, amplitudes, color=DISTINCT[i % len(DISTINCT)],
                      linewidth=1.2, label=label)
    axes.set(xlabel=units_of(run).label("frequency", "frequency"),
             ylabel="relative amplitude", ylim=(1e-4, 1.5),
             xlim=(0, spectra[0][1][-1]))
    legend_below(axes)
    return drawing

