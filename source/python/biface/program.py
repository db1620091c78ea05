# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the program biface and starts it."""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from .errors import BifaceError

# Exit codes of the program, see `biface --help`
NOT_CONVERGED, STOPPED = 2, (128 + signal.SIGINT, 128 + signal.SIGTERM)


def find_program(program=None):
    """The path of the program: the one given, $BIFACE, the one built from the
    sources that contain this package or installed with it, or the one on PATH."""
    chosen = program or os.environ.get("BIFACE")
    # the folder of source/python, or the prefix of lib/python3/dist-packages
    sources, prefix = Path(__file__).resolve().parents[3:5]
    candidates = [chosen] if chosen else [
        sources / "build/biface", prefix / "bin/biface", "biface"]
    for candidate in candidates:
        found = shutil.which(candidate)
        if found:
            return Path(found).absolute()
    if chosen:
        raise BifaceError(f"{chosen} is not a program that can be run.")
    raise BifaceError("The program biface was not found: set the environment variable "
                      "BIFACE to its path.")


def call(program, *words):
    """What the program prints, such as for --print-parameters=json."""
    done = subprocess.run([find_program(program), *map(os.fspath, words)], text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        raise BifaceError(message_of(done.stderr))
    return done.stdout


def execute(words, ranks=1, program=None, progress=None):
    """Runs the program with words of a command line, on several ranks by mpirun.
    Returns its exit code and its message.

    The function progress is called with each line about a step or a sample. Ctrl-C
    and any other exception stop the program, which keeps the steps done."""
    if not isinstance(ranks, (int, np.integer)) or ranks < 1:
        raise BifaceError(f"The number of ranks is {ranks!r}, but must be an integer, 1 "
                          "or more.")
    command = [find_program(program), *map(os.fspath, words)]
    if ranks > 1:
        if not shutil.which("mpirun"):
            raise BifaceError("mpirun is missing, which several ranks need (Debian: "
                              "openmpi-bin).")
        command = ["mpirun", "-n", str(int(ranks)), *command]
    if not progress:
        command.append("--quiet")
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as errors:
        # in a session of its own, so that Ctrl-C reaches the program once
        try:
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=errors, text=True, errors="replace", env=environment(),
                start_new_session=True)
        except OSError as error:
            raise BifaceError(f"{command[0]} cannot be started "
                              f"({error.strerror}).") from None
        try:
            for line in process.stdout:
                if progress and (match := re.match("  ((step )?[0-9]+ of .*)", line)):
                    progress(match[1])
            code = process.wait()
        finally:
            if process.poll() is None:
                stop(process)
            process.stdout.close()
        errors.seek(0)
        message = message_of(errors.read())
    if code == 0 and message:
        print(f"biface: {message}", file=sys.stderr)
    if code < 0:
        message = message or f"The program was ended by signal {-code}."
    return code, message


def environment():
    """The environment of the program: Open MPI may start more ranks than there are
    cores, and as root."""
    result = {**os.environ, "OMPI_MCA_rmaps_base_oversubscribe": "true"}
    if os.geteuid() == 0:
        result.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return result


def stop(process):
    """Stops the program as Ctrl-C does; a second Ctrl-C ends it at once."""
    process.send_signal(signal.SIGINT)
    try:
        process.communicate()
    except KeyboardInterrupt:
        process.kill()
        raise


def message_of(text):
    """The message of the program among what it and mpirun print as errors."""
    own = re.search(r"^biface: (.*?)\s*(?:^-{60}|\Z)", text, re.DOTALL | re.MULTILINE)
    return own[1] if own else text.strip()
