# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of the tests of biface-tire-model."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["BIFACE_SOURCE"]) / "tests/report"))

from report_test import (PACKAGE, SOURCE, check, check_refused_by, require, run_command,
                         run_here, scratch)

sys.path.insert(0, str(PACKAGE))

DATA = SOURCE / "tests/data"

# A tire of MF 5.2 and one of MF 6.1
TRUCK, MADE = DATA / "hmmwv_pac2002.tir", DATA / "made_mf61.tir"

CHANNELS = ("F_x", "F_y", "M_x", "M_y", "M_z")


def tire_model(*words):
    """Runs biface-tire-model; returns its exit code, its output, its error messages."""
    return run_command("biface-tire-model", *words)


def output_of(*words):
    """The output of biface-tire-model, which must succeed without warnings."""
    code, output, errors = tire_model_here(*words)
    check(code == 0 and errors == "", f"the exit code is {code}: {errors}")
    return output


def tire_model_here(*words):
    """The same without the time that a new process takes."""
    from biface_tire_model.program import main
    return run_here(main, *words)


def check_refused(words, sentence):
    """Checks that words of the command line are refused with a sentence."""
    check_refused_by("biface-tire-model", tire_model_here(*words), sentence, words)


def write(name, text):
    """A file in a new directory."""
    path = scratch() / name
    path.write_text(text, encoding="utf-8")
    return path


def neutral_formula(kind, **changes):
    """A formula with neutral coefficients but for some."""
    return kind({"FNOMIN": 4000.0, "UNLOADED_RADIUS": 0.3, "NOMPRES": 2e5, **changes})


def sweeps(formula, loads, cambers=(0,), pressures=(None,), angles=15, slips=10):
    """Measurements of a formula: sweeps of slip angle and of longitudinal slip, and
    combined slip at two slip angles on each side."""
    import numpy as np
    from biface_tire_model import Measurements
    alphas = np.radians(np.linspace(-14, 14, 2 * angles + 1))
    kappas = 0.5 * np.linspace(-1, 1, 2 * slips + 1) ** 3
    kappas = kappas[np.abs(kappas) > 0.006]
    rows = [(load, kappa, alpha, camber, pressure or np.nan)
            for load in loads for camber in cambers for pressure in pressures
            for kappa, alpha in [*((0, alpha) for alpha in alphas),
                                 *((kappa, alpha) for kappa in kappas
                                   for alpha in np.radians((-8, -3, 0, 3, 8)))]]
    F_z, kappa, alpha, camber, pressure = np.array(rows).T
    columns = {"F_z": F_z, "slip_ratio": kappa, "slip_angle": alpha,
               "inclination_angle": camber}
    if pressures[0]:
        columns["pressure"] = pressure
    forces = formula.evaluate(F_z, kappa, alpha, camber, columns.get("pressure"))
    return Measurements({**columns, **forces._asdict()})


def largest_errors(formula, data):
    """The largest error of each channel in parts of its peak."""
    import numpy as np
    forces = formula.evaluate(**data.arguments())
    return {name: np.abs(getattr(forces, name) - data[name]).max()
            / (np.abs(data[name]).max() or 1) for name in CHANNELS}
