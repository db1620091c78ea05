# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forces and moments of the ground on a wheel, in the axes of ISO 8855, and where
its footprint sticks and slips."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np

from .drawing import BLUE, GRAY, RED, embed
from .footprint import Footprint
from .ground import axis_name, ground_in_step, ground_of, unit
from .loading import TESTED
from .page import LeftOut, Section, figure, number, paragraph, table
from .units import units_of

# The axle of a surface of revolution
AXLE = np.array([0.0, 1.0, 0.0])

# Ground closer to the axle than this does not carry a wheel: the sine of the
# angle between its plane and the axle
LYING = 0.9

# Steps towards the contact center along the middle plane of the wheel
SEARCHES = 200


class WheelAxes:
    """The axes of ISO 8855 at the contact center: x forward, y to the left, z up
    from the ground, as the rows of a matrix."""

    def __init__(self, direction):
        """From the direction toward the ground."""
        self.direction = unit(direction)
        up = -self.direction
        left = unit(AXLE - (AXLE @ up) * up)
        self.axes = np.array([np.cross(left, up), left, up])

    def contact_center(self, ground):
        """Where the line from the center of the wheel down in its middle plane, the
        plane of symmetry across the axle, meets the ground."""
        down = unit(self.direction - (self.direction @ AXLE) * AXLE)
        point = np.zeros(3)
        for _ in range(SEARCHES):
            point = point + ground.clearance(point) * down
        return point

    def resultant(self, force, moment, center, point):
        """Force and moment about a point, in these axes, from those about a
        center."""
        about_point = moment - np.cross(point - center, force)
        return self.axes @ force, self.axes @ about_point


def is_wheel(run):
    """Whether the shell goes all the way around the y axis, is no tube along it, and
    the ground, if any, is across it."""
    direction = run.numbers("Contact/Direction", 3)
    return (run.setting("Surface/Type") == "surface of revolution"
            and run.setting("Mesh/Closed in alpha_2") == "true"
            and not is_tube(run)
            and direction is not None and np.any(direction)
            and abs(unit(direction) @ AXLE) < LYING)


def is_tube(run):
    """Whether the shell is a cylinder or cone that is longer than its diameter."""
    ends = [run.numbers(f"Surface/Straight line/{end}", 2)
            for end in ("Start", "End")]
    if (run.setting("Surface/Meridian") != "straight line"
            or any(end is None for end in ends)):
        return False
    (radius_1, axial_1), (radius_2, axial_2) = ends
    return abs(axial_2 - axial_1) > 2 * max(radius_1, radius_2)


def wheel_axes(run):
    """The axes of a run, or None if it is no wheel on the ground."""
    ground = ground_of(run)
    return (None if ground is None or not is_wheel(run)
            else WheelAxes(ground.direction))


def wheel_forces(run):
    """The table of forces and moments in all steps in contact; None without contact,
    or if the shell is no wheel."""
    name = "Forces in wheel axes"
    axes = wheel_axes(run)
    if axes is None or not run.in_contact.any():
        return None
    if leans(run):
        return LeftOut(name, "The wheel leans over the ground in some stage, where the "
                             "axes are others; rolling.csv has the forces of a rolling one.")
    center = run.numbers("Output/Moment center", 3)
    forces = run.forces()
    if forces is None or center is None:
        return LeftOut(name, "forces.csv is missing.")
    rows, units = [], units_of(run)
    for i, step in enumerate(run.steps):
        if run.history["stage"][i].startswith(TESTED):
            continue
        ground = (ground_in_step(run, step) if run.in_contact[i] else None)
        here = forces.where((forces["step"] == step)
                            & (forces["body"] == "foundation"))
        if ground is None or len(here) == 0:
            continue
        point = axes.contact_center(ground)
        force, moment = axes.resultant(here.positions("F_")[0],
                                       here.positions("M_")[0],
                                       np.array(center), point)
        size, length = np.linalg.norm(force), np.linalg.norm(point)
        rows.append([f"Step {step}", escape(run.history["stage"][i])]
                    + [number(value, scale=size) for value in force]
                    + [number(value, scale=size * length) for value in moment]
                    + [number(length)])
    if not rows:
        return LeftOut(name, "Only the tire test has contact." if run.tire_test() is not None else
                       "The files of the contact zone are missing.")
    forward, left, up = axes.axes
    text = paragraph(
        "The force of the ground on the wheel and its moment about the contact "
        "center, in the axes of ISO 8855: x forward "
        f"({in_words(forward)}), y to the left, along the axle "
        f"({in_words(left)}), z up from the ground ({in_words(up)}). F<sub>x</sub> is "
        "the longitudinal, F<sub>y</sub> the lateral and F<sub>z</sub> the vertical "
        "force, M<sub>x</sub> the overturning, M<sub>y</sub> the rolling and "
        "M<sub>z</sub> the aligning moment, right-handed. The contact center is "
        "below the center of the wheel, in its middle plane y = 0; their distance "
        "is the loaded radius.")
    heads = ["", "Stage"] + [f"{letter}<sub>{axis}</sub>" for letter in "FM"
                                 for axis in "xyz"] + ["Loaded radius"]
    return Section("wheel", name, table(
        f"Forces and moments on the wheel [{units['force']}, {units['moment']}]",
        heads, rows)
        + text, True)


def leans(run):
    """Whether a stage of the parameter file gives the wheel an inclination angle."""
    number = 1
    while (value := run.setting(f"Stage {number}/Inclination angle")) is not None:
        if value != "unchanged" and float(value) != 0:
            return True
        number += 1
    return False


def in_words(axis):
    """A direction: plus or minus one of the axes of the input, if it is along one."""
    name = axis_name(axis)
    if len(name) > 1:
        return name
    return ("−" if axis["xyz".index(name)] < 0 else "+") + name + " of the input"


def stick_slip(run, footprint):
    """The picture of nodes that stick and slip, with the tractions of friction."""
    name = "Stick and slip"
    contact = run.contact() if footprint is not None else None
    columns = ["slipping"] + [f"friction_{i}" for i in "xyz"]
    if contact is None or any(column not in contact for column in columns):
        return None
    active = contact["active"] > 0
    tractions = contact.positions("friction_")[active]
    if not np.any(tractions):
        return None
    slips = contact["slipping"][active] > 0
    html = figure(
        embed(draw_stick_slip(footprint, slips, tractions, units_of(run))),
        f"Map of the contact zone: {int(slips.sum())} of {len(slips)} nodes slip.",
        f"Nodes in contact: {int((~slips).sum())} stick, {int(slips.sum())} slip at "
        "the limit of friction. Arrows: the traction of friction on the shell.")
    return Section("friction", name, html)


def draw_stick_slip(footprint: Footprint, slips, tractions, units):
    """The figure; the longer side of the zone is horizontal."""
    nodes = footprint.nodes[footprint.active]
    order = [0, 1] if np.ptp(nodes[:, 0]) >= np.ptp(nodes[:, 1]) else [1, 0]
    nodes = nodes[:, order]
    arrows = (tractions @ footprint.axes.T)[:, order]
    drawing, axes = plt.subplots(figsize=(5.6, 4.2))
    for chosen, color, label in ((~slips, BLUE, "sticks"), (slips, RED, "slips")):
        axes.plot(*nodes[chosen].T, "o", color=color, markersize=3, label=label)
    longest = np.linalg.norm(arrows, axis=1).max()
    if longest > 0:
        length = 0.08 * np.ptp(nodes, axis=0).max() or 1
        axes.quiver(*nodes.T, *arrows.T, color=GRAY, angles="xy",
                    scale_units="xy", scale=longest / length, width=0.004)
    axes.set_aspect("equal")
    axes.margins(0.08)
    names = [footprint.axis_names[i] for i in order]
    axes.set(xlabel=units.label(names[0], "length"),
             ylabel=units.label(names[1], "length"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=2)
    return drawing
