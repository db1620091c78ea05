# SPDX-License-Identifier: LGPL-2.1-or-later

# With --stable, curves of an unstable law give a law that is stable at all stretches.

from rubber_test import (TRELOAR, check, curves, entries_of, output_of, require, scratch,
                         write)

require("numpy", "scipy")

from biface_rubber.laws import LINEAR, Law

law = Law("Mooney-Rivlin", LINEAR["Mooney-Rivlin"].values(), (0.3, -0.01))
path = write(scratch() / "curves.csv", curves(law))
words = ("--law", "Mooney-Rivlin", "--up-to", "100")
check("unstable: uniaxial from" in output_of(path, *words), "the law is stable")
output = output_of(path, *words, "--stable")
check("condition: stable;" in output and entries_of(output)["c01"] == [0], output)

output = output_of(TRELOAR, "--stable", "--up-to", "100")
check("unstable" not in output and output.count(" stable\n") == 6, output)
