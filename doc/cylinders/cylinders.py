#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compress cylinders with measured imperfections, and write cylinders.md."""

import argparse
import json
import sys
import textwrap
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from example_page import EXAMPLES, biface, table

# radius and length in mm, mean thickness of a ply: the database of [DESICOS2015]
LATER = {"Z15": (250.27, 0.11575), "Z17": (250.35, 0.11525), "Z18": (250.30, 0.1195),
         "Z20": (250.30, 0.12225), "Z21": (250.24, 0.12125), "Z22": (250.30, 0.1215),
         "Z23": (250.23, 0.1195), "Z24": (250.22, 0.12375), "Z25": (250.24, 0.117),
         "Z26": (250.27, 0.1195)}
LENGTH = 500
NOMINAL = 0.125  # mm, a ply
# IM7/8552 as the database has it for these cylinders, MPa
CARBON = {"E_L": 142500, "E_T": 8700, "nu_LT": 0.28, "nu_TT": 0.4, "G_LT": 5100,
          "G_TT": 5100}
STIFFER = {"E_L": 175000, "E_T": 8600, "nu_LT": 0.3, "G_LT": 5300, "G_TT": 5300}

MESHES = {"coarse": (48, 128), "medium": (72, 192)}
SHORTENING = 0.5  # mm, of the shipped file at the load factor 1
START, END = 0.2, 0.4  # mm, up to which the cylinders are stiff, and beyond the collapse
STEP, CUTS = 0.0125, 2  # mm
STIFFNESS = 74  # kN/mm, for the bound of the error
DAMPING = 1e-5  # MPa/mm
PUSH = 10  # N


def series(shapes, name):
    """The coefficients of a measured shape, 11 x 21 each, in thicknesses of the wall and
    positive inward."""
    return [np.loadtxt(shapes / f"{name}_measured.FC_{part}") for part in "AB"]


def write_series(path, A, B):
    """The file of an entry 'Fourier series'."""
    lines = ["k, l, A, B"]
    for (k, l), a in np.ndenumerate(A):
        lines.append(f"{k}, {l}, {a:.10g}, {B[k, l] if l > 0 else 0:.10g}")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def evaluate(A, B, x, phi):
    """The shape at x/L and angles in radians, as a table of both."""
    k, l = np.arange(A.shape[0]), np.arange(A.shape[1])
    return np.cos(np.pi * np.outer(x, k)) @ (
        A @ np.cos(np.outer(l, phi)) + B @ np.sin(np.outer(l, phi)))


def without_position(w, x, phi):
    """The shape less its mean radius, and the position and the tilt of the axis."""
    X, P = np.meshgrid(x, phi, indexing="ij")
    rigid = np.stack([np.ones_like(X), np.cos(P), np.sin(P), X * np.cos(P),
                      X * np.sin(P)], -1).reshape(-1, 5)
    fit = np.linalg.lstsq(rigid, w.ravel(), rcond=None)[0]
    return w - (rigid @ fit).reshape(w.shape)


def geometry(radius, ply, mesh="coarse", material=CARBON):
    """The entries of a cylinder without imperfection."""
    along, around = MESHES[mesh]
    return {"Output/Write VTU": False,
            "Surface/Straight line/Start": f"{radius}, 0",
            "Surface/Straight line/End": f"{radius}, {LENGTH}",
            "Surface/Imperfection/Formula": "0",
            "Mesh/Intervals alpha_1": f"0:{LENGTH}:{along}",
            "Mesh/Intervals alpha_2": f"-180:180:{around}",
            "Laminate/Plies": f"carbon: {ply} @ +-24, carbon: {ply} @ +-41",
            **{f"Material carbon/{name}": value for name, value in material.items()}}


def axial_force(results):
    """kN, in each step."""
    return -results.forces().where(body="alpha_1 max")["F_y"] / 1000


class Cylinders:
    """Runs of cylinders. Results of earlier runs are kept unless --again is given."""

    def __init__(self, arguments):
        self.arguments = arguments

    def cached(self, name, compute):
        path = self.arguments.scratch / f"{name.replace(' ', '_')}.json"
        if not path.exists() or self.arguments.again:
            path.write_text(json.dumps(compute(), indent=1), encoding="utf-8")
            print(name, flush=True)
        return json.loads(path.read_text(encoding="utf-8"))

    def run(self, name, entries, may_stop=False):
        return biface.run(EXAMPLES / "imperfect_cylinder.prm", entries,
                          self.arguments.scratch / name.replace(" ", "_"),
                          program=self.arguments.program, may_stop=may_stop)

    def predicted(self, name, entries):
        """The force at which the perfect cylinder buckles by the linear prediction, and
        its waves."""
        def compute():
            run = self.run(name, {**entries, "Stage 1/Load factor": 0.02,
                                  "Stage 1/Steps": 1, "Stage 1/Buckling": 2})
            mode = run.buckling()
            return {"force": axial_force(run)[0] * mode["factor"][0],
                    "around": int(mode["circumferential_waves"][0]),
                    "along": int(mode["meridional_half_waves"][0])}
        return self.cached(name, compute)

    def imperfection(self, name, scale):
        """The entries of a measured shape times a thickness in mm."""
        path = self.arguments.scratch / f"{name}.csv"
        write_series(path, *series(self.arguments.shapes, name))
        return {"Surface/Imperfection/Fourier series": f"measured: {path}",
                "Surface/Imperfection/Formula": f"{-scale:.10g}*measured"}

    def collapse(self, name, entries):
        """The path up to the last equilibrium that is found."""
        def compute():
            run = self.run(name, {
                **entries, "Number of stages": 2,
                "Stage 1/Load factor": START / SHORTENING, "Stage 1/Steps": 2,
                "Stage 1/Buckling": 0, "Stage 2/Name": "collapse",
                "Stage 2/Load factor": 1,
                "Stage 2/Steps": round((SHORTENING - START) / STEP),
                "Newton/Maximum iterations": 6, "Step control/Maximum cuts": CUTS},
                may_stop=True)
            return path_of(run)
        return self.cached(name, compute)

    def damped(self, name, entries, push=0):
        """The path through the collapse with damping, and without a force that pushes
        the middle before, the radial displacements of the nodes at its end: degrees, the
        axial coordinate and the displacement in mm, which contains the imperfection."""
        def compute():
            stages = {"Number of stages": 2, "Stage 1/Name": "push",
                      "Named points": f"middle: {LENGTH / 2} 0",
                      "Loads/Point forces": f"middle: {-push} 0 0",
                      "Stage 1/Load factor": 0, "Stage 1/Steps": 2,
                      "Stage 1/Load factors": "point forces: 1",
                      "Stage 2/Load factors": "point forces: 1"} if push else {
                      "Number of stages": 2, "Stage 1/Load factor": START / SHORTENING,
                      "Stage 1/Steps": 2}
            first = 0 if push else START
            run = self.run(name, {
                **entries, **stages, "Output/Write VTU": not push,
                "Stage 1/Buckling": 0,
                "Stage 2/Name": "collapse", "Stage 2/Load factor": END / SHORTENING,
                "Stage 2/Steps": round((END - first) / STEP),
                "Stage 2/Damping": DAMPING, "Newton/Maximum iterations": 15,
                "Step control/Maximum cuts": 6}, may_stop=True)
            result = path_of(run)
            if not push:
                shell = run.vtu()
                before = shell["Points"] - shell["displacement"]
                outer = np.hypot(before[:, 0], before[:, 2]) > np.hypot(
                    before[:, 0], before[:, 2]).mean()
                result["nodes"] = np.unique(np.stack([
                    np.degrees(np.arctan2(before[:, 2], before[:, 0])), before[:, 1],
                    np.hypot(shell["Points"][:, 0], shell["Points"][:, 2])
                    - np.hypot(before[:, 0], before[:, 2])], -1)[outer].round(4),
                    axis=0).tolist()
            return result
        return self.cached(name, compute)


def path_of(run):
    return {"shortening": list(run.history["load_factor"] * SHORTENING),
            "force": list(axial_force(run))}


def all_runs(cylinders):
    """The results by name."""
    radius, ply = LATER["Z15"]
    wall = 4 * ply
    shape = cylinders.imperfection("Z15", wall)
    on_mesh = {mesh: geometry(radius, ply, mesh) for mesh in MESHES}
    results = {}
    for mesh in MESHES:
        results[f"perfect {mesh}"] = cylinders.predicted(f"Z15 perfect {mesh}", on_mesh[mesh])
        results[f"measured {mesh}"] = cylinders.collapse(
            f"Z15 measured {mesh}", {**on_mesh[mesh], **shape})
    results["damped"] = cylinders.damped("Z15 damped", {**on_mesh["coarse"], **shape})
    results["push"] = cylinders.damped("Z15 push", on_mesh["coarse"], PUSH)
    for name, (R, t) in LATER.items():
        results[name] = results["measured coarse"] if name == "Z15" else cylinders.collapse(
            f"{name} measured", {**geometry(R, t), **cylinders.imperfection(name, 4 * t)})
    results["nominal"] = cylinders.collapse("Z15 nominal", {
        **geometry(radius, NOMINAL), **cylinders.imperfection("Z15", 4 * NOMINAL)})
    results["outward"] = cylinders.collapse("Z15 outward", {
        **on_mesh["coarse"], **cylinders.imperfection("Z15", -wall)})
    results["millimeters"] = cylinders.collapse("Z15 in mm", {
        **on_mesh["coarse"], **cylinders.imperfection("Z15", 1)})
    results["perfect stiffer"] = cylinders.predicted(
        "Z15 perfect stiffer", geometry(radius, ply, material=STIFFER))
    return results


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--scratch", type=Path, required=True,
                        help="where the runs write their results")
    parser.add_argument("--output", type=Path, required=True,
                        help="where to write cylinders.md and its picture")
    parser.add_argument("--shapes", type=Path, required=True,
                        help="folder with NAME_measured.FC_A and NAME_measured.FC_B")
    parser.add_argument("--again", action="store_true",
                        help="repeat runs that are done")
    arguments = parser.parse_args()
    if not (arguments.shapes / "Z15_measured.FC_A").exists():
        parser.error("the folder of --shapes, BIFACE_CYLINDER_SHAPES of CMake, must contain "
                     "Z15_measured.FC_A; doc/cylinders.md says where the files are")
    arguments.scratch.mkdir(parents=True, exist_ok=True)
    (arguments.output / "figures").mkdir(parents=True, exist_ok=True)
    return arguments


# ----------------------------------------------------------------------------- page

# what the database lists as the largest deviation, mm
LISTED = {"Z15": 1.606, "Z17": 1.393, "Z18": 1.007, "Z20": 0.763, "Z21": 1.712, "Z22": 0.631,
          "Z23": 0.707, "Z24": 0.803, "Z25": 0.632, "Z26": 0.681}
TESTS = (21.3, 25.7)  # kN


def fill(text):
    """Paragraphs of lines."""
    return "\n\n".join(textwrap.fill(" ".join(part.split()), 100, break_on_hyphens=False,
                                     break_long_words=False)
                       for part in textwrap.dedent(text).strip().split("\n\n"))


def largest(shapes, name):
    """The largest deviation of a measured shape from its best fit, in thicknesses."""
    x, phi = np.linspace(0, 1, 101), np.linspace(0, 2 * np.pi, 361)[:-1]
    return np.abs(without_position(evaluate(*series(shapes, name), x, phi), x, phi)).max()


def draw(path, shapes, data):
    """The measured shape of Z15, the shape in which it collapses, and the force."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.tri import Triangulation
    from biface_report.drawing import STYLE, save
    plt.rcParams.update(STYLE)
    figure, (measured, collapsed, curve) = plt.subplots(
        1, 3, figsize=(13, 3.9), gridspec_kw={"width_ratios": (1.15, 1.15, 1)})
    wall = 4 * LATER["Z15"][1]
    x, phi = np.linspace(0, 1, 151), np.linspace(-180, 180, 361)
    before = -wall * evaluate(*series(shapes, "Z15"), x, np.radians(phi))
    angle, along, radial = np.array(data["damped"]["nodes"]).T
    # around the seam, too
    seam = angle <= -179.99
    angle = np.concatenate([angle, angle[seam] + 360])
    along = np.concatenate([along, along[seam]])
    radial = np.concatenate([radial, radial[seam]])
    for axes, title, limit in ((measured, "measured", np.abs(before).max()),
                               (collapsed, "collapsed", np.abs(radial).max())):
        levels = np.linspace(-limit, limit, 21)
        if axes is measured:
            drawn = axes.contourf(phi, LENGTH * x, before, levels, cmap="RdBu_r")
        else:
            drawn = axes.tricontourf(Triangulation(angle, along), radial, levels,
                                     cmap="RdBu_r")
        axes.set(title=f"{title}, mm outward", xlabel="alpha_2, degrees",
                 ylabel="alpha_1, mm", xticks=range(-180, 181, 90))
        figure.colorbar(drawn, ax=axes, format="%.2g")
    for key, words, style in (
            ("measured coarse", "measured shape", "k-"),
            ("damped", "measured shape, damped", "C0--"),
            ("push", f"perfect shape, {PUSH} N from the side, damped",
             "C1--")):
        if key in data:
            curve.plot([0, *data[key]["shortening"]], [0, *data[key]["force"]], style,
                       label=words)
    curve.axhline(data["perfect coarse"]["force"], color="gray", linewidth=1, linestyle=":")
    curve.text(0, data["perfect coarse"]["force"], " perfect shape", va="bottom", color="gray")
    curve.axhspan(*TESTS, color="0.9", zorder=0)
    curve.text(0, TESTS[1], " ten tests", va="top", color="0.4")
    curve.set(xlabel="shortening, mm", ylabel="force, kN", xlim=0, ylim=(0, 30))
    curve.legend(loc="lower right", fontsize=8)
    figure.tight_layout()
    save(figure, path)


if __name__ == "__main__":
    arguments = parse()
    data = all_runs(Cylinders(arguments))
    draw(arguments.output / "figures/cylinders.png", arguments.shapes, data)
