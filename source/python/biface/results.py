# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of one run, read and checked.

The files of a step are complete once history.csv has its line, which is written
last. The last lines of history.csv and probes.csv may be cut off if the run was
stopped; they are left out then.
"""

import re
from pathlib import Path

import numpy as np

from .errors import BifaceError
from .parameters import read_parameters
from .tables import read_csv, read_text

HISTORY_COLUMNS = ("step", "stage", "approach", "force", "contact_nodes",
                   "contact_area", "max_pressure", "iterations", "seconds",
                   "pressure", "load_factor")
CONTACT_COLUMNS = ("alpha_1", "alpha_2", "x", "y", "z", "clearance", "pressure",
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
BUCKLING_COLUMNS = ("step", "mode", "stage", "factor", "pressure", "load_factor",
                    "approach")
CRITICAL_COLUMNS = ("step", "stage", "kind", "located", "negative_pivots_before",
                    "negative_pivots", "factor", "pressure", "load_factor",
                    "approach")
ROLLING_COLUMNS = ("step", "stage", "angular_velocity", "ground_velocity",
                   "slip_angle", "F_x", "F_y", "F_z", "M_x", "M_y", "M_z",
                   "axle_moment")
SENSITIVITY_COLUMNS = ("step", "stage", "entry", "entry_value", "output",
                       "output_value", "derivative", "logarithmic_derivative")
PLY_COLUMNS = ("name", "ply", "material", "fraction", "angle", "height",
               "fiber_tension", "s_L", "s_T", "t_LT")


class Results:
    """A directory of results, up to a step."""

    def __init__(self, directory, step=None):
        """Reads the history, up to the step or, by default, the last one."""
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
        self._choose(step)

    def _check_history(self, path):
        if len(self.history) == 0:
            raise BifaceError(f"{path} has no step: there is nothing to report "
                              "before the first one is done.")
        steps = self.history["step"]
        if (steps != np.round(steps)).any() or (np.diff(steps) <= 0).any():
            raise BifaceError(f"{path} is damaged: its steps are not in order.")

    def _read_parameters(self):
        path = self.directory / "parameters.prm"
        return read_parameters(read_text(path)) if path.exists() else None

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

    def last(self, column):
        """The value of a column of the history in the step of the report."""
        return self.history[column][-1]

    @property
    def in_contact(self):
        """For each step, whether any node is in contact."""
        return self.history["contact_nodes"] > 0

    @property
    def is_contact(self):
        """Whether the step of the report is in contact."""
        return bool(self.in_contact[-1])

    def path(self, kind, step=None, ending="csv"):
        """The file of a kind and step."""
        return self.directory / f"{kind}-{step or self.step:04d}.{ending}"

    @property
    def has_points_in_cells(self):
        """Whether points in the cells make contact instead of the nodes."""
        return self.setting("Contact/Points in cells", "0") != "0"

    def contact(self, step=None):
        """contact-NNNN.csv, or None if it is missing."""
        table = self._read_step("contact", CONTACT_COLUMNS, step)
        at = np.searchsorted(self.steps, step or self.step)
        expected = int(self.history["contact_nodes"][at])
        if (table is not None and not self.has_points_in_cells
                and (table["active"] > 0).sum() != expected):
            raise BifaceError(
                f"{self.path('contact', step)} does not belong to history.csv, "
                f"which has {expected} nodes in contact in this step, but it has "
                f"{(table['active'] > 0).sum()}.")
        return table

    def profile(self, step=None):
        """profile-NNNN.csv, or None if it is missing."""
        return self._read_step("profile", PROFILE_COLUMNS, step)

    def plies(self):
        """plies-NNNN.csv, or None if it is missing."""
        return self._read_step("plies", PLY_COLUMNS, None)

    def _read_step(self, kind, columns, step):
        path = self.path(kind, step)
        return read_csv(path, columns)[0] if path.exists() else None

    def _growing_table(self, name, columns):
        """The lines of a file that grows with the steps, up to the step of the
        report; None if it is missing."""
        path = self.directory / name
        if not path.exists():
            return None
        table, _ = read_csv(path, columns, True)
        return table.where(np.isin(table["step"], self.steps))

    def probes(self):
        """The lines of probes.csv for the middle surface, up to the step of the
        report; None if it is missing."""
        table = self._growing_table("probes.csv", PROBE_COLUMNS)
        return (None if table is None else
                table.where(table["face"] == "middle"))

    def forces(self):
        """forces.csv up to the step of the report; None if it is missing."""
        return self._growing_table("forces.csv", FORCE_COLUMNS)

    def stiffness(self):
        """stiffness.csv up to the step of the report; None if it is missing."""
        return self._growing_table("stiffness.csv", STIFFNESS_COLUMNS)

    def modes(self):
        """modes.csv up to the step of the report; None if it is missing."""
        return self._growing_table("modes.csv", MODE_COLUMNS)

    def buckling(self):
        """buckling.csv up to the step of the report; None if it is missing."""
        return self._growing_table("buckling.csv", BUCKLING_COLUMNS)

    def critical_points(self):
        """critical_points.csv up to the step of the report; None if it is
        missing."""
        return self._growing_table("critical_points.csv", CRITICAL_COLUMNS)

    def rolling(self):
        """rolling.csv up to the step of the report; None if it is missing."""
        return self._growing_table("rolling.csv", ROLLING_COLUMNS)

    def sensitivities(self):
        """sensitivities.csv up to the step of the report; None if it is
        missing."""
        return self._growing_table("sensitivities.csv", SENSITIVITY_COLUMNS)

    def setting(self, entry, otherwise=None):
        """The value of an entry of parameters.prm, as text."""
        found = self.parameters.find(entry) if self.parameters else None
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
