# SPDX-License-Identifier: LGPL-2.1-or-later

# A tire from its size runs: it is inflated, carries its load near the deflection of NASA's
# formula, and is judged without a warning; with a load that is not that of its pressure
# there is one.

import os
import re
import subprocess

from tire_from_size_test import check, check_close, output_of, scratch, tire

path = scratch() / "tire"
output_of("new", "4.00-8", "4PR", "--rim", "2.50C", "--cells", "0.5", "--output", path)
# inflation, the tensions of the vibration, touch and load
done = subprocess.run([os.environ["BIFACE_PROGRAM"], "--set", "Number of stages=4",
                       "--set", "Stage 2/Modes=0", "--set", "Output/Write VTU=false",
                       path / "tire.prm"], capture_output=True, text=True, check=False)
check(done.returncode == 0, f"the run fails: {done.stderr}")
code, output, errors = tire("judge", path)
check(code == 0 and errors == "", f"the exit code is {code}: {output}{errors}")


def line(name):
    """Value, compared value and ratio of a line."""
    return [float(word) for word in re.findall(
        rf"^{name} +(\S+) \S+ +(\S+) +(\S+)  ", output, re.MULTILINE)[0]]


force, _, ratio = line("force")
check_close(force, 2690, 1e-3, "the load")
check(0.8 < ratio < 1, f"the force is {ratio} of NASA's")
check(0.12 < line("deflection")[2] < 0.2, f"the deflection is {line('deflection')}")
# the cords of two plies by netting, 125 N over 7.6 times the pressure
check_close(line("cord tension, inflated")[0], 125 / 7.6, 0.15, "the tension")

text = (path / "tire.prm").read_text(encoding="utf-8")
(path / "tire.prm").write_text(text.replace("--rim 2.50C", "--rim 2.50C --load 4000"),
                               encoding="utf-8")
code, output, errors = tire("judge", path)
check(code == 1 and "Warning: the run ends at 2690 N of the load of 4000 N." in output,
      f"the exit code is {code}: {output}{errors}")
