# SPDX-License-Identifier: LGPL-2.1-or-later
# %% [markdown]
# # biface in Python
#
# The Python package `biface` runs parameter files, reads their results as NumPy arrays,
# varies them in studies, and gives values and gradients to optimizers. This page goes
# from a single run of the bias tire to an optimization by derivatives.
#
# It is written from [python/tutorial.py](python/tutorial.py), whose cells editors such as
# Visual Studio Code and Spyder run one by one. Start it in the root of the checkout; it
# takes about a minute on two cores.
#
# From the Debian package, `import biface` works at once in Debian's Python; in any other,
# also of a virtual environment, install the packages:
#
#     pip install source/python
#
# or tell Python where they are: `export PYTHONPATH=$PWD/source/python`. They need NumPy,
# and this tutorial also matplotlib, SciPy and pandas (Debian: `python3-matplotlib`,
# `python3-scipy`, `python3-pandas`). The program is the one in
# `build/`, the one installed with the package, or the one on the `PATH`; the environment
# variable `BIFACE` names another. `help(biface)` lists what the package has.
#
# ## A run
#
# `run` takes a parameter file and entries with other values. `progress=True` would print
# a line for each step.

# %%
import biface
import matplotlib.pyplot as plt
import numpy as np

TIRE = "prm/bias_tire_true_pressure.prm"
SETTINGS = {"Contact/Multiplier mass": "lumped", "Output/Write VTU": False}

results = biface.run(TIRE, {**SETTINGS, "Stage 2/Steps": 5}, "output/tire")
results

# %% [markdown]
# `history` is the table `history.csv`, with a NumPy array for each of the columns that
# [output.md](output.md) describes. `last` is a value of the last step, and `stage` keeps
# the steps of one stage.

# %%
print(results.last("force"), "N at", results.last("approach"), "mm")
print(results.stage("contact").history["force"])

# %% [markdown]
# With pandas, each table becomes a DataFrame.

# %%
columns = ["step", "stage", "approach", "force", "footprint_area", "mean_pressure"]
results.history.to_pandas()[columns].round(3)

# %% [markdown]
# The other files are methods: `contact()`, `profile()` and `plies()` of a step, `forces()`,
# `probes()`, `stiffness()`, `modes()`, `rolling()` and so on of all steps, `vtu()` for what
# ParaView shows. `support_motions` names the columns of supports that move, such as
# `alpha_1_max_force`. A table has `where` to choose rows, and `row` and `rows` for one or all
# of them; notebooks show its first and last rows. `response()` has complex columns `x`, `y` and `z` in place of the real and
# imaginary ones of its file: `response().where(excitation="ground z", output="foundation")`
# are the forces of the ground over `["frequency"]`.

# %%
ground = results.forces().where(body="foundation").row(-1)
print({name: round(float(ground[name]), 1) for name in ("F_x", "F_y", "F_z")})

# The force against the approach, and the pressure at the nodes in contact
contact = results.stage("contact").history
nodes = results.contact().where(active=1)
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
left.plot([0, *contact["approach"]], [0, *contact["force"]], "o-")
left.set(xlabel="approach, mm", ylabel="force, N")
dots = right.scatter(nodes["z"], nodes["y"], c=nodes["pressure"], s=16)
right.set(xlabel="z, mm", ylabel="y, mm", aspect="equal")
figure.colorbar(dots, label="pressure, MPa");

# %% [markdown]
# ## When a run fails
#
# A wrong entry raises a `RunError` with the message of the program. A step that does not
# converge raises `NotConverged`, which has the steps before it; with `may_stop=True` they
# are returned instead, and `results.stopped` is the message.

# %%
try:
    biface.run(TIRE, {"Stage 2/Travle": 30}, "output/wrong")
except biface.RunError as error:
    print(error)

too_far = {**SETTINGS, "Stage 2/Travel": 90, "Stage 2/Steps": 3,
           "Step control/Maximum cuts": 0}
try:
    biface.run(TIRE, too_far, "output/too_far")
except biface.NotConverged as error:
    print(str(error).splitlines()[0])
    print("reached:", error.results.last("approach"), "mm")

# %% [markdown]
# ## A sweep
#
# `sweep` runs all combinations of values as a study of the program ([studies.md](studies.md)),
# here on two ranks at a time, and returns its table. A sample that fails is a row without
# outputs, whose `status` tells why. Several numbers that are equal have a name.

# %%
study = biface.sweep(
    TIRE, {"pressure: Stage 1/Pressure, Stage 2/Pressure": [0.1, 0.15, 0.2],
           "travel: Stage 2/Travel": [5, 10, 15, 20]},
    ["force", "footprint_area", "max_fiber_tension"],
    {**SETTINGS, "Stage 2/Steps": 1}, "output/sweep", ranks=2)
study.where(status="ok").to_pandas().pivot(
    index="travel", columns="pressure", values="force").round(1)

# %%
# The force against the travel at three pressures
figure, axes = plt.subplots(figsize=(5, 3.2), layout="constrained")
for pressure in np.unique(study["pressure"]):
    samples = study.where(pressure=pressure)
    axes.plot(samples["travel"], samples["force"], "o-", label=f"{pressure:g} MPa")
axes.set(xlabel="travel, mm", ylabel="force, N")
axes.legend();

# %% [markdown]
# `study.results(7)` are all results of the seventh sample. With `samples=24`, two values
# for each variable are a range in which 24 samples lie at random.
#
# ## Derivatives
#
# With the entries of `Sensitivities`, the program computes derivatives of results by
# numbers of the file in the same run. `derivatives()` has them by output and entry.

# %%
results = biface.run(TIRE, {
    **SETTINGS, "Stage 2/Steps": 1,
    "Sensitivities/Entries": "angle: Laminate/Plies[2], -Laminate/Plies[4], "
                             "Laminate/Plies[6], -Laminate/Plies[8]; Stage 2/Travel",
    "Sensitivities/Outputs": ["force", "footprint_length"]}, "output/derivatives")
for output, by_entry in results.derivatives().items():
    print(output, {entry: round(value, 3) for entry, value in by_entry.items()})

# %% [markdown]
# The samples of a sweep can have derivatives, too: here the stiffness at each point of the
# curve.

# %%
# The force against the travel, with the tangents that the program computes
study = biface.sweep(
    TIRE, {"Stage 2/Travel": [5, 10, 15, 20]}, ["force"],
    {**SETTINGS, "Stage 2/Steps": 1, "Sensitivities/Entries": "Stage 2/Travel",
     "Sensitivities/Outputs": "force"}, "output/tangents", ranks=2)
figure, axes = plt.subplots(figsize=(5, 3.2), layout="constrained")
axes.plot(study["Stage 2/Travel"], study["force"], "o")
for sample in study.rows():
    derivatives = study.results(sample["sample"]).derivatives()
    stiffness = derivatives["force"]["Stage 2/Travel"]
    aside = np.array([-2, 2])
    axes.plot(sample["Stage 2/Travel"] + aside, sample["force"] + stiffness * aside, "C1")
axes.set(xlabel="travel, mm", ylabel="force, N");

# %% [markdown]
# ## An optimization
#
# A tire shall carry 1900 N when it is pressed on by 20 mm. With which pressure and which
# cord angle is the largest tension of the cords least? A `Model` has results as functions
# of numbers of the file, with their gradients, as the optimizers of SciPy expect them;
# each point is run once.

# %%
from scipy.optimize import minimize

model = biface.Model(
    TIRE, ["pressure: Stage 1/Pressure, Stage 2/Pressure",
           "angle: Laminate/Plies[2], -Laminate/Plies[4], "
           "Laminate/Plies[6], -Laminate/Plies[8]"],
    ["force", "max_fiber_tension"],
    {**SETTINGS, "Stage 2/Steps": 1, "Newton/Residual tolerance": 1e-10},
    "output/model")

# the optimizer sees variables and results near 1
start = np.array([0.15, 52])
tension = model.value(start, "max_fiber_tension")
carries = {
    "type": "ineq",
    "fun": lambda x: model.value(x * start, "force") / 1900 - 1,
    "jac": lambda x: start * model.gradient(x * start, "force") / 1900}
found = minimize(
    lambda x: model.value(x * start, "max_fiber_tension") / tension, [1, 1],
    jac=lambda x: start * model.gradient(x * start, "max_fiber_tension") / tension,
    constraints=[carries], bounds=[(0.6, 1.4), (46 / 52, 58 / 52)], method="SLSQP",
    options={"ftol": 1e-5})

for name, point in (("start", start), ("found", found.x * start)):
    print(f"{name}: {point[0]:.4f} MPa, {point[1]:.2f} degrees, "
          f"{model.value(point, 'force'):.0f} N, "
          f"{model.value(point, 'max_fiber_tension'):.3f} N/mm")
print(len(model.runs), "runs")

# %% [markdown]
# The angle ends at its bound. `model.map(points, at_once=2)` runs several points, two at the
# same time, and returns their table; `progress=True` prints a line for each point.
# [python/designs.ipynb](python/designs.ipynb) is a notebook with both: thirty designs at
# random, the best one, and the way to a better one. [design.md](design.md) has a larger
# example. The remaining functions:
#
# - `biface.Results("output")` reads the results of any run, `biface.Study("study")` those
#   of a study, and `biface.run_study` runs a study file.
# - `biface.entries()` lists all entries of parameter files with their types, defaults,
#   units and documentation.
# - `biface.read_parameters` and `biface.write_parameters` read a parameter file and write
#   one with changes.
