# SPDX-License-Identifier: LGPL-2.1-or-later

# A parameter file is read as the program reads it, and written with changes that the program obeys.

from python_test import COARSE, TIRE, biface, check, error_of, scratch

parameters = biface.read_parameters(TIRE)
check(parameters["Stage 2/Travel"] == "20", f"{parameters['Stage 2/Travel']}")
check(parameters["Contact/Regularization"] == "1e4", "a comment is part of a value")
study = biface.read_parameters(TIRE.parent / "study_of_footprint.prm")
check(study["Study/Outputs"].endswith("mean_pressure, footprint_length, "
                                      "footprint_width, max_fiber_tension, "
                                      "strain_energy @ inflation"),
      f"continued lines are not joined: {study['Study/Outputs']}")
file = scratch() / "joined.prm"
file.write_text("subsection Laminate\n  set Plies = ud: 1 @ 0,  # inner \\\n    # outer\n"
                "    ud: 2 @ 0   # last\nend\n# alone \\\nset Materials = ud\n")
joined = biface.read_parameters(file)
check(joined["Laminate/Plies"] == "ud: 1 @ 0, ud: 2 @ 0",
      f"a comment hides the next line: {joined['Laminate/Plies']}")
check(joined["Materials"] == "ud", "a comment alone hides the next line")
file = scratch() / "changed.prm"
biface.write_parameters(file, {**COARSE, "Stage 2/Travel": 10.5}, TIRE)
check(biface.read_parameters(file)["Stage 2/Travel"] == "10.5", "a change is not read")
results = biface.run(file, output=scratch())
check(results.last("approach") == 10.5, "the program does not obey the change")
written = biface.read_parameters(results.directory / "parameters.prm")
check({entry.name: entry.default for entry in written.changed()}["Stage 2/Travel"]
      == "unchanged", "the default is not read")
error_of(biface.BifaceError, biface.write_parameters, file, {"Stage 1/Name": "a # b"})
