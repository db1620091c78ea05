# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rigid ground: a plane, a drum or a sphere, where it stands in a step."""

import numpy as np

# Intervals along each side of a patch
PATCH_CELLS = 48


class Ground:
    """The shape, its direction, and how far it has traveled against it.

    shape is 'plane', 'drum' or 'sphere'. A negative radius is that of a hollow
    drum or sphere. At the travel 0 the ground touches the point, and the
    direction is its normal there, or nearest to it for an oblique drum."""

    def __init__(self, shape, direction, point=(0, 0, 0), radius=1.0,
                 axis=(0, 1, 0), travel=0.0):
        self.shape = shape
        self.direction = unit(direction)
        self.point = np.array(point, dtype=float)
        self.radius = radius
        self.axis = unit(axis)
        self.travel = travel

    def name(self):
        """What to call it."""
        hollow = "hollow " if self.shape != "plane" and self.radius < 0 else ""
        return hollow + self.shape

    def at_clearances(self, points, clearances):
        """The same ground with the travel that gives points, one a row,
        their clearances."""
        ahead = (self.point - points) @ self.direction - clearances
        if self.shape != "plane":
            # |a + t b| = |R + c|: the root on the side of the shell
            a = self._across(points - self.point) - self.radius * self._normal()
            b = self._across(self.direction)
            half = a @ b / (b @ b)
            rest = half**2 - ((a * a).sum(-1)
                              - (self.radius + clearances)**2) / (b @ b)
            ahead = -half - np.sign(self.radius) * np.sqrt(np.maximum(rest, 0))
        return Ground(self.shape, self.direction, self.point, self.radius,
                      self.axis, float(np.median(ahead)))

    def clearance(self, points):
        """The distance of points, one a row, from the surface: negative within
        the ground."""
        if self.shape == "plane":
            return (self._nearest() - points) @ self.direction
        distance = np.linalg.norm(self._across(self._center() - points), axis=-1)
        return np.sign(self.radius) * distance - self.radius

    def patch_axes(self):
        """Two unit vectors, across the normal, along which patches reach."""
        if self.shape == "drum":
            return np.array([np.cross(self.axis, self._normal()), self.axis])
        return plane_axes(self.direction)[0]

    def patch(self, low, high):
        """A part of the surface: a grid of points, of the shape n x m x 3.

        low and high are corners of a rectangle in the plane that touches the
        ground, products of points with the patch_axes(). It is wrapped round
        the ground, at most once: lengths along its middle lines are kept."""
        first, second = self.patch_axes()
        reach = {"plane": np.inf, "drum": np.pi * abs(self.radius) * np.array(
            [1, np.inf]), "sphere": np.pi * abs(self.radius)}[self.shape]
        middle = self.patch_axes() @ self._nearest()
        low, high = np.maximum(low, middle - reach), np.minimum(high, middle + reach)
        u, v = np.meshgrid(*(np.linspace(low[i], high[i], PATCH_CELLS + 1)
                             for i in range(2)), indexing="ij")
        nearest, normal = self._nearest(), self._normal()
        u, v = (u - nearest @ first)[..., None], (v - nearest @ second)[..., None]
        if self.shape == "plane":
            return nearest + u * first + v * second
        if self.shape == "drum":
            flat, along = u * first, v * second
        else:
            flat, along = u * first + v * second, 0
        length = np.maximum(np.linalg.norm(flat, axis=-1, keepdims=True), 1e-300)
        size = abs(self.radius)
        angle = np.minimum(length / size, np.pi)
        return (self._center() + along - self.radius * np.cos(angle) * normal
                + size * np.sin(angle) * flat / length)

    def _across(self, vectors):
        """The part of vectors that the distance depends on."""
        if self.shape == "drum":
            return vectors - np.multiply.outer(vectors @ self.axis, self.axis)
        return vectors

    def _normal(self):
        """The normal at the point of the surface that meets the shell first."""
        return unit(self._across(self.direction))

    def _nearest(self):
        """That point."""
        return self.point - self.travel * self.direction

    def _center(self):
        """The center of a sphere, a point of the axis of a drum."""
        return self._nearest() + self.radius * self._normal()


def unit(vector):
    """A vector scaled to length 1."""
    return np.array(vector, dtype=float) / np.linalg.norm(vector)


def ground_of(run):
    """The ground of a run before it travels, or None where parameters.prm
    does not tell."""
    direction = run.numbers("Contact/Direction", 3)
    point = run.numbers("Contact/Point on path", 3)
    shape = run.setting("Contact/Foundation", "plane")
    if direction is None or point is None or not np.any(direction):
        return None
    if shape == "plane":
        return Ground(shape, direction, point)
    radius = run.numbers(f"Contact/{shape.capitalize()}/Radius", 1)
    if shape == "sphere" and radius is not None:
        return Ground(shape, direction, point, radius[0])
    axis = run.numbers("Contact/Drum/Axis", 3)
    if shape == "drum" and radius is not None and axis is not None:
        return Ground(shape, direction, point, radius[0], axis)
    return None


def ground_in_step(run, step=None):
    """The ground where it stands in a step, or None where that is unknown:
    the clearances of the nodes near it tell."""
    ground = ground_of(run)
    contact = run.contact(step) if ground else None
    if contact is None or len(contact) == 0:
        return None
    return ground.at_clearances(contact.positions(), contact["clearance"])


def plane_axes(normal):
    """Two unit vectors in a plane, and what to call them."""
    direction = np.argmax(np.abs(normal))
    others = [i for i in range(3) if i != direction]
    first = np.eye(3)[others[0]]
    first = unit(first - (first @ normal) * normal)
    second = np.cross(normal, first)
    if second[others[1]] < 0:
        second = -second
    return np.array([first, second]), [axis_name(axis)
                                       for axis in (first, second)]


def axis_name(axis):
    """What to call a direction: by its Cartesian axis if it is along one."""
    main = np.argmax(np.abs(axis))
    if np.isclose(abs(axis[main]), 1, atol=1e-9):
        return "xyz"[main]
    return "along ({:.3g}, {:.3g}, {:.3g})".format(*axis)
