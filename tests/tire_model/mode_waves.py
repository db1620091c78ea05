# SPDX-License-Identifier: LGPL-2.1-or-later

# Without files of the shapes, lateral and longitudinal modes follow from the effective
# masses, the yaw mode from its waves; what is not certain is left out with a reason.

from structure_test import Run, structural, values
from tire_model_test import check

LATERAL = (40, 0, 1, 0, 0.8, 0)
YAW = [(50, 1, 1, 0.001, 0, 0), (50, 1, 1, 0, 0, 0.001)]
LONGITUDINAL = [(90, 1, 3, 0.7, 0, 0), (90, 1, 3, 0, 0, 0.7)]
NO_TRANSLATION = (70, 0, 1, 0, 0, 0)


def frequencies(rows):
    """The frequencies of a run with modes, and why others are left out."""
    run = Run()
    run.vibrate("inflated", 2e5, rows)
    result = structural(run)
    return ({name: value for name, value in values(result).items()
             if name.startswith("FREQ")}, result.left_out)


found, reasons = frequencies([LATERAL, *YAW, NO_TRANSLATION, *LONGITUDINAL])
check(found == {"FREQ_LAT": 40, "FREQ_YAW": 50, "FREQ_LONG": 90}, f"{found}")
check("may also be radial ones" in reasons["FREQ_WINDUP"], f"{reasons}")
for rows, name, sentence in (
        ([(40, 0, 1, 0, 0.45, 0), (60, 0, 3, 0, 0.3, 0)], "FREQ_LAT",
         "no mode without waves holds more than half of the mass along y: the largest has "
         "45 %"),
        ([LATERAL, (90, 1, 3, 0.3, 0, 0), (90, 1, 3, 0, 0, 0.3)], "FREQ_LONG",
         "the largest has 30 %"),
        # a pair of which one mode is missing, or whose frequencies are apart
        ([LATERAL, LONGITUDINAL[0]], "FREQ_LONG", "there is none"),
        ([LATERAL, LONGITUDINAL[0], (95, 1, 3, 0, 0, 0.7)], "FREQ_LONG", "there is none"),
        ([LATERAL, *YAW, *((f + 30, *rest) for f, *rest in YAW)], "FREQ_YAW",
         "several pairs with one wave"),
        ([LATERAL, (50, 1, 1, 0.1, 0, 0), (50, 1, 1, 0, 0, 0.1)], "FREQ_YAW",
         "no pair with one wave"),
        ([LATERAL, (50, 1, 4, 0, 0, 0), (50, 1, 4, 0, 0, 0)], "FREQ_YAW",
         "no pair with one wave")):
    found, reasons = frequencies(rows)
    check(name not in found and sentence in reasons[name], f"{name}: {found} {reasons}")
