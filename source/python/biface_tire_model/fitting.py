# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coefficients of the Magic Formula by least squares, in stages.

Each stage fits the coefficients of one curve to the states it holds for, with those of
the stages before fixed: F_y and F_x at pure slip, M_z at pure lateral slip, then what
combined slip adds to F_x, F_y and M_z, then M_x and M_y.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable

import numpy as np
from scipy.optimize import least_squares

from biface.errors import BifaceError
from . import coefficients as known
from .channels import OUTPUTS
from .magic_formula import FORMULAS, REFERENCE_VELOCITY
from .table import ANGLE_STEP
from .units import one_of

# A coefficient is not determined if its standard error is more than this part of the width
# of its bounds, or if it can run through them while the others of its stage make up for
# that, and the root mean square of the residuals changes by less than that part of the
# peak
LARGEST_ERROR, SMALLEST_CHANGE = 0.25, 1e-5

# The root mean square may become larger by this factor where a coefficient that is not
# determined gets its neutral value
WORSE = 1.02

# Weight of the pull to neutral values, in parts of the bounds and of the peak: without
# effect on what the data determine
PULL = 1e-6

# Evaluations of a start, how many of the best are refined, and evaluations for that; no
# more are refined once the root mean square of the residuals is this part of the peak
SHORT, REFINED, LONG, GOOD = 40, 6, 300, 1e-4

# What becomes of the reductions of F_x and F_y by each other if no state has both slips:
# typical ones, none, or an error
WITHOUT_COMBINED = ("typical", "neutral", "refuse")

# Of a channel: number of states, root mean square and largest absolute residual, and the
# largest absolute value
Residual = namedtuple("Residual", "states rms largest peak")


class Fit:
    """The result of a fit.

    formula   a MagicFormula
    reasons   why coefficients stayed neutral or have typical values, by their names
    typical   the names of those that have typical values of another tire
    at_bound  names of coefficients that ended at a bound
    residuals a Residual for each channel that was measured, in SI units
    data      the Measurements
    """

    def __init__(self, formula, reasons, at_bound, data, typical=()):
        self.formula, self.reasons, self.typical = formula, reasons, set(typical)
        self.at_bound, self.data = at_bound, data
        self.residuals = residuals(formula, data)


def fit(data, version: str, radius: float, nominal_load: float | None = None,
        nominal_pressure: float | None = None, velocity: float | None = None,
        without_combined: str = WITHOUT_COMBINED[0],
        progress: Callable[[str], object] | None = None) -> Fit:
    """Fits a formula to measurements.

    data              Measurements
    version           "5.2" or "6.1"
    radius            of the unloaded tire [m]
    nominal_load      [N]; by default the level of the load nearest to the mean of all
    nominal_pressure  [Pa]; by default the level with most states
    velocity          reference velocity LONGVL [m/s]; by default that of most states
    without_combined  if no state has both slips, one of WITHOUT_COMBINED: "typical"
                      reductions of F_x and F_y by each other, those of
                      coefficients.TYPICAL; "neutral", none; or "refuse"
    progress          a function that is called with what is fitted

    Coefficients that the data do not determine stay neutral. Raises BifaceError if there
    are too few states for any curve."""
    if without_combined not in WITHOUT_COMBINED:
        raise BifaceError(f"the choice without combined slip is '{without_combined}', but "
                          f"must be {one_of(WITHOUT_COMBINED)}.")
    if without_combined == "refuse" and not has_combined(data).any():
        raise BifaceError("no state has both a slip angle and a longitudinal slip: a file "
                          "would give full F_x and full F_y at once.")
    if version not in FORMULAS:
        raise BifaceError(f"the format is '{version}', but must be 5.2 or 6.1.")
    if not radius > 0:
        raise BifaceError(f"the radius is {radius:g} m, but must be positive.")
    constants = {"UNLOADED_RADIUS": radius,
                 "FNOMIN": nominal_load or nearest_level(data, "F_z"),
                 "LONGVL": velocity or usual_level(data, "velocity")
                 or REFERENCE_VELOCITY}
    pressure = nominal_pressure or usual_level(data, "pressure")
    if pressure:
        constants.update(NOMPRES=pressure, INFLPRES=pressure)
    work = Work(data, FORMULAS[version](constants), without_combined == "typical",
                progress or (lambda what: None))
    for stage in STAGES:
        stage(work)
    if not work.fitted:
        raise BifaceError("no curve can be fitted: each needs states at "
                          f"{FEWEST} slips or more, with the other slip 0.")
    return Fit(work.formula, work.reasons, work.at_bound, data, work.typical)


# ---- levels of the data

def usual_level(data, name):
    """The level of a quantity with most states, of several such levels the one nearest to
    the mean; None without the column."""
    if data[name] is None:
        return None
    values, numbers = data.levels(name)
    counts = np.bincount(numbers)
    usual = values[counts == counts.max()]
    return usual[np.argmin(np.abs(usual - values.mean()))]


def nearest_level(data, name):
    """The level of a quantity nearest to the mean of all levels."""
    values, _ = data.levels(name)
    return values[np.argmin(np.abs(values - values.mean()))]


def nominal(data, formula):
    """Where load, inclination angle, pressure and velocity are at the levels nearest to
    those of the formula."""
    result = np.ones(len(data), bool)
    for name, target in (("F_z", formula.p.FNOMIN), ("inclination_angle", 0),
                         ("pressure", formula.nominal_pressure),
                         ("velocity", formula.velocity)):
        if data[name] is not None:
            values, numbers = data.levels(name)
            result &= numbers == np.argmin(np.abs(values - target))
    return result


def variations(data):
    """The letters of Coefficient.needs that data provide."""
    counts = {letter: len(data.levels(name)[0]) for letter, name in
              (("l", "F_z"), ("p", "pressure"), ("v", "velocity"))}
    result = {letter: count - 1 for letter, count in counts.items()}
    cambers = data.levels("inclination_angle")[0]
    result["c"] = int((np.abs(cambers) > ANGLE_STEP).any())
    return result


WORDS = {"l": "loads", "p": "pressures", "v": "velocities"}


def missing_variation(coefficient, found):
    """Why data with some variations cannot determine a coefficient, or None."""
    for letter in sorted(set(coefficient.needs)):
        needed = coefficient.needs.count(letter)
        if found[letter] < needed:
            if letter == "c":
                return "no inclination angle"
            count = found[letter] + 1
            return (f"{'one' if count == 1 else 'two'} "
                    f"{WORDS[letter] if count > 1 else singular(WORDS[letter])}")
    return None


def singular(word):
    """One of several."""
    return word[:-3] + "y" if word.endswith("ies") else word[:-1]


# ---- the work

# States with different slips that a curve needs
FEWEST = 5


class Work:
    """What the stages change: the formula, and what became of the coefficients."""

    def __init__(self, data, formula, uses_typical=False, progress=lambda what: None):
        self.data, self.formula = data, formula
        self.reasons, self.at_bound, self.fitted = {}, [], set()
        self.uses_typical, self.typical, self.progress = uses_typical, set(), progress

    def group_of(self, group):
        """The coefficients of a group that the formula has."""
        return [coefficient for coefficient in group.values()
                if self.formula.name in coefficient.formulas]

    def leave_out(self, group, reason):
        """Leaves a group neutral."""
        for coefficient in self.group_of(group):
            self.reasons[coefficient.name] = reason

    def take_typical(self, group):
        """Typical values in place of neutral ones, if they are wanted."""
        if not self.uses_typical:
            return
        values = {coefficient.name: known.TYPICAL[coefficient.name]
                  for coefficient in self.group_of(group)
                  if coefficient.name in known.TYPICAL}
        self.formula = self.formula.with_coefficients(values)
        self.typical |= set(values)

    def states(self, group, channel, chosen, slip):
        """The states of a stage, or None, with a reason, if there are too few slips."""
        measured = np.isfinite(self.data[channel])
        if not measured.any():
            return self.leave_out(group, f"no {channel}")
        states = self.data.where(measured & chosen)
        if len(np.unique(np.round(states[slip], 6))) < FEWEST:
            return self.leave_out(group, f"fewer than {FEWEST} values of {slip}")
        return states

    def solve(self, group, states, channel, evaluate, starts):
        """Fits a group of coefficients.

        states    Measurements
        channel   the name of the measured column
        evaluate  gives it for a formula and states
        starts    dictionaries of coefficients to start from; the best result counts"""
        target = states[channel]
        self.progress(f"fitting {channel} to {len(states)} states")
        problem = Problem(self.formula, states, target, evaluate)
        found, names = variations(states), []
        for coefficient in self.group_of(group):
            reason = missing_variation(coefficient, found)
            if reason:
                self.reasons[coefficient.name] = reason
            else:
                names.append(coefficient.name)
        # without the variations there are fewer wrong minima
        basic = [name for name in names if not known.COEFFICIENTS[name].needs]
        middle = states.where(nominal(states, self.formula))
        first = problem if len(middle) < 2 * len(basic) else \
            Problem(self.formula, middle, middle[channel], evaluate)
        begun = sorted(((start, *first.run(basic, start, SHORT)) for start in starts),
                       key=lambda parts: parts[2].cost)
        values, result = None, None
        for begin in different(begun, basic)[:REFINED]:
            later, other = problem.run(names, begin, LONG)
            self.progress(f"fitting {channel} to {len(states)} states from other starts")
            if result is None or other.cost < result.cost:
                values, result = later, other
            if 2 * result.cost < GOOD ** 2 * len(target):
                break
        needed = []
        while len(needed) < len(names):
            weakest = least_determined(names, needed, result.jac[:len(target)],
                                       result.fun[:len(target)])
            if weakest is None:
                break
            fewer = [name for name in names if name != weakest]
            if not fewer:
                break
            others, other = problem.run(fewer, values, LONG)
            self.progress(f"fitting {channel} to {len(states)} states without {weakest}")
            if rms(other, target) > WORSE * rms(result, target) + SMALLEST_CHANGE:
                # others make up for its changes, but not for its neutral value
                needed.append(weakest)
                continue
            names, values, result = fewer, others, other
            self.reasons[weakest] = "not determined by the data"
        neutral = {coefficient.name: self.formula.neutral[coefficient.name]
                   for coefficient in self.group_of(group)}
        self.formula = self.formula.with_coefficients({**neutral, **values})
        self.fitted.add(channel)
        self.at_bound = [name for name in self.at_bound if name not in neutral]
        self.at_bound += [name for name, value in values.items()
                          if is_at_bound(name, value)]
        for name in values:
            self.reasons.pop(name, None)


class Problem:
    """Residuals of a channel in parts of its peak, by coefficients in parts of their
    bounds."""

    def __init__(self, formula, states, target, evaluate):
        self.formula, self.states, self.target = formula, states, target
        self.evaluate = evaluate
        # a channel that is 0 throughout has no peak
        self.peak = np.abs(target).max() or 1.0

    def run(self, names, start, evaluations):
        """The coefficients with smallest residuals from a start on, and the result of
        least_squares."""
        bounds = [known.COEFFICIENTS[name] for name in names]
        low = np.array([bound.low for bound in bounds], float)
        size = np.array([bound.high - bound.low for bound in bounds], float)
        neutral = np.array([self.formula.neutral[name] for name in names], float)
        first = np.array([start.get(name, value)
                          for name, value in zip(names, neutral)], float)
        pull = PULL * np.sqrt(len(self.target))

        def errors(x):
            values = low + x * size
            formula = self.formula.with_coefficients(dict(zip(names, values)))
            return np.concatenate([
                (self.evaluate(formula, self.states) - self.target) / self.peak,
                pull * (values - neutral) / size])

        result = least_squares(errors, np.clip((first - low) / size, 1e-9, 1 - 1e-9),
                               bounds=(0, 1), x_scale="jac", max_nfev=evaluations,
                               xtol=1e-12, ftol=1e-12, gtol=1e-12)
        return dict(zip(names, (low + result.x * size).tolist())), result


def different(begun, fitted):
    """Of starts, their results and their costs in order, those that differ in their costs
    or in what is not @p fitted yet, as new starts. What ran to a bound starts anew: all
    states may have a better minimum elsewhere."""
    found = []
    for start, values, result in begun:
        rest = {name: value for name, value in start.items() if name not in fitted}
        if not any(result.cost < 1.001 * cost and rest == other
                   for _, _, cost, other in found):
            found.append((start, values, result.cost, rest))
    return [{**start, **{name: value for name, value in values.items()
                         if not is_at_bound(name, value)}}
            for start, values, *_ in found]


def is_at_bound(name, value):
    """Whether a coefficient is at one of its bounds."""
    bounds = known.COEFFICIENTS[name]
    return min(value - bounds.low, bounds.high - value) \
        < 1e-6 * (bounds.high - bounds.low)


def rms(result, target):
    """The root mean square of the residuals, in parts of the peak."""
    return np.sqrt(np.mean(result.fun[:len(target)] ** 2))


def least_determined(names, needed, jacobian, errors):
    """The coefficient that the data determine least, if not at all; None if all but those
    of @p needed are determined. Of those alike the last one, which is the variation of
    another."""
    count = len(errors)
    scaled = jacobian / np.sqrt(count)
    inverse = np.linalg.pinv(scaled.T @ scaled + 1e-20 * np.eye(len(names)),
                             rcond=1e-15, hermitian=True)
    # of the root mean square by the whole range of each, with the best of the others
    changes = np.minimum(1 / np.sqrt(np.maximum(np.diag(inverse), 1e-30)),
                         np.linalg.norm(scaled, axis=0))
    spread = np.linalg.norm(errors) / max(count - len(names), 1)
    limit = max(SMALLEST_CHANGE, spread / LARGEST_ERROR)
    weak = [i for i, name in enumerate(names)
            if name not in needed and changes[i] < limit]
    weak = [i for i in weak if changes[i] <= 10 * changes[weak].min()]
    return names[weak[-1]] if weak else None


def residuals(formula, data):
    """The residuals of all channels that were measured."""
    forces, result = formula.evaluate(**data.arguments()), {}
    for channel in OUTPUTS:
        measured = np.isfinite(data[channel])
        if measured.any():
            errors = (getattr(forces, channel) - data[channel])[measured]
            result[channel] = Residual(int(measured.sum()),
                                       float(np.sqrt(np.mean(errors ** 2))),
                                       float(np.abs(errors).max()),
                                       float(np.abs(data[channel][measured]).max()))
    return result


# ---- the stages

def slope(states, slip, force):
    """The slope of a force over a slip near zero, over the load, at the loads near the
    middle one."""
    load = states["F_z"]
    near = np.abs(states[slip]) <= 0.35 * np.abs(states[slip]).max()
    x, y = states[slip][near], (states[force] / load)[near]
    return np.polyfit(x, y, 1)[0] if len(np.unique(x)) > 1 else 0.0


def friction(states, force):
    """The largest force over the load."""
    return float(np.abs(states[force] / states["F_z"]).max())


def fit_lateral(work):
    """F_y at pure lateral slip."""
    group = known.PURE_LATERAL
    states = work.states(group, "F_y", work.data.is_lateral, "slip_angle")
    if states is None:
        return
    stiffness, peak = slope(states, "slip_angle", "F_y"), friction(states, "F_y")
    # sin(PKY4 atan(1 / PKY2)) of the neutral coefficients is 0.8
    starts = [{"PDY1": peak, "PKY1": stiffness * factor / 0.8, "PCY1": shape,
               "PEY1": curvature}
              for factor in (1, 2)
              for shape, curvature in ((1.3, -0.5), (1.6, 0.3), (1.9, 0.5), (1.5, -2))]
    work.solve(group, states, "F_y", lambda formula, data: formula.lateral(
        data["F_z"], data["slip_angle"], data["inclination_angle"],
        data["pressure"]).value, starts)


def fit_longitudinal(work):
    """F_x at pure longitudinal slip."""
    group = known.PURE_LONGITUDINAL
    states = work.states(group, "F_x", work.data.is_longitudinal, "slip_ratio")
    if states is None:
        return
    stiffness = slope(states, "slip_ratio", "F_x")
    peak = friction(states, "F_x")
    starts = [{"PDX1": peak, "PKX1": max(stiffness, 1) * factor, "PCX1": shape,
               "PEX1": curvature, "PEX4": asymmetry}
              for factor in (1, 2.5)
              for shape, curvature, asymmetry in ((1.65, 0, 0), (1.4, 0.5, 0),
                                                  (1.4, -0.2, 1.5), (1.4, -0.2, -1.5))]
    work.solve(group, states, "F_x", lambda formula, data: formula.longitudinal(
        data["F_z"], data["slip_ratio"], data["inclination_angle"],
        data["pressure"]).value, starts)


def fit_aligning(work):
    """M_z at pure lateral slip."""
    group = known.PURE_ALIGNING
    if "F_y" not in work.fitted:
        return work.leave_out(group, "no F_y at pure lateral slip")
    states = work.states(group, "M_z", work.data.is_lateral, "slip_angle")
    if states is None:
        return
    work.solve(group, states, "M_z", lambda formula, data: formula.aligning_moment(
        data["F_z"], data["slip_angle"], data["inclination_angle"], data["pressure"]),
        starts_of_aligning())


def starts_of_aligning():
    """Trails and residual moments of pure lateral slip."""
    return [{"QDZ1": trail, "QBZ1": stiffness, "QCZ1": shape, "QEZ1": curvature,
             "QBZ9": residual, "QDZ6": 1e-3}
            for trail, stiffness, shape, curvature in
            ((0.1, 10, 1.1, -1), (0.1, 6, 1.4, 0), (0.08, 15, 1.2, -3))
            for residual in (5, 30)]


def slips(data):
    """The inputs of combined slip."""
    return (data["F_z"], data["slip_ratio"], data["slip_angle"],
            data["inclination_angle"], data["pressure"])


def aligning(formula, data):
    """M_z at combined slip."""
    return formula.evaluate(*slips(data)).M_z


def has_combined(data):
    """Where both slips are not zero."""
    return ~data.is_lateral & ~data.is_longitudinal


def combined_states(work, group, channel, pure, chosen):
    """The states from which a force at combined slip is fitted, or None, with a reason,
    if it is not known at @p pure slip or if there is no combined slip; then its reduction is
    typical or neutral."""
    states = None
    if channel not in work.fitted:
        work.leave_out(group, f"no {channel} at pure {pure} slip")
    elif not has_combined(work.data).any():
        work.leave_out(group, "no combined slip")
    else:
        states = work.states(group, channel, chosen, "slip_ratio")
    if states is None:
        work.take_typical(group)
    return states


def fit_combined_x(work):
    """What slip angles change in F_x."""
    group = known.COMBINED_LONGITUDINAL
    states = combined_states(work, group, "F_x", "longitudinal",
                             ~work.data.is_longitudinal)
    if states is None:
        return
    work.solve(group, states, "F_x",
               lambda formula, data: formula.longitudinal_force(*slips(data)),
               [{"RBX1": stiffness, "RBX2": variation, "RCX1": shape}
                for stiffness in (6, 15) for variation in (1, 12) for shape in (1, 1.2)])


def fit_combined_y(work):
    """What longitudinal slip changes in F_y."""
    group = known.COMBINED_LATERAL
    states = combined_states(work, group, "F_y", "lateral", ~work.data.is_lateral)
    if states is None:
        return
    work.solve(group, states, "F_y",
               lambda formula, data: formula.lateral_force(*slips(data)),
               [{"RBY1": stiffness, "RBY2": variation, "RCY1": 1.05, "RVY1": 0.01,
                 "RVY4": angle, "RVY6": slip}
                for stiffness in (7, 18) for variation in (2, 12)
                for angle, slip in ((10, 10), (30, 25))])


def fit_combined_aligning(work):
    """What F_x adds to M_z, and again trail and residual moment, which act up to larger
    equivalent slip angles here."""
    group = known.COMBINED_ALIGNING
    if not {"F_x", "F_y", "M_z"} <= work.fitted:
        return work.leave_out(group, "no F_x, F_y and M_z at pure slip")
    states = work.states(group, "M_z", ~work.data.is_lateral, "slip_ratio")
    if states is not None:
        work.solve(group, states, "M_z", aligning, [{}])
        states = work.data.where(np.isfinite(work.data["M_z"]))
        before = work.formula.coefficients
        work.solve({**known.PURE_ALIGNING, **group}, states, "M_z", aligning,
                   [before] + [{**before, **start} for start in starts_of_aligning()])


def fit_overturning(work):
    """M_x."""
    group = known.OVERTURNING_MOMENT
    if "F_y" not in work.fitted:
        return work.leave_out(group, "no F_y at pure lateral slip")
    states = work.states(group, "M_x", True, "slip_angle")
    if states is None:
        return
    starts = [{"QSX2": camber, "QSX4": factor, "QSX5": load, "QSX6": 1, "QSX7": 0.5,
               "QSX8": force, "QSX9": stiffness, "QSX10": 0.1, "QSX11": 1}
              for camber in (0.5, -1) for factor in (0.05, -0.05, 1)
              for load, force, stiffness in ((0.5, 1, 1), (1.5, 1, 1), (0.5, 1, 5))]
    # with F_y of the formula, which the stages before have fitted
    states = states.with_column("F_y", work.formula.lateral_force(*slips(states)))
    work.solve(group, states, "M_x", lambda formula, data: formula.overturning_moment(
        data["F_z"], data["F_y"], data["inclination_angle"], data["pressure"]),
        starts if work.formula.name == "6.1" else [{}])


def fit_rolling(work):
    """M_y."""
    group = known.ROLLING_RESISTANCE
    measured = np.isfinite(work.data["M_y"])
    if not measured.any():
        return work.leave_out(group, "no M_y")
    if (measured & ~work.data.is_lateral).any() and "F_x" not in work.fitted:
        return work.leave_out(group, "no F_x at pure longitudinal slip")
    states = work.data.where(measured)
    states = states.with_column("F_x", work.formula.longitudinal_force(*slips(states)))
    work.solve(group, states, "M_y",
               lambda formula, data: formula.rolling_resistance_moment(
                   data["F_z"], data["F_x"], data["inclination_angle"], data["pressure"],
                   data["velocity"]), [{"QSY1": 0.01}])


STAGES = (fit_lateral, fit_longitudinal, fit_aligning, fit_combined_x, fit_combined_y,
          fit_combined_aligning, fit_overturning, fit_rolling)
