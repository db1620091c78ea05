# SPDX-License-Identifier: LGPL-2.1-or-later

# By the example protocol, the model of a tire whose forces, stiffnesses and frequency are known
# has them in its .tir file and tables; a second call computes nothing, one after an
# interruption goes on, another protocol changes its own runs, and another tire all.

import os
import signal
import subprocess
import sys
import time

from known_tire import (CALLS, FREQUENCY, RADIAL, RADIUS, STIFFNESS, WAIT, formula,
                        known_program)
from tire_from_size_test import (PACKAGE, SOURCE, check, check_close, output_of, require,
                                 scratch, tire)

require("matplotlib")

import numpy as np
from biface_tire import model_report
from biface_tire_model import read_tir

directory = scratch()
os.environ["BIFACE"] = str(known_program(directory))
output_of("new", "4.00-8", "4PR", "--rim", "2.50C", "--output", directory / "tire")
protocol = directory / "few.csv"
protocol.write_bytes((SOURCE / "prm/tire_protocol.csv").read_bytes())
results = directory / "tire/model_few"
words = ["model", directory / "tire", "--protocol", protocol]

# interrupted in its first run, as by Ctrl-C or kill
(directory / WAIT).touch()
with subprocess.Popen([sys.executable, "-B", "-m", "biface_tire", *words],
                      env={**os.environ, "PYTHONPATH": str(PACKAGE)}, text=True,
                      stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
    while not (results / "runs/standing/checkpoint.bin").exists():
        check(process.poll() is None, "it ended early")
        time.sleep(0.05)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate()
check(process.returncode == 130 and "the same command goes on from here" in errors,
      f"{process.returncode}: {errors}")
(directory / WAIT).unlink()


def runs():
    """The runs since the last call: pairs of name and whether they were continued."""
    lines = (directory / CALLS).read_text(encoding="utf-8").splitlines()
    (directory / CALLS).write_text("", encoding="utf-8")
    return [(line.partition("--output ")[2].split()[0].rsplit("/", 1)[1],
             "--restart" in line) for line in lines if "--output" in line]


runs()
code, output, errors = tire(*words)
check(code == 0 and errors == "", f"{code}: {errors}")
found = runs()
check(found == [("standing", True), ("vibrating", False), ("steady-1", False)], f"{found}")

file = read_tir(results / "tire.tir")
check(file.find("FITTYP") == 6, "two pressures are not in this protocol")
check_close(file.find("UNLOADED_RADIUS"), RADIUS, 1e-6, "the radius")
check_close(file.find("FNOMIN"), 2689.77, 1e-5, "the nominal load")
check_close(file.find("VERTICAL_STIFFNESS"), RADIAL, 1e-6, "the vertical stiffness")
loads, alpha = np.array([[1500.0], [2500.0]]), np.radians(np.linspace(-9, 9, 19))
fitted, known = file.formula(), formula()
for name, slips in (("F_y", {"alpha": alpha}), ("F_x", {"kappa": alpha})):
    values = [getattr(one.evaluate(loads, **slips), name) for one in (fitted, known)]
    check(np.abs(values[0] - values[1]).max() < 0.01 * np.abs(values[1]).max(),
          f"{name} is another one")
for kind, value in STIFFNESS.items():
    rows = (results / f"tables/{kind}_stiffness.csv").read_text(
        encoding="utf-8").splitlines()[2:]
    check(len(rows) == 2, f"{rows}")
    for row in rows:
        check_close(float(row.split(",")[5]), value, 1e-6, f"the {kind} stiffness")
check("FREQ_LAT" in output and "Relaxation lengths" in output, output)
check(f"{FREQUENCY:g}" in (results / "tables/frequencies.csv").read_text(encoding="utf-8"),
      "another frequency")
check("combined slip is not measured" in (results / "tire.tir").read_text(encoding="utf-8"),
      "the file promises full F_x and F_y")
page = (results / "report.html").read_text(encoding="utf-8")
check(all(title in page for title in ("Magic Formula", "Standing tire", "Rolling: steady-1")),
      "a section of the report is missing")
check(len(list((results / "tydex").glob("*.tdx"))) == 4, "other TYDEX files")

# what is done remains; what another protocol or tire changes does not; once is enough for
# the pictures
model_report.write_report = lambda *words: None
check("All runs are done: nothing is computed again." in output_of(*words) and not runs(),
      "it computes again")
protocol.write_text("kind,load [%]\nlateral,60\nmodes,\n", encoding="utf-8")
output = output_of(*words)
check("The protocol is not that of the results in" in output
      and runs() == [("standing", False)], output)
check(not (results / "tire.tir").exists(), "the file of the other protocol remains")
path = directory / "tire/tire.prm"
path.write_text(path.read_text(encoding="utf-8").replace("E_cord          = 2400",
                                                         "E_cord          = 2500"),
                encoding="utf-8")
output = output_of(*words)
check("The tire file is not that of the results in" in output and ": all is computed anew."
      in output and runs() == [("standing", False), ("vibrating", False)], output)
other = directory / "other"
other.mkdir()
(other / "note.txt").touch()
code, _, errors = tire(*words, "--output", other)
check(code == 1 and "is not empty, and holds no earlier results" in errors, errors)
