# SPDX-License-Identifier: LGPL-2.1-or-later

# A map over points has the values and gradients of single runs, runs each point once, and says why a point failed.

from python_test import COARSE, TIRE, biface, check, check_close, error_of, scratch

output = scratch()
lines = []
model = biface.Model(TIRE, ["p: Stage 1/Pressure, Stage 2/Pressure", "Stage 2/Travel"],
                     ["force", "strain_energy @ inflation"],
                     {**COARSE, "Sensitivities/Stages": [1, 2],
                      "Newton/Residual tolerance": 1e-10, "Step control/Maximum cuts": 1},
                     output, progress=lines.append)
points = [[0.15, 10], [0.12, 12], [0.15, 10], [0.15, 300]]
table = model.map(points, at_once=2)
check(list(table) == ["p", "Stage 2/Travel", "force", "strain_energy @ inflation", "status"],
      f"the columns are {list(table)}")
check(list(table["status"][:3]) == ["ok"] * 3, f"the points are {table['status']}")
check(table["status"][3] != "ok" and table["force"][3] != table["force"][3],
      "a tire pressed flat is a result")
check(len(lines) == 3 and lines[0].startswith("point 1 at 0.15, 10.0: force"),
      f"the progress is {lines}")
alone = biface.Model(TIRE, model.variables, model.outputs, model.settings, scratch())
for row, point in zip(table.rows()[:2], points):
    for name in model.outputs:
        check_close(row[name], alone.value(point, name), 1e-8, name)
        for computed, expected in zip(model.gradient(point, name),
                                      alone.gradient(point, name)):
            check_close(computed, expected, 1e-6, f"the gradient of {name}")
n_runs = len(list(output.iterdir()))
check(n_runs == 1, f"{n_runs} studies were run")
check(error_of(biface.RunError, model.value, points[3], "force"), "a point that failed")
error_of(biface.BifaceError, model.map, [])
error_of(biface.BifaceError, model.map, [[0.15]])
