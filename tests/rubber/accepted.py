# SPDX-License-Identifier: LGPL-2.1-or-later

# biface accepts the sections that biface-rubber prints.

import os
import re
import subprocess

from rubber_test import SOURCE, TRELOAR, check, output_of, require, scratch

require("numpy", "scipy")

example = (SOURCE / "prm/tutorial/1_cylinder.prm").read_text(encoding="utf-8")
directory = scratch()
for words in (["--shore", "60"], ["--shore", "60", "--K", "1000"],
              *([TRELOAR, "--law", law] for law in ("neo-Hooke", "Mooney-Rivlin",
                                                    "Yeoh", "Ogden"))):
    file = directory / "tube.prm"
    section = output_of(*words)
    file.write_text(re.sub(r"subsection Material rubber.*?\nend\n", lambda _: section,
                           example, flags=re.DOTALL), encoding="utf-8")
    done = subprocess.run(
        [os.environ["BIFACE_PROGRAM"], "--check", "--output", directory / "results",
         "--set", "Stage 1/Strain theory=nonlinear", file],
        capture_output=True, text=True, check=False)
    check(done.returncode == 0, f"{words}: {done.stderr}")
