# SPDX-License-Identifier: LGPL-2.1-or-later

# Where not even the first step converges there are no results, not even older ones in the directory.

from python_test import COARSE, TIRE, biface, check, error_of, scratch

output = scratch()
biface.run(TIRE, COARSE, output)
error = error_of(biface.NotConverged, biface.run, TIRE,
                 {**COARSE, "Newton/Maximum iterations": 1,
                  "Step control/Maximum cuts": 0}, output, may_stop=True)
check(error.results is None, f"there are results: {error.results}")
