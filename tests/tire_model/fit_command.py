# SPDX-License-Identifier: LGPL-2.1-or-later

# The command fit writes a file that gives the forces of the table, with its ranges, and
# prints the residuals.

from tire_model_test import (CHANNELS, TRUCK, check, largest_errors, output_of, require,
                             scratch)

require("numpy", "scipy")

from biface_tire_model import read_table, read_tir
from biface_tire_model.units import System

folder = scratch()
whole = folder / "test.csv"
parts = []
for slips in (("--alpha", "-10:10:1", "--gamma", "-3,0,3"),
              ("--kappa", "-.3:.3:.03", "--alpha", "-6,-2,0,2,6")):
    parts.append(output_of("evaluate", TRUCK, "--fz", "10000,20000,30000", *slips,
                           "--units", "mm, N, s"))
whole.write_text(parts[0] + "\n".join(parts[1].splitlines()[2:]) + "\n", encoding="utf-8")
path = folder / "fitted.tir"
text = output_of("fit", whole, "--format", "5.2", "--radius", "469.9", "--units",
                 "mm, N, s", "--side", "RIGHT", "--output", path)
file = read_tir(path)
check(file.formula().name == "5.2" and file.side() == "RIGHT"
      and file.find("FE_METHOD") == "NO", "another model")
for name, value in (("KPUMIN", -0.3), ("KPUMAX", 0.3), ("ALPMIN", -0.17453292519943295),
                    ("ALPMAX", 0.17453292519943295), ("CAMMIN", -0.05235987755982989),
                    ("CAMMAX", 0.05235987755982989), ("FZMIN", 10000), ("FZMAX", 30000),
                    ("UNLOADED_RADIUS", 0.4699), ("FNOMIN", 20000)):
    check(abs(file.find(name) - value) < 1e-9 * abs(value),
          f"{name} is {file.find(name)}, not {value}")
data = read_table(whole, System("mm, N, s"))
errors = largest_errors(file.formula(), data)
check(max(errors.values()) < 0.01, f"{errors}")
for name in CHANNELS:
    row = [line for line in text.splitlines() if line.startswith(name + " ")]
    check(len(row) == 1 and float(row[0].split()[3]) < 1
          and float(row[0].split()[4]) < 1, f"{name}: {row}")
check("Neutral (one pressure):" in text and "Neutral (one velocity): QSY3, QSY4." in text,
      text)
check("Magic Formula 5.2, fitted to" in file.remarks[1], f"{file.remarks}")
check(output_of("check", path).endswith("No coefficient is out of its usual bounds.\n"),
      "the file is unusual")
