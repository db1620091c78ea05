# SPDX-License-Identifier: LGPL-2.1-or-later

# The relaxation coefficients of MF 5.2 give the relaxation lengths; the file has no
# stiffnesses, and scales of 1.

import math

from structure_test import Run, made_fit, structural, values
from tire_model_test import check

from biface_tire_model import make_tir

COEFFICIENTS = {"PKY1": -18, "PKY2": 1.8, "PKX1": 22}
RADIUS, LOAD = 0.3, 4000
fit = made_fit("5.2", **COEFFICIENTS)


def file_of(loads, lateral, longitudinal):
    """The coefficients of runs with relaxation lengths over the load."""
    run = Run()
    for load in loads:
        for motion, length in (("lateral", lateral), ("longitudinal", longitudinal)):
            slope = abs(float(getattr(fit.formula, motion)(load).slope))
            run.move(motion, load, 2e5, slope / length(load))
    result = structural(run, fit=fit)
    file = make_tir(fit, structural=result)
    check("STRUCTURAL" not in file.sections and "LATERAL_STIFFNESS" in values(result),
          "the file has stiffnesses")
    for name, section in (("PTX1", "LONGITUDINAL_COEFFICIENTS"),
                          ("PTY1", "LATERAL_COEFFICIENTS"),
                          ("LSGKP", "SCALING_COEFFICIENTS"),
                          ("LSGAL", "SCALING_COEFFICIENTS")):
        check(name in file.sections[section].entries, f"{name} is not in [{section}]")
    check(file.find("LSGKP") == 1 == file.find("LSGAL"), "a scale is not 1")
    return {name: file.find(name) for name in ("PTX1", "PTX2", "PTX3", "PTY1", "PTY2")}


def lateral_length(load):
    return 2.1 * RADIUS * math.sin(2 * math.atan(load / 2.4 / LOAD))


def longitudinal_length(load):
    return load * (1.9 - 0.4 * (load / LOAD - 1)) * RADIUS / LOAD


for loads in ((3000, 5000), (2000, 4000, 6000)):
    found = file_of(loads, lateral_length, longitudinal_length)
    for name, value in (("PTX1", 1.9), ("PTX2", -0.4), ("PTX3", 0), ("PTY1", 2.1),
                        ("PTY2", 2.4)):
        check(abs(found[name] - value) < 1e-5, f"{name} is {found[name]}, not {value}")

# one load: as for a stiffness that does not depend on it
found = file_of((4200,), lambda load: 0.5, lambda load: 0.1)
check(found["PTY2"] == 1.8 and found["PTX2"] == 0, f"{found}")
check(abs(found["PTY1"] * RADIUS * math.sin(2 * math.atan(4200 / 1.8 / LOAD)) - 0.5) < 1e-7
      and abs(found["PTX1"] * RADIUS * 4200 / LOAD - 0.1) < 1e-7, f"{found}")
