# SPDX-License-Identifier: LGPL-2.1-or-later

# In the view of modes, the shell moves by the mode times the amplitude, back and
# forth, while it is played.

from report_test import PACKAGE, RUNS, check, report, require, scratch

require("matplotlib")

import sys

import numpy as np
from browser import Browser

sys.path.insert(0, str(PACKAGE))

from biface import read_vtu

AMPLITUDE = 0.2

target = scratch() / "page.html"
report(RUNS / "tire_modes", target=target)
# the second mode of the last stage
browser = Browser(target, section="modes")
browser.set("Amplitude", AMPLITUDE)
browser.set("Shape", 1)
path = sorted((RUNS / "tire_modes").glob("modes-*-002.vtu"))[-1]
data = read_vtu(path)
size = np.ptp(data["Points"], axis=0).max()
expected = np.abs(AMPLITUDE * size * data["mode"]).max(0)


def moved():
    """The largest displacements along the axes."""
    return np.abs(browser.run("""
        const rest = view.chosen.positions(1, [[view.chosen.motion, 1]]);
        return [...view.nodes].map((place, i) => place - rest[i]);""")).reshape(
            -1, 3).max(0)


found = moved()
check(np.allclose(found, expected, rtol=1e-3), f"moved by {found}, not {expected}")
browser.run("""
    view.play.click();
    while (view.phase < 0.5)
      await new Promise((done) => setTimeout(done, 20));
    view.play.click();""")
check(np.linalg.norm(moved()) < 0.9 * np.linalg.norm(expected),
      "the shape does not move")
browser.check_no_errors()
