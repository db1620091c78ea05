# SPDX-License-Identifier: LGPL-2.1-or-later
"""A series of runs that goes on where it was interrupted."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import time

from biface.errors import BifaceError, NotConverged, RunError
from biface.program import call
from biface.results import Results
from biface.running import run as run_file

# The file in which a series keeps what is done, and the directory of its runs
STATE, RUNS = "series.json", "runs"

# Seconds between two lines of progress
PAUSE = 10


class Series:
    """Runs in a directory, each in one of its own.

    results   of the runs that are done, by name
    left_out  sentences on runs that the program refuses, and on those that ended early
    """

    def __init__(self, output, runs, inputs, ranks=1, say=print):
        """output  the directory
        runs    a list of runs.Run
        inputs  what all runs depend on, as text by what it is, such as "the tire file";
                if one has changed since the last time, all is computed anew
        ranks   number of ranks of each run
        say     a function that takes lines of progress

        Raises BifaceError if the directory has something else in it."""
        self.output, self.runs, self.ranks, self.say = output, runs, ranks, say
        self.results, self.left_out = {}, []
        self.inputs = {name: digest(text) for name, text in inputs.items()}
        self.texts = {run.name: digest(run.text) for run in runs}
        self.state = self._read_state()
        # seconds and steps of this session, for the time left
        self.begin, self.steps = None, 0
        self.last_said = 0.0

    def _read_state(self):
        """What is done; starts anew if the inputs have changed, and forgets runs whose files
        have."""
        path = self.output / STATE
        if not path.exists():
            if self.output.is_dir() and any(self.output.iterdir()):
                raise BifaceError(f"{self.output} is not empty, and holds no earlier results "
                                  "of this command: choose another directory with --output.")
            return {"inputs": self.inputs, "runs": self.texts, "done": {}}
        try:
            state = json.loads(path.read_text(encoding="utf-8"))
            known, texts, done = (dict(state[key]) for key in ("inputs", "runs", "done"))
        except (ValueError, KeyError, TypeError):
            known, texts, done = {}, {}, {}
        changed = [name for name in self.inputs if known.get(name) != self.inputs[name]]
        if changed:
            self.say(f"{changed[0][0].upper()}{changed[0][1:]} is not that of the results in "
                     f"{self.output}: all is computed anew.")
            shutil.rmtree(self.output / RUNS, ignore_errors=True)
            return {"inputs": self.inputs, "runs": self.texts, "done": {}}
        if texts != self.texts:
            self.say(f"The protocol is not that of the results in {self.output}: runs that it "
                     "changes are computed anew.")
        for name in set(texts) | set(self.texts):
            if texts.get(name) != self.texts.get(name):
                done.pop(name, None)
                shutil.rmtree(self.output / RUNS / name, ignore_errors=True)
                (self.output / RUNS / f"{name}.prm").unlink(missing_ok=True)
        return {"inputs": self.inputs, "runs": self.texts, "done": done}

    def _write_state(self):
        path = self.output / STATE
        temporary = path.with_suffix(".tmp")
        temporary.write_text(json.dumps(self.state, indent=1), encoding="utf-8")
        os.replace(temporary, path)

    def compute(self):
        """Runs all that is not done. Raises RunError if a run fails for another reason than
        its input or convergence, and KeyboardInterrupt if it is interrupted."""
        (self.output / RUNS).mkdir(parents=True, exist_ok=True)
        self._write_state()
        counts = self._check()
        done = self.state["done"]
        todo = [run for run in self.runs if run.name in counts and run.name not in done]
        left = sum(counts[run.name] for run in todo)
        if todo:
            self.say(f"{len(todo)} of {len(self.runs)} runs to do, about {left} steps.")
        else:
            self.say("All runs are done: nothing is computed again.")
        for run in todo:
            left -= counts[run.name]
            done[run.name] = self._run(run, counts[run.name], left)
            self._write_state()
        for run in self.runs:
            if run.name in counts:
                self._collect(run)

    def _check(self):
        """The number of steps of each run, but of those that the program refuses."""
        counts = {}
        for run in self.runs:
            path = self.file_of(run)
            if not path.exists() or path.read_text(encoding="utf-8") != run.text:
                path.write_text(run.text, encoding="utf-8")
            if run.name in self.state["done"]:
                counts[run.name] = 0
                continue
            try:
                text = call(None, "--check", path)
            except BifaceError as error:
                self.left_out.append(f"{run.title}: {error}")
                continue
            found = re.search(r"for (\d+) steps", text)
            counts[run.name] = int(found[1]) if found else 1
        return counts

    def file_of(self, run):
        """The parameter file of a run."""
        return self.output / RUNS / f"{run.name}.prm"

    def directory_of(self, run):
        """Where the results of a run are."""
        return self.output / RUNS / run.name

    def _run(self, run, count, left):
        """Runs or continues one; returns why it ended early, "" if it did not."""
        directory = self.directory_of(run)
        goes_on = any((directory / name).exists()
                      for name in ("checkpoint.bin", "checkpoint-previous.bin"))
        self.say(f"{run.title}: {count} steps" + (", continued" if goes_on else "") + " ...")
        before = None

        def progress(line):
            nonlocal before
            found = re.match(r"step (\d+) of (?:about )?(\d+)", line)
            if not found:
                return
            number, whole = int(found[1]), int(found[2])
            if before is None:
                before = number - 1
            self._progress(run, number, whole, number - before, left)

        if self.begin is None:
            self.begin = time.monotonic()
        try:
            for restart in (True, False) if goes_on else (False,):
                try:
                    results = run_file(self.file_of(run), None, directory, ranks=self.ranks,
                                       progress=progress, may_stop=True, restart=restart)
                    break
                except NotConverged:
                    raise
                except RunError as error:
                    # a checkpoint that is of no use
                    if not restart or error.code != 1:
                        raise
        except NotConverged as error:
            return first_line(error)
        self.steps += count
        return first_line(results.stopped or "")

    def _progress(self, run, number, whole, done, left):
        now = time.monotonic()
        if now - self.last_said < PAUSE:
            return
        self.last_said = now
        rest = whole - number + left
        per_step = (now - self.begin) / max(1, self.steps + done)
        self.say(f"  {run.title}: step {number} of {whole}, about "
                 f"{duration(per_step * rest)} left in all")

    def _collect(self, run):
        """Reads the results of a run that is done."""
        stopped = self.state["done"].get(run.name, "")
        try:
            self.results[run.name] = Results(self.directory_of(run))
        except BifaceError as error:
            self.left_out.append(f"{run.title}: {stopped or error}")
            return
        if stopped:
            self.left_out.append(f"{run.title}, from where it stopped: {stopped}")


def digest(text):
    """What tells a text from others."""
    return hashlib.sha256(text.encode()).hexdigest()


def first_line(message):
    """The first line of a message, which says what is wrong; others give hints."""
    return str(message).partition("\n")[0].strip()


def duration(seconds):
    """A time for people."""
    if seconds < 90:
        return f"{seconds:.0f} s"
    if seconds < 5400:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"
