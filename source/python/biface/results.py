# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of one run, read and checked.

The files of a step are complete once history.csv has its line, which is written
last. The last lines of history.csv and probes.csv may be cut off if the run was
stopped; they are left out then.
"""

from __future__ import annotations

import copy
import os
import re
from pathlib import Path

import numpy as np

from .errors import BifaceError
from .parameters import read_parameters
from .tables import Table, read_csv
from .vtu import read_vtu

HISTORY_COLUMNS = ("step", "stage", "approach", "force", "contact_nodes",
                   "contact_area", "max_pressure", "iterations", "seconds",
                   "pressure", "load_factor")
# a mesh from a file has no coordinates
CONTACT_COLUMNS = ("x", "y", "z", "clearance", "pressure",
                   "active")
PROFILE_COLUMNS = ("alpha_1", "alpha_2", "outer_x", "outer_y", "outer_z",
                   "inner_x", "inner_y", "inner_z", "pressure")
FORCE_COLUMNS = ("step", "stage", "body", "F_x", "F_y", "F_z", "M_x", "M_y",
                 "M_z")
PROBE_COLUMNS = ("step", "stage", "load_factor", "name", "face", "u_x", "u_y",
                 "u_z")
STIFFNESS_COLUMNS = ("step", "stage", "pressure", "force", "approach", "motion",
                     "amount", "direction_x", "direction_y", "direction_z",
                     "secant", "tangent", "secant_F_x", "secant_F_y", "secant_F_z")
MODE_COLUMNS = ("step", "mode", "stage", "frequency", "growth_rate",
                "effective_mass_x", "effective_mass_y", "effective_mass_z",
                "total_mass")
RESPONSE_COLUMNS = ("step", "stage", "excitation", "frequency", "output", "kind",
                    "x_real", "x_imaginary", "y_real", "y_imaginary", "z_real",
                    "z_imaginary")
BUCKLING_COLUMNS = ("step", "mode", "stage", "factor", "pressure", "load_factor",
                    "approach")
CRITICAL_COLUMNS = ("step", "stage", "kind", "located", "negative_pivots_before",
                    "negative_pivots", "factor", "pressure", "load_factor",
                    "approach")
ROLLING_COLUMNS = ("step", "stage", "angular_velocity", "ground_velocity",
                   "slip_angle", "F_x", "F_y", "F_z", "M_x", "M_y", "M_z",
                   "axle_moment")
TIRE_TEST_COLUMNS = ("point", "status", "axes", "load", "slip_ratio")
SENSITIVITY_COLUMNS = ("step", "stage", "entry", "entry_value", "output",
                       "output_value", "derivative", "logarithmic_derivative")
HYSTERESIS_COLUMNS = ("step", "stage", "ply", "material", "energy", "power")
HEAT_COLUMNS = ("alpha_1_begin", "alpha_1_end", "ply", "material", "source")
PLY_COLUMNS = ("name", "ply", "material", "fraction", "angle", "height",
               "fiber_tension", "s_L", "s_T", "t_LT")


class Results:
    """The results of a run, up to a step.

    Tables have the columns that doc/output.md describes, and None stands for a file
    that the run did not write. Other files are read when they are asked for.

    directory   where they are
    history     history.csv, a Table with a row for each step
    steps       the numbers of these steps
    step        the number of the last of them, and the step shown where none is chosen
    parameters  the entries of the run, a Parameters; None if the file is missing
    stopped     the message of a run that ended early, if run(may_stop=True) made it
    """

    def __init__(self, directory: str | os.PathLike, step: int | None = None):
        """Reads the history, up to the step or, by default, the last one. Raises
        BifaceError if there is none or if it is damaged."""
        self.directory = Path(directory)
        if not self.directory.is_dir():
            raise BifaceError(f"{directory} is not a directory.")
        path = self.directory / "history.csv"
        if not path.exists():
            raise BifaceError(f"{directory} holds no results of biface: there "
                              "is no history.csv in it.")
        self.history, self.is_cut = read_csv(path, HISTORY_COLUMNS, True)
        self._check_history(path)
        self.parameters = self._read_parameters()
        self.stopped = None
        self._choose(step)

    def __repr__(self):
        return (f"<Results in {self.directory}: {len(self.steps)} steps, stages "
                f"{', '.join(self.stages)}>")

    def _check_history(self, path):
        if len(self.history) == 0:
            raise BifaceError(f"{path} has no step: there is nothing to report "
                              "before the first one is done.")
        steps = self.history["step"]
        if (steps != np.round(steps)).any() or (np.diff(steps) <= 0).any():
            raise BifaceError(f"{path} is damaged: its steps are not in order.")

    def _read_parameters(self):
        path = self.directory / "parameters.prm"
        return read_parameters(path) if path.exists() else None

    def _choose(self, step):
        steps = self.history["step"].astype(int)
        self.last_step = steps[-1]
        self.step = steps[-1] if step is None else step
        if self.step not in steps:
            raise BifaceError(f"{self.directory / 'history.csv'} has no step "
                              f"{step}: it has the steps {steps[0]} to "
                              f"{steps[-1]}.")
        self.history = self.history.where(steps <= self.step)
        self.steps = self.history["step"].astype(int)

    @property
    def stages(self) -> list[str]:
        """The names of the stages, in order."""
        return list(dict.fromkeys(self.history["stage"]))

    def stage(self, name: str) -> Results:
        """The same results, with the steps of one stage only."""
        chosen = self.history["stage"] == name
        if not chosen.any():
            raise BifaceError(f"{self.directory} has no step of a stage '{name}': it "
                              f"has {', '.join(self.stages)}.")
        result = copy.copy(self)
        result.history = self.history.where(chosen)
        result.steps = self.steps[chosen]
        result.step = result.last_step = result.steps[-1]
        return result

    def last(self, column: str):
        """The value of a column of the history in the last step."""
        return self.history[column][-1]

    @property
    def support_motions(self) -> dict[str, tuple[str, str]]:
        """The supports that move, as history.csv names them, each with its columns of
        the displacement and the force along it, such as "alpha_1_max": ("alpha_1_max_displacement",
        "alpha_1_max_force"); for a rotation, of the angle and the moment."""
        found = {}
        for kinds in (("displacement", "force"), ("angle", "moment")):
            for column in self.history:
                name = column.removesuffix(f"_{kinds[0]}")
                columns = tuple(f"{name}_{kind}" for kind in kinds)
                if name != column and columns[1] in self.history:
                    found[name] = columns
        return found

    @property
    def in_contact(self) -> np.ndarray:
        """For each step, whether any node is in contact."""
        return self.history["contact_nodes"] > 0

    @property
    def is_contact(self) -> bool:
        """Whether the last step is in contact."""
        return bool(self.in_contact[-1])

    def path(self, kind: str, step: int | None = None, ending: str = "csv") -> Path:
        """The file of a kind, such as "shell", and a step."""
        return self.directory / f"{kind}-{int(step or self.step):04d}.{ending}"

    @property
    def has_coordinates(self) -> bool:
        """Whether the surface has coordinates; a mesh from a file has none."""
        return self.setting("Surface/Type") != "mesh"

    @property
    def has_points_in_cells(self) -> bool:
        """Whether points in the cells make contact instead of the nodes."""
        return self.setting("Contact/Points in cells", "0") != "0"

    def contact(self, step: int | None = None, body: str | None = None) \
            -> Table | None:
        """contact-NNNN.csv: the nodes in contact with the ground or a body, and
        those beside them."""
        kind, prefix = ("contact", "") if body is None else \
            (f"contact-{body.replace(' ', '_')}", f"{body.replace(' ', '_')}_")
        table = self._read_step(kind, CONTACT_COLUMNS, step)
        at = np.searchsorted(self.steps, step or self.step)
        expected = self.history[f"{prefix}contact_nodes"][at]
        if (table is not None and not self.has_points_in_cells
                and (table["active"] > 0).sum() != expected):
            raise BifaceError(
                f"{self.path(kind, step)} does not belong to history.csv, "
                f"which has {expected:.0f} nodes in contact in this step, but it has "
                f"{(table['active'] > 0).sum()}.")
        return table

    def profile(self, step: int | None = None) -> Table | None:
        """profile-NNNN.csv: the section along a meridian."""
        return self._read_step("profile", PROFILE_COLUMNS, step)

    def plies(self, step: int | None = None) -> Table | None:
        """plies-NNNN.csv: stresses in the plies at the named points."""
        return self._read_step("plies", PLY_COLUMNS, step)

    def heat(self, step: int | None = None) -> Table | None:
        """heat-NNNN.csv: sources of heat and temperatures of a rolling wheel."""
        return self._read_step("heat", HEAT_COLUMNS, step)

    def vtu(self, kind: str = "shell", step: int | None = None,
            mode: int | None = None) -> dict[str, np.ndarray] | None:
        """The arrays by name of a file for ParaView, with "Points" and
        "connectivity", four corners of a quadrilateral or eight of a hexahedron:
        kind "shell" or "plies", or, with the number of the mode, "modes" or
        "buckling"."""
        name = f"{kind}-{int(self._checked(step)):04d}"
        path = self.directory / f"{name if mode is None else f'{name}-{mode:03d}'}.vtu"
        return read_vtu(path) if path.exists() else None

    def _checked(self, step):
        """A step of the history."""
        if step is not None and step not in self.steps:
            raise BifaceError(f"{self.directory} has no step {step} here: it has the "
                              f"steps {self.steps[0]} to {self.steps[-1]}.")
        return step or self.step

    def _read_step(self, kind, columns, step):
        path = self.path(kind, self._checked(step))
        return read_csv(path, columns)[0] if path.exists() else None

    def _growing_table(self, name, columns):
        """The lines of a file that grows with the steps, up to the last step; None
        if it is missing."""
        path = self.directory / name
        if not path.exists():
            return None
        table, _ = read_csv(path, columns, True)
        return table.where(np.isin(table["step"], self.steps))

    def probes(self, face: str = "middle") -> Table | None:
        """probes.csv: the displacements of the named points, of one face, and in runs with
        inertia their velocities, NaN in other stages."""
        table = self._growing_table("probes.csv", PROBE_COLUMNS)
        return None if table is None else table.where(face=face)

    def forces(self) -> Table | None:
        """forces.csv: forces and moments on the shell, a row for each body."""
        return self._growing_table("forces.csv", FORCE_COLUMNS)

    def stiffness(self) -> Table | None:
        """stiffness.csv: stiffness against motions of the ground."""
        return self._growing_table("stiffness.csv", STIFFNESS_COLUMNS)

    def modes(self) -> Table | None:
        """modes.csv: natural frequencies."""
        return self._growing_table("modes.csv", MODE_COLUMNS)

    def response(self) -> Table | None:
        """response.csv: the steady response to excitations of amplitude 1 at the ends of
        stages, a row for each excitation, output and frequency.

        Its real and imaginary parts are here one complex column for each of x, y and z:
        amplitudes of exp(i omega t), displacements of the faces of named points, of the
        kind "inner" or "outer", and forces, of the kind "force", in units of length and
        force per unit of the excitation. NaN where the program found none."""
        table = self._growing_table("response.csv", RESPONSE_COLUMNS)
        if table is None:
            return None
        columns = dict(table)
        for i in "xyz":
            columns[i] = columns.pop(f"{i}_real") + 1j * columns.pop(f"{i}_imaginary")
        return Table(columns)

    def buckling(self) -> Table | None:
        """buckling.csv: predicted buckling loads."""
        return self._growing_table("buckling.csv", BUCKLING_COLUMNS)

    def critical_points(self) -> Table | None:
        """critical_points.csv: limit points and bifurcations."""
        return self._growing_table("critical_points.csv", CRITICAL_COLUMNS)

    def rolling(self) -> Table | None:
        """rolling.csv: forces, moments and powers of a rolling wheel."""
        return self._growing_table("rolling.csv", ROLLING_COLUMNS)

    def tire_test(self) -> Table | None:
        """tire_test.csv: the points of a tire test; NaN where one has failed."""
        path = self.directory / "tire_test.csv"
        return read_csv(path, TIRE_TEST_COLUMNS)[0] if path.exists() else None

    def hysteresis(self) -> Table | None:
        """hysteresis.csv: what the plies of a rolling wheel dissipate."""
        return self._growing_table("hysteresis.csv", HYSTERESIS_COLUMNS)

    def sensitivities(self) -> Table | None:
        """sensitivities.csv: derivatives of results by entries, as rows."""
        return self._growing_table("sensitivities.csv", SENSITIVITY_COLUMNS)

    def derivatives(self) -> dict[str, dict[str, float]]:
        """The derivative of each output by each entry, at the last step that has
        any: derivatives()["force"]["Stage 2/Travel"]. Empty without
        `Sensitivities/Entries`."""
        table = self.sensitivities()
        result: dict[str, dict[str, float]] = {}
        if table is not None and len(table) > 0:
            for row in table.where(step=table["step"][-1]).rows():
                result.setdefault(row["output"], {})[row["entry"]] = float(
                    row["derivative"])
        return result

    def setting(self, entry, otherwise=None):
        """The value of an entry of parameters.prm, as text."""
        found = self.parameters.entries.get(entry) if self.parameters else None
        return otherwise if found is None else found.value

    def numbers(self, entry, count):
        """The numbers of an entry of parameters.prm, separated by commas, or
        None where it has not as many finite ones."""
        words = re.split(r"[\s,]+", self.setting(entry, "").strip())
        try:
            values = np.array([float(word) for word in words])
        except ValueError:
            return None
        return values if len(values) == count and np.isfinite(values).all() \
            else None
