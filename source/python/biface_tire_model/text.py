# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command prints of a fit."""

import textwrap


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
        by_reason.setdefault(reason, []).append(name)
    lines = [f"Neutral ({reason}): {', '.join(names)}."
             for reason, names in by_reason.items()]
    if fit.at_bound:
        lines.append(f"At their bounds: {', '.join(fit.at_bound)}.")
    return "".join(textwrap.fill(line, 88, subsequent_indent="  ") + "\n"
                   for line in lines)


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
