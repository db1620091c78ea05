# SPDX-License-Identifier: LGPL-2.1-or-later

# The notebook of thirty designs runs as a script: its best design carries the load, and along its line the tension falls at nearly the same force.

import json
import os

from python_test import SOURCE, check, check_close, require, scratch

require("matplotlib")
import matplotlib

matplotlib.use("Agg")

cells = json.loads((SOURCE / "doc/python/designs.ipynb").read_text(encoding="utf-8"))["cells"]
os.chdir(scratch())
os.symlink(SOURCE / "prm", "prm")
variables = {}
for cell in cells:
    if cell["cell_type"] == "code":
        check(not cell["outputs"], "the notebook has outputs")
        exec("".join(cell["source"]), variables)

check(len(variables["study"]) == 30, "the number of designs")
best, line = variables["best"], variables["line"]
check(best["force"] >= variables["LOAD"], f"the best design carries {best['force']} N")
check_close(line["force"][0], best["force"], 1e-6, "the force of the best design")
for step in (1, 2):
    check(line["max_fiber_tension"][step] < line["max_fiber_tension"][step - 1],
          "the tension does not fall")
    check_close(line["force"][step], best["force"], 0.02, "the force along the line")
os.chdir(SOURCE)
