# SPDX-License-Identifier: LGPL-2.1-or-later

# The gradient of a model is that of its values, also by a factor and at the end of a stage, and each point is run once.

from python_test import COARSE, TIRE, biface, check, check_close, error_of, scratch

output = scratch()
model = biface.Model(
    TIRE, ["p: Stage 1/Pressure, Stage 2/Pressure", "E: factor of Material cord/E_L"],
    ["force", "strain_energy @ inflation"],
    {**COARSE, "Sensitivities/Stages": [1, 2], "Newton/Residual tolerance": 1e-10},
    output)
point = [0.15, 1.1]
for name in model.outputs:
    for i, derivative in enumerate(model.gradient(point, name)):
        ends = [model.value([x + side * 1e-4 * x * (k == i)
                             for k, x in enumerate(point)], name) for side in (-1, 1)]
        check_close(derivative, (ends[1] - ends[0]) / (2e-4 * point[i]), 1e-4,
                    f"the derivative of {name} by {model.variables[i]}")
n_runs = len(list(output.iterdir()))
check(n_runs == 5, f"{n_runs} points were run")
check(model.results(point).last("force") == model.value(point, "force"), "the results")
error_of(biface.RunError, model.value, [-0.15, 0], "force")
