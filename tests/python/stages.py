# SPDX-License-Identifier: LGPL-2.1-or-later

# The results of a stage are those of its steps, in all files.

from python_test import biface, check, error_of, run

results = run()
inflation, contact = map(results.stage, results.stages)
check(results.stages == ["inflation", "contact"], f"the stages are {results.stages}")
check(list(inflation.steps) == [1] and list(contact.steps) == [2, 3], "the steps")
check(contact.last("force") == results.last("force") > inflation.last("force") == 0,
      "the force is not that of the last step of the stage")
check(set(inflation.forces()["step"]) == {1}, "forces.csv is not cut to the stage")
check(inflation.profile()["outer_x"].max() == results.profile(1)["outer_x"].max(),
      "the profile is not that of the last step of the stage")
message = str(error_of(biface.BifaceError, results.stage, "contcat"))
check("'contcat'" in message and "inflation, contact" in message, message)
check("steps 1 to 1" in str(error_of(biface.BifaceError, inflation.contact, 2)),
      "a step of another stage is read")
