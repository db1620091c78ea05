# SPDX-License-Identifier: LGPL-2.1-or-later

# Frequencies are those of a standing, inflated tire in the air on a fixed rim, at the
# pressure next to the nominal one.

from structure_test import Run, structural, values
from tire_model_test import check


def rows(frequency, *end):
    """A lateral mode."""
    return [(frequency, 0, 1, 0, 0.8, 0, *end)]


run = Run()
run.vibrate("unloaded", 0, rows(20))
run.vibrate("soft", 1.7e5, rows(37))
run.vibrate("inflated", 2.05e5, rows(40))
run.vibrate("pressed", 2e5, rows(45), load=4000)
result = structural(run)
check(values(result)["FREQ_LAT"] == 40, f"{values(result)}")
comment = [entry.comment for entry in result.known if entry.name == "FREQ_LAT"][0]
check(comment == "lateral, rim fixed, in the air, 205000 Pa", comment)

for pressure, content, load, sentence in (
        (2e5, rows(40), 4000, "the tire of the stage 'only' is on the ground"),
        (0, rows(40), 0, "the tire of the stage 'only' is not inflated"),
        (2e5, rows(40, 0, 1), 0, "the tire of the stage 'only' spins, or is not stable"),
        (2e5, rows(40, 3, 0), 0, "the tire of the stage 'only' spins, or is not stable"),
        (2e5, rows(40, -3, 0), 0, "the tire of the stage 'only' spins, or is not stable"),
        (2e5, rows(0) + rows(40), 0, "the tire of the stage 'only' is not held at the rim"),
        (2e5, [(40, "nan", "nan", 0, 0.8, 0)], 0,
         "the tire of the stage 'only' is no full turn"),
        (1.5e5, rows(40), 0,
         "the modes are those at 150000 Pa, the nominal pressure is 200000 Pa")):
    run = Run(settings={"Stage 1/Angular velocity": "40"})
    run.vibrate("only", pressure, content, load)
    result = structural(run)
    check(set(result.left_out) >= {"FREQ_LAT", "FREQ_LONG", "FREQ_YAW", "FREQ_WINDUP"}
          and result.left_out["FREQ_LAT"] == sentence and not values(result),
          f"{result.left_out}")

# rounding makes the pairs of a standing tire travel
run = Run()
run.vibrate("inflated", 2e5, rows(40) + [(90, 1, 3, 0.35, 0, 0.35, 1e-6, -1),
                                         (90, 1, 3, 0.35, 0, 0.35, -1e-6, 1)])
check(values(structural(run))["FREQ_LONG"] == 90, "the pair has no name")
