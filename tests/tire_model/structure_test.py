# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results with known stiffnesses and modes, for tests of what becomes of them."""

import math

from tire_model_test import neutral_formula, require, scratch

require("scipy")

import numpy as np
from biface_tire_model.channels import OUTPUTS
from biface_tire_model.fitting import Fit
from biface_tire_model.magic_formula import FORMULAS
from biface_tire_model.structural import Structural
from biface_tire_model.structure import read_structure
from biface_tire_model.table import Measurements
from biface_tire_model.units import System

HISTORY = ("step", "stage", "approach", "force", "contact_nodes", "contact_area",
           "max_pressure", "iterations", "seconds", "pressure", "load_factor",
           "footprint_length", "footprint_width", "footprint_area", "loaded_radius")
STIFFNESS = ("step", "stage", "pressure", "force", "approach", "motion", "amount",
             "direction_x", "direction_y", "direction_z", "secant", "tangent", "secant_F_x",
             "secant_F_y", "secant_F_z")
MODES = ("step", "mode", "stage", "frequency", "growth_rate", "effective_mass_x",
         "effective_mass_y", "effective_mass_z", "total_mass", "circumferential_waves",
         "meridional_half_waves", "travel")
DIRECTIONS = {"approach": (-1, 0, 0), "lateral": (0, 1, 0), "longitudinal": (0, 0, 1),
              "turn": (1, 0, 0)}
MASS = 8.0


class Run:
    """A directory with results. Everything is given in SI units, and written in those
    of the run."""

    def __init__(self, units="mm, N, s", settings=None):
        self.path, self.system = scratch(), System(units or "mm, N, s")
        self.settings = {"Units": units, "Contact/Friction": "0", **(settings or {})}
        self.history, self.stiffness, self.modes, self.stages = [], [], [], []

    def step(self, stage, pressure, load=0, approach=0, radius=0):
        """A step; returns its number."""
        if stage not in self.stages:
            self.stages.append(stage)
        size = self.system
        self.history.append((
            len(self.history) + 1, stage, approach / size["length"], load / size["force"],
            9 * (load > 0), 0, 0, 1, 1, pressure / size["pressure"], 1,
            0.2 * approach / size["length"], 0.1 * approach / size["length"],
            0.01 * approach / size["length"] ** 2, radius / size["length"]))
        return len(self.history)

    def row(self, motion, stage, pressure, load, amount, secant, tangent, **step):
        """A row of stiffness.csv; the amount of a turn is in degrees."""
        length, force = self.system["length"], self.system["force"]
        kind = {"approach": "approach", "turn": "turn"}.get(motion, "slide")
        unit = force * length * 180 / math.pi if kind == "turn" else force / length
        self.stiffness.append((
            self.step(stage, pressure, **{"load": load, "approach": 0.01, **step}), stage,
            pressure / self.system["pressure"], load / force, 0, kind,
            amount if kind == "turn" else amount / length, *DIRECTIONS[motion],
            secant / unit, tangent / unit, 0, 0, 0))

    def press(self, stage, pressure, loads, deflection):
        """The ground approaches under loads; @p deflection is a function of them."""
        last = 0
        for load in loads:
            depth, before = deflection(load), deflection(last)
            self.row("approach", stage, pressure, 0, depth, load / depth,
                     (load - last) / (depth - before))
            self.history[-1] = self.history[-1][:2]
            self.history.pop()
            self.step(stage, pressure, load, depth, 0.3 - depth)
            last = load

    def move(self, motion, load, pressure, stiffness, grip="glued"):
        """Two steps of a stage in which the ground moves; the second one is softer."""
        stage = f"{motion} {len(self.stages) + 1} {grip}"
        for steps, secant in ((1, stiffness), (2, 0.9 * stiffness)):
            self.row(motion, stage, pressure, load, steps * (0.1 if motion == "turn" else
                                                             1e-4), secant, 0.8 * secant)
        number = len(self.stages)
        self.settings[f"Stage {number}/Glued"] = "true" if grip == "glued" else "false"
        self.settings[f"Stage {number}/Friction"] = {"friction": "0.8"}.get(grip, "")

    def vibrate(self, stage, pressure, rows, load=0):
        """Modes: rows of frequency, waves, half waves and the parts of the mass along x,
        y and z, and perhaps growth rate and travel."""
        step = self.step(stage, pressure, load, approach=0.01 * (load > 0))
        for number, row in enumerate(rows, 1):
            frequency, waves, half_waves, *rest = row
            masses, (growth, travel) = rest[:3], rest[3:] or (0, 0)
            self.modes.append((step, number, stage, frequency * self.system["time"], growth,
                               *(MASS * part for part in masses), MASS, waves, half_waves,
                               travel))
        return step

    def shape(self, step, mode, motion):
        """The file of the shape of a mode; @p motion gives it for points on a belt of
        radius 1 and width 0.4, as rows."""
        angles, n = np.linspace(0, 2 * np.pi, 49)[:-1], 5
        across = np.linspace(-0.2, 0.2, n)
        points = np.array([(np.cos(a), y, np.sin(a)) for a in angles for y in across])
        cells = [(i * n + j, i * n + j + 1, (i + 1) % 48 * n + j + 1, (i + 1) % 48 * n + j)
                 for i in range(48) for j in range(n - 1)]

        def array(name, values, kind, count):
            numbers = " ".join(repr(value) for value in np.ravel(values).tolist())
            return (f'<DataArray type="{kind}" Name="{name}" format="ascii" '
                    f'NumberOfComponents="{count}">{numbers}</DataArray>')

        (self.path / f"modes-{step:04d}-{mode:03d}.vtu").write_text(
            '<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece>'
            + array("Points", points, "Float64", 3)
            + array("connectivity", cells, "Int32", 1)
            + array("mode", motion(points), "Float64", 3)
            + "</Piece></UnstructuredGrid></VTKFile>\n", encoding="utf-8")

    def write(self):
        """Writes the files; returns the directory."""
        for name, columns, rows in (("history", HISTORY, self.history),
                                    ("stiffness", STIFFNESS, self.stiffness),
                                    ("modes", MODES, self.modes)):
            if rows or name == "history":
                (self.path / f"{name}.csv").write_text("".join(
                    ",".join(map(str, row)) + "\n" for row in (columns, *rows)),
                    encoding="utf-8")
        lines = [f"set Number of stages = {len(self.stages)}"]
        settings = {**self.settings, **{f"Stage {number}/Name": name for number, name in
                                        enumerate(self.stages, 1)}}
        for entry, value in settings.items():
            *sections, name = entry.split("/")
            lines += [f"subsection {section}" for section in sections]
            lines += [f"set {name} = {value or ''}"] + ["end"] * len(sections)
        (self.path / "parameters.prm").write_text("\n".join(lines) + "\n",
                                                  encoding="utf-8")
        return self.path


def made_fit(version="6.1", loads=(2000, 6000), pressures=(1.8e5, 2.2e5), reasons=None,
             **coefficients):
    """A Fit without a table, whose data have the given loads and pressures."""
    formula = neutral_formula(FORMULAS[version], **coefficients)
    grid = np.meshgrid(loads, pressures)
    data = Measurements({"F_z": grid[0].ravel(), "pressure": grid[1].ravel(),
                         "slip_angle": np.zeros(grid[0].size),
                         **{name: np.zeros(grid[0].size) for name in OUTPUTS}})
    return Fit(formula, reasons or {}, [], data)


def structural(*runs, fit=None, vertical=True, units=None):
    """The Structural of runs."""
    return Structural(read_structure([run.write() for run in runs], units),
                      fit or made_fit(), vertical)


def values(result):
    """The known values by name."""
    return {entry.name: entry.value for entry in result.known}
