# SPDX-License-Identifier: LGPL-2.1-or-later

# Ctrl-C during a run stops the program in order and goes on to the script; a restart continues.

import os
import signal

from python_test import biface, check, error_of, run, scratch


def interrupt(line):
    """Ctrl-C after the first step."""
    if line.startswith("step 1 "):
        os.kill(os.getpid(), signal.SIGINT)


output = scratch()
settings = {"Stage 2/Steps": 200}
error_of(KeyboardInterrupt, run, settings, output=output, progress=interrupt)
results = biface.Results(output)
check(len(results.steps) < 201, "the run went on to its end")
log = (output / "run.log").read_text(encoding="utf-8")
check("SIGINT" in log, f"the program was killed: {log[-500:]}")
lines = []
results = run(settings, output=output, restart=True, progress=lines.append)
check(len(results.steps) == 201 and results.last("approach") == 20,
      f"the run has {len(results.steps)} steps")
check(not lines[0].startswith("step 1 "), "the run has started from scratch")
