# SPDX-License-Identifier: LGPL-2.1-or-later

# A run that does not converge raises NotConverged with the steps before, or returns them, marked, if it may stop.

from python_test import TOO_FAR, biface, check, error_of, run

error = error_of(biface.NotConverged, run, TOO_FAR)
check(error.code == 2, f"the exit code is {error.code}")
check("did not converge" in str(error), f"this is not the program's message: {error}")
check(0 < error.results.last("approach") < 90, "the steps before are missing")
results = run(TOO_FAR, may_stop=True)
check(results.stopped == str(error), f"the results are not marked: {results.stopped}")
check(list(results.history["force"]) == list(error.results.history["force"]),
      "the results are others")
check(run().stopped is None, "a complete run is marked, too")
