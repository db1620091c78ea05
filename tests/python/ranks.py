# SPDX-License-Identifier: LGPL-2.1-or-later

# A run on more ranks than cores has the forces of a run on one.

import os

from python_test import biface, check, check_close, error_of, run

one = run()
several = run(ranks=(os.cpu_count() or 1) + 1)
check(len(one.steps) == len(several.steps), "the steps differ")
check_close(several.last("force"), one.last("force"), 1e-8, "the force")
check("ranks is 0" in str(error_of(biface.BifaceError, run, ranks=0)),
      "no rank is accepted")
