# SPDX-License-Identifier: LGPL-2.1-or-later

# A second run in the same directory leaves no results of the first one, and other files.

from python_test import check, run, scratch

output = scratch()
(output / "modes-of-mine.csv").write_text("mine\n", encoding="utf-8")
first = run({"Named points": "crown: 0 0", "Stage 1/Modes": 1,
             "Material cord/Density": 1e-9,
             "Sensitivities/Entries": "Stage 2/Travel", "Sensitivities/Outputs": "force",
             "Output/Write VTU": True, "Output/Write ply VTU": True}, output)
check(first.derivatives() and first.modes() is not None
      and first.probes() is not None and first.plies() is not None
      and first.vtu("plies") is not None and first.vtu("modes", 1, 1) is not None,
      "results of the first run are missing")
second = run({"Stage 2/Steps": 1}, output)
check(not second.derivatives() and second.modes() is None
      and second.probes() is None and second.plies() is None,
      "tables of the first run are left")
left = sorted(path.name for path in output.iterdir()
              if path.suffix in (".vtu", ".pvd") or "0003" in path.name)
check(not left, f"files of the first run are left: {left}")
check((output / "modes-of-mine.csv").exists(), "a file of the user is gone")
