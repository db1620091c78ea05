# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modes of vibration: their table, and pictures of the first ones."""

from html import escape

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from .drawing import embed
from .page import (LeftOut, Section, details, figure, number, paragraph,
                   plain_number, table)
from .vtu import corners, read_vtu

# Pictures, and the largest displacement in them relative to the shell
N_PICTURES = 6
AMPLITUDE = 0.12


def modes(run):
    """The table of modes.csv, and pictures of the last stage in it."""
    name = "Modes of vibration"
    found = run.modes()
    if found is None or len(found) == 0:
        return LeftOut(name, "No stage asks for 'Modes'.")
    grows = (found["growth_rate"] != 0).any()
    turns = np.isfinite(found["circumferential_waves"]).any()
    rows = []
    for i in range(len(found)):
        row = [escape(found["stage"][i]), str(int(found["mode"][i])),
               number(found["frequency"][i], 6)]
        if grows:
            row.append(number(found["growth_rate"][i]))
        if turns:
            row += [str(int(found[column][i])) for column in
                    ("circumferential_waves", "meridional_half_waves")]
        total = found["total_mass"][i]
        row += [f"{100 * found['effective_mass_' + axis][i] / total:.1f} %"
                for axis in "xyz"]
        rows.append(row)
    heads = (["Stage", "Mode", "Frequency"] + (["Growth rate"] if grows else [])
             + (["Waves around", "Half waves along the meridian"]
                if turns else [])
             + [f"Effective mass, {axis}" for axis in "xyz"])
    text = paragraph(
        "Natural frequencies [1/time] of the loaded shell at the end of each stage; "
        "effective masses of translations, of the mass of the shell, "
        f"{plain_number(found['total_mass'][-1])}.")
    all_modes = table("Modes, from modes.csv", heads, rows)
    last = found.where(found["step"] == found["step"][-1])
    pictures = draw(run, last)
    if pictures is None:
        return Section("modes", name, all_modes + text, True)
    return Section("modes", name, pictures + "\n" + text + details(
        "All modes", all_modes))


def draw(run, found):
    """Pictures of the first modes of a stage; None if their files are missing."""
    step = int(found["step"][0])
    paths = [run.directory / f"modes-{step:04d}-{i + 1:03d}.vtu"
             for i in range(min(N_PICTURES, len(found)))]
    if run.setting("Output/Write VTU") == "false" or not all(
            path.exists() for path in paths):
        return None
    columns = min(3, len(paths))
    lines = -(-len(paths) // columns)
    picture = plt.figure(figsize=(3 * columns, 2.6 * lines))
    for i, path in enumerate(paths):
        axes = picture.add_subplot(lines, columns, i + 1, projection="3d")
        draw_mode(axes, path)
        axes.set_title(f"{i + 1}: {found['frequency'][i]:.5g}", fontsize=9, y=1.03)
    picture.subplots_adjust(0, 0, 1, 0.92, 0.02, 0.12)
    html = figure(
        embed(picture, "png"), "Shapes of the first modes of vibration.",
        f"The first modes of the stage {escape(found['stage'][0])} with their "
        "frequencies, the displacements enlarged; color: displacement of the outer "
        "face along its normal.")
    plt.close(picture)
    return html


def draw_mode(axes, path):
    """The outer face, moved and colored by the mode."""
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
    limit = max(np.abs(along).max(), 1e-12)
    axes.add_collection3d(Poly3DCollection(
        faces, facecolors=plt.get_cmap("RdBu_r")(0.5 + along / (2 * limit)),
        edgecolors=(0, 0, 0, 0.15), linewidths=0.2))
    middle = (faces.reshape(-1, 3).max(0) + faces.reshape(-1, 3).min(0)) / 2
    reach = 0.31 * np.ptp(faces.reshape(-1, 3), axis=0).max()
    # y, the axis of wheels, points away from the reader's right
    for set_limits, center in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim),
                                  middle):
        set_limits(center - reach, center + reach)
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(elev=28, azim=-62)
    axes.set_axis_off()
