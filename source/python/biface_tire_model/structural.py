# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entries of a .tir file that do not come from forces of the rolling tire: stiffnesses
on the ground, frequencies, and relaxation lengths."""

from __future__ import annotations

from collections import namedtuple

import numpy as np

from .mode_names import MEANINGS, name_modes, unfit
from .relaxation import SLOPES, coefficients_52, relaxation_lengths
from .stiffness_fit import far, fit_stiffness, numbers, of_best_grip
from .structure import levels

# Of each motion: its entry, what it is, and the coefficients of its dependence on load,
# load squared and pressure in MF 6.1
STIFFNESSES = {
    "longitudinal": ("LONGITUDINAL_STIFFNESS", "N/m", ("PCFX1", "PCFX2", "PCFX3")),
    "lateral": ("LATERAL_STIFFNESS", "N/m", ("PCFY1", "PCFY2", "PCFY3")),
    "turn": ("YAW_STIFFNESS", "N m/rad", ())}
VARIATIONS = ("load", "load squared", "pressure")

# The sections of coefficients in MF 5.2
SECTIONS_52 = {"PTX": "LONGITUDINAL_COEFFICIENTS", "PTY": "LATERAL_COEFFICIENTS"}

# Smaller deviations of the data from the formula are rounding
EXACT = 1e-5

# An entry of a file, with its unit for the printed text
Entry = namedtuple("Entry", "section name value unit comment")


class Structural:
    """What a Structure gives for a Fit.

    entries      for the file, a list of Entry
    known        the stiffnesses and frequencies, a list of Entry; those of the file, or
                 for MF 5.2 only to be printed
    lengths      a list of relaxation.Relaxation
    left_out     why there is no value of an entry, by its name
    unused       why stiffnesses of one directory do not count, beside others; or ""
    grip         how the footprint of the relaxation lengths holds; "" if there are none
    vertical     the Entry of the vertical stiffness; None if the table gives it
    """

    def __init__(self, structure, fit, vertical):
        self.known, self.left_out = [], {}
        self.unused = structure.unused if structure.states else ""
        self.vertical, self.lengths, self.entries, self.grip = None, [], [], ""
        formula = fit.formula
        self.is_old = formula.name == "5.2"
        load = formula.p.FNOMIN
        pressure = formula.nominal_pressure or only_pressure(structure)
        if pressure is None:
            reason = "there are several pressures, and --nominal-pressure is missing"
            self.left_out = {name: reason for name in (
                *(name for name, *_ in STIFFNESSES.values()), *MEANINGS)}
            return
        if not vertical:
            self.vertical = self._vertical(structure, load, pressure)
        stiffnesses = self._add_stiffnesses(structure, load, pressure)
        self._add_frequencies(structure, pressure)
        self.lengths = relaxation_lengths(fit, structure.states, stiffnesses, pressure)
        if self.lengths:
            self.grip = " or ".join(dict.fromkeys(
                state.grip for motion in SLOPES for state in of_best_grip(
                    [state for state in structure.states if state.motion == motion])))
        self.entries = [self.vertical] if self.vertical else []
        self.entries += self._old_entries(fit, pressure) if self.is_old else self.known

    def _vertical(self, structure, load, pressure):
        """The tangent stiffness of the approaching ground at the nominal load, between
        those of the steps around it."""
        name = "VERTICAL_STIFFNESS"
        found = [press for press in structure.presses if press.tangent > 0]
        if not found or far([press.pressure for press in found], pressure):
            self.left_out[name] = "the ground approaches at no pressure near the nominal one"
            return None
        values, which = levels([press.pressure for press in found])
        nearest = np.abs(values - pressure).argmin()
        found = [press for press, number in zip(found, which) if number == nearest]
        middle = np.array([(press.load + press.load_before) / 2 for press in found])
        order = np.argsort(middle)
        if not middle.min() <= load <= middle.max():
            self.left_out[name] = (f"the ground approaches under {numbers(middle)} N, the "
                                   f"nominal load is {load:.5g} N")
            return None
        value = np.interp(load, middle[order],
                          np.array([press.tangent for press in found])[order])
        return Entry("VERTICAL", name, float(value), "N/m",
                     f"of the ground approaching at {values[nearest]:.6g} Pa")

    def _add_stiffnesses(self, structure, load, pressure):
        """The stiffnesses; returns the StiffnessFits by motion."""
        result = {}
        for motion, (name, unit, variations) in STIFFNESSES.items():
            found = fit_stiffness([state for state in structure.states
                                   if state.motion == motion], load, pressure)
            if isinstance(found, str):
                self.left_out[name] = (found if structure.states else
                                       structure.unused or found)
                continue
            result[motion] = found
            loads = numbers([state.load for state in found.states])
            pressures = numbers([state.pressure for state in found.states])
            comment = f"footprint {found.grip}, {loads} N, {pressures} Pa"
            if found.deviation > EXACT:
                comment += f", up to {100 * found.deviation:.2g} % off"
            self._know(name, found.value, unit, comment)
            for variation, coefficient in zip(VARIATIONS, variations):
                comment = f"variation with {variation}"
                if variation in found.reasons:
                    comment += f"; neutral: {found.reasons[variation]}"
                self._know(coefficient, found.coefficients[variation], "", comment)
        return result

    def _add_frequencies(self, structure, pressure):
        """The frequencies."""
        fits = [modes for modes in structure.modes if not unfit(modes)]
        if not fits:
            reason = "no stage has 'Modes'"
            if structure.modes:
                modes = structure.modes[0]
                reason = f"the tire of the stage '{modes.stage}' {unfit(modes)}"
            self.left_out.update(dict.fromkeys(MEANINGS, reason))
            return
        modes = min(fits, key=lambda modes: abs(modes.pressure - pressure))
        if far([modes.pressure], pressure):
            self.left_out.update(dict.fromkeys(
                MEANINGS, f"the modes are those at {modes.pressure:.6g} Pa, the nominal "
                          f"pressure is {pressure:.6g} Pa"))
            return
        named, reasons = name_modes(modes)
        for name, meaning in MEANINGS.items():
            if name in named:
                self._know(name, named[name].frequency, "Hz",
                           f"{meaning}, rim fixed, in the air, {modes.pressure:.6g} Pa")
            else:
                self.left_out[name] = reasons[name]

    def _know(self, name, value, unit, comment):
        self.known.append(Entry("STRUCTURAL", name, value, unit, comment))

    def _old_entries(self, fit, pressure):
        """The coefficients of the relaxation lengths of MF 5.2, and their scales, which
        some programs take as 0 if they are missing."""
        values, comments = coefficients_52(self.lengths, fit, pressure)
        result = [Entry(SECTIONS_52[name[:3]], name, value, "", comments[name])
                  for name, value in values.items()]
        for coefficient, scale, what in (("PTX1", "LSGKP", "F_x"),
                                         ("PTY1", "LSGAL", "F_y")):
            if coefficient in values:
                result.append(Entry("SCALING_COEFFICIENTS", scale, 1.0, "",
                                    f"scale of the relaxation length of {what}"))
        return result

    def write(self, file):
        """Adds the entries to a TirFile."""
        for entry in self.entries:
            file.section(entry.section).set(
                entry.name, float(f"{entry.value:.9g}"), entry.comment)


def only_pressure(structure):
    """The pressure of all states and modes, if there is only one."""
    found = levels([item.pressure for item in
                    (*structure.states, *(modes for modes in structure.modes
                                          if not unfit(modes)))])[0]
    return float(found[0]) if len(found) == 1 else None
