# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the first shapes of a series, modes of vibration or of buckling, and
the view of all."""

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from biface.vtu import corners, read_vtu

from . import view
from .drawing import embed
from .page import figure

# Pictures, and the largest displacement in them relative to the shell
N_PICTURES = 6
AMPLITUDE = 0.12
# Where the pictures are seen from, in degrees
ELEVATION, AZIMUTH = 28, -62


def pictures_of(run, series, found, values, alternative, caption):
    """Pictures of the first shapes of a stage, from SERIES-NNNN-MMM.vtu; None if
    these files are missing.

    found: the rows of the shapes of a stage; values: what is written above each
    picture, after the number of the shape."""
    step = int(found["step"][0])
    numbers = found["mode"][:N_PICTURES].astype(int)
    paths = [run.directory / f"{series}-{step:04d}-{i:03d}.vtu" for i in numbers]
    if run.setting("Output/Write VTU") == "false" or not all(
            path.exists() for path in paths):
        return None
    columns = min(3, len(paths))
    lines = -(-len(paths) // columns)
    picture = plt.figure(figsize=(3 * columns, 2.6 * lines))
    for i, path in enumerate(paths):
        axes = picture.add_subplot(lines, columns, i + 1, projection="3d")
        draw_shape(axes, path)
        axes.set_title(f"{numbers[i]}: {values[i]}", fontsize=12, y=1.0)
    picture.subplots_adjust(0, 0, 1, 0.92, 0.02, 0.12)
    return figure(
        embed(picture, "png"), alternative,
        f"{caption}, the displacements enlarged; color: displacement of the outer "
        "face along its normal.") + "\n" + view.shapes(
            run, series, found, values, view_axes(ELEVATION, AZIMUTH)[2], (0, 0, 1))


def draw_shape(axes, path):
    """The outer face, moved and colored by the shape."""
    data = read_vtu(path)
    cells = corners(data)
    cells = cells[data["outer_face"][cells[:, 0]] > 0.5]
    points, shape = data["Points"], data["mode"]
    size = np.ptp(points, axis=0).max()
    faces = (points + AMPLITUDE * size * shape)[cells]
    normals = np.cross(points[cells[:, 2]] - points[cells[:, 0]],
                       points[cells[:, 3]] - points[cells[:, 1]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    along = (shape[cells].mean(1) * normals).sum(1)
    # a shape without motion along the normal is white, not the color of round-off
    limit = max(np.abs(along).max(), 1e-6 * np.abs(shape).max())
    axes.add_collection3d(Poly3DCollection(
        faces, facecolors=plt.get_cmap("RdBu_r")(0.5 + along / (2 * limit)),
        edgecolors=(0, 0, 0, 0.15), linewidths=0.2))
    # y, the axis of wheels, points away from the reader's right
    view = view_axes(ELEVATION, AZIMUTH)
    seen = faces.reshape(-1, 3) @ view.T
    middle = (seen.max(0) + seen.min(0)) / 2 @ view
    reach = 0.36 * np.ptp(seen[:, :2], axis=0).max()
    for set_limits, center in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim),
                                  middle):
        set_limits(center - reach, center + reach)
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    axes.set_axis_off()


def view_axes(elevation, azimuth):
    """The directions to the right, up and toward the reader, as the rows of a
    matrix; angles in degrees."""
    e, a = np.radians([elevation, azimuth])
    return np.array([[-np.sin(a), np.cos(a), 0],
                     [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)],
                     [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]])
