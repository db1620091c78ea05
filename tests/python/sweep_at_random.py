# SPDX-License-Identifier: LGPL-2.1-or-later

# With a number of samples, a sweep is a Latin hypercube of the ranges.

import numpy as np

from python_test import COARSE, TIRE, biface, check, scratch

study = biface.sweep(TIRE, {"Stage 1/Pressure": (0.1, 0.2), "Stage 2/Travel": (4, 8)},
                     ["force"], COARSE, scratch(), samples=4, options={"Seed": 3})
check(len(study) == 4, f"there are {len(study)} samples")
for name, low, size in (("Stage 1/Pressure", 0.1, 0.1), ("Stage 2/Travel", 4, 4)):
    parts = np.floor((study[name] - low) / size * 4)
    check(sorted(parts) == [0, 1, 2, 3], f"not one of {study[name]} in each quarter")
