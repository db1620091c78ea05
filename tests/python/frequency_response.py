# SPDX-License-Identifier: LGPL-2.1-or-later

# The response of a bar that is shaken at its support has complex amplitudes: its end
# moves by 1/cos(kL), with the complex modulus of the loss factor, and the support pulls
# by -E A k tan(kL).

import numpy as np

from python_test import SOURCE, biface, check, check_close, read_csv, scratch

E, A, L, DENSITY = 70000 * (1 + 0.1j), 20, 1000, 2.7e-9

results = biface.run(SOURCE / "tests/data/shaken_bar.prm",
                     {"Stage 1/Loss factor": 0.1,
                      "Stage 1/Frequency response": "300:1500:5"}, scratch())
table = results.response()
check(len(table) == len(read_csv(results.directory / "response.csv")) == 2 * 3 * 5,
      f"{len(table)} rows")
shaken = table.where(excitation="supports x")
end = shaken.where(output="end", kind="inner")
support = shaken.where(kind="force")
for i, frequency in enumerate((300, 600, 900, 1200, 1500)):
    check(end["frequency"][i] == frequency, f"the frequency {end['frequency'][i]}")
    k = 2 * np.pi * frequency * np.sqrt(DENSITY / E)
    check_close(end["x"][i], 1 / np.cos(k * L), 1e-3, f"the end at {frequency}")
    check_close(support["x"][i], -E * A * k * np.tan(k * L), 1e-3,
                f"the force at {frequency}")

# where the program has found none
path = results.directory / "response.csv"
lines = path.read_text(encoding="utf-8").splitlines()
lines[1] = ",".join(lines[1].split(",")[:7] + 6 * ["nan"])
path.write_text("\n".join(lines) + "\n", encoding="utf-8")
changed = results.response()
check(np.isnan(changed.positions()[0]).all(), "nan is a number")
check(np.isfinite(changed.positions()[1:]).all(), "numbers are nan")
