# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views of the shell that the reader can turn: HTML and data for view.js, and
three.js, from its Debian package."""

import base64
import json
from html import escape
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from .bodies import bodies_of
from .ground import ground_of
from .loading import step_labels
from .page import LeftOut, Section
from .sectors import around, copies_of
from .units import units_of
from .view_data import Part

# three.js and its license (Debian: libjs-three)
LIBRARY = Path("/usr/share/javascript/three")
SCRIPTS = ("three.min.js", "examples/js/controls/OrbitControls.js")
LICENSE = Path("/usr/share/doc/libjs-three/copyright")
# The scripts of this package that draw with it
OWN_SCRIPTS = ("view_curved.js", "view_part.js", "view_drawing.js", "view.js")

# The data of a part in characters, about, which limits the states in the page
MAXIMUM_DATA = {"shell": 4_000_000, "plies": 2_500_000, "shapes": 1_500_000}

# Where a closed shell without contact is seen from, and half a turn of copies of a
# sector, and what is up
ASIDE = np.array([0.52, 0.45, 0.72]), np.array([0, 1.0, 0])
INTO = np.array([0.3, 0.5, -0.81]), np.array([0, 1.0, 0])

HELP = ("Drag to turn, with the right button or two fingers to move; in the chosen "
        "view, scroll to zoom, or use the arrow keys, + and −.")


def shell(run):
    """The section with the deformed shell in all steps."""
    name = "Deformed shell"
    if run.setting("Output/Write VTU") == "false":
        return LeftOut(name, "Output/Write VTU is false.")
    steps = {kind: [step for step in run.steps
                    if run.path(kind, step, "vtu").exists()]
             for kind in ("shell", "plies")}
    if not steps["shell"]:
        return LeftOut(name, f"{run.path('shell', ending='vtu').name} is missing.")
    if not is_available():
        return LeftOut(name, "three.js is missing (Debian: libjs-three).")
    chosen = {kind: thinned(run, kind, steps[kind]) for kind in steps if steps[kind]}
    shown = sorted(set().union(*chosen.values()))
    labels = dict(zip(shown, step_labels(run, shown)))
    parts = [Part(kind, [labels[step] for step in chosen[kind]],
                  [run.path(kind, step, "vtu") for step in chosen[kind]],
                  units_of(run)) for kind in chosen]
    notes = [f"To keep the page small, it has {len(chosen[kind])} of the "
             f"{len(steps[kind])} steps of the {kind}." for kind in chosen
             if len(chosen[kind]) < len(steps[kind])]
    copies = copies_of(run, parts[0].base)
    bodies, left_out = bodies_of(run, labels, around(parts[0].base, copies))
    if left_out:
        notes.append(f"Not drawn: {escape(', '.join(left_out))}.")
    if run.is_contact:
        notes.insert(0, "Gray: zero, as without contact.")
    ground = ground_of(run) if run.is_contact else None
    direction, up = (view_of_contact(ground.direction) if ground else
                     INTO if len(copies) > 1 else view_of_shell(parts[0]))
    if len(copies) > 1:
        notes.append("The sector is repeated, with its colors; "
                     f"{len(copies)} make a full turn.")
    scene = {"title": name, "bodies": bodies, "is_series": False, "copies": copies,
             "color": "contact_pressure" if run.is_contact else "displacement"}
    caption = ("Without shading, colors are those of the bar. Cells are "
               f"smooth between the nodes. {' '.join(notes)}")
    return Section("shell", name,
                   view("shell", scene, parts, direction, up, caption), True)


def shapes(run, series, found, values, direction, up):
    """The view of modes of vibration or shapes of buckling, or nothing without
    three.js or if files are missing.

    series: 'modes' or 'buckling'; found: the rows of the shapes of a stage; values:
    what they are called, after their numbers; direction: to the camera."""
    step, numbers = int(found["step"][0]), found["mode"].astype(int)
    paths = [run.directory / f"{series}-{step:04d}-{i:03d}.vtu" for i in numbers]
    if not is_available() or not all(path.exists() for path in paths):
        return ""
    count = affordable(run, "shapes", paths, None)
    names = [f"{i}: {value}" for i, value in zip(numbers, values)]
    part = Part("shell", names[:count], paths[:count], units_of(run),
                motion=None)
    scene = {"title": "Shape", "bodies": [], "is_series": True,
             "copies": [[1, 0, 0, 1]], "color": "mode"}
    note = "" if count == len(paths) else \
        f"To keep the page small, it has the first {count} of {len(paths)}. "
    return view(f"{series}-view", scene, [part], direction, up,
                f"The shapes in motion, enlarged. {note}")


def affordable(run, kind, paths, motion="displacement"):
    """How many of some files the page has room for, if all are like the last."""
    last = Part(kind, [""], paths[-1:], units_of(run), motion)
    size = sum(len(field["values"]) for field in last.fields)
    return min(len(paths), max(1, MAXIMUM_DATA[kind] // size))


def thinned(run, kind, steps):
    """As many steps as the page has room for, in even distances up to the last."""
    count = affordable(run, kind, [run.path(kind, step, "vtu") for step in steps])
    places = np.round(np.linspace(len(steps) - 1, 0, count)).astype(int)
    return [steps[place] for place in places[::-1]]


# ---------------------------------------------------------------- camera


def view_of_contact(normal):
    """Direction from the shell to the camera, and which way is up. The camera looks
    through the ground, slightly from the side."""
    # the Cartesian axes that are most nearly in the plane
    order = np.argsort(np.abs(normal), kind="stable")
    aside, up = (np.eye(3)[i] for i in sorted(order[:2]))
    return normal + 0.44 * aside + 0.32 * up, up


def view_of_shell(part):
    """The same without contact. An open shell lies with its outer face up; for a
    closed one, y is up."""
    corners = part.base[part.node[part.quads]]
    corners = corners[:dict((name, n) for name, _, n in part.groups)["outer face"]]
    areas = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    area = areas.sum(0) / np.linalg.norm(areas, axis=1).sum()
    share = np.linalg.norm(area)
    if share < 0.3:
        return ASIDE
    up = area / share
    flat = part.base - part.base.mean(0)
    flat = flat - np.outer(flat @ up, up)
    _, _, axes = np.linalg.svd(flat[::max(1, len(flat) // 2000)],
                               full_matrices=False)
    # the Cartesian axes, unless the shell lies obliquely
    long = np.eye(3)[np.argmax(np.abs(axes[0]))]
    long = long - (long @ up) * up
    long /= np.linalg.norm(long)
    short = np.cross(up, long)
    return 0.55 * long - 0.8 * short + 0.75 * up, up


# ---------------------------------------------------------------- HTML


def view(name, scene, parts, direction, up, caption):
    """A view and its data."""
    scene = scene | {
        "parts": [part.as_dict() for part in parts],
        "size": float(np.ptp(parts[0].base, axis=0).max()),
        "direction": list(direction), "up": list(up),
        "colors": {colors: color_bytes(colors) for colors in ("viridis", "plasma")}}
    data = json.dumps(scene).replace("<", "\\u003c")
    return (f'<figure class="view" data-scene="{name}-data">\n'
            '<noscript><p class="warning">The view needs JavaScript.</p></noscript>\n'
            f'<figcaption>{caption} <span class="help">{HELP}</span></figcaption>'
            "</figure>\n"
            f'<script type="application/json" id="{name}-data">{data}</script>')


def color_bytes(name):
    """A color map of matplotlib, three bytes per color."""
    colors = plt.get_cmap(name)(np.arange(256), bytes=True)[:, :3]
    return base64.b64encode(colors.tobytes()).decode()


def is_available():
    """Whether three.js is there."""
    return all(path.exists() for path in
               (LICENSE, *(LIBRARY / name for name in SCRIPTS)))


def scripts(sections):
    """The scripts that some sections need."""
    if not any('<figure class="view"' in section.html for section in sections):
        return ""
    notice = read(LICENSE).replace("*/", "* /")
    texts = [f"/* three.js\n\n{notice}*/",
             *(read(LIBRARY / name) for name in SCRIPTS),
             *(read(Path(__file__).with_name(name)) for name in OWN_SCRIPTS)]
    return "".join("<script>\n{}\n</script>\n".format(
        text.replace("</script", "<\\/script")) for text in texts)


def read(path):
    """The text of a file."""
    return path.read_text(encoding="utf-8")
