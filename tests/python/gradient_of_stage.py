# SPDX-License-Identifier: LGPL-2.1-or-later

# The gradient of an output at the end of the run is never that of an earlier stage.

from python_test import COARSE, TIRE, biface, check, check_close, error_of, scratch

model = biface.Model(TIRE, ["Stage 1/Pressure"], ["strain_energy",
                                                  "strain_energy @ inflation"],
                     {**COARSE, "Sensitivities/Stages": 1}, scratch())
check("has no derivatives" in str(error_of(
    biface.BifaceError, model.gradient, [0.15], "strain_energy")), "an error")
ends = [model.value([p], "strain_energy@inflation") for p in (0.1499, 0.1501)]
check_close(model.gradient([0.15], "strain_energy@inflation")[0],
            (ends[1] - ends[0]) / 2e-4, 1e-4, "the derivative at the end of inflation")
