# SPDX-License-Identifier: LGPL-2.1-or-later

# Phases of the frequency response are those of an oscillator, -90 degrees at its natural
# frequency; they do not jump where they vary around 180 degrees, and round-off has none.

import sys

from report_test import PACKAGE, check, check_equal, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np

from biface_report.response import phases, wrapped

ratio = np.linspace(0, 2, 201)
x, y = wrapped(ratio, phases(1 / (1 - ratio**2 + 2j * 0.05 * ratio)))
check_equal(y[100], -90, "the phase at the natural frequency")
check((np.diff(y) < 0).all() and -180 < y[-1] < -170, "the phase does not fall")

x, y = wrapped(np.arange(5), np.array([170., 179, -175, 178, -172]))
check(np.allclose(y, [170, 179, 185, 178, 188]), f"around 180: {y}")
x, y = wrapped(np.arange(3), np.array([170., -150, -120]))
check(np.isnan(y[1]) and list(y[[0, 2, 3]]) == [170, -150, -120]
      and list(x) == [0, 1, 1, 2], f"past 180: {x}, {y}")

check(list(phases(np.array([-1 - 1e-9j, 2 + 1e-9j]))) == [180, 0],
      "round-off has a phase")
