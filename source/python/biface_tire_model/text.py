# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command prints of a fit."""

import textwrap

from .coefficients import TYPICAL_TIRE


def table_of_residuals(fit):
    """A row for each channel."""
    lines = [f"{'channel':8}{'states':>8}{'peak':>12}{'RMS, %':>10}{'largest, %':>12}"]
    for channel, residual in fit.residuals.items():
        unit = "N" if channel[0] == "F" else "N m"
        peak = residual.peak or 1
        lines.append(f"{channel:8}{residual.states:8d}{residual.peak:12.5g}"
                     f"{100 * residual.rms / peak:10.3f}"
                     f"{100 * residual.largest / peak:12.3f}  {unit}")
    return "\n".join(lines) + "\n"


def left_neutral(fit):
    """Sentences on coefficients that the data do not determine, by reason."""
    by_reason = {}
    for name, reason in fit.reasons.items():
        if name not in fit.typical:
            by_reason.setdefault(reason, []).append(name)
    lines = [f"Neutral ({reason}): {', '.join(names)}."
             for reason, names in by_reason.items()]
    if fit.at_bound:
        lines.append(f"At their bounds: {', '.join(fit.at_bound)}.")
    return "".join(textwrap.fill(line, 88, subsequent_indent="  ") + "\n"
                   for line in lines)


def of_combined(fit):
    """A list of a sentence, or none, on reductions of F_x and F_y by each other that do not
    follow from the data."""
    if fit.typical:
        return [f"combined slip is not measured: {', '.join(sorted(fit.typical))} are "
                f"typical, those of {TYPICAL_TIRE}, not of this tire."]
    if {"RBX1", "RBY1"} & set(fit.reasons):
        return ["combined slip is not measured: the coefficients give full F_x and full F_y "
                "at once."]
    return []


def not_used(columns):
    """A sentence on columns of the table that are no channels."""
    if not columns:
        return ""
    return textwrap.fill(f"Columns not used: {', '.join(columns)}.", 88,
                         subsequent_indent="  ") + "\n"


def of_stiffness(vertical):
    """A sentence on the vertical stiffness, if it is known."""
    if vertical is None:
        return ""
    return (f"Vertical stiffness {vertical.stiffness:.5g} N/m, radius without load "
            f"{vertical.radius:.5g} m.\n")


def of_fit(fit):
    """The whole text: residuals in percent of the peak of each channel, and what stayed
    neutral."""
    data = fit.data
    loads = data.levels("F_z")[0]
    head = (f"Magic Formula {fit.formula.name}, {len(data)} states at "
            f"{len(loads)} load{'s' * (len(loads) > 1)} from {data['F_z'].min():.5g} to "
            f"{data['F_z'].max():.5g} N.\n")
    return head + table_of_residuals(fit) + left_neutral(fit)


def of_structural(structural):
    """What results tell of the structure: stiffnesses, frequencies and relaxation lengths,
    and what is left out."""
    lines = []
    if structural.vertical:
        entry = structural.vertical
        lines.append(f"Vertical stiffness {entry.value:.5g} N/m, {entry.comment}.")
    if structural.known:
        lines.append("Structure" + (", which a file of MF 5.2 does not contain:"
                                    if structural.is_old else ":"))
        lines += [f"{entry.name:24}{entry.value:12.5g}  {entry.unit:8}{entry.comment}"
                  .rstrip() for entry in structural.known]
    if structural.lengths:
        lines.append("Relaxation lengths, to first order: slope of the force over the slip "
                     "over the")
        lines.append(f"stiffness of the standing tire, footprint {structural.grip}:")
        lines.append(f"{'load, N':>10}{'pressure, Pa':>14}{'of F_y, m':>12}"
                     f"{'of F_x, m':>12}")
        lines += [f"{row.load:10.5g}{row.pressure:14.6g}{length(row.lateral)}"
                  f"{length(row.longitudinal)}" for row in structural.lengths]
    if structural.is_old and structural.entries:
        lines.append("  ".join(f"{entry.name} {entry.value:.5g}"
                               for entry in structural.entries
                               if entry.name[:2] == "PT"))
    if structural.unused:
        lines += textwrap.wrap(f"Not used: stiffnesses, since {structural.unused}.", 88,
                               subsequent_indent="  ")
    by_reason = {}
    for name, reason in structural.left_out.items():
        by_reason.setdefault(reason, []).append(name)
    for reason, names in by_reason.items():
        lines += textwrap.wrap(f"Left out: {', '.join(names)}: {reason}.", 88,
                               subsequent_indent="  ")
    return "\n".join(lines) + "\n"


def length(value):
    """A relaxation length in its column, if it is known."""
    return f"{'-':>12}" if value is None else f"{value:12.5g}"
