# SPDX-License-Identifier: LGPL-2.1-or-later

# Directories that are no results, without the files, without units or with others, are
# answered in one sentence.

from structure_test import Run
from tire_model_test import check_refused, scratch, write

HEAD = "slip_angle,F_z,F_y\n"
TABLE = write("table.csv", HEAD + "".join(f"{angle},4000,{-900 * angle}\n"
                                          for angle in range(-4, 5)))
FIT = ("fit", TABLE, "--format", "6.1", "--radius", "0.3", "--output",
       scratch() / "out.tir", "--structure")


def changed(file, text):
    """Results with another file, or without it."""
    run = Run()
    run.move("lateral", 4000, 2e5, 1e5)
    run.vibrate("inflated", 2e5, [(40, 0, 1, 0, 0.8, 0)])
    path = run.write() / file
    if text is None:
        path.unlink()
    else:
        path.write_text(text, encoding="utf-8")
    return path.parent


empty = Run()
empty.step("inflated", 2e5)
nameless = Run(units="")
nameless.move("lateral", 4000, 2e5, 1e5)
nothing = Run()
nothing.vibrate("pressed", 2e5, [(40, 0, 1, 0, 0.8, 0)], load=100)
for directory, sentence in (
        ("/no/such/directory", "/no/such/directory is not a directory."),
        (scratch(), "holds no results of biface: there is no history.csv in it."),
        (empty.write(), "has neither stiffness.csv nor modes.csv: in no stage does the "
                        "ground move, and none has 'Modes'."),
        (nameless.write(), "does not name its units: the entry 'Units' of its "
                           "parameters.prm is empty, and --units is missing."),
        (changed("parameters.prm", None), "does not name its units"),
        (changed("parameters.prm", "set Units = mm, stone, s\n"),
         "the unit of force is 'stone', but must be"),
        (changed("stiffness.csv", "step,stage\n"), "is damaged: its first line does not "
                                                   "name the column 'pressure'")):
    for words in ((*FIT, directory), ("stiffness", directory)):
        check_refused(words, sentence)
check_refused(("stiffness", nothing.write()), "nothing for a table")
check_refused(("stiffness", nameless.write(), "--units", "mm, N"),
              "the units are 'mm, N', but must be those of length, force and time")
good = Run("m, N, s")
good.move("lateral", 4000, 2e5, 1e5)
other = Run("mm, N, s")
other.move("lateral", 4000, 2e5, 1e5)
check_refused(("stiffness", good.write(), other.write()),
              "has the units mm, N, s, but ")
check_refused(("stiffness", good.write(), "-o", TABLE), "cannot be read or written")
