# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steady frequency response: magnitudes and phases of forces and displacements, per
unit of what shakes the shell."""

from collections import namedtuple
from html import escape

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import LogFormatterSciNotation, LogLocator, NullLocator

from .bodies import names_of_bodies
from .charts import MAXIMUM_CURVES
from .drawing import DISTINCT, embed, legend_below, plain
from .modes import rigid_motions
from .page import TOLERANCE, LeftOut, Section, count, figure, paragraph, plain_number
from .units import units_of
from .wheel import is_wheel

NAME = "Frequency response"

# Excitations that are drawn; the file has all
MAXIMUM_EXCITATIONS = 6
# With so few frequencies, each has a dot
FEW = 30
# Degrees up to which a curve of phases goes on beyond 180
FARTHEST = 200
# Parts of the largest magnitude below this are left out of a chart
LOWEST = 1e-6
# Air of a tire acts on the rim
AIR = "rim on air"

# A component of a force or a displacement over the frequency: its label, color, line and
# complex values
Curve = namedtuple("Curve", "label color line values")


def response(run):
    """Charts of response.csv."""
    found = run.response()
    if found is None or len(found) == 0:
        return LeftOut(NAME, "No stage asks for a 'Frequency response'.")
    cases = list(dict.fromkeys(zip(found["step"], found["excitation"])))
    parts = []
    for step, excitation in cases[:MAXIMUM_EXCITATIONS]:
        here = found.where(step=step, excitation=excitation)
        parts += charts_of(run, here.where(np.argsort(here["frequency"], kind="stable")))
    html = paragraph(notes(run, found)) + "".join(map(paragraph, gaps(found)))
    others = len(cases) - MAXIMUM_EXCITATIONS
    if others > 0:
        html += paragraph("Not drawn, but in response.csv: "
                          f"{count(others, 'other excitation')}.")
    if not (found["kind"] == "inner").any():
        html += paragraph("For displacements set 'Named points'.")
    return Section("response", NAME, html + '\n<div class="pairs">\n'
                   + "\n".join(parts) + "\n</div>", True)


def notes(run, found):
    """What the charts show."""
    forces = "tire" if is_wheel(run) else "shell"
    supports = "wheel" if is_wheel(run) else "supports"
    has_air = (found["output"] == AIR).any()
    return (
        f"Steady response of the loaded {forces} at the end of a stage to excitations of "
        "the amplitude 1. A positive phase is ahead of the excitation. Forces are those "
        f"on the {forces}; {supports}: the sum of all supports"
        + (f", with the force of the {AIR}" if has_air else "")
        + ". Drawn are their components in the direction of the motion that excites, or "
        "the largest one if a load does, and in the largest other direction; of "
        "displacements of the middle surface that in which a named point moves most. "
        "What is round-off is left out."
        + (" Dotted: natural frequencies of the stage, from modes.csv."
           if any(natural_frequencies(run, found.where(step=step)).size
                  for step in dict.fromkeys(found["step"])) else ""))


def gaps(found):
    """A sentence for each stage in which the response was not found at all
    frequencies."""
    result = []
    for step in dict.fromkeys(found["step"]):
        here = found.where(step=step)
        missing = np.unique(here["frequency"][np.isnan(here["x"])])
        if len(missing) > 0:
            result.append(
                f"In the stage {escape(here['stage'][0])} the response was not found at "
                + (f"the frequency {plain_number(missing[0])}" if len(missing) == 1 else
                   f"{len(missing)} frequencies from {plain_number(missing[0])} to "
                   f"{plain_number(missing[-1])}")
                + ", where curves have gaps.")
    return result


def charts_of(run, found):
    """The figures of one excitation: forces, and displacements of named points."""
    stage, excitation = found["stage"][0], found["excitation"][0]
    parts = []
    for curves, what in (
            (force_curves(run, found, direction_of(run, excitation)), "forces"),
            (point_curves(found), "displacements")):
        if curves:
            chart = draw(run, found, curves, label_of(run, excitation, what))
            parts.append(figure(
                embed(chart), f"Chart of magnitude and phase of {what} over the "
                f"frequency, end of {stage}, excitation {excitation}.",
                f"{what.capitalize()} at the end of “{escape(stage)}”, excitation "
                f"<b>{escape(excitation)}</b>"
                + ("" if direction_of(run, excitation) is not None else
                   ", per unit of this load") + "."))
    return parts


def direction_of(run, excitation):
    """The number of the direction in which something moves, or None for a load."""
    body, _, direction = excitation.rpartition(" ")
    moves = body in ["ground", "supports"] + names_of_bodies(run)
    return "xyz".index(direction) if moves and direction in ("x", "y", "z") else None


def label_of(run, excitation, what):
    """The label of an axis of forces or displacements per unit of an excitation."""
    units, kind = units_of(run), "force" if what == "forces" else "length"
    if direction_of(run, excitation) is not None:
        return (units.label("dynamic stiffness", "stiffness") if kind == "force"
                else "transmissibility")
    return (f"{what[:-1]} [{units.per(kind, 'pressure')}]" if excitation == "pressure"
            else units.label(what[:-1], kind))


# ---------------------------------------------------------------- curves


def total_forces(run, found):
    """Forces by the label of what acts on the shell, as rows of components x, y, z over
    the frequency. Those of all supports, and of the rim on the air, are one."""
    forces = found.where(kind="force")
    bodies = names_of_bodies(run)
    result, held = {}, []
    for name in dict.fromkeys(forces["output"]):
        values = forces.where(output=name).positions()
        if name == "foundation":
            result["ground"] = values
        elif name in bodies:
            result[name] = values
        else:
            held.append(values)
    if held:
        result["wheel" if is_wheel(run) else "supports"] = sum(held)
    return result


def force_curves(run, found, direction):
    """Of each force the component in the direction of the excitation, for a load the
    largest one, and the largest other one unless it is round-off."""
    forces = total_forces(run, found)
    largest = max((peak(values) for values in forces.values()), default=0)
    curves = []
    for i, (name, values) in enumerate(forces.items()):
        peaks = [peak(values[:, k]) for k in range(3)]
        first = int(np.argmax(peaks)) if direction is None else direction
        peaks_of_others = [-1 if k == first else peaks[k] for k in range(3)]
        for line, k in (("-", first), ("--", int(np.argmax(peaks_of_others)))):
            if peaks[k] > TOLERANCE * largest:
                curves.append(Curve(f"{plain(name)}, $F_{'xyz'[k]}$",
                                    DISTINCT[i % len(DISTINCT)], line, values[:, k]))
    return curves[:MAXIMUM_CURVES]


def point_curves(found):
    """The displacement of each named point in the middle surface, in the direction in
    which it moves most."""
    points = found.where(kind="inner")
    moved = {}
    for name in dict.fromkeys(points["output"]):
        faces = [found.where(kind=face, output=name).positions()
                 for face in ("inner", "outer")]
        moved[name] = sum(faces) / 2
    largest = max(map(peak, moved.values()), default=0)
    curves = []
    for name, values in moved.items():
        k = int(np.argmax([peak(values[:, k]) for k in range(3)]))
        if peak(values[:, k]) > TOLERANCE * largest:
            curves.append(Curve(f"{plain(name)}, $u_{'xyz'[k]}$",
                                DISTINCT[len(curves) % len(DISTINCT)], "-",
                                values[:, k]))
    return curves[:MAXIMUM_CURVES]


def peak(values):
    """The largest finite magnitude; 0 without any."""
    return np.max(np.abs(values), where=np.isfinite(values), initial=0)


def phases(values):
    """Phases from -180 to 180 degrees; an imaginary part that is round-off is none."""
    imaginary = np.where(np.abs(values.imag) <= TOLERANCE * np.abs(values), 0,
                         values.imag)
    return np.degrees(np.arctan2(imaginary, values.real))


# ---------------------------------------------------------------- charts


def draw(run, found, curves, y_label):
    """Magnitudes above, phases below."""
    frequencies = found.where(output=found["output"][0],
                              kind=found["kind"][0])["frequency"]
    drawing, (above, below) = plt.subplots(
        2, 1, figsize=(5.6, 5.2), sharex=True, layout="constrained",
        height_ratios=(3, 2))
    largest = max(peak(curve.values) for curve in curves)
    for label, color, line, values in curves:
        # a force of inertia is none at rest, and round-off has no phase
        values = np.where(np.abs(values) > LOWEST * largest, values, np.nan)
        plot(above, frequencies, np.abs(values), color, line, label)
        plot(below, *wrapped(frequencies, phases(values)), color, line, label)
    for i, frequency in enumerate(natural_frequencies(run, found)):
        for axes in (above, below):
            axes.axvline(frequency, color="0.6", linewidth=0.8, linestyle=":",
                         zorder=1.5, label=None if i else "natural frequencies")
    scale_by_powers(above)
    above.set(ylabel=y_label.replace(" [", "\n["))
    below.set(ylabel="phase [degrees]", ylim=(-FARTHEST, FARTHEST),
              yticks=np.arange(-180, 181, 90),
              xlabel=units_of(run).label("frequency", "frequency"))
    if frequencies[0] < frequencies[-1]:
        below.set_xlim(frequencies[0], frequencies[-1])
    legend_below(below)
    return drawing


def plot(axes, x, y, color, line, label):
    """A curve, with dots where it has few points and where it has no neighbors."""
    is_there = np.concatenate([[False], np.isfinite(y), [False]])
    alone = is_there[1:-1] & ~is_there[:-2] & ~is_there[2:]
    dots = np.flatnonzero(is_there[1:-1] if len(x) <= FEW else alone)
    axes.plot(x, y, color=color, linestyle=line, linewidth=1.5, label=label,
              marker="o" if len(dots) else None, markersize=3, markevery=list(dots),
              clip_on=False)


def wrapped(frequencies, angles):
    """Phases over the frequency, from FARTHEST below 0 to FARTHEST above, so that those
    around 180 degrees do not jump to -180 and back; with gaps where others jump."""
    x, y, last = [], [], np.nan
    for frequency, angle in zip(frequencies, angles):
        if np.isfinite(last) and np.isfinite(angle):
            near = angle + 360 * np.round((last - angle) / 360)
            if abs(near) <= FARTHEST:
                angle = near
            else:
                x.append(frequency)
                y.append(np.nan)
        last = angle
        x.append(frequency)
        y.append(angle)
    return np.array(x), np.array(y)


def scale_by_powers(axes):
    """A logarithmic scale of at least a decade; below two, also with 2 and 5."""
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    if high < 10 * low:
        middle = np.sqrt(low * high)
        low, high = middle / 10**0.5, middle * 10**0.5
        axes.set_ylim(low, high)
    if high < 100 * low:
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(
            LogFormatterSciNotation(minor_thresholds=(np.inf, np.inf)))
        axes.yaxis.set_minor_locator(NullLocator())


def natural_frequencies(run, found):
    """Those of the same stage within the frequencies of a response, without rigid
    motions."""
    modes = run.modes()
    if modes is None or len(modes) == 0:
        return np.array([])
    values = modes["frequency"][(modes["step"] == found["step"][0])
                                & ~rigid_motions(modes)]
    return values[(values >= found["frequency"].min())
                  & (values <= found["frequency"].max())]
