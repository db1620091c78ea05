#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the table of doc/rolling.md about a cleat at speed, from
prm/cleat_at_speed.prm, and draw doc/figures/cleat_at_speed.png.

    python3 doc/rolling/cleat_at_speed.py --program build/biface
"""

import argparse
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import Runs, table

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))
from biface_report.drawing import BLUE, GRAY, RED, STYLE, save

# in km/h, with the ways of the cleat in mm
WAYS = {1: 300., 10: 500., 30: 1000.}
# its place at the start
START = 120.


def entries(speed, way):
    """The settings of a speed in mm/s."""
    return {"Stage 3/Ground velocity": repr(speed),
            "Stage 4/Duration": repr(way / speed),
            "Body cleat/Motions": f"pass: 0 0 -{way}"}


def without_inertia(speed, way):
    """Those of a wheel without inertia."""
    return {**entries(speed, way), "Stage 4/Inertia": "false", "Stage 4/Steps": 75,
            "Stage 4/Time step": "Duration/Steps", "Stage 4/Time error": 0.01,
            "Stage 4/Stiffness damping": 0, "Stage 4/Numerical damping": 0,
            "Stage 4/Moment of inertia": 0}


class Forces:
    """Forces of the wheel on its axle while the cleat passes, the change of
    the forward one and of that down, in N, and the angular velocity."""

    def __init__(self, results, speed):
        cleat = results.stage("cleat")
        rolling = results.rolling()
        in_stage = rolling["stage"] == "cleat"
        # no time passes before
        self.time = rolling["time"][in_stage]
        self.steps = len(self.time)
        self.iterations = int(sum(cleat.history["iterations"]))
        self.place = START - speed * self.time
        forces = results.forces()
        first = cleat.history["step"][0]

        def of_beads(component):
            sum_of = {}
            for row in forces.rows():
                if row["body"].startswith("alpha_1"):
                    sum_of[row["step"]] = sum_of.get(row["step"], 0) + row[component]
            steady = sum_of[first - 1]
            return np.array([steady - sum_of[step] for step in cleat.history["step"]])

        # up is -x, forward is z
        self.up, self.forward = -of_beads("F_x"), of_beads("F_z")
        self.angular_velocity = rolling["angular_velocity"][in_stage]


def spectrum(time, values):
    """Frequencies in Hz and the amplitudes of a signal that dies away."""
    n = 4096
    even = np.linspace(time[0], time[-1], n)
    signal = np.interp(even, time, values)
    signal -= signal[-1]
    amplitude = np.abs(np.fft.rfft(signal * np.hanning(2 * n)[n:], 8 * n)) / n
    return np.fft.rfftfreq(8 * n, even[1] - even[0]), amplitude


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=Path, default=Path("build/biface"))
    parser.add_argument("--scratch", type=Path, default=Path("build/cleat_at_speed"))
    parser.add_argument("--output", type=Path,
                        default=Path(__file__).resolve().parents[1] / "figures")
    arguments = parser.parse_args()
    for directory in (arguments.scratch, arguments.output):
        directory.mkdir(parents=True, exist_ok=True)
    runs = Runs(arguments)

    settings = {f"{speed}": entries(speed / 3.6e-3, way) for speed, way in WAYS.items()}
    settings["slow"] = without_inertia(1 / 3.6e-3, WAYS[1])
    with ThreadPoolExecutor(2) as pool:
        forces = dict(zip(settings, pool.map(
            lambda name: Forces(runs.run(name, "cleat_at_speed.prm", settings[name]),
                                float(settings[name]["Stage 3/Ground velocity"])),
            settings)))

    rows = []
    for name, of in forces.items():
        label = "1, without inertia" if name == "slow" else name
        rows.append([label, f"{of.steps}", f"{of.iterations}",
                     f"{max(of.up):.0f}", f"{min(of.up):.0f}",
                     f"{max(of.forward):.0f}", f"{min(of.forward):.0f}",
                     f"{100 * (max(of.angular_velocity) / of.angular_velocity[0] - 1):.2f}, "
                     f"{100 * (min(of.angular_velocity) / of.angular_velocity[0] - 1):.2f}"])
    print(table(["speed, km/h", "steps", "iterations", "up, N", "", "forward, N", "",
                 "angular velocity, %"], rows))

    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(2, 2, figsize=(9, 5.6),
                                gridspec_kw={"wspace": 0.28, "hspace": 0.35})
    colors = {"1": GRAY, "10": BLUE, "30": RED}
    for name, color in colors.items():
        of = forces[name]
        for axis, values in zip(axes[:, 0], (of.up, of.forward)):
            axis.plot(of.place, values, color=color, label=f"{name} km/h")
    for axis, values in zip(axes[:, 0], (forces["slow"].up, forces["slow"].forward)):
        axis.plot(forces["slow"].place, values, "--", color="black", linewidth=0.9,
                  label="without inertia")
        axis.set_xlim(120, -400)
        axis.set_xlabel("Cleat ahead of the axle, mm")
    axes[0, 0].set_ylabel("Force up, N")
    axes[1, 0].set_ylabel("Force forward, N")
    axes[0, 0].legend()

    fast = forces["30"]
    axes[0, 1].plot(1e3 * fast.time, fast.angular_velocity, color=RED)
    axes[0, 1].set_xlabel("Time, ms")
    axes[0, 1].set_ylabel("Angular velocity, 1/s")
    after = fast.time > 0.032
    for values, color, label in ((fast.up, BLUE, "up"), (fast.forward, RED, "forward")):
        frequency, amplitude = spectrum(fast.time[after], values[after])
        axes[1, 1].plot(frequency, amplitude, color=color, label=label)
        peaks = [i for i in range(1, len(frequency) - 1) if frequency[i] < 300 and
                 amplitude[i] > amplitude[i - 1] and amplitude[i] > amplitude[i + 1] and
                 amplitude[i] > 0.1 * max(amplitude)]
        print(label, "peaks at", ", ".join(f"{frequency[i]:.0f}" for i in peaks), "Hz")
    axes[1, 1].set_xlim(0, 300)
    axes[1, 1].set_ylim(bottom=0)
    axes[1, 1].set_xlabel("Frequency, Hz")
    axes[1, 1].set_ylabel("Amplitude after the cleat, N")
    axes[1, 1].legend()
    save(figure, arguments.output / "cleat_at_speed.png")


if __name__ == "__main__":
    main()
