# SPDX-License-Identifier: LGPL-2.1-or-later

# Coefficients that the data cannot determine stay neutral, and the file says why.

from tire_model_test import MADE, check, require

require("numpy", "scipy")

import numpy as np
from biface_tire_model import Measurements, fit, make_tir, read_tir
from biface_tire_model.coefficients import COEFFICIENTS
from biface_tire_model.tir_file import parse

formula = read_tir(MADE).formula()
alpha = np.radians(np.linspace(-8, 8, 17))
forces = formula.evaluate(4000, 0, alpha)
for version in ("5.2", "6.1"):
    data = Measurements({"F_z": np.full(17, 4000.0), "slip_angle": alpha,
                         "F_y": forces.F_y, "M_z": forces.M_z})
    result = fit(data, version, 0.32, without_combined="neutral")
    check(set(result.residuals) == {"F_y", "M_z"}, f"{result.residuals}")
    check(all(residual.largest < 1e-3 * residual.peak
              for residual in result.residuals.values()), f"{result.residuals}")
    file = parse(make_tir(result).text())
    # then Adams and Chrono combine the slips by themselves
    check(file.find("FE_METHOD") == ("YES" if version == "5.2" else None),
          f"FE_METHOD is {file.find('FE_METHOD')}")
    for name, reason in (("PDY2", "one load"), ("PDY3", "no inclination angle"),
                         ("PPY1", "one pressure"), ("PDX1", "no F_x"),
                         ("RBY1", "no combined slip"), ("SSZ1", "no F_x, F_y and M_z"),
                         ("QSX3", "no M_x"), ("QSY1", "no M_y")):
        check(reason in result.reasons.get(name, ""),
              f"{name}: {result.reasons.get(name)}")
        if name[:2] == "PP" and version == "5.2":
            continue
        coefficient = COEFFICIENTS[name]
        section = file.sections[coefficient.section]
        check(section.entries[name] == coefficient.neutral
              and f"neutral: {reason}" in section.comments[name],
              f"{name} = {section.entries[name]} ${section.comments[name]}")
    check(not set(result.reasons) & {"PDY1", "PCY1", "PKY1", "QDZ1"}, "they are neutral")

    # two loads still do not determine their squares
    both = Measurements({name: np.concatenate([data[name], factor * data[name]])
                         if name in ("F_z", "F_y", "M_z") else np.tile(data[name], 2)
                         for name in data.columns for factor in (0.5,)})
    result = fit(both, version, 0.32)
    check("PDY2" not in result.reasons and result.reasons["QBZ3"] == "two loads",
          f"{result.reasons}")
