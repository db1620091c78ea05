# SPDX-License-Identifier: LGPL-2.1-or-later

# All tables of a run have the numbers of its files.

from python_test import biface, check, check_equal, read_csv, run

results = run({"Named points": "crown: 0 0", "Output/Points per ply": 1,
               "Stage 2/Modes": 2, "Material cord/Density": 1e-9,
               "Sensitivities/Entries": "Stage 2/Travel",
               "Sensitivities/Outputs": "force", "Output/Write VTU": True})
for name, table in (
        ("history", results.history), ("contact-0003", results.contact()),
        ("contact-0002", results.contact(2)), ("profile-0003", results.profile()),
        ("plies-0003", results.plies()), ("probes", results.probes()),
        ("forces", results.forces()), ("stiffness", results.stiffness()),
        ("modes", results.modes()), ("sensitivities", results.sensitivities())):
    lines = [line for line in read_csv(results.directory / f"{name}.csv")
             if line.get("face", "middle") == "middle"]
    check(len(table) == len(lines) > 0, f"{name} has {len(table)} rows")
    for row, line in zip(table.rows(), lines):
        for column, text in line.items():
            if isinstance(row[column], str) or text in ("", "nan"):
                check(str(row[column]) == (text or "nan"), f"{row[column]}: {text}")
            else:
                check_equal(row[column], float(text), f"{column} of {name}")
for name in ("buckling", "critical_points", "rolling", "hysteresis", "heat", "response"):
    check(getattr(results, name)() is None, f"there is a table {name}")
faces = results.vtu(step=2)
check(len(faces["connectivity"]) == 2 * 4 * 14 * 14, "the faces are not all cells")
check(results.vtu("modes", mode=2)["mode"].shape == faces["Points"].shape,
      "the mode has other points than the shell")
check(biface.read_table(results.directory / "history.csv")["force"][-1]
      == results.last("force"), "read_table() reads other numbers")
