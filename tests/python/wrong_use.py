# SPDX-License-Identifier: LGPL-2.1-or-later

# Wrong values raise a BifaceError with a sentence, before anything is run.

from python_test import TIRE, biface, check, error_of, run, scratch

output = scratch()
file = output / "file"
file.write_text("", encoding="utf-8")
results = run(output=output / "run")
for function, words, sentence in (
        (biface.sweep, (TIRE, {"Stage 2/Travel": "15"}, ["force"], {}, output),
         "must be a list of numbers"),
        (biface.sweep, (TIRE, {"Stage 2/Travel": 15}, ["force"], {}, output),
         "must be a list of numbers"),
        (biface.sweep, (TIRE, {"Stage 2/Travel": [15]}, ["force"], {}, file),
         "cannot be created"),
        (biface.Model, (TIRE, "Stage 2/Travel", ["force"]), "must be lists"),
        (biface.Model(TIRE, ["Stage 2/Travel"], ["force"]).value, ([1, 2], "force"),
         "has 2 numbers"),
        (biface.Model, (TIRE, ["p: factor of Stage 2/Pressure", "Stage 2/Pressure"],
                        ["force"]), "there is no derivative by it"),
        (biface.read_table, (file,), "damaged"),
        (biface.write_parameters, (output / "none/x.prm", {}), "cannot be written"),
        (biface.write_parameters, (file, {"Stage 1/Name": "a\\"}), "backslash"),
        (biface.entries, ("/bin/true",), "is not biface"),
        (results.last, ("forc",), "There is no column 'forc'"),
        (results.forces().where, (), None)):
    if sentence is None:
        error = error_of(biface.BifaceError, function, bdy="foundation")
        sentence = "There is no column 'bdy'"
    else:
        error = error_of(biface.BifaceError, function, *words)
    check(sentence in str(error), f"it says: {error}")
for ranks in (0, None, "2", float("nan")):
    check("the number of ranks" in str(error_of(
        biface.BifaceError, biface.run, TIRE, {}, output / "run", ranks=ranks)).lower(),
        f"{ranks} ranks")
