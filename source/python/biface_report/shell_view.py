# SPDX-License-Identifier: LGPL-2.1-or-later
"""Has the picture of the deformed shell drawn (see shell_picture.py) in a process
of its own: VTK ends the process where it finds no display."""

import json
import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from .foundation import foundation_in_step
from .units import units_of


class NoPicture(Exception):
    """Why there is no picture, as one sentence."""


def draw_shell(run, target):
    """Draws shell-NNNN.vtu of the step of a run to a PNG file. Returns the
    foundation in the picture, which is then colored by contact pressure, or None;
    and the direction to the camera."""
    if not find_spec("vtk"):
        raise NoPicture("VTK for Python is missing (Debian: python3-vtk9).")
    command = [sys.executable, "-B", "-m", "biface_report.shell_picture",
               run.path("shell", ending="vtu"), target]
    foundation = foundation_in_step(run) if run.is_contact else None
    if foundation:
        command += ["--foundation", json.dumps(foundation.as_dict())]
    quantity = (("contact pressure", "pressure") if foundation else
                ("displacement", "length"))
    command += ["--label", units_of(run).label(*quantity)]
    path = [str(Path(__file__).resolve().parents[1]),
            os.environ.get("PYTHONPATH", "")]
    environment = dict(os.environ,
                       PYTHONPATH=os.pathsep.join(filter(None, path)))
    displays = available_displays()
    for prefix in displays:
        done = subprocess.run([*prefix, *map(str, command)], env=environment,
                              capture_output=True, check=False, text=True)
        if done.returncode == 0 and target.exists():
            return foundation, [float(x) for x in done.stdout.split()]
    raise NoPicture("VTK could not draw it." if displays else
                    "VTK needs a display; a virtual one will do (Debian: xvfb, "
                    "xauth).")


def available_displays():
    """What to put before a command for it to have a display: a virtual one if
    possible, then the user's."""
    result = []
    virtual = shutil.which("xvfb-run")
    if virtual and shutil.which("xauth"):
        result.append([virtual, "-a", "-s", "-screen 0 2000x1600x24"])
    if os.environ.get("DISPLAY"):
        result.append([])
    return result
