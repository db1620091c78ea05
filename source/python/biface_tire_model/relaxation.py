# SPDX-License-Identifier: LGPL-2.1-or-later
"""Relaxation lengths: the distance over which the forces of a rolling tire follow a small
change of its slips, to first order the slope of the force over the slip, divided by the
stiffness of the standing tire, see section 7.2 of Pacejka (2012)."""

from __future__ import annotations

from collections import namedtuple

import numpy as np
from scipy.optimize import least_squares

from .stiffness_fit import of_best_grip
from .structure import levels
from .table import RELATIVE_STEP

# At a load [N] and a pressure [Pa]: relaxation lengths of F_y and F_x [m], None where the
# slope or the stiffness is not known, and whether the stiffness is that of the fit over the
# load, not of a state
Relaxation = namedtuple("Relaxation", "load pressure lateral longitudinal is_between")

# Of each direction: the coefficient without which the slope is not known, and what gives it
SLOPES = {"lateral": "PKY1", "longitudinal": "PKX1"}

# Bounds of PTY2, the load of the largest lateral length over the nominal one
PTY2_BOUNDS = (0.1, 50)


def slope(fit, motion, load, pressure):
    """The absolute slope of the force of a Fit over its slip [N] or [N/rad]; None if the
    data do not determine it there."""
    formula, data = fit.formula, fit.data
    if SLOPES[motion] in fit.reasons:
        return None
    if outside(load, data["F_z"]) or (data["pressure"] is not None
                                      and outside(pressure, data["pressure"])):
        return None
    given = pressure if formula.nominal_pressure else None
    return abs(float(getattr(formula, motion)(load, pressure=given).slope))


def outside(value, values):
    """Whether a value is out of the range of data."""
    return not (values.min() * (1 - RELATIVE_STEP) <= value
                <= values.max() * (1 + RELATIVE_STEP))


def relaxation_lengths(fit, states, stiffnesses, pressure) -> list[Relaxation]:
    """A Relaxation for each load and pressure with a stiffness and one for the nominal
    ones, in ascending order of pressure and load.

    fit          a Fit of the forces
    states       the States
    stiffnesses  the StiffnessFit of "lateral" and "longitudinal", as far as they are known
    pressure     the nominal one [Pa]"""
    load = fit.formula.p.FNOMIN
    states = [state for motion in SLOPES for state in of_best_grip(
        [state for state in states if state.motion == motion])]
    load_levels, load_numbers = levels([state.load for state in states])
    pressure_levels, pressure_numbers = levels([state.pressure for state in states])
    rows = []
    for pair in sorted(set(zip(pressure_numbers, load_numbers))):
        chosen = [state for state, *numbers in zip(states, pressure_numbers, load_numbers)
                  if tuple(numbers) == pair]
        at = float(load_levels[pair[1]]), float(pressure_levels[pair[0]])
        values = {motion: [state.first for state in chosen if state.motion == motion]
                  for motion in SLOPES}
        rows.append(Relaxation(*at, *(
            over(slope(fit, motion, *at), np.mean(found) if found else None)
            for motion, found in values.items()), False))
    if not any(is_near(row.load, load) and is_near(row.pressure, pressure)
               for row in rows):
        rows.append(Relaxation(load, pressure, *(
            over(slope(fit, motion, load, pressure), stiffnesses[motion].value
                 if motion in stiffnesses else None) for motion in SLOPES), True))
    return sorted((row for row in rows if row.lateral or row.longitudinal),
                  key=lambda row: (row.pressure, row.load))


def over(slope_of, stiffness):
    """A length, if both are known."""
    return None if slope_of is None or stiffness is None else float(slope_of / stiffness)


def is_near(value, other):
    """Whether two values are one level."""
    return abs(value - other) <= RELATIVE_STEP * other


def coefficients_52(lengths, fit, pressure):
    """The coefficients of the relaxation lengths in MF 5.2 as a dictionary, with one of
    comments, by least squares of the relative deviations:

        sigma_kappa = F_z (PTX1 + PTX2 df_z) R_0/F_z0,
        sigma_alpha = PTY1 sin(2 arctan(F_z/(PTY2 F_z0))) R_0

    The factor exp(PTX3 df_z) of the former remains 1: programs differ in its sign."""
    formula = fit.formula
    load, radius = formula.p.FNOMIN, formula.p.UNLOADED_RADIUS
    result, comments = {}, {}
    rows = [row for row in lengths
            if is_near(row.pressure, pressure) and not row.is_between]
    found = [(row.load, row.longitudinal) for row in rows if row.longitudinal]
    if found:
        loads, sigma = np.array(found).T
        df = loads / load - 1
        columns = [np.ones_like(df), df][:min(len(levels(loads)[0]), 2)]
        factors = loads * radius / load / sigma
        solution = np.linalg.lstsq(np.stack(columns, -1) * factors[:, None],
                                   np.ones_like(df), rcond=None)[0]
        result.update(PTX1=float(solution[0]), PTX2=0.0, PTX3=0.0)
        comments.update(
            PTX1="relaxation length of F_x over load at the nominal load",
            PTX2="its variation with load",
            PTX3="its exponent with load; neutral: programs differ in its sign")
        if len(solution) > 1:
            result["PTX2"] = float(solution[1])
        else:
            comments["PTX2"] += "; neutral: one load"
    found = [(row.load, row.lateral) for row in rows if row.lateral]
    if found:
        loads, sigma = np.array(found).T
        result.update(lateral_52(loads / load, sigma / radius, formula.p.PKY2))
        comments.update(PTY1="largest relaxation length of F_y over radius",
                        PTY2="its load over the nominal load")
        if len(levels(loads)[0]) == 1:
            comments["PTY2"] += "; one load: PKY2"
    return result, comments


def lateral_52(loads, lengths, peak):
    """PTY1 and PTY2 for loads over the nominal one and lengths over the radius; of one
    load PTY2 is @p peak, as for a stiffness that does not depend on the load."""
    def shape(at):
        return np.sin(2 * np.arctan(loads / at))

    def height(at):
        # of the relative deviations
        parts = shape(at) / lengths
        return parts.sum() / (parts ** 2).sum()

    if len(levels(loads)[0]) > 1:
        low, high = np.log(PTY2_BOUNDS)
        best = min((least_squares(
            lambda x: height(np.exp(x[0])) * shape(np.exp(x[0])) / lengths - 1, [start],
            bounds=(low, high), xtol=1e-14, ftol=1e-14, gtol=1e-14)
            for start in np.linspace(low, high, 7)[1:-1]), key=lambda result: result.cost)
        peak = float(np.exp(best.x[0]))
    return {"PTY1": float(height(peak)), "PTY2": float(peak)}
