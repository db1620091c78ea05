# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tire model from the parameter file of a tire: the runs of a test protocol, and what
follows from their results."""

from __future__ import annotations

import textwrap
from collections import namedtuple
from pathlib import Path

import numpy as np

from biface.errors import BifaceError
from biface.program import call
from biface.tables import read_text
from biface_tire_model.fitted_file import make_tir
from biface_tire_model.fitting import WITHOUT_COMBINED, fit
from biface_tire_model.patience import Patience
from biface_tire_model.structural import Structural
from biface_tire_model.structure import read_structure
from biface_tire_model.structure_tables import (StructureTable, structure_tables, text_of)
from biface_tire_model.table import Measurements, doubts, read_table, write_table
from biface_tire_model import text as fit_text
from biface_tire_model.tydex import write_tydex
from biface_tire_model.units import System
from biface_tire_model.vertical import vertical
from .protocol import BARS, STEADY, read_protocol
from .runs import LEANING, ON_BAR, STANDING, VIBRATING, Tire, plan
from .series import Series

# Files in the directory of the results
STEADY_TABLE, TABLES, TYDEX, SUMMARY = "steady.csv", "tables", "tydex", "summary.txt"
REPORT = "report.html"

# States that differ by less, relative to the largest values, are the same
SAME = 1e-6

# What a series gives.
# tire        a runs.Tire
# series      a series.Series whose runs are done
# data        the Measurements of steady rolling; None without any
# fit         the fitting.Fit; None without one
# structural  a structural.Structural; None without a fit or results
# stiffness   the vertical.Vertical of the rolling tire; None if it is not known
# tables      structure tables, by the name of their file
# left_out    sentences
# is_incomplete  whether a run has no results, or no rolling state was reached
Outcome = namedtuple("Outcome", "tire series data fit structural stiffness tables left_out "
                                "is_incomplete")


def make_model(tire: Tire, protocol: Path, output: Path, version: str | None = None,
               ranks: int = 1, without_combined: str = WITHOUT_COMBINED[0],
               say=print) -> Outcome:
    """Computes what a protocol asks for and writes the results into a directory; what is
    there already is not computed again.

    protocol  a file, see protocol.read_protocol()
    output    the directory
    version   of the Magic Formula, "5.2" or "6.1"; by default 6.1 if the rolling tire has
              several pressures, otherwise 5.2
    say       a function that takes lines of progress

    Raises BifaceError if nothing can be computed."""
    rows = read_protocol(protocol)
    runs, left_out = plan(tire, rows)
    if not runs:
        raise BifaceError("nothing of the protocol can be computed: " + " ".join(left_out))
    series = Series(output, runs, inputs_of(tire), ranks, say)
    for sentence in left_out:
        say(wrapped("Left out: " + sentence))
    output.mkdir(parents=True, exist_ok=True)
    series.compute()
    left_out += series.left_out
    if not series.results:
        raise BifaceError("no run succeeded: " + " ".join(left_out))
    remove_old(output, tire)
    data, failed = measurements(series, tire)
    left_out += failed
    result = stiffness = structural = None
    if data is not None:
        (output / STEADY_TABLE).write_text(write_table(data.columns, System("m, N, s")),
                                           encoding="utf-8")
        write_tydex(data, output / TYDEX)
        left_out += doubts(data)
        say("Fitting the Magic Formula ...")
        result, structural, stiffness = model_of(
            series, data, tire, version or version_for(data), without_combined, left_out, say)
    if result:
        make_tir(result, title=f"Computed by biface for the tire of {tire.path.name}, "
                               f"protocol {protocol.stem}.", vertical=stiffness,
                 structural=structural).write(output / f"{tire.path.stem}.tir")
        left_out += fit_text.of_combined(result)
    tables = tables_of(series, left_out)
    (output / TABLES).mkdir(exist_ok=True)
    for name, table in tables.items():
        (output / TABLES / f"{name}.csv").write_text(text_of(table), encoding="utf-8")
    is_incomplete = (len(series.results) < len(runs)
                     or data is None and any(run.kind == STEADY for run in runs))
    return Outcome(tire, series, data, result, structural, stiffness, tables, left_out,
                   is_incomplete)


def remove_old(output, tire):
    """Removes what an earlier protocol has left."""
    for path in (output / f"{tire.path.stem}.tir", output / STEADY_TABLE,
                 *(output / TYDEX).glob("*.tdx"), *(output / TABLES).glob("*.csv")):
        path.unlink(missing_ok=True)


def inputs_of(tire):
    """What all results depend on."""
    files = "".join(read_text(path) for path in tire.files.values())
    return {"the tire file": tire.text + files + f"{tire.load}",
            "the program": call(None, "--version")}


def version_for(data):
    """The version of the Magic Formula for measurements: 6.1 if pressures vary."""
    return "6.1" if len(data.levels("pressure")[0]) > 1 else "5.2"


# ---- steady rolling

def measurements(series, tire):
    """The Measurements of all tire tests, each state once; and sentences on points that were
    not reached."""
    parts, failed = [], []
    for run in series.runs:
        results = series.results.get(run.name)
        if run.kind != STEADY or results is None:
            continue
        found = results.tire_test()
        if found is None or len(found) == 0:
            failed.append(f"{run.title} ({run.name}): no point was reached.")
            continue
        bad = found.where(found["status"] != "ok")
        if len(bad):
            row = bad.row(0)
            failed.append(
                f"{run.title} ({run.name}): {len(bad)} of {len(found)} points, the first at "
                f"the load {row['load']:g}, inclination {row['inclination_angle']:g}, slip "
                f"angle {row['slip_angle']:g} and slip ratio {row['slip_ratio']:g}: "
                f"{row['status']}")
        if len(bad) < len(found):
            parts.append(read_table(results.directory / "tire_test.csv",
                                    System(tire.system.text, "deg")))
    if not parts:
        return None, failed
    names = [name for name in parts[0].columns
             if all(name in part.columns for part in parts)]
    columns = {name: np.concatenate([part[name] for part in parts]) for name in names}
    inputs = [name for name in ("pressure", "velocity", "inclination_angle", "F_z",
                                "slip_angle", "slip_ratio") if name in columns]
    keys = np.stack([np.round(columns[name] / (np.abs(columns[name]).max() or 1) / SAME)
                     for name in inputs], -1)
    # in ascending order
    _, first = np.unique(keys, axis=0, return_index=True)
    return Measurements({name: values[first] for name, values in columns.items()}), failed


def model_of(series, data, tire, version, without_combined, left_out, say=print):
    """The Fit, the Structural of the runs that stand, and the Vertical; None for what is not
    known, with a sentence."""
    stiffness = vertical(data, tire.pressure)
    if stiffness is None:
        left_out.append(".tir file: the upright tire rolls straight ahead at one load only, "
                        "from which its radius without load does not follow.")
        return None, None, None
    try:
        result = fit(data, version, stiffness.radius, tire.load, tire.pressure,
                     without_combined=without_combined, progress=Patience(say))
    except BifaceError as error:
        if without_combined == "refuse":
            raise
        left_out.append(f".tir file: {error}")
        return None, None, None
    directories = [series.directory_of(run) for run in series.runs
                   if run.name in (STANDING, VIBRATING) and run.name in series.results]
    structural = None
    if directories:
        try:
            structural = Structural(read_structure(directories), result, stiffness)
        except BifaceError as error:
            left_out.append(f"structure: {error}")
    return result, structural, stiffness


# ---- tables

def tables_of(series, left_out):
    """The tables of standing tires by the names of their files."""
    tables = {}
    standing = [series.directory_of(run) for run in series.runs
                if run.name in (STANDING, VIBRATING) and run.name in series.results]
    if standing:
        try:
            tables = {table.name: table for table in
                      structure_tables(read_structure(standing))}
        except BifaceError as error:
            left_out.append(str(error))
    for run in series.runs:
        if run.name in series.results and (run.name == LEANING or run.kind in BARS):
            name = ("leaning_radial_stiffness" if run.name == LEANING else
                    run.name.replace("-", "_"))
            tables[name] = pressed(name, run, series.results[run.name])
    return tables


def pressed(name, run, results):
    """Load over deflection of a run whose ground leans or has a bar."""
    system = System(results.setting("Units"))
    loads = normal_forces(results)
    columns = (("pressure", "pressure", "Pa"), ("approach", "length", "m"),
               ("footprint_length", "length", "m"), ("footprint_width", "length", "m"))
    has_bar = run.kind in BARS
    found = results.history.rows()
    chosen = [i for i, row in enumerate(found)
              if row["stage"].startswith(ON_BAR if has_bar else "load ")]
    if has_bar:
        # while the bar rises there is no state to measure
        rising = [i for i in chosen if found[i]["stage"] == found[chosen[0]]["stage"]]
        chosen, columns = chosen[len(rising) - 1:], columns[:2]
    rows = [[found[i]["stage"], f"{loads[i] * system['force']:.10g}",
             *(f"{found[i][column] * system[kind]:.10g}" for column, kind, _ in columns)]
            for i in chosen]
    title = (f"load of ground and bar over deflection, {run.title}; the deflection counts "
             "from where the plane touches the unloaded tire" if has_bar else
             "load over deflection and footprint of the leaning tire, along the normal of the "
             "ground")
    names = {"approach": "deflection"}
    return StructureTable(name, title, [
        "stage", "load [N]", *(f"{names.get(column, column)} [{unit}]"
                               for column, _, unit in columns)], rows)


def normal_forces(results):
    """The force of ground and bar along the normal of the ground in each step of the
    history: that of ground and bar in forces.csv, where there is a bar."""
    forces = results.forces()
    if forces is None or not (forces["body"] == "bar").any():
        return results.history["force"]
    normal = results.numbers("Contact/Direction", 3)
    whole = sum(np.stack([chosen["F_x"], chosen["F_y"], chosen["F_z"]], -1)
                for chosen in (forces.where(body=body) for body in ("foundation", "bar")))
    return -whole @ normal / np.linalg.norm(normal)


def wrapped(sentence):
    """A sentence in lines."""
    return textwrap.fill(sentence, 88, subsequent_indent="  ")


def summary(outcome: Outcome, files) -> str:
    """The summary for people: the fit, stiffnesses, and what is left out."""
    lines = []
    if outcome.fit:
        lines.append(fit_text.of_fit(outcome.fit) + fit_text.of_stiffness(outcome.stiffness)
                     + (fit_text.of_structural(outcome.structural)
                        if outcome.structural else ""))
        lines.append(of_slopes(outcome))
    lines += [wrapped(f"Left out or to be noted: {sentence[0].upper()}{sentence[1:]}") + "\n"
              for sentence in outcome.left_out]
    lines.append("Written: " + ", ".join(files) + "\n")
    return "".join(lines)


def of_slopes(outcome):
    """Slopes of the fit at zero slip over the load."""
    formula, data = outcome.fit.formula, outcome.data
    lines = []
    if not {"PKY1", "PKX1"} - set(outcome.fit.reasons):
        return ""
    pressure = formula.nominal_pressure
    for load in data.levels("F_z")[0]:
        words = [f"{load:10.5g}"]
        for name, curve in (("PKY1", formula.lateral), ("PKX1", formula.longitudinal)):
            known = name not in outcome.fit.reasons
            words.append(f"{abs(float(curve(load, pressure=pressure).slope)) / load:14.4g}"
                         if known else f"{'-':>14}")
        lines.append("".join(words) + "\n")
    return ("Slopes at zero slip over the load, of F_y in 1/rad, of F_x without unit:\n"
            f"{'load, N':>10}{'of F_y':>14}{'of F_x':>14}\n" + "".join(lines))
