# SPDX-License-Identifier: LGPL-2.1-or-later

# Ctrl-C during a run stops the program in order, and goes on to the script.

import os
import signal

from python_test import biface, check, error_of, run, scratch


def interrupt(line):
    """Ctrl-C after the first step."""
    if line.startswith("step 1 "):
        os.kill(os.getpid(), signal.SIGINT)


output = scratch()
error_of(KeyboardInterrupt, run, {"Stage 2/Steps": 400}, output=output,
         progress=interrupt)
results = biface.Results(output)
check(len(results.steps) < 401, "the run went on to its end")
log = (output / "run.log").read_text(encoding="utf-8")
check("SIGINT" in log, f"the program was killed: {log[-500:]}")
