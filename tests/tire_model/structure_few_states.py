# SPDX-License-Identifier: LGPL-2.1-or-later

# What few states do not determine is neutral, and a stiffness far from the nominal load or
# pressure is left out; the reasons are told.

from structure_test import Run, structural, values
from tire_model_test import check

# loads, pressures, the neutral coefficients and their reasons
for states, neutral in (
        ([(4000, 2e5)], {"PCFY1": "one load", "PCFY2": "one load", "PCFY3": "one pressure"}),
        ([(3000, 2e5), (5000, 2e5)], {"PCFY2": "two loads", "PCFY3": "one pressure"}),
        ([(3000, 1.8e5), (5000, 2.2e5)], {"PCFY2": "two loads",
                                          "PCFY3": "load and pressure change together"})):
    run = Run()
    for load, pressure in states:
        run.move("lateral", load, pressure, 1e5 + 10 * load)
    result = structural(run)
    check(abs(values(result)["LATERAL_STIFFNESS"] - 1.4e5) < 1, f"{values(result)}")
    comments = {entry.name: entry.comment for entry in result.known}
    for name in ("PCFY1", "PCFY2", "PCFY3"):
        if name in neutral:
            check(values(result)[name] == 0
                  and comments[name].endswith(f"neutral: {neutral[name]}"),
                  f"{name}: {comments[name]}")
        else:
            check(values(result)[name] != 0 and "neutral" not in comments[name],
                  f"{name}: {comments[name]}")

for load, pressure, sentence in (
        (3000, 2e5, "the loads are 3000 N, the nominal one is 4000 N"),
        (4000, 1.5e5, "the pressures are 150000 Pa, the nominal one is 200000 Pa")):
    run = Run()
    run.move("lateral", load, pressure, 1e5)
    result = structural(run)
    check(result.left_out["LATERAL_STIFFNESS"] == sentence
          and result.left_out["YAW_STIFFNESS"]
          == "no stage moves the ground so from a loaded state", f"{result.left_out}")
    check("LATERAL_STIFFNESS" not in values(result), "it is written")
