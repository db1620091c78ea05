# SPDX-License-Identifier: LGPL-2.1-or-later

# pip installs the packages with their data into any folder, in the version of the program, which is found on the PATH.

import os
import shutil
import subprocess

from python_test import PACKAGE, check, scratch

folder = scratch()
# pip leaves what it builds beside the sources
shutil.copytree(PACKAGE, folder / "source", ignore=shutil.ignore_patterns("__pycache__"))
subprocess.run([os.environ["BIFACE_PYTHON"], "-m", "pip", "install", "--quiet", "--no-deps",
                "--no-index", "--no-build-isolation", "--disable-pip-version-check",
                "--root-user-action=ignore", "--target", folder / "site",
                folder / "source"], check=True)
for file in sorted(PACKAGE.rglob("*")):
    name = file.relative_to(PACKAGE)
    if file.is_file() and len(name.parts) > 1 and "__pycache__" not in name.parts:
        check((folder / "site" / name).exists(), f"{name} is not installed")

(folder / "bin").mkdir()
(folder / "bin/biface").symlink_to(os.environ["BIFACE"])
environment = {name: value for name, value in os.environ.items() if name != "BIFACE"}
done = subprocess.run(
    [os.environ["BIFACE_PYTHON"], "-B", "-c",
     "import biface, importlib.metadata; print(biface.__file__); "
     "print(biface.find_program()); print(importlib.metadata.version('biface'))"],
    env={**environment, "PYTHONPATH": str(folder / "site"),
         "PATH": f"{folder / 'bin'}:{environment['PATH']}"},
    check=True, capture_output=True, text=True, cwd=folder).stdout.splitlines()
check(done[0].startswith(str(folder / "site")), f"the package is {done[0]}")
check(done[1] == str(folder / "bin/biface"), f"the program is {done[1]}")
version = subprocess.run([os.environ["BIFACE"], "--version"], check=True,
                         capture_output=True, text=True).stdout.split()[1]
check(done[2] == version, f"the version is {done[2]}, that of the program {version}")
