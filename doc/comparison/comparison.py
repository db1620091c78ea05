#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the bias tire with biface and with CalculiX, and write comparison.md.

Both have the same mesh, true pressure and no friction. CalculiX (ccx) takes
composite shells S8R, which it expands to quadratic bricks; the plane is a rigid
brick.
"""

import argparse
import math
import os
import platform
import re
import subprocess
import sys
import textwrap
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, biface, table

# -------------------------------------- the tire of prm/bias_tire_true_pressure.prm

CENTER_RADIUS, RADIUS, THICKNESS = 200, 50, 4.8
ANGLES = (52, -52, 52, -52)  # from the inner face
E_L, E_T, G_LT, G_TT, NU_LT, NU_TT = 510.45, 6.91, 2.33, 1.77, 0.46, 0.95
PRESSURE = 0.15
APPROACHES = (5, 10, 15, 20)  # from the undeformed tire
MIDDLE = RADIUS + THICKNESS / 2
OUTER = RADIUS + THICKNESS
CROWN = CENTER_RADIUS + OUTER

# ------------------------------------------------------------ choices in CalculiX

GAP = 0.5  # between the undeformed tire and the plane, before it moves
SLOPE = 100  # contact pressure over penetration, MPa/mm
CLAMP = 3  # degrees, length of the cells that clamp the beads
NEAR = (60, 35)  # degrees in psi and phi, where contact is looked for

REFINED = 2  # cells of biface's finer mesh for one of the common mesh


def graded(begin, end, cells, first):
    """Coordinates from begin to end; cells grow geometrically from first."""
    low, high = 1.0, 10.0
    for _ in range(100):
        ratio = (low + high) / 2
        if first * sum(ratio**k for k in range(1, cells + 1)) < end - begin:
            low = ratio
        else:
            high = ratio
    sizes = [first * ratio**k for k in range(1, cells + 1)]
    return [begin + sum(sizes[:k]) for k in range(cells + 1)]


def lines():
    """The mesh lines in psi and phi, in degrees: those of the parameter file."""
    psi = ([-120 + 6.25 * i for i in range(12)] + [-45 + 5 * i for i in range(18)]
           + [45 + 6.25 * i for i in range(13)])
    outer = graded(15, 180, 11, 5 / 3)
    inner = [-15 + 5 / 3 * i for i in range(19)]
    return psi, [-x for x in outer[:0:-1]] + inner + outer[1:]


def half_lines():
    """The lines of the deck's nodes: those of the mesh, of the cells that clamp
    the beads, and halfway."""
    psi, phi = lines()
    psi = [psi[0] - CLAMP] + psi + [psi[-1] + CLAMP]
    return tuple(sorted(a + [(p + q) / 2 for p, q in zip(a, a[1:])])
                 for a in (psi, phi))


# ----------------------------------------------------------------------- the deck


def frame(psi, phi):
    """The unit vectors e_1, e_2, e_3 at a place of the surface."""
    s, t = math.radians(psi), math.radians(phi)
    return ((-math.sin(s) * math.cos(t), math.cos(s), -math.sin(s) * math.sin(t)),
            (-math.sin(t), 0, math.cos(t)),
            (math.cos(s) * math.cos(t), math.sin(s), math.cos(s) * math.sin(t)))


def surface(psi, phi, radius):
    """A place in the wall, by its distance from the center line."""
    t = math.radians(phi)
    normal = frame(psi, phi)[2]
    return [CENTER_RADIUS * math.cos(t) + radius * normal[0], radius * normal[1],
            CENTER_RADIUS * math.sin(t) + radius * normal[2]]


def numbers(values):
    """One line of the deck."""
    return ",".join(f"{x:.10g}" for x in values)


def in_rows(labels):
    """The lines of a set."""
    return [numbers(labels[i:i + 10]) + ","
            for i in range(0, len(labels), 10)]


def deck(half):
    """The input of ccx."""
    psi, phi = half[0][::2], half[1][::2]
    rows, columns = len(half[0]), len(half[1]) - 1
    node = {}
    text = ["*NODE"]
    for j in range(columns):
        for i in range(rows):
            if i % 2 and j % 2:
                continue
            node[i, j] = len(node) + 1
            text.append(numbers(
                [node[i, j]] + surface(half[0][i], half[1][j], MIDDLE)))

    cells = {}
    n_psi, n_phi = len(psi) - 1, len(phi) - 1
    for b in range(n_phi):
        for a in range(n_psi):
            cells[a, b] = len(cells) + 1
            # Nodes of ccx's shells have no rotations. A row of stiff cells beyond
            # each bead, all of whose nodes are held, clamps the wall.
            text.append("*ELEMENT, TYPE=S8R, ELSET="
                        + ("TIRE" if 0 < a < n_psi - 1 else "CLAMP"))
            i, j = 2 * a, 2 * b
            # the normal points outward
            corners = [(i, j), (i + 2, j), (i + 2, j + 2), (i, j + 2),
                       (i + 1, j), (i + 2, j + 1), (i + 1, j + 2), (i, j + 1)]
            text.append(numbers([cells[a, b]] + [
                node[p, q % columns] for p, q in corners]))

    text += ["*MATERIAL, NAME=CORD", "*ELASTIC, TYPE=ENGINEERING CONSTANTS",
             numbers([E_L, E_T, E_T, NU_LT, NU_LT, NU_TT, G_LT, G_LT]),
             numbers([G_TT]), "*MATERIAL, NAME=STEEL", "*ELASTIC", "200000,0.3"]
    for (a, b), cell in cells.items():
        if 0 < a < n_psi - 1:
            text += section(cell, (psi[a] + psi[a + 1]) / 2,
                            (phi[b] + phi[b + 1]) / 2)
    text += ["*SHELL SECTION, ELSET=CLAMP, COMPOSITE",
             *len(ANGLES) * [f"{THICKNESS / len(ANGLES)},,STEEL"]]

    near = [n for (a, b), n in cells.items()
            if abs(psi[a] + psi[a + 1]) < 2 * NEAR[0]
            and abs(phi[b] + phi[b + 1]) < 2 * NEAR[1]]
    text += ["*NSET, NSET=RIM"] + in_rows(
        [n for (i, _), n in node.items() if i < 3 or i >= rows - 3])
    text += ["*ELSET, ELSET=NEAR"] + in_rows(near)
    text += plane(len(node) + 1, len(cells) + 1)
    for step, delta in enumerate((-GAP,) + APPROACHES):
        text += ["*STEP, NLGEOM, INC=200", "*STATIC",
                 "0.25,1.,1e-4,1." if step == 0 else "0.25,1.,1e-4,0.5"]
        if step == 0:
            text += ["*DLOAD", f"TIRE,P,{PRESSURE}"]
        else:
            text += ["*BOUNDARY", f"PLANE,1,1,{-GAP - delta}"]
        # at the end of the step only
        text += ["*NODE PRINT, NSET=PLANE, TOTALS=ONLY, FREQUENCY=1000", "RF",
                 "*NODE FILE, OUTPUT=3D, FREQUENCY=1000", "U", "*END STEP"]
    return "\n".join(text) + "\n"


def section(cell, psi, phi):
    """The plies of a cell. CalculiX projects the axis L of a ply on the shell at
    the center of the cell; there the axes of the whole cell are taken."""
    e_1, e_2, _ = frame(psi, phi)
    text = []
    for name, angle in (("P", ANGLES[0]), ("M", ANGLES[1])):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        text += [f"*ORIENTATION, NAME={name}{cell}",
                 numbers([c * x + s * y for x, y in zip(e_1, e_2)]
                         + [c * y - s * x for x, y in zip(e_1, e_2)])]
    text += [f"*ELSET, ELSET=CELL{cell}", f"{cell},",
             f"*SHELL SECTION, ELSET=CELL{cell}, COMPOSITE"]
    return text + [f"{THICKNESS / len(ANGLES)},,CORD,"
                   f"{'P' if angle > 0 else 'M'}{cell}" for angle in ANGLES]


def plane(node, cell):
    """The rigid brick and its contact with the outer face of the cells nearby."""
    low, high = CROWN + GAP, CROWN + GAP + 20
    corners = [(x, y, z) for x in (low, high) for y, z in
               ((-150, -200), (-150, 200), (150, 200), (150, -200))]
    # its first face is that of its first four nodes, whose normal is -x
    return (["*NODE, NSET=PLANE"]
            + [numbers([node + k, *corner]) for k, corner in enumerate(corners)]
            + ["*ELEMENT, TYPE=C3D8, ELSET=BRICK",
               numbers([cell] + [node + k for k in (0, 3, 2, 1, 4, 7, 6, 5)]),
               "*SOLID SECTION, ELSET=BRICK, MATERIAL=STEEL",
               "*SURFACE, NAME=OUTER, TYPE=ELEMENT", "NEAR,SPOS",
               "*SURFACE, NAME=GROUND, TYPE=ELEMENT", "BRICK,S1",
               "*SURFACE INTERACTION, NAME=HARD",
               "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{SLOPE}",
               "*CONTACT PAIR, INTERACTION=HARD, TYPE=SURFACE TO SURFACE",
               "OUTER,GROUND", "*BOUNDARY", "RIM,1,3", "PLANE,1,3"])


# ------------------------------------------------------------------ the two runs


def measured(command, directory, log):
    """Run a command with one thread; CPU seconds and peak memory in MB."""
    with open(directory / log, "w", encoding="utf-8") as file:
        process = subprocess.Popen(
            command, cwd=directory, stdout=file, stderr=subprocess.STDOUT,
            env={**os.environ, "OMP_NUM_THREADS": "1",
                 "OPENBLAS_NUM_THREADS": "1"})
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{command[0]} failed, see {directory / log}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def run_calculix(program, directory):
    """The results of ccx."""
    half = half_lines()
    (directory / "tire.inp").write_text(deck(half), encoding="utf-8")
    seconds, memory = measured([program, "tire"], directory, "tire.log")
    data = (directory / "tire.dat").read_text(encoding="utf-8")
    forces = [abs(float(x)) for x in re.findall(
        r"total force \(fx,fy,fz\) for set PLANE.*\n\n\s+([-+.\dE]+)", data)]
    with open(directory / "tire.cvg", encoding="utf-8") as file:
        # step, increment, attempt, iteration, ...
        steps = [line.split()[0] for line in file if line.split()[0].isdigit()]
    iterations = [steps.count(step) for step in dict.fromkeys(steps)]
    if not len(forces) == len(iterations) == 1 + len(APPROACHES):
        sys.exit(f"{program} did not reach the end, see {directory / 'tire.log'}")
    nodes, displacements = read_frd(directory / "tire.frd")
    face = {place(x, half): n for n, x in nodes.items()
            if abs(section_radius(x) - OUTER) < THICKNESS / 10}
    inflated = displacements[0]
    opposite = max((at for at in face if at[0] == 0), key=lambda at: abs(at[1]))
    sizes = []
    for delta, moved in zip(APPROACHES, displacements[1:]):
        deformed = {at: [x + u for x, u in zip(surface(*at, OUTER), moved[n])]
                    for at, n in face.items()}
        sizes.append(footprint(deformed, half, CROWN - delta))
    return {"inflation": inflated[face[0, 0]][0],
            "opposite": -inflated[face[opposite]][0],
            "forces": forces[1:], "sizes": sizes,
            "iterations": iterations, "seconds": seconds, "memory": memory}


def section_radius(x):
    """The distance from the center line of the section."""
    return math.hypot(math.hypot(x[0], x[2]) - CENTER_RADIUS, x[1])


def place(x, half):
    """psi and phi of a node; the file has its place to six digits only."""
    return tuple(min(values, key=lambda value, at=at: abs(value - at))
                 for values, at in zip(half, (
                     math.degrees(math.atan2(
                         x[1], math.hypot(x[0], x[2]) - CENTER_RADIUS)),
                     math.degrees(math.atan2(x[2], x[0])))))


def read_frd(path):
    """The nodes, and the displacements of each step by node."""
    nodes, steps, block = {}, [], None
    with open(path, encoding="latin-1") as file:
        for line in file:
            key = line[:5]
            if key == "    2":
                block = nodes
            elif key == " -4  ":
                block = None
                if line.split()[1] == "DISP":
                    steps.append({})
                    block = steps[-1]
            elif key[:3] == " -3":
                block = None
            elif key[:3] == " -1" and block is not None:
                block[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k])
                                          for k in range(3)]
    return nodes, steps


def footprint(deformed, half, ground, parts=8):
    """Length, width and area of the zone of contact: of the convex hull of those
    parts of the quadratic outer face that reach the plane, from the deformed
    places of its nodes."""
    # the coordinates xi, eta of the nodes of a cell, and samples of the cell
    corners = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]
    samples = [-1 + 2 * k / parts for k in range(parts + 1)]
    weights = [[weight(corner, xi, eta) for corner in corners]
               for xi in samples for eta in samples]
    zone = []
    for i in range(1, len(half[0]) - 1, 2):
        for j in range(1, len(half[1]) - 1, 2):
            # cells that cannot touch
            if max(abs(half[0][i]), abs(half[1][j])) > 60:
                continue
            cell = [deformed[half[0][i + x], half[1][j + y]] for x, y in corners]
            for sample in weights:
                x = [sum(w * node[k] for w, node in zip(sample, cell))
                     for k in range(3)]
                if x[0] >= ground:
                    zone.append((x[2], x[1]))
    zone.sort()
    edge = half_hull(zone) + half_hull(zone[::-1])
    area = sum(p[0] * q[1] - q[0] * p[1]
               for p, q in zip(edge, edge[1:] + edge[:1])) / 2
    return [*(max(x[k] for x in edge) - min(x[k] for x in edge)
              for k in (0, 1)), abs(area)]


def half_hull(points):
    """The part of the convex hull from the first to the last of sorted points,
    without the last."""
    hull = []
    for x, y in points:
        while len(hull) > 1:
            (x_0, y_0), (x_1, y_1) = hull[-2:]
            if (x_1 - x_0) * (y - y_0) > (y_1 - y_0) * (x - x_0):
                break
            hull.pop()
        hull.append((x, y))
    return hull[:-1]


def weight(corner, xi, eta):
    """The quadratic shape function of a node of a cell with eight nodes."""
    x, y = corner
    if x and y:
        return (1 + x * xi) * (1 + y * eta) * (x * xi + y * eta - 1) / 4
    if x:
        return (1 + x * xi) * (1 - eta**2) / 2
    return (1 - xi**2) * (1 + y * eta) / 2


def run_biface(program, directory, mass, refined=1):
    """The results of biface, by consistent or lumped multipliers; inflation, then
    a stage to each of the approaches, which biface counts from the inflated
    tire."""
    template = EXAMPLES / "bias_tire_true_pressure.prm"
    name = f"{mass}_{refined}"

    def run(stages, output):
        settings = {"Output/Write VTU": "false",
                    "Contact/Multiplier mass": mass,
                    "Number of stages": len(stages) + 1}
        if refined > 1:
            settings["Mesh/Intervals alpha_1"] = ", ".join(
                f"{begin}:{end}:{refined * cells}" for begin, end, cells in
                ((-120, -45, 12), (-45, 45, 18), (45, 120, 12)))
            settings["Mesh/Intervals alpha_2"] = (
                f"-180:-15:{refined * 11}:smooth, -15:15:{refined * 18}, "
                f"15:180:{refined * 11}:smooth")
        for i, stage in enumerate(stages, start=2):
            for entry, value in stage.items():
                settings[f"Stage {i}/{entry}"] = value
        command = [program, "--quiet", "--output", output]
        for entry, value in settings.items():
            command += ["--set", f"{entry}={value}"]
        return measured(command + [str(template)], directory, output + ".log")

    common = {"Strain theory": "nonlinear", "Pressure": PRESSURE, "Steps": 1}
    run([{"Name": "hold", **common, "Contact": "false", "Travel": 0}],
        name + "_inflated")
    profile = biface.Results(directory / f"{name}_inflated").profile()
    inflation = profile.where(alpha_1=0)["outer_x"][0] - CROWN
    # stages end where the plane has traveled so far in all
    seconds, memory = run(
        [{"Name": f"contact {delta}", **common, "Contact": "true",
          "Travel": inflation + delta} for delta in APPROACHES], name)
    results = biface.Results(directory / name)
    stages = [results.stage(stage) for stage in results.stages]
    return {"inflation": inflation,
            "forces": [stage.last("force") for stage in stages[1:]],
            "sizes": [[stage.last("footprint_" + size)
                       for size in ("length", "width", "area")]
                      for stage in stages[1:]],
            "iterations": [int(stage.history["iterations"].sum()) for stage in stages],
            "seconds": seconds, "memory": memory}


# ----------------------------------------------------------------------- the page


def fill(text):
    return "\n\n".join(textwrap.fill(" ".join(part.split()), 88,
                                     break_on_hyphens=False)
                       for part in text.strip().split("\n\n"))


def machine():
    """The processor, as its maker calls it."""
    try:
        info = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        info = ""
    found = re.search(r"model name\s*:\s*(.*)", info)
    return found.group(1) if found else platform.machine()


def version(program):
    done = subprocess.run([program, "-v"], check=False, capture_output=True,
                          text=True)
    found = re.search(r"Version\s+(\S+)", done.stdout)
    return found.group(1) if found else "of unknown version"


def page(runs, fine, ccx_version):
    """The page, from runs on the common mesh by name and of biface on a finer
    one."""
    calculix, consistent = list(runs.values())[:2]
    mesh = f"{42 * REFINED} × {40 * REFINED}"
    columns = {**runs, f"biface, consistent, {mesh}": fine}

    forces, sizes, limits, cells = [], [], [], []
    for i, delta in enumerate(APPROACHES):
        reference = calculix["forces"][i]
        values = [run["forces"][i] for run in columns.values()]
        # errors decrease with the square of the size of the cells
        values.append(fine["forces"][i] + (fine["forces"][i]
                                           - consistent["forces"][i])
                      / (REFINED**2 - 1))
        deviations = [100 * (value / reference - 1) for value in values]
        limits.append(deviations[-1])
        # how many times as many cells biface needs for the error of CalculiX
        cells.append((consistent["forces"][i] - values[-1])
                     / (values[-1] - reference))
        forces.append([f"{delta}", f"{reference:.1f}"] + [
            f"{value:.1f} ({deviation:+.1f} %)"
            for value, deviation in list(zip(values, deviations))[1:]])
        sizes.append([f"{delta}"] + [
            "{:.1f} × {:.1f}, {:.0f}".format(*run["sizes"][i])
            for run in columns.values()])
    faster = calculix["seconds"] / consistent["seconds"]
    costs = [[name, " + ".join(map(str, run["iterations"])),
              f"{sum(run['iterations'])}", f"{run['seconds']:.1f}",
              f"{run['memory']:.0f}"] for name, run in runs.items()]
    return "\n\n".join([
        "<!-- Written by doc/comparison/comparison.py: cmake --build build "
        "--target comparison -->",
        "# Comparison with CalculiX",
        fill(f"""
        The [bias tire](bias_tire.md) under true pressure and without friction
        (`prm/bias_tire_true_pressure.prm`), computed with biface and with
        [CalculiX](https://www.calculix.de) {ccx_version}, a general finite element
        program. Both have the same mesh of 42 × 40 cells. The approach Δ is
        counted from the undeformed tire here, so that it does not depend on the
        computed inflation.
        """),
        "## The model in CalculiX",
        "\n".join("- " + textwrap.fill(" ".join(item.split()), 86,
                                       subsequent_indent="  ") for item in (
            """Composite shells of eight nodes, S8R, on the middle surface of the
            wall. CalculiX expands each into one brick of 20 nodes with reduced
            integration in each ply.""",
            """CalculiX projects the axes of a ply on the shell at the center of a
            cell and uses them in all of it. Toward its edges the cords lean out
            of the wall: by half the angle of the cell, which is 2.5° by 0.8° in
            the footprint and 3.1° by 22° opposite to it. biface takes the axes at
            each vertex.""",
            f"""Shell nodes have no rotations. A row of stiff cells {CLAMP}° long
            beyond each bead, with all nodes held, clamps the wall.""",
            """The pressure acts on the inner face and follows it.""",
            f"""Contact from surface to surface with the face of a rigid brick and
            a penalty of {SLOPE} MPa/mm: a pressure of {PRESSURE} MPa penetrates by
            {PRESSURE / SLOPE:g} mm. The increments are those CalculiX chooses,
            from a quarter of a step on.""")),
        fill(f"""
        Inflation moves the crown of the outer face, above the middle of the
        footprint to be, by {calculix['inflation']:.3f} mm along the radius in
        CalculiX and by {consistent['inflation']:.3f} mm in biface. On the
        opposite side, between the longest cells, it moves by
        {calculix['opposite']:.3f} mm in CalculiX. By symmetry it should move by
        the same: these cells are too long for constant axes and parabolic sides.
        They are far from the footprint.
        """),
        "## Forces (N)",
        table(["Δ (mm)", *columns, "biface, limit"], forces),
        fill(f"""
        In parentheses: deviation from CalculiX. The last column extrapolates the
        forces on both meshes with consistent multipliers to cells of size 0; the
        error of biface's bilinear element decreases with the square of their size,
        see [bias_tire.md](bias_tire.md#mesh-error). So most of the difference on the
        common mesh is the mesh error of biface. What is left,
        {min(limits):.1f} to {max(limits):.1f} %, contains that of CalculiX, whose
        plies and elements also differ from biface's as described above.
        """),
        "## Footprints: length × width (mm), area (mm²)",
        table(["Δ (mm)", *columns], sizes),
        fill("""
        Those of biface are the columns of [history.csv](output.md#historycsv).
        Those of CalculiX are those of the convex hull of the parts of its quadratic
        outer face that reach the plane.
        """),
        "## Cost",
        table(["", "Iterations: inflation + approaches", "In all", "CPU s",
               "Memory (MB)"], costs),
        fill(f"""
        Measured in one run of the target, one thread each, on {machine()}.
        CalculiX takes {faster:.0f} times as much time as biface with consistent
        multipliers on the same mesh. At equal error it takes {faster / max(cells):.0f}
        to {faster / min(cells):.0f} times as much: if what is left in the table of
        forces is the error of CalculiX, biface needs {min(cells):.1f} to
        {max(cells):.1f} times as many cells for the same error, and its time grows in
        proportion to their number. The quadratic bricks of CalculiX have nearly four
        times as many unknowns; each has eight integration points in each of its four
        plies, and at all of them CalculiX rotates the stiffness of the ply again in
        every iteration. It reaches each approach in several increments, biface in one
        step. CPU times also depend on
        what else the machine does: 3 to 6 s were measured for the same run of
        biface.
        """),
        "## Reproducing this page",
        fill("On Debian 12:"),
        "```sh\nsudo apt-get install calculix-ccx\ncmake -S . -B build\n"
        "cmake --build build --target comparison\n```",
        fill("""
        Without `ccx` this target does not exist. The deck `tire.inp` and the results
        of both programs are in `doc/comparison/runs` of the build directory.
        """)]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", required=True, help="the program biface")
    parser.add_argument("--calculix", required=True, help="the program ccx")
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True,
                        help="where to write comparison.md")
    arguments = parser.parse_args()
    arguments.scratch.mkdir(parents=True, exist_ok=True)

    def biface(*options):
        return run_biface(arguments.program, arguments.scratch, *options)

    fine = biface("consistent", REFINED)
    runs = {"biface, consistent": biface("consistent"),
            "biface, lumped": biface("lumped")}
    runs = {"CalculiX": run_calculix(arguments.calculix, arguments.scratch), **runs}
    (arguments.output / "comparison.md").write_text(
        page(runs, fine, version(arguments.calculix)), encoding="utf-8")


if __name__ == "__main__":
    main()
