# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stiffness of a tire on the ground over load and pressure, as in MF 6.1:

    C = C_0 (1 + p_1 df_z + p_2 df_z^2) (1 + p_3 dp_i)

with df_z and dp_i of the Magic Formula, (17) and (18) of Besselink et al. (2010).
"""

from __future__ import annotations

from collections import namedtuple

import numpy as np
from scipy.optimize import least_squares

from .structure import GRIPS, levels

# How far the nominal load or pressure may lie outside those of the data, in parts of it
NEAR = 0.1

# value         C_0 [N/m] or [N m/rad]
# coefficients  p_1, p_2 and p_3 by the names "load", "load squared" and "pressure"; 0 if
#               they are neutral
# reasons       why some are, by the same names
# deviation     the largest one of the data from the formula, in parts of it
# grip          one of structure.GRIPS
# states        the States it is from
StiffnessFit = namedtuple("StiffnessFit",
                          "value coefficients reasons deviation grip states")


def of_best_grip(states):
    """The States with the best of the grips that there are."""
    for grip in GRIPS:
        chosen = [state for state in states if state.grip == grip]
        if chosen:
            return chosen
    return []


def numbers(values, digits=6):
    """Levels in a sentence: one of them, or the range."""
    found = levels(values)[0]
    first, last = f"{found[0]:.{digits}g}", f"{found[-1]:.{digits}g}"
    return first if len(found) == 1 else f"{first} to {last}"


def far(values, nominal):
    """Whether a nominal value lies outside the range of others."""
    return not min(values) * (1 - NEAR) <= nominal <= max(values) * (1 + NEAR)


def fit_stiffness(states, load: float, pressure: float) -> StiffnessFit | str:
    """The StiffnessFit of States with one motion, by least squares of the relative
    deviations; or why there is none.

    load      the nominal one [N]
    pressure  the nominal one [Pa]"""
    states = of_best_grip(states)
    if not states:
        return "no stage moves the ground so from a loaded state"
    loads = np.array([state.load for state in states])
    pressures = np.array([state.pressure for state in states])
    for values, nominal, what, unit in ((loads, load, "loads", "N"),
                                        (pressures, pressure, "pressures", "Pa")):
        if far(values, nominal):
            return (f"the {what} are {numbers(values)} {unit}, the nominal one is "
                    f"{nominal:.6g} {unit}")
    values = np.array([state.first for state in states])
    if not (values > 0).all():
        return "a stiffness is not positive"
    df, dp = loads / load - 1, pressures / pressure - 1
    names, reasons = determined(loads, pressures, df, dp)

    def model(x):
        p = dict(zip(names, x[1:]))
        return (values.mean() * x[0]
                * (1 + p.get("load", 0) * df + p.get("load squared", 0) * df ** 2)
                * (1 + p.get("pressure", 0) * dp))

    result = least_squares(lambda x: model(x) / values - 1,
                           np.array([1.0] + [0.0] * len(names)), x_scale="jac",
                           xtol=1e-14, ftol=1e-14, gtol=1e-14)
    coefficients = {"load": 0.0, "load squared": 0.0, "pressure": 0.0,
                    **dict(zip(names, result.x[1:].tolist()))}
    return StiffnessFit(float(values.mean() * result.x[0]), coefficients, reasons,
                        float(np.abs(result.fun).max()), states[0].grip, states)


def determined(loads, pressures, df, dp):
    """The names of the coefficients that states determine, and why not the others."""
    many_loads, many_pressures = len(levels(loads)[0]), len(levels(pressures)[0])
    columns, names, reasons = [np.ones_like(df)], [], {}
    words = {1: "one load", 2: "two loads"}
    for name, column, missing in (
            ("load", df, words[1] if many_loads == 1 else None),
            ("pressure", dp, "one pressure" if many_pressures == 1 else None),
            ("load squared", df ** 2, words.get(many_loads))):
        more = columns + [column]
        if missing:
            reasons[name] = missing
        elif np.linalg.matrix_rank(np.stack(more, -1), tol=1e-3) < len(more):
            reasons[name] = "load and pressure change together"
        else:
            columns, names = more, names + [name]
    return names, reasons
