# SPDX-License-Identifier: LGPL-2.1-or-later

# A sample that fails is a row without outputs, with the reason as its status; a wrong input raises.

import numpy as np

from python_test import TIRE, TOO_FAR, biface, check, error_of, scratch

study = biface.sweep(TIRE, {"Stage 2/Travel": [5, 90]}, ["force"], TOO_FAR, scratch())
check(list(study.is_ok) == [True, False], f"the statuses are {study['status']}")
check("did not converge" in study["status"][1], f"the reason is {study['status'][1]}")
check(np.isnan(study["force"][1]) and study["force"][0] > 0, f"{study['force']}")
check(len(study.where(status="ok")) == 1, "where() does not choose by the status")
error = error_of(biface.RunError, biface.sweep, TIRE, {"Stage 2/Travle": [5]},
                 ["force"], None, scratch())
check("Travle" in str(error), f"this is not the program's sentence: {error}")
