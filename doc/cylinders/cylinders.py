#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compress cylinders with measured imperfections, and write cylinders.md."""

import argparse
import json
import re
import sys
import textwrap
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from example_page import EXAMPLES, biface, table

# radius and length in mm, mean thickness of a ply: the database of [DESICOS2015]
MEASURED = {"Z15": (250.27, 0.11575), "Z17": (250.35, 0.11525), "Z18": (250.30, 0.1195),
            "Z20": (250.30, 0.12225), "Z22": (250.30, 0.1215), "Z24": (250.22, 0.12375)}
LENGTH = 500
NOMINAL = 0.125  # mm, a ply
# IM7/8552 as the database has it for these cylinders, MPa
CARBON = {"E_L": 142500, "E_T": 8700, "nu_LT": 0.28, "nu_TT": 0.4, "G_LT": 5100,
          "G_TT": 5100}

MESHES = {"coarse": (48, 128), "medium": (72, 192)}
SHORTENING = 0.5  # mm, of the shipped file at the load factor 1
START, END = 0.25, 0.5  # mm, up to which the cylinders are stiff, and beyond the collapse
STEP, CUTS = 0.0125, 2  # mm
STIFFNESS = 74  # kN/mm, for the bound of the error
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


def geometry(radius, ply, mesh="coarse"):
    """The entries of a cylinder without imperfection."""
    along, around = MESHES[mesh]
    return {"Output/Write VTU": False,
            "Surface/Straight line/Start": f"{radius}, 0",
            "Surface/Straight line/End": f"{radius}, {LENGTH}",
            "Surface/Imperfection/Formula": "0",
            "Mesh/Intervals alpha_1": f"0:{LENGTH}:{along}",
            "Mesh/Intervals alpha_2": f"-180:180:{around}",
            "Laminate/Plies": f"carbon: {ply} @ +-24, carbon: {ply} @ +-41",
            **{f"Material carbon/{name}": value for name, value in CARBON.items()}}


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

    def collapse(self, name, entries, push=0, nodes=False):
        """The path up to the last equilibrium that is found; before, a force may push
        the middle. With the displacements of the nodes of the outer face there, if
        wanted: degrees, the axial coordinate, and outward from the shape without load."""
        def compute():
            stages = {"Stage 1/Name": "push", "Named points": f"middle: {LENGTH / 2} 0",
                      "Loads/Point forces": f"middle: {-push} 0 0",
                      "Stage 1/Load factor": 0, "Stage 1/Steps": 2,
                      "Stage 1/Load factors": "point forces: 1",
                      "Stage 2/Load factors": "point forces: 1"} if push else {
                          "Stage 1/Load factor": START / SHORTENING, "Stage 1/Steps": 1}
            first = 0 if push else START
            run = self.run(name, {
                **entries, **stages, "Output/Write VTU": nodes, "Number of stages": 2,
                "Stage 1/Buckling": 0, "Stage 2/Name": "collapse",
                "Stage 2/Load factor": END / SHORTENING,
                "Stage 2/Steps": round((END - first) / STEP),
                "Newton/Maximum iterations": 6, "Step control/Maximum cuts": CUTS},
                may_stop=True)
            result = {"shortening": list(run.history["load_factor"] * SHORTENING),
                      "force": list(axial_force(run))}
            if nodes:
                result["nodes"] = displacements(run).tolist()
            return result
        return self.cached(name, compute)


def displacements(run):
    """The outward displacement of the outer face in the last step since the first one,
    with the angle in degrees and the axial coordinate before."""
    first, last = run.vtu("shell", run.steps[0]), run.vtu()
    before = last["Points"] - last["displacement"]
    axis = np.hypot(before[:, 0], before[:, 2])
    outward = (np.hypot(last["Points"][:, 0], last["Points"][:, 2])
               - np.hypot(first["Points"][:, 0], first["Points"][:, 2]))
    nodes = np.stack([np.degrees(np.arctan2(before[:, 2], before[:, 0])), before[:, 1],
                      outward], -1)
    return np.unique(nodes[axis > axis.mean()].round(4), axis=0)


def all_runs(cylinders):
    """The results by name."""
    radius, ply = MEASURED["Z15"]
    wall = 4 * ply
    shape = cylinders.imperfection("Z15", wall)
    on_mesh = {mesh: geometry(radius, ply, mesh) for mesh in MESHES}
    results = {}

    def converge(mesh):
        results[f"perfect {mesh}"] = cylinders.predicted(f"Z15 perfect {mesh}", on_mesh[mesh])
        results[f"measured {mesh}"] = cylinders.collapse(
            f"Z15 measured {mesh}", {**on_mesh[mesh], **shape}, nodes=mesh == "coarse")

    converge("coarse")
    converge("medium")
    results["push"] = cylinders.collapse("Z15 push", on_mesh["coarse"], PUSH)
    results["millimeters"] = cylinders.collapse("Z15 in mm", {
        **on_mesh["coarse"], **cylinders.imperfection("Z15", 1)})
    results["nominal"] = cylinders.collapse("Z15 nominal", {
        **geometry(radius, NOMINAL), **cylinders.imperfection("Z15", 4 * NOMINAL)})
    for name, (R, t) in MEASURED.items():
        results[name] = results["measured coarse"] if name == "Z15" else cylinders.collapse(
            f"{name} measured", {**geometry(R, t), **cylinders.imperfection(name, 4 * t)})
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
LISTED = {"Z15": 1.606, "Z17": 1.393, "Z18": 1.007, "Z20": 0.763, "Z22": 0.631, "Z24": 0.803}
TESTS = (21.3, 25.7)  # kN


def fill(text):
    """Paragraphs of lines; links are not broken."""
    text = re.sub(r"\[[^\]]*\]\([^)]*\)",
                  lambda link: " ".join(link[0].split()).replace(" ", "\0"), text)
    return "\n\n".join(textwrap.fill(" ".join(part.split()), 100, break_on_hyphens=False,
                                     break_long_words=False)
                       for part in textwrap.dedent(text).strip().split("\n\n")).replace(
                           "\0", " ")


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
    wall = 4 * MEASURED["Z15"][1]
    x, phi = np.linspace(0, 1, 151), np.linspace(-180, 180, 361)
    before = -wall * evaluate(*series(shapes, "Z15"), x, np.radians(phi))
    angle, along, radial = np.array(data["Z15"]["nodes"]).T
    radial -= radial.mean()  # Poisson's ratio
    # around the seam, too
    seam = angle <= -179.99
    angle = np.concatenate([angle, angle[seam] + 360])
    along = np.concatenate([along, along[seam]])
    radial = np.concatenate([radial, radial[seam]])
    for axes, title, limit in ((measured, "measured", np.abs(before).max()),
                               (collapsed, "before the collapse",
                                np.abs(radial).max())):
        levels = np.linspace(-limit, limit, 21)
        if axes is measured:
            drawn = axes.contourf(phi, LENGTH * x, before, levels, cmap="RdBu_r")
        else:
            drawn = axes.tricontourf(Triangulation(angle, along), radial, levels,
                                     cmap="RdBu_r")
        axes.set(title=f"{title}, mm", xlabel="alpha_2, degrees",
                 ylabel="alpha_1, mm", xticks=range(-180, 181, 90))
        figure.colorbar(drawn, ax=axes, format="%.2g",
                        ticks=(limit * np.array([-0.9, -0.45, 0, 0.45, 0.9])).round(2))
    perfect = data["perfect coarse"]["force"]
    for key, words in (("Z15", "measured shape"),
                       ("push", f"perfect shape, {PUSH} N from the side")):
        curve.plot([0, *data[key]["shortening"]],
                   np.array([0, *data[key]["force"]]) / perfect, "o-", markersize=3,
                   label=words)
    curve.set(xlabel="shortening, mm", ylabel="force over the perfect one", xlim=0,
              ylim=(0, 1))
    curve.legend(loc="lower right", fontsize=8)
    figure.tight_layout()
    save(figure, path)


PAGE = """<!-- Written by doc/cylinders/cylinders.py: cmake --build build --target cylinders -->

# Cylinders with measured imperfections

{introduction}

```
subsection Surface
  subsection Imperfection
    set Fourier series = measured: Z15.csv      # rows k, l, A, B
    set Formula        = -0.463*measured        # in thicknesses of the wall, inward
  end
end
```

{data}

    cmake -DBIFACE_CYLINDER_SHAPES=FOLDER build && cmake --build build --target cylinders

## Unit and sign

{unit}

## Z15

![The measured shape of Z15; its displacement at the last equilibrium; and forces over the shortening up to the last equilibria](figures/cylinders.png)

*Left: the measured shape. Middle: the displacement since then, less its mean, at the last equilibrium, where it is
about to collapse. Right: the force up to there, with a step per point.*

{z15}

{variants}

{lower}

## Others of the design

{ten}

{survey}

{end_of_page}
"""


def write(path, shapes, data):
    wall = 4 * MEASURED["Z15"][1]
    reached = {name: max(result["force"]) for name, result in data.items()
               if isinstance(result["force"], list)}
    perfect = {mesh: data[f"perfect {mesh}"]["force"] for mesh in MESHES}
    base = perfect["coarse"]

    def row(words, force, of=base):
        return [words, f"{force:.1f}", f"{force / of:.2f}"]

    nominal = base * (NOMINAL * 4 / wall) ** 2
    meshes = [[f"{along} x {around}", f"{perfect[mesh]:.1f}",
               f"{reached[f'measured {mesh}']:.1f}",
               f"{reached[f'measured {mesh}'] / perfect[mesh]:.2f}"]
              for mesh, (along, around) in MESHES.items()]
    survey, ratios, forces = [], [], []
    for name, (_, ply) in MEASURED.items():
        scaled = base * (4 * ply / wall) ** 2
        ratios.append(reached[name] / scaled)
        forces.append(reached[name])
        survey.append([name, f"{4 * ply:.3f}", f"{4 * ply * largest(shapes, name):.2f}",
                       f"{LISTED[name]:.2f}", f"{scaled:.1f}", f"{reached[name]:.1f}",
                       f"{ratios[-1]:.2f}"])
    excess = [100 * (largest(shapes, name) / LISTED[name] - 1)
              for name in ("Z15", "Z17", "Z18")]
    # second order
    share = 1 / ((MESHES["medium"][1] / MESHES["coarse"][1]) ** 2 - 1)
    limit = {"perfect": perfect["medium"] + share * (perfect["medium"] - base),
             "measured": reached["measured medium"]
             + share * (reached["measured medium"] - reached["Z15"])}
    path.write_text(PAGE.format(
        introduction=fill("""
        A thin cylinder under axial compression carries less than the perfect one, since it is not round.
        Its shape can be measured, and is published as the coefficients of half waves of a cosine
        along the axis and whole waves around it. The entry
        [`Fourier series`](parameters.md#surface-imperfection) reads them, and the formula gives them
        unit and sign:"""),
        data=fill("""
        The shapes here are those of cylinders that DLR has built and tested
        ([Degenhardt et al. 2010](references.bib#Degenhardt2010)), k up to 10 and l up to 20, from the files
        Z15_measured.FC_A and so on in a [collection](references.bib#ImperfectionDataFourier) on GitHub. It has no
        license, so that neither the numbers nor a download of them are part of this project; the folder
        in which they are is an entry of CMake. Radii, thicknesses and elastic constants are those of
        [DESICOS 2015](references.bib#DESICOS2015), four plies at 24, -24, 41, -41 degrees from the inside, 500 mm
        long, E_L = 142500 MPa, E_T = 8700, nu = 0.28, G = 5100; the shear across the fibers of the plane,
        nu_TT = 0.4, is assumed. Both ends are clamped. The runs are those of
        [imperfect_cylinder.prm](../prm/imperfect_cylinder.prm) with other entries, about ten minutes on a core."""),
        unit=fill(f"""
        The collection does not say either. The coefficients are thicknesses of the wall, positive inward: nodes of
        finite elements that [Wagner 2021](references.bib#Wagner2021) has published for the same coefficients
        of Z07 and Z10 are closer to the axis by 0.50 mm times the series, and the wall is 0.5 mm. In
        millimeters the series of Z15, Z17 and Z18 would also be {excess[0]:.0f}, {excess[1]:.0f} and
        {excess[2]:.0f} % larger than anything that the database lists as measured on them, after the
        mean radius and the position and tilt of the axis are taken out, and Z15 would carry much less than
        any cylinder of the tests (below)."""),
        z15=fill(f"""
        The perfect cylinder is taken to buckle at the force of the linear prediction, in
        {data["perfect coarse"]["around"]} waves around. The one with
        the measured shape is compressed in steps of {STEP} mm, halved up to twice, to the last
        equilibrium that is found, within {STIFFNESS * STEP / 2**CUTS:.1f} kN. Forces in kN on two meshes:""")
        + "\n\n" + table(["Cells along and around", "Perfect", "Measured shape", "Ratio"], meshes)
        + "\n\n" + fill(f"""
        If the errors are of second order, as in the
        [benchmarks](verification.md#buckling-of-a-cylinder-with-axisymmetric-waves), the limits are about
        {limit["perfect"]:.1f} and {limit["measured"]:.1f} kN: {MESHES["coarse"][1]} cells around give
        {100 * (1 - base / limit["perfect"]):.0f} % too little for the perfect cylinder,
        {MESHES["medium"][1]} cells {100 * (1 - perfect["medium"] / limit["perfect"]):.0f} %, and
        {300 * round(np.sqrt((1 - base / limit["perfect"]) / 0.02) * MESHES["coarse"][1] / 300):.0f} would
        give 2 %. The ratio hardly depends on the mesh; all that follows is on the one of
        {MESHES["coarse"][1]} cells around."""),
        variants=table(["Z15", "kN", "over the perfect one"], [
            row("perfect", base),
            row("measured shape", reached["Z15"]),
            row("measured shape in mm, 2.2 times as large", reached["millimeters"]),
            row(f"perfect shape, pushed by {PUSH} N from the side", reached["push"]),
            row(f"plies of {NOMINAL} mm as designed, measured shape", reached["nominal"], nominal)]),
        lower=fill(f"""
        The force from the side is that of the single perturbation load approach; beyond a few newtons
        the collapse hardly depends on it, see [Z07](measured_tires.md#a-composite-cylinder-with-imperfections), which
        also has other forces, shapes of buckling and dents. With plies of {NOMINAL} mm the perfect force is
        {nominal:.1f} kN, that of Z15 times the square of the thickness."""),
        ten=fill(f"""
        Ten cylinders of this design failed between {TESTS[0]} and {TESTS[1]} kN; which of them at which
        force was not at hand. Six of them have their radius, mean thickness and shape here; perfect is
        the force of Z15 times the square of the thickness, and listed the largest deviation in
        the database."""),
        survey=table(["Cylinder", "Wall, mm", "Largest deviation, mm", "listed, mm", "Perfect, kN",
                      "Measured shape, kN", "Ratio"], survey),
        end_of_page=fill(f"""
        The measured shapes leave {min(ratios):.2f} to {max(ratios):.2f} of the force of the perfect cylinder.
        Forces on fine meshes are about {limit["measured"] / reached["Z15"]:.2f} times these, as for Z15:
        {min(forces) * limit["measured"] / reached["Z15"]:.1f} to
        {max(forces) * limit["measured"] / reached["Z15"]:.1f} kN. What
        else there is, an uneven load at the ends, a wall of varying thickness, and
        shorter waves than those of the series, is not in these runs, nor do the ends keep the
        measured shape: an imperfection is zero where supports hold the wall.""")),
        encoding="utf-8")


if __name__ == "__main__":
    arguments = parse()
    data = all_runs(Cylinders(arguments))
    draw(arguments.output / "figures/cylinders.png", arguments.shapes, data)
    write(arguments.output / "cylinders.md", arguments.shapes, data)
