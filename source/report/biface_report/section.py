# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane that the deformed section is drawn in."""

import numpy as np


def points_of(profile, face):
    """The points of a face of profile-NNNN.csv."""
    return np.stack([profile[f"{face}_{i}"] for i in "xyz"], -1)


class SectionPlane:
    """The plane nearest to all points of some profiles, with a horizontal and
    an upward axis: the foundation is below, if there is one."""

    def __init__(self, profiles, normal=None, surface=None):
        """From the tables of profiles, the normal of the foundation, and the
        entry Surface/Type, if they are known."""
        points = np.concatenate([points_of(profile, face)
                                 for profile in profiles
                                 for face in ("outer", "inner")])
        self.center = points.mean(0)
        _, _, axes = np.linalg.svd(points - self.center, full_matrices=False)
        self.across = cartesian_if_near(
            axes[2] if surface is None else
            across_coordinate_line(surface, profiles[0]["alpha_2"][0]))
        if normal is not None and abs(normal @ self.across) < 0.7:
            up = -(normal - (normal @ self.across) * self.across)
        else:
            up = self._upward(profiles[0])
        self.up = up / np.linalg.norm(up)
        right = np.cross(self.up, self.across)
        self.right = right * np.sign(right[np.argmax(np.abs(right))])

    def _upward(self, profile):
        """Of the Cartesian axes in the plane the one that is nearest to the way
        from the inner face to the outer one."""
        outward = (points_of(profile, "outer") - points_of(profile, "inner")).mean(0)
        candidates = np.eye(3) - np.outer(self.across, self.across)
        lengths = np.linalg.norm(candidates, axis=1)
        candidates = candidates[lengths > 0.5] / lengths[lengths > 0.5, None]
        up = candidates[np.argmax(np.abs(candidates @ outward))]
        return up if up @ outward > 0 else -up

    def project(self, points):
        """Horizontal and upward coordinate of points, as columns."""
        points = np.asarray(points)
        return np.stack([points @ self.right, points @ self.up], -1)

    def labels(self):
        """What to call the two axes, and whether upward counts downward."""
        names, is_down = [], False
        for axis in (self.right, self.up):
            main = np.argmax(np.abs(axis))
            if np.isclose(abs(axis[main]), 1, atol=1e-9):
                names.append("xyz"[main])
                is_down = axis[main] < 0
            else:
                names.append("along ({:.3g}, {:.3g}, {:.3g})".format(*axis))
        return names, is_down

    def foundation(self, normal, distance):
        """A point of the line in which a plane, the points whose product with
        the normal is the distance, cuts this one, and the line's direction; None
        where they are nearly parallel."""
        in_plane = normal - (normal @ self.across) * self.across
        if np.linalg.norm(in_plane) < 0.1:
            return None
        point = self.center + in_plane * (
            (distance - normal @ self.center) / (in_plane @ in_plane))
        return self.project(point), self.project(np.cross(self.across, in_plane))


def across_coordinate_line(surface, alpha_2):
    """The direction in which alpha_2 grows: around the y axis or, on the plane
    z = 0, along y."""
    if surface == "plane":
        return np.array([0, 1.0, 0])
    angle = np.radians(alpha_2)
    return np.array([-np.sin(angle), 0, np.cos(angle)])


def cartesian_if_near(axis):
    """The axis, or the Cartesian one that it hardly differs from."""
    main = np.argmax(np.abs(axis))
    if abs(axis[main]) > 0.999:
        return np.eye(3)[main]
    return axis
