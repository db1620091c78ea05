# SPDX-License-Identifier: LGPL-2.1-or-later

# biface accepts the parameter files of all kinds of tires, with a tread of bristles or a
# layer, as a tire test and with a contour, and the number of unknowns is that of the
# summary.

import os
import re
import subprocess

from tire_from_size_test import check, output_of, scratch

directory = scratch()
CASES = [["195/65R15", "91V"], ["245/35R19", "93Y", "--tire-test"], ["LT235/85R16", "LRE"],
         ["11R22.5", "--tread", "layer"], ["380/85R28", "133A8"],
         ["4.00-8", "4PR", "--rim", "2.50C"], ["49x17", "26PR", "--tread", "layer"],
         ["700x25C", "--rim", "17C"], ["110/90-18", "61H"],
         ["H44.5x16.5-21", "28PR", "--pressure", "1.4"]]


def check_accepted(number, case):
    """Returns the directory of a case."""
    path = directory / str(number)
    output = output_of("new", *case, "--cells", "0.5", "--output", path)
    done = subprocess.run(
        [os.environ["BIFACE_PROGRAM"], "--check", path / "tire.prm"],
        capture_output=True, text=True, check=False)
    check(done.returncode == 0, f"{case}: {done.stderr}")
    check("swings" not in done.stdout + done.stderr, f"{case}: {done.stdout}")
    unknowns = int(re.search(r"(\d+) unknowns", done.stdout)[1])
    said = int(re.search(r"cells, (\d+) unknowns", output)[1])
    check(unknowns == said, f"{case}: {said}, not {unknowns} unknowns")
    return path


for number, case in enumerate(CASES):
    path = check_accepted(number, case)
    if case == CASES[0]:
        check_accepted("contour", ["195/65R15", "91V", "--contour",
                                   path / "tire_profile.csv"])
