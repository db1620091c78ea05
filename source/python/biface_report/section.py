# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line along which the deformed section is drawn, and its plane."""

import matplotlib.figure
import numpy as np

from biface import Table, read_vtu

from .ground import axis_name

# Relative to the size of the shell, nodes closer than this are on one line
NEAR = 1e-5

# Points along each side of the rectangle in which a ground is looked for
TRACE_POINTS = 401


class SectionPlane:
    """The plane nearest to all points of some profiles, with a horizontal and an
    upward axis; the ground is below, if there is one."""

    def __init__(self, profiles, normal=None, across=None):
        """From the tables of profiles, the normal of the ground, and that of the
        plane, if they are known."""
        points = np.concatenate([profile.positions(f"{face}_")
                                 for profile in profiles
                                 for face in ("outer", "inner")])
        self.center = points.mean(0)
        _, _, axes = np.linalg.svd(points - self.center, full_matrices=False)
        self.across = cartesian_if_near(axes[2] if across is None else across)
        if normal is not None and abs(normal @ self.across) < 0.7:
            up = -(normal - (normal @ self.across) * self.across)
        else:
            up = self._upward(profiles[0])
        self.up = up / np.linalg.norm(up)
        right = np.cross(self.up, self.across)
        self.right = right * np.sign(right[np.argmax(np.abs(right))])

    def _upward(self, profile):
        """The Cartesian axis in the plane that is nearest to the direction from the
        inner face to the outer one."""
        outward = (profile.positions("outer_")
                   - profile.positions("inner_")).mean(0)
        candidates = np.eye(3) - np.outer(self.across, self.across)
        lengths = np.linalg.norm(candidates, axis=1)
        candidates = candidates[lengths > 0.5] / lengths[lengths > 0.5, None]
        up = candidates[np.argmax(np.abs(candidates @ outward))]
        return up if up @ outward > 0 else -up

    def project(self, points):
        """Horizontal and upward coordinates of points, as columns."""
        points = np.asarray(points)
        return np.stack([points @ self.right, points @ self.up], -1)

    def labels(self):
        """The names of the two axes, and whether the upward one is a negative
        Cartesian axis."""
        names = [axis_name(axis) for axis in (self.right, self.up)]
        return names, names[1] in ("x", "y", "z") and self.up.min() < -0.5

    def trace(self, ground, low, high):
        """Where a ground cuts this plane: polylines of projected points, in
        the rectangle between two projected points."""
        x, y = (np.linspace(low[i], high[i], TRACE_POINTS) for i in range(2))
        x, y = np.meshgrid(x, y)
        points = (np.multiply.outer(x, self.right) + np.multiply.outer(y, self.up)
                  + (self.center @ self.across) * self.across)
        clearance = ground.clearance(points.reshape(-1, 3)).reshape(x.shape)
        contour = matplotlib.figure.Figure().subplots().contour(
            x, y, clearance, levels=[0])
        return [line for line in contour.allsegs[0] if len(line) > 1]


def is_straight(run):
    """Whether the shell is straight along alpha_1, as a cylinder is: its section is
    around the axis."""
    ends = [run.numbers(f"Surface/Straight line/{end}", 2)
            for end in ("Start", "End")]
    if (run.setting("Surface/Type") != "surface of revolution"
            or run.setting("Surface/Meridian") != "straight line"
            or any(end is None for end in ends)):
        return False
    radial, axial = np.abs(ends[1] - ends[0])
    return axial > radial


def section_around(run, step):
    """The nodes around the axis in the middle of a shell that is_straight(), from
    shell-NNNN.vtu: a table as of a profile, with the undeformed 'y'; None if there
    are fewer than four."""
    data = read_vtu(run.path("shell", step, "vtu"))
    before = data["Points"] - data["displacement"]
    axial = before[:, 1]
    size = np.ptp(before, axis=0).max()
    middle = axial[np.argmin(np.abs(axial - (axial.min() + axial.max()) / 2))]
    on_line = np.abs(axial - middle) < NEAR * size
    is_outer = data["outer_face"] > 0.5
    outer, inner = (around_axis(before, data["Points"], on_line & face)
                    for face in (is_outer, ~is_outer))
    if len(outer) < 4 or len(outer) != len(inner):
        return None
    if run.setting("Mesh/Closed in alpha_2") == "true":
        outer, inner = (np.concatenate([face, face[:1]]) for face in (outer, inner))
    columns = {f"{name}_{axis}": face[:, i] for name, face in
               (("outer", outer), ("inner", inner)) for i, axis in enumerate("xyz")}
    return Table({"y": np.full(len(outer), middle), **columns})


def around_axis(before, points, chosen):
    """Points in the order of their angles before they moved, each angle once with the
    smallest radius, starting after the largest gap."""
    before, points = before[chosen], points[chosen]
    radius = np.hypot(before[:, 0], before[:, 2])
    angle = np.round(np.arctan2(before[:, 2], before[:, 0]), 6)
    order = np.lexsort((radius, angle))
    _, first = np.unique(angle[order], return_index=True)
    order = order[first]
    if len(order) < 2:
        return points[order]
    gaps = np.diff(angle[order], append=angle[order[0]] + 2 * np.pi)
    return points[np.roll(order, -1 - int(np.argmax(gaps)))]


def across_coordinate_line(surface, alpha_2):
    """The direction in which alpha_2 grows: around the y axis or, on the plane
    z = 0, along y."""
    if surface == "plane":
        return np.array([0, 1.0, 0])
    angle = np.radians(alpha_2)
    return np.array([-np.sin(angle), 0, np.cos(angle)])


def cartesian_if_near(axis):
    """The axis, or the Cartesian one if they hardly differ."""
    main = np.argmax(np.abs(axis))
    if abs(axis[main]) > 0.999:
        return np.eye(3)[main]
    return axis
