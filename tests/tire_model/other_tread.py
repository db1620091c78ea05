# SPDX-License-Identifier: LGPL-2.1-or-later

# Stiffnesses of a tire with another tread of bristles than that of the tire test do not
# count, and its frequencies do.

from structure_test import Run, made_fit, values
from tire_model_test import check

from biface import Results
from biface_tire_model.structural import Structural
from biface_tire_model.structure import read_structure
from biface_tire_model.text import of_structural

TREAD = {"Contact/Tread/Height": "8", "Contact/Tread/Modulus": "1.8"}


def run(settings):
    """Results with a stiffness and a mode."""
    result = Run(settings=settings)
    result.move("lateral", 4000, 2e5, 1e5)
    result.vibrate("inflated", 2e5, [(40, 0, 1, 0, 0.8, 0)])
    return result.write()


rolling = Results(run(TREAD))
for settings, is_used in ((TREAD, True), ({}, False),
                          ({**TREAD, "Contact/Tread/Modulus": "2"}, False)):
    structure = read_structure([run(settings)], rolling=rolling)
    result = Structural(structure, made_fit(), True)
    check(("LATERAL_STIFFNESS" in values(result)) == is_used
          and "FREQ_LAT" in values(result), f"{settings}: {values(result)}")
    if not is_used:
        check(result.left_out["LATERAL_STIFFNESS"].endswith(
            f"is not that of {rolling.directory} (Height 8, Modulus 1.8, Void ratio 0)"),
            f"{result.left_out}")

# one of two directories
structure = read_structure([run({}), run(TREAD)], rolling=rolling)
result = Structural(structure, made_fit(), True)
check("LATERAL_STIFFNESS" in values(result) and "Not used: stiffnesses, since"
      in of_structural(result), of_structural(result))
