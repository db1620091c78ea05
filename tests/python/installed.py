# SPDX-License-Identifier: LGPL-2.1-or-later

# The installed package is imported from its prefix, and finds the program installed there.

import os
import subprocess

from python_test import BUILD, check, scratch

prefix = scratch() / "a prefix"
subprocess.run([os.environ["CMAKE"], "--install", BUILD / "source/python",
                "--prefix", prefix], check=True, capture_output=True)
program = prefix / "bin/biface"
program.symlink_to(os.environ["BIFACE"])
environment = {name: value for name, value in os.environ.items() if name != "BIFACE"}
done = subprocess.run(
    [os.environ["BIFACE_PYTHON"], "-B", "-c",
     "import biface; print(biface.__file__); print(biface.find_program())"],
    env={**environment, "PYTHONPATH": str(prefix / "lib/python3/dist-packages")},
    check=True, capture_output=True, text=True).stdout.splitlines()
check(done[0].startswith(str(prefix)), f"the package is {done[0]}")
check(done[1] == str(program), f"the program is {done[1]}")
