#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""A run that is killed repeatedly, and restarted each time, ends with the
results of an uninterrupted run.

The program is killed (SIGKILL) at random moments, uniformly distributed over the
duration of the uninterrupted run; every other time as soon as the next file is
being written. When a run ends, its history and its series for ParaView are
compared with those of the uninterrupted run, and another run starts, until the
number of kills is reached.

  tests/kill_test.py build/biface prm/bias_tire.prm
  tests/kill_test.py --kills 3 --ranks 1,2 build/biface --set ... FILE.prm
"""

import argparse
import csv
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time

TOLERANCE = 1e-9
KILLS_A_RUN = 5


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=20041)
    parser.add_argument("--ranks", default="1",
                        help="numbers of ranks, used in turn; the first one is "
                        "that of the uninterrupted run")
    parser.add_argument("--mpirun", default="mpirun --oversubscribe")
    parser.add_argument("--directory", type=pathlib.Path,
                        default=pathlib.Path("kill_test"))
    parser.add_argument("program")
    parser.add_argument("words", nargs=argparse.REMAINDER)
    found = parser.parse_args()
    found.ranks = [int(n) for n in found.ranks.split(",")]
    return found


def start(given, n_ranks, output, log, restart):
    words = [given.program, "--output", str(output), *given.words]
    if restart:
        words.insert(1, "--restart")
    if n_ranks > 1:
        # mpirun refuses to run as root otherwise
        root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        words = [*given.mpirun.split(), *root, "-n", str(n_ranks), *words]
    return subprocess.Popen(words, stdout=log, stderr=log)


def descendants(pid):
    """All processes started by a process, directly or indirectly."""
    children = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text().rsplit(")", 1)[1].split()
            except OSError:
                continue
            children.setdefault(int(fields[1]), []).append(int(entry.name))
    result = []
    for child in children.get(pid, []):
        result += [child, *descendants(child)]
    return result


def kill(process):
    pids = [*descendants(process.pid), process.pid]
    for pid in pids:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    # ranks may write until they have ended
    while any(pathlib.Path(f"/proc/{pid}").exists() for pid in pids):
        time.sleep(0.01)


def wait_until(condition, process, seconds):
    """Wait until a condition holds, the process ends, or the time is up."""
    end = time.monotonic() + seconds
    while (time.monotonic() < end and process.poll() is None
           and not condition()):
        time.sleep(0.0002)


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def same(a, b):
    try:
        x, y = float(a), float(b)
    except ValueError:
        return a == b
    return math.isclose(x, y, rel_tol=TOLERANCE)


def complaints(whole, cut):
    """The differences between the results in two directories."""
    result = []
    for name in ("history.csv", "probes.csv"):
        if not (whole / name).exists():
            continue
        expected, found = table(whole / name), table(cut / name)
        if len(expected) != len(found):
            result.append(f"{name}: {len(found)} lines, not {len(expected)}")
        for row, other in zip(expected, found):
            for column, a, b in zip(expected[0], row, other):
                if column != "seconds" and not same(a, b):
                    result.append(f"{name}, step {row[0]}, {column}: {b}, "
                                  f"not {a}")
    for path in whole.glob("*.pvd"):
        entries = re.compile('timestep="([^"]*)".* file="([^"]*)"')
        found = entries.findall((cut / path.name).read_text())
        if found != entries.findall(path.read_text()):
            result.append(f"{path.name} differs")
        for _, name in found:
            if not (cut / name).read_bytes().rstrip().endswith(b"</VTKFile>"):
                result.append(f"{name} is not complete")
    for path in whole.glob("*-[0-9][0-9][0-9][0-9].csv"):
        if not (cut / path.name).exists():
            result.append(f"there is no {path.name}")
    for path in cut.glob("*.tmp"):
        result.append(f"{path.name} was left")
    return result


def says_step(log_path, offset):
    """Whether the program has printed the start of a step."""
    with open(log_path, "rb") as log:
        log.seek(offset)
        return b"\nStep " in log.read()


def steps_in(directory):
    try:
        return len((directory / "history.csv").read_text().splitlines()) - 1
    except FileNotFoundError:
        return 0


def main():
    given = arguments()
    draw = random.Random(given.seed)
    shutil.rmtree(given.directory, ignore_errors=True)
    given.directory.mkdir(parents=True)
    whole, cut = given.directory / "whole", given.directory / "cut"
    log_path = given.directory / "log"
    print(f"seed {given.seed}")

    with open(log_path, "w", encoding="utf-8") as log:
        begin = time.monotonic()
        if start(given, given.ranks[0], whole, log, False).wait() != 0:
            sys.exit(f"the run left alone did not end well, see {log_path}")
        duration = time.monotonic() - begin
        n_steps = steps_in(whole)
        print(f"left alone: {n_steps} steps, {duration:.1f} s", flush=True)

        n_kills, n_launches, n_runs, n_bad = 0, 0, 0, 0
        n_early, n_writing, at_steps = 0, 0, []
        while n_kills < given.kills or cut.exists():
            n_ranks = given.ranks[n_launches % len(given.ranks)]
            n_launches += 1
            restart = (cut / "checkpoint.bin").exists() or (
                cut / "checkpoint-previous.bin").exists()
            # a constant rate: kills are uniformly distributed over the run
            delay = draw.expovariate(KILLS_A_RUN / duration)
            size = log_path.stat().st_size
            process = start(given, n_ranks, cut, log, restart)
            if n_kills < given.kills:
                # one of four may happen during set-up
                if n_kills % 4 != 3:
                    wait_until(lambda: says_step(log_path, size), process, 600)
                wait_until(lambda: False, process, delay)
                if n_kills % 2 == 0:
                    wait_until(lambda: any(cut.glob("*.tmp")), process, duration)
            else:
                process.wait()
            if process.poll() is None:
                kill(process)
                n_kills += 1
                at_steps.append(steps_in(cut))
                n_early += not (cut / "checkpoint.bin").exists()
                n_writing += any(cut.glob("*.tmp"))
                continue
            if process.returncode != 0:
                sys.exit(f"a restart ended with {process.returncode}, see "
                         f"{log_path}")

            n_runs += 1
            print(f"run {n_runs} has ended, after {n_kills} kills", flush=True)
            bad = complaints(whole, cut)
            n_bad += len(bad)
            for complaint in bad[:10]:
                print(f"run {n_runs}: {complaint}")
            shutil.rmtree(cut)

    print(f"{n_kills} kills, {n_writing} of them while a file was written, "
          f"{n_early} without a newest checkpoint")
    print("steps done when killed:", *at_steps)
    print(f"{n_runs} runs came to their end, {n_bad} differences")
    return 1 if n_bad > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
