# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command prints: a section of a parameter file, and the rest as
comments."""

import textwrap

import numpy as np

from . import hardness
from biface.errors import BifaceError
from .laws import TESTS


def comments(*lines):
    """Lines as comments of a parameter file."""
    return "".join(textwrap.fill(line, 88, initial_indent="# ",
                                 subsequent_indent="# ") + "\n" for line in lines)


def section(name, law_name, entries, bulk_modulus):
    """A section of a parameter file."""
    lines = [("Type", law_name), *entries, ("K", f"{bulk_modulus:.6g}")]
    width = max(len(entry) for entry, _ in lines)
    return (f"subsection Material {name}\n"
            + "".join(f"  set {entry:{width}} = {value}\n" for entry, value in lines)
            + "end\n")


def bulk_modulus_of(shear_modulus, bulk_modulus, nu):
    """The bulk modulus, given or by Poisson's ratio, and a line about it."""
    if bulk_modulus is None:
        value = 2 * shear_modulus * (1 + nu) / (3 * (1 - 2 * nu))
        origin = f"by nu = {nu:g}"
    else:
        value, origin = bulk_modulus, "as given"
        if not value > 2 / 3 * shear_modulus:
            raise BifaceError(f"--K is {value:g}, but must be greater than two thirds "
                              f"of the shear modulus, {shear_modulus:.4g}.")
    return value, (f"K {origin}, {value / shear_modulus:.3g} shear moduli; rubbers "
                   "have about 1000 MPa, and thin shells hardly notice.")


def of_hardness(shore, name, bulk_modulus, nu):
    """The section from Shore A."""
    modulus = hardness.young_modulus(shore)
    other = hardness.young_modulus_of_simulations(shore)
    shear_modulus = modulus / 3
    value, line = bulk_modulus_of(shear_modulus, bulk_modulus, nu)
    return comments(
        f"An estimate from Shore A {shore:g}, in MPa: E = {modulus:.3g} and mu = E/3 by "
        "the relation of Gent (Rubber Chemistry and Technology 31, 1958). By that of Qi, "
        "Joyce and Boyce (Rubber Chemistry and Technology 76, 2003) mu would be "
        f"{other / 3:.3g}. Both are used here from {hardness.LOWEST} to "
        f"{hardness.HIGHEST}, for small strains. Measure a curve if it matters.",
        line) + section(name, "neo-Hooke", [("mu", f"{shear_modulus:.4g}")], value)


def residuals(law, data):
    """The errors of a law by test: for each the points, the root mean square, the
    largest one and its stretch."""
    result = {}
    for test in data.measured():
        where = data.of(test)
        errors = law.stress(test, data.stretches[where]) - data.stresses[where]
        worst = np.argmax(np.abs(errors))
        result[test] = (errors.size, np.sqrt(np.mean(errors ** 2)),
                        abs(errors[worst]), data.stretches[where][worst])
    return result


def stability(found):
    """A sentence on the instabilities of a law."""
    if not found:
        return "stable"
    return "unstable: " + "; ".join(
        f"{test} " + " and ".join(
            f"from {low:.3g}" + (f" to {high:.3g}" if high else "")
            for low, high in ranges)
        for test, ranges in found.items())


def of_fit(law, data, fitted, measure, found, end, name, bulk_modulus, nu):
    """The section of a law that was fitted, with its errors and its stability."""
    value, line = bulk_modulus_of(law.shear_modulus(), bulk_modulus, nu)
    rows = [f"{'test':12}{'points':>7}{'stretches':>16}{'RMS error':>13}"
            f"{'maximum':>12}  at"]
    for test, (points, size, worst, at) in residuals(law, data).items():
        stretches = data.stretches[data.of(test)]
        span = f"{stretches.min():.4g} to {stretches.max():.4g}"
        rows.append(f"{test:12}{points:7d}{span:>16}{size:13.3g}{worst:12.3g}  {at:.4g}"
                    + ("" if test in fitted.measured() else "  (not fitted)"))
    missing = [test for test in TESTS if test not in data.measured()]
    if missing:
        rows.append(f"No points: {', '.join(missing)}. The law is a guess there.")
    return comments(
        f"{law.name}, least squares of the {measure} errors of {len(fitted)} stresses.",
        *rows,
        f"Drucker's condition: {stability(found)}; checked in all tests up to the "
        f"stretch {end:.4g}, fitted up to {fitted.largest_stretch():.4g}.",
        f"Shear modulus {law.shear_modulus():.4g}.",
        line) + section(name, law.name, law.entries(), value)


def of_all(rows, data, fitted, measure, end):
    """A table of laws: for each its label, and the law and its instabilities, or
    why there is none."""
    columns = f"{'law':15}{'constants':>9}" + "".join(
        f"{test:>13}" for test in data.measured()) + "  stability"
    which = ("" if len(fitted) == len(data)
             else f" in {' and '.join(fitted.measured())} tests")
    lines = textwrap.wrap(
        f"Least squares of the {measure} errors of {len(fitted)} stresses{which}. RMS "
        "errors by test, in the unit of the stresses. Drucker's condition in all tests "
        f"up to the stretch {end:.4g}, fitted up to {fitted.largest_stretch():.4g}.", 88)
    lines += ["", columns]
    for label, law, found in rows:
        if law is None:
            lines.append(f"{label:15}{found}")
            continue
        count = len(law.constants) * (2 if law.name == "Ogden" else 1)
        lines.append(f"{label:15}{count:9d}"
                     + "".join(f"{error[1]:13.3g}"
                               for error in residuals(law, data).values())
                     + f"  {stability(found)}")
    return "\n".join(lines) + "\n"
