# SPDX-License-Identifier: LGPL-2.1-or-later

# The data of the view have the points and the values of all VTU files, to 16 bits.

from report_test import PACKAGE, RUNS, check, page_of, require, require_three

require("matplotlib")
require_three()

import base64
import json
import sys
import zlib

import numpy as np

sys.path.insert(0, str(PACKAGE))

from biface import read_vtu


def unpacked(text, kind):
    """The numbers in a compressed text."""
    return np.frombuffer(zlib.decompress(base64.b64decode(text)), kind)


for run, kind in (("shell", "shell"), ("drum", "shell"), ("plies", "plies")):
    files = sorted((RUNS / run).glob(f"{kind}-*.vtu"))
    page = page_of(RUNS / run)
    scene = next(json.loads(text) for text in page.scripts
                 if text.startswith('{"title": "Deformed shell"'))
    part = next(part for part in scene["parts"] if part["name"] == kind)
    check(len(part["states"]) == len(files) > 1,
          f"{run}: {len(part['states'])} steps of {len(files)}")
    nodes = unpacked(part["nodes"], "<i4")
    base = unpacked(part["base"], "<f4").reshape(-1, 3)
    for state, path in enumerate(files):
        data = read_vtu(path)
        # the outer face first, or both sides of one ply after the other
        cells = data["connectivity"].reshape(-1, 4 if kind == "shell" else 8)
        key = data["ply"] if kind == "plies" else -data["outer_face"]
        corners = cells[np.argsort(key[cells[:, 0]], kind="stable")].ravel()
        for field in part["fields"]:
            if field["name"] not in data:
                continue
            values = unpacked(field["values"], "<i2").reshape(
                len(files), -1, field["components"])[state] * field["scales"][state]
            found = values[nodes] if field["at_nodes"] else values
            exact = data[field["name"]][corners].reshape(found.shape)
            error = np.abs(found - exact).max()
            check(error <= 0.51 * field["scales"][state],
                  f"{path.name}: {field['name']} is off by {error}")
            if field["name"] == "displacement":
                points = base[nodes] + found
                error = np.abs(points - data["Points"][corners]).max()
                check(error < 1e-4 * np.abs(base).max(),
                      f"{path.name}: points are off by {error}")
    names = {field["name"] for field in part["fields"]}
    expected = {"displacement", "H_11", "contact_pressure"} if kind == "shell" else \
        {"displacement", "s_L", "fiber"}
    check(expected <= names, f"{names}")
