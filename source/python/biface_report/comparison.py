# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that compares two runs, also of different meshes."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from biface import BifaceError
from biface.parameters import is_same

from . import charts, maps
from .content import (find_footprint, ground_if_known, normal_of, section_caption,
                      section_lines)
from .drawing import BLUE, RED, STYLE, embed, headroom, legend_below, plain
from .page import (LeftOut, Section, figure, missing, number, page, paragraph,
                   plain_number, table)
from .section import SectionPlane
from .summary import in_brackets, input_name, rows_of, warnings
from .units import units_of

COLORS = (BLUE, RED)
LINES = ("-", "--")
# Entries that say nothing about the shell
IGNORED = ("Output/Directory",)


def report(*runs):
    """The page about two runs. Throws a BifaceError if they have different units."""
    units = [units_of(run) for run in runs]
    if units[0].names != units[1].names and all(unit.are_named for unit in units):
        raise BifaceError(
            f"{runs[0].directory} and {runs[1].directory} have different units, "
            f"{', '.join(units[0].names)} and {', '.join(units[1].names)}: their "
            "numbers cannot be compared.")
    plt.rcParams.update(STYLE)
    names = names_of(runs)
    footprints = [find_footprint(run) for run in runs]
    parts = [numbers(runs, names, footprints), curves(runs, names),
             pressures(runs, names), *maps_of_footprints(runs, names, footprints),
             sections(runs, names), entries(runs, names)]
    shown = [part for part in parts if isinstance(part, Section)]
    absent = [part for part in parts if isinstance(part, LeftOut)]
    if absent:
        shown.append(missing(absent))
    return page(f"biface: {names[0]} and {names[1]}", introduction(runs, names), shown)


def names_of(runs):
    """What to call the runs: their directories, with more of the path if needed."""
    paths = [run.directory.resolve() for run in runs]
    names = [path.name for path in paths]
    return names if names[0] != names[1] else [str(path) for path in paths]


def introduction(runs, names):
    """Where the numbers come from, and what is missing of the runs."""
    units = [units_of(run) for run in runs]
    result = [paragraph(
        f"{escape(name)}: {escape(input_name(run))}, step {run.step} of "
        f"{run.last_step}, stage “{escape(run.last('stage'))}”.", "facts")
        for run, name in zip(runs, names)]
    result.append(paragraph(max(units, key=lambda unit: unit.are_named).sentence(),
                            "facts"))
    if units[0].names != units[1].names:
        result.append(paragraph("Only one of the inputs names its units; those of the "
                                "other are taken to be the same.", "warning"))
    return "\n".join(result + [
        paragraph(f"{escape(name)}: {escape(text)}", "warning")
        for run, name in zip(runs, names) for text in warnings(run)])


def numbers(runs, names, footprints):
    """The numbers of both summaries beside each other."""
    rows = [{row.name: row for row in rows_of(run, footprint)}
            for run, footprint in zip(runs, footprints)]
    body = []
    for name in dict.fromkeys([*rows[0], *rows[1]]):
        here = [row.get(name) for row in rows]
        line = [name + in_brackets((here[0] or here[1]).unit)]
        line += [number(row.value, row.digits) if row else "–" for row in here]
        if all(here):
            first, second = (row.value for row in here)
            change = second - first
            line += [number(change, 4, max(abs(first), abs(second))),
                     number(100 * change / abs(first), 3) if first else "–"]
        else:
            line += ["–", "–"]
        body.append(line)
    return Section("numbers", "Numbers", table(
        "Numbers of both runs", ["", *map(escape, names), "Difference", "%"], body)
        + paragraph("The difference is the second less the first, in percent of the "
                    "first. The report of each run says what the numbers mean."), True)


# ---------------------------------------------------------------- curves


def curves(runs, names):
    """Force against approach or, without contact, a load against displacements."""
    name = "Load and deflection"
    in_contact = [run.in_contact.any() for run in runs]
    if in_contact[0] != in_contact[1]:
        return LeftOut(name, "Only one of the runs has contact.")
    drawing, axes = plt.subplots(figsize=(5.6, 3.8))
    if in_contact[0]:
        for run, label, color, line in zip(runs, names, COLORS, LINES):
            for i, (approach, force) in enumerate(charts.contact_curves(run)):
                axes.plot(approach, force, "o", color=color, linestyle=line,
                          markersize=3.5, label=None if i else plain(label))
        charts.label_contact_curve(axes, units_of(runs[0]))
        words = "the force on the ground against its approach"
    else:
        words = draw_points(axes, runs, names)
        if words is None:
            plt.close(drawing)
            return LeftOut(name, "The runs have no named point in common that moves "
                           "in the same direction under the same load.")
    headroom(axes)
    legend_below(axes)
    return Section("curve", name, figure(
        embed(drawing), f"Chart of {words} in both runs.",
        "All branches of each run, in its color."))


def draw_points(axes, runs, names):
    """The curves of the first named point that both runs have; words about them, or
    None if there is none."""
    probes = [run.probes() for run in runs]
    if any(table_of is None or len(table_of) == 0 for table_of in probes):
        return None
    found = [charts.ProbeCurves(run, table_of)
             for run, table_of in zip(runs, probes)]
    common = [key for key in found[0].curves if key in found[1].curves]
    if not common or found[0].load_name != found[1].load_name:
        return None
    point, direction = common[0]
    for each, label, color, line in zip(found, names, COLORS, LINES):
        for i, (moved, load, _) in enumerate(each.curves[common[0]]):
            axes.plot(moved, load, "o", color=color, linestyle=line, markersize=3.5,
                      label=None if i else plain(label))
    axes.set(xlabel=units_of(runs[0]).label(f"{plain(point)}, $u_{direction}$",
                                             "length"),
             ylabel=found[0].load_name)
    return f"the {found[0].load_name} against the displacement of {escape(point)}"


def pressures(runs, names):
    """The contact pressures along the lines of the profiles."""
    name = "Contact pressure along the section"
    profiles = [run.profile() for run in runs]
    if any(profile is None or not profile["pressure"].any() for profile in profiles):
        return LeftOut(name, "Not both runs have contact pressures in their profiles.")
    if len({run.setting("Surface/Meridian") == "circular arc" for run in runs}) > 1:
        return LeftOut(name, "alpha_1 is an angle in one of the runs and a length in "
                       "the other.")
    drawing, axes = plt.subplots(figsize=(5.6, 3.8))
    for profile, label, color, line in zip(profiles, names, COLORS, LINES):
        axes.plot(profile["alpha_1"], profile["pressure"], color=color, linestyle=line,
                  marker="o", markersize=3.5, label=plain(label))
    shown = [profile["alpha_1"][profile["pressure"] > 0] for profile in profiles]
    low, high = (end(np.concatenate(shown)) for end in (np.min, np.max))
    margin = 0.15 * (high - low) or 1
    axes.set(xlim=(low - margin, high + margin), ylim=(0, None),
             xlabel=units_of(runs[0]).label("$α_1$", "length")
             if runs[0].setting("Surface/Meridian") != "circular arc"
             else "$α_1$ [degrees]",
             ylabel=units_of(runs[0]).label("contact pressure", "pressure"))
    legend_below(axes)
    places = " and ".join(plain_number(profile["alpha_2"][0]) for profile in profiles)
    return Section("pressure", name, figure(
        embed(drawing), "Chart of the contact pressure against alpha_1 in both runs.",
        f"At the nodes along α<sub>2</sub> = {places}, per area of the undeformed "
        "middle surface."))


# ---------------------------------------------------------------- pictures


def maps_of_footprints(runs, names, footprints):
    """The footprints beside each other, with the same scales."""
    if any(footprint is None for footprint in footprints):
        return [LeftOut("Footprints", "Not both shells are in contact.")]
    if footprints[0].axis_names != footprints[1].axis_names:
        return [LeftOut("Footprints", "The directions toward the ground differ.")]
    shown = maps.frame(*footprints)
    maximum = max(footprint.fine_pressure.max() for footprint in footprints)
    return [Section(f"footprint{i + 1}", f"Footprint of {name}", figure(
        embed(maps.draw_footprint(footprint, units_of(run), shown, maximum), "png"),
        "Map of the contact pressure."))
        for i, (run, name, footprint) in enumerate(zip(runs, names, footprints))]


def sections(runs, names):
    """The deformed sections in one drawing."""
    name = "Deformed sections"
    found = [section_lines(run) for run in runs]
    for run_name, lines in zip(names, found):
        if isinstance(lines, str):
            return LeftOut(name, f"{run_name}: {lines}")
    profiles = [lines[1][-1] for lines in found]
    plane = SectionPlane(profiles, normal_of(runs[0]), found[0][2])
    drawing, is_to_scale, has_ground = maps.draw_sections(
        plane, profiles, list(map(plain, names)),
        [ground_if_known(run, run.step) for run in runs], units_of(runs[0]), COLORS)
    return Section("section", name, figure(
        embed(drawing), "Drawing of the deformed sections of both shells.",
        section_caption(runs[0], found[0][3], is_to_scale, has_ground)))


# ---------------------------------------------------------------- input


def entries(runs, names):
    """The entries of parameters.prm that differ."""
    if any(run.parameters is None for run in runs):
        return LeftOut("Entries that differ", "parameters.prm is missing.")
    both = [{name: entry for name, entry in run.parameters.entries.items()
             if name not in IGNORED} for run in runs]
    rows = [[escape(name)] + ["(no such entry)" if entry is None else
                              escape(entry.value) or "(empty)" for entry in found]
            for name in dict.fromkeys([*both[0], *both[1]])
            if differ(*(found := [each.get(name) for each in both]))]
    if not rows:
        return Section("input", "Entries that differ", paragraph("None."), True)
    return Section("input", "Entries that differ", table(
        "Entries of parameters.prm; of stages and materials that only one run has, "
        "those that differ from the default",
        ["Entry", *map(escape, names)], rows).replace(
            'class="scroll"', 'class="scroll words"', 1), True)


def differ(first, second):
    """Whether two entries, None for a missing one, mean something else."""
    if first is not None and second is not None:
        return not is_same(first.value, second.value)
    return (first or second).default is not None
