# SPDX-License-Identifier: LGPL-2.1-or-later

# The report of a run with inertia shows displacements and the force over time, energies
# that balance, and spectra whose peaks are the frequencies of the curves, in place of a
# curve of load and deflection.

import sys

from report_test import PACKAGE, RUNS, check, check_equal, page_of, require

require("matplotlib", "numpy")
sys.path.insert(0, str(PACKAGE))

import numpy as np

from biface import Results
from biface_report import motion

run = Results(RUNS / "motion")
curves = motion.curves_over_time(run)
check([label for label, _, _ in curves]
      == ["top, $u_x$", "bottom, $u_x$", "force on the ground"], f"{curves}")
check(curves[0][2][-1] < 0, "the top does not fall")
check_equal(curves[2][2].max(), run.history["force"].max(), "the largest force")

page = page_of(RUNS / "motion")
check("Energies and works balance." in page.text, "the balance is not told")
check("steps with inertia, which are no equilibria" in page.text,
      "the curve of load and deflection is not left out")

step, frequency = 1e-3, 50
times = np.arange(400) * step
frequencies, amplitudes = motion.spectrum(
    2 + 3 * times + np.sin(2 * np.pi * frequency * times), step)
check_equal(frequencies[np.argmax(amplitudes)], frequency, "the peak")
