# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modes of vibration: their table, and pictures of the first ones."""

from html import escape

import numpy as np

from .page import (LeftOut, Section, count, details, number, paragraph, plain_number,
                   table)
from .shapes import pictures_of
from .units import units_of

# A smaller part of the kinetic energy in the air is not worth a column
LITTLE_AIR = 1e-6
# Frequencies are square roots of numbers that are exact to about ten digits
RIGID = 1e-4


def modes(run):
    """The table of modes.csv, and pictures of the last stage in it."""
    name = "Modes of vibration"
    found = run.modes()
    if found is None or len(found) == 0:
        return LeftOut(name, "No stage asks for 'Modes'.")
    grows = (found["growth_rate"] != 0).any()
    turns = np.isfinite(found["circumferential_waves"]).any()
    # traveling waves of wheels that roll or spin
    travel = found.get("travel", np.zeros(len(found)))
    travels = (np.nan_to_num(travel) != 0).any()
    # the air in a tire moves with it
    part_of_air = found.get("part_of_air", np.zeros(len(found)))
    has_air = (part_of_air > LITTLE_AIR).any()
    is_rigid, units = rigid_motions(found), units_of(run)
    rows = []
    for i in range(len(found)):
        row = [escape(found["stage"][i]), str(int(found["mode"][i])),
               "≈ 0, rigid motion" if is_rigid[i] else
               number(found["frequency"][i], 6)]
        if grows:
            row.append(number(found["growth_rate"][i]))
        if turns:
            row += [plain_number(found[column][i]) for column in
                    ("circumferential_waves", "meridional_half_waves")]
        if travels:
            row.append(plain_number(np.round(travel[i], 2)))
        if has_air:
            row.append(percent(part_of_air[i]))
        total = found["total_mass"][i]
        row += [percent(found[f"effective_mass_{axis}"][i] / total) for axis in "xyz"]
        rows.append(row)
    heads = (["Stage", "Mode", "Frequency"] + (["Growth rate"] if grows else [])
             + (["Waves around", "Half waves along the meridian"]
                if turns else [])
             + (["Travel"] if travels else [])
             + (["Part of the air"] if has_air else [])
             + [f"Effective mass, {axis}" for axis in "xyz"])
    text = paragraph(
        f"Natural frequencies [{units['frequency']}] of the loaded shell at the end of "
        "each stage; effective masses of translations, of the mass of the shell, "
        f"{plain_number(found['total_mass'][-1])}"
        + (f"\u00a0{units['mass']}" if units.are_named else "") + "."
        + (" Travel: 1 for waves in the direction in which the wheel turns, -1 for "
           "those against it." if travels else "")
        + (" Part of the air: its part of the kinetic energy." if has_air else ""))
    all_modes = table("Modes, from modes.csv", heads, rows)
    last = found["step"] == found["step"][-1]
    if (is_rigid & last).any():
        text += paragraph(
            f"Not drawn: {count(int((is_rigid & last).sum()), 'rigid motion')} of the "
            f"stage {escape(found['stage'][-1])}, with a frequency of zero within "
            "round-off.")
    last = found.where(last & ~is_rigid)
    unit = " " + units["frequency"] if units.are_named else ""
    pictures = None if len(last) == 0 else pictures_of(
        run, "modes", last, [f"{value:.5g}{unit}" for value in last["frequency"]],
        "Shapes of the first modes of vibration.",
        f"The first modes of the stage {escape(last['stage'][0])} with their "
        "frequencies")
    if pictures is None:
        return Section("modes", name, all_modes + text, True)
    return Section("modes", name, pictures + "\n" + text + details(
        "All modes", all_modes), True)


def percent(part):
    """A part of 1 in percent; a dash for one that is not known."""
    return f"{100 * part:.1f}\u00a0%" if np.isfinite(part) else "–"


def rigid_motions(found):
    """Whether each mode is a rigid motion that nothing holds: its frequency is zero
    within round-off, relative to the highest one of the stage, and it does not
    grow."""
    highest = {step: found["frequency"][found["step"] == step].max()
               for step in found["step"]}
    size = np.hypot(2 * np.pi * found["frequency"], found["growth_rate"])
    limits = np.array([2 * np.pi * RIGID * highest[step] for step in found["step"]])
    return size <= limits
