#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write any_mesh.md: how meshes from files are used, and published benchmarks
on regular and irregular meshes of Gmsh's format, which this script writes."""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from scipy.integrate import solve_bvp

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import biface, parse_arguments, table
from meshes import Runner, at, displacement, isotropic, joined, mapped, triangles
from published import (large_table, modes_table, nafems_table, other_table,
                       thin_elliptic_membrane)

PAGE = """<!-- Written by doc/any_mesh/any_mesh.py: cmake --build build --target any_mesh -->

# Meshes from files

A shell need not be a plane or a surface of revolution: with `Surface/Type = mesh` its surface is a mesh of
quadrilaterals, flat or warped, of any shape that is convex; triangles are divided into some. [plate_with_hole.prm](../prm/plate_with_hole.prm)
and [rubber_dome.prm](../prm/rubber_dome.prm) are examples.

    build/biface prm/rubber_dome.prm

```
subsection Surface
  set Type = mesh
  subsection Mesh
    set File      = part.msh
    set Direction = 1; 0; 0
  end
end
subsection Supports
  set Edge supports = rim: fixed, cut: symmetry y
end
subsection Loads
  set Edge forces = flange: 0 0 -2.5
end
```

- **File**: MSH 2.2 or 4.1 of Gmsh, in ASCII, or an input file of Abaqus or CalculiX with shells (S4R, S3, S8R, ...). Gmsh
  converts others, without the names of groups: `gmsh part.bdf -save -o part.msh`. Cells of second order count as those of their corners. Parts that were meshed one by one
  have nodes of their own at their common lines: `Merge distance` makes one of nodes that are so close.
- **Triangles and finer meshes**: `Refine = 1` divides each triangle into three quadrilaterals and each quadrilateral into four, with their
  groups; `Refine = 2` does so twice. In Gmsh, `Recombine Surface` makes quadrilaterals, of which fewer are needed. A set of nodes gets
  the new ones on the free sides and folds between its nodes, and others unless these lie between nodes of such sides.
- **Geometry**: a mesh of a curved surface must know it to be refined, since the parts of a flat cell are facets. `Geometry` is a formula
  of x, y and z that is zero on the surface, such as `x^2 + y^2 + z^2 - 50^2`, and for several surfaces
  `z > 0 ? x^2 + y^2 + z^2 - 50^2 : x^2 + y^2 - 50^2`; `Geometry file` is a STEP file of any CAD program, in the unit of `Units`. All nodes, also those of the
  file, are moved to the surface and have its normals. New nodes of a rim or of a fold are on the edges of the STEP file; a formula knows none, so that they
  move along its gradient, and a condition such as `z > 0` must change beside the nodes of a fold, not at them. Of a solid, nodes stay on the faces on which those of
  the file are. A number of the formula is a parameter of the shape for [`Sensitivities`](parameters.md#sensitivities) and studies.
- **Names**: a `Physical Curve` is an edge, for `Edge supports`, `Edge forces` and `Edge moments`, and a
  `Physical Point` is a named point, for supports, forces, probes and control. Other points are given by their
  positions, `Named points = tip: 0 0 12.5`; they must be nodes. In Gmsh, anything without a physical group is not
  saved as soon as there is one, so that the surfaces need a group, too. In an input file a `*NSET` of several nodes is an
  edge, along the free sides and the folds between them, and one of a single node is a point; their names are in capitals. The lines that Gmsh writes as
  trusses (T3D2), without a section, are edges, too.
- **Outward** is where the nodes of the cells run counterclockwise. All cells of a connected part take the
  orientation of the first one. Pressure acts on the inner face and contact on the outer one, unless told
  otherwise.
- **Direction** is the direction of alpha_1, from which the angles of plies count: a vector, or a formula of the
  position, that is projected into the surface. `-y; x; 0` runs around the z axis. Components v_1 and v_2 of
  supports and `local` loads are along it and across it.
- **Plies by group**: `cord: 1 @ 30 in flange` in `Laminate/Plies` covers only the cells of the group `flange` (a
  `Physical Surface` or an `*ELSET`). Where groups meet, their walls share the
  displacements of the director, as where a ply ends on other shells, and contact sees the mean of their faces. Plies of all groups
  stand in one list, by which `Layers` and `Initial ply stresses` count them.
- **Plies that vary**: thickness, angle and initial stress may be formulas of `x`, `y`, `z`, such as `cord: 2-0.01*x @ 30`:
  a node has the thickness of its place, and a cell the stiffness of its center.
- **Normals** are those of the `Geometry`, or else the means of the cells around a node. Edges with `symmetry x`, `symmetry y` or `symmetry z` keep
  their normals in the plane of symmetry.
- **Folds**: cells that meet at more than `Fold angle`, 20 degrees, belong to different parts of the shell, which are
  joined rigidly; the run says how many such sides there are. On a coarse mesh of a smooth surface the angle should be larger. Three cells or more
  may meet at a side: those that go on smoothly remain one part. `Joints = lid: hinge, seam: 2.5` releases the sides of a
  `Physical Curve`, or of the nodes of an `*NSET`, or gives them a stiffness: the moment per length and per angle in
  radians. Parts that meet only at sides of three cells or more have their own orientations. Supports, loads and probes along
  a line or at a point of a fold are those of the part of its first cell in the file; the displacement of the reference surface is
  the same for all of them. See
  [theory.md](theory.md#folds-and-joints).
- **Elements** are those of `Formulation = standard` ([theory.md](theory.md#elements-that-know-a-rigid-motion)):
  other values are refused.

The nodes must lie on the surface within a tenth of the thickness: a plate whose nodes are off its plane by 0.3 of its
thickness is 7 % softer, as a crumpled plate is. The mesh itself is the surface: where cells turn by an angle
$`\\theta`$, the chords are shorter than the arcs by $`\\theta^2/24`$.

A sealed gas needs a cavity that is closed by the shell, by planes of symmetry, or by edges that are held (then its
volume must be given). All of the shell bounds this one cavity: partitions and fins are refused, and parts that are apart share the gas. What needs coordinates is refused in one sentence before the first step: rolling and heat, end
plates, multigrid and coarse meshes, and plies and imperfections by alpha_1 and alpha_2. Layers, rubber, cords that go slack and
relaxation are those of other shells. Derivatives of the length, width and area of the footprint are refused, too, since these jump by
half a cell with a node.
The places of maxima in history.csv, which are coordinates, are nan.

## Published values on regular and irregular meshes

Computed over published. On *random* meshes the nodes are moved by up to a quarter of a cell at random, those of
edges along them; on *graded* ones opposite edges are divided 1 : 2 : … : n in opposite directions. MITC4 is the usual four-node shell element
(covariant membrane strains at 2 × 2 points, tied shear) with the same unknowns, on random and graded meshes of its own.

{linear}

- Scordelis-Lo roof under its weight, a quarter, 0.3024; cylinder between diaphragms, pinched, an eighth, with
  both faces held; hemisphere with a hole of 18 degrees, pinched, a quarter, 0.0935 @cite MacNealHarder1985 .
- Beam twisted by 90 degrees, thickness 0.32 and 0.0032: 0.005424, 0.001754, 5.256 and 1.294 (for a millionth of the force) in and out
  of its plane @cite MacNealHarder1985 .
- Skew plate of 60 degrees, two edges simply supported, L/t = 100, under pressure: 0.7945 (Razzaque).

The hemisphere on a random mesh of 4 × 4 cells, each cut into two triangles, as it is divided:

{divided}

Large displacements of the hemisphere at P = 400, in one step; the last column is the number of iterations:

{nonlinear}

## Benchmarks of NAFEMS

{nafems}

- LE1 @cite NAFEMS1990 , a quarter of an elliptic plate with an elliptic hole, 0.1 m thick, with semiaxes of 3.25 × 2.75 m and
  2 × 1 m, pulled at its outer edge by 10 MPa: the stress along the edge of the hole at D. The target is that of plane stress. In
  biface the wall thins continuously from place to place, which raises the peak by terms of the thickness: 0.001 m thick, the last regular mesh has
  {thin}. The rest is the stress at a node of a free edge, which is of first order in the size of the cells.
- LE2 @cite NAFEMS1990 , 30 degrees of a cylinder of radius 1 m, 0.5 m long and 0.01 m thick, clamped along one generator, with planes of
  symmetry at both ends. Along the other generator there are 1 kN m/m, or 60 MPa in the direction of the tangent, with a pressure of 0.6 MPa on the wall.
  The tangent is given in Cartesian components: at a free edge, `local` is along the last cell. Under a
  membrane force N, the stresses on the faces differ from N/h by $`\\pm\\tfrac32 N/R`$, here 1.5 %, since plies are integrated over
  the lengths of the middle surface ([`Laminate/Integrals`](parameters.md#laminate)).
- LE3 @cite NAFEMS1990 , a closed hemisphere of radius 10 m, 0.04 m thick, E = 68.25 GPa, with 2 kN outward at A and inward at C on a quarter, which is
  three patches of cells. The force over the modulus is twice that of MacNeal and Harder @cite MacNealHarder1985 , and so is the
  displacement: theirs is 0.0924 without a hole.
- R0031/1 @cite NAFEMSR0031 , a strip [0/90/0/90/0/90/0] of 30 mm between supports, 10 mm wide and 1 mm thick (the middle ply 0.4 mm,
  the others 0.1 mm), under 10 N/mm at midspan: deflection, stress on the tensile side at midspan, and shear stress between the two
  lowest plies 4 mm away. The bending moment has a kink at the load, which cells round off.

Frequencies of square plates, 10 m wide and 0.05 m thick (E = 200 GPa, ν = 0.3, 8000 kg/m³), with 8 × 8, 16 × 16 and 32 × 32
cells. By Ritz's method with polynomials, some of the published values are up to {excess} % too high for thin plates:

{modes}

## Other linear benchmarks

{other}

- Cook's membrane @cite Cook1974 , 48 wide, 44 and 16 high, 1 thick, E = 1, ν = 1/3, under the shear force 1, without units: the displacement of
  the middle of its end. 23.96 is the limit of fine meshes in the literature.
- Skew plate of Morley @cite Morley1963 of side a and thickness h under a uniform load q, simply supported: 1000 w D/(q a⁴) at its center. For thin plates,
  0.408 is the value of Morley and that of two problems of membranes, solved by Ritz's method. At h/a = 1/100 it is 4 % more, since the edges are free to
  twist: 0.424 is that of the theory of Reissner and Mindlin by Ritz's method with polynomials of degree 40. Moments
  are infinite at the obtuse corners; the cells are small at the edges.
- Raasch's hook @cite Knight1997 , two arcs with radii of 14 and 46 in, 20 in wide and 2 in thick, E = 3300 psi, ν = 0.35, under 1 lb along the width at its
  end, with `Transverse shear = equilibrium`. 5.02 in is the value of solid elements in the Abaqus Benchmarks Guide. Knight's is
  4.9352 in; the last random mesh has {hook} of it.
- Hyperboloid r² = 1 + y², −1 ≤ y ≤ 1 (m), E = 200 GPa, ν = 1/3, under the pressure cos 2θ MPa @cite HillerBathe2003 : the strain energy. The targets are those of
  three-dimensional elasticity by Ritz's method, with polynomials of degree 46 along the meridian and 2 across the wall. With free
  ends the shell bends without stretching.

## Large displacements

{large}

The values of Sze, Liu and Lo @cite SzeLiuLo2004 are those in [verification.md](verification.md), which has the same cases on lines of coordinates
and the reasons of deviations of the order of h². There are no units:

- a plate of radii 6 and 10 and thickness 0.03, E = 21·10⁶, ν = 0, lifted by 0.8 per length at one lip of a slit, the other being clamped, in one step. The slit is
  0.004° wide, since nodes at the same place are refused;
- a cylinder of radius 4.953, length 10.35 and thickness 0.094, E = 10.5·10⁶, ν = 0.3125, pulled by two forces P = 40000 in 20 steps:
  displacements under a force, a quarter turn away from it, and at the end;
- roofs of radius 2540, half angle 0.1 rad and half length 254, E = 3102.75, ν = 0.3, hinged along their straight edges, that snap through under a
  force at their center, with arc length control: the first maximum and, for h = 12.7, the minimum of the force over 3000.

![A hook, a slit annular plate and a pulled cylinder, deformed, on irregular meshes](figures/any_mesh.png)

*Raasch's hook with ten times its displacements, the slit annular plate and the pulled cylinder, on random meshes.*

## Folds

A strip of two legs of the length L = 6 that meet at a right angle, clamped at one end, with n cells on each leg: its displacement
under a force at the other end over that of a beam; and the
distance from the clamped end that a moment leaves which bends each leg by 90 degrees, so that both ends meet:

{folded_strip}

The last is the error of the chords, which a straight strip has as well. A square tube of length 10, side 1 and thickness 0.02 in torsion turns by {torsion} of Bredt's
formula, with 4 × 40 cells on each side.

NAFEMS LE5, a cantilever of Z section in torsion: the axial stress at point A, -108 MPa, and the rotation of the end,
0.0306 without transverse shear (Vlasov):

{z_section}

A nozzle of radius 100 and height 200 mm in a spherical head of radius 500 mm, as in
[nozzle.prm](../prm/nozzle.prm), under the pressure 1 MPa: the joint moves outward by u_r and along the axis by u_z (mm), and
the hoop stress there in the middle of the nozzle's wall (MPa). Theory is that of thin shells with transverse shear,
solved as a boundary value problem by SciPy, with the pressure on the inner faces and on the gap between them at the joint, which pushes
it outward by the thickness over two:

{nozzle}

## A hole in an orthotropic plate

The stress along the fibers at the edge of the hole of [plate_with_hole.prm](../prm/plate_with_hole.prm) over
the stress far away. In an infinite plate it is $`1+\\sqrt{{2(\\sqrt{{E_L/E_T}}-\\nu_{{LT}})+E_L/G_{{LT}}}}`$
(Lekhnitskii):

{hole}

The stress falls by half within a fifth of the radius of the hole, so that cells there have to be small: the file is
[plate_with_hole.geo](../prm/plate_with_hole.geo), with the mesh graded in rings.
"""


def hemisphere(u, v):
    longitude, latitude = np.pi / 2 * u, np.radians(72) * v
    return (10 * np.cos(latitude) * np.cos(longitude),
            10 * np.cos(latitude) * np.sin(longitude), 10 * np.sin(latitude))


def cylinder(radius, length, angle):
    return lambda u, v: (length * u, radius * np.sin(np.radians(angle) * v),
                         radius * np.cos(np.radians(angle) * v))


def twisted_beam(u, v):
    angle, across = np.pi / 2 * u, 1.1 * (v - 0.5)
    return 12 * u, across * np.cos(angle), across * np.sin(angle)


def skew_plate(angle):
    return lambda u, v: (100 * u + 100 * np.cos(np.radians(angle)) * v,
                         100 * np.sin(np.radians(angle)) * v, 0 * u)


@dataclass
class Benchmark:
    """A linear benchmark: the published displacement of a point."""
    name: str
    surface: Callable
    young: float
    poisson: float
    thickness: float
    supports: str
    loads: dict
    point: str
    component: str
    published: float
    cells: dict
    mitc4: dict
    points: str = ""


PINCH = {"Loads/Point forces": "A: 1 0 0, B: 0 -1 0"}
QUARTERS = "west: symmetry y, east: symmetry x"

THIN_BEAM = {"regular": [(12, 2), (24, 4), (48, 8)],
             "random": [(12, 2), (24, 4), (48, 8), (96, 16)]}

BENCHMARKS = [
    Benchmark("Scordelis-Lo roof", cylinder(25, 25, 40), 4.32e8, 0, 0.25,
              "west: symmetry x, south: symmetry y, east: y middle; z middle",
              {"Loads/Area force": "0, 0, -90"}, "D", "u_z", -0.3024,
              {kind: [(4, 4), (8, 8), (16, 16)] for kind in ("regular", "random", "graded")},
              {"regular": ".946 .973 .989", "random": ".918 .964 .985",
               "graded": ".875 .934 .975"}),
    Benchmark("pinched cylinder", cylinder(300, 300, 90), 3e6, 0.3, 3,
              "west: symmetry x, south: symmetry y, north: symmetry z, "
              "east: y both; z both",
              {"Loads/Point forces": "A: 0 0 -0.25"}, "A", "u_z", -1.82488e-5,
              {kind: [(8, 8), (16, 16), (32, 32)] for kind in ("regular", "random", "graded")},
              {"regular": ".746 .929 .989", "random": ".627 .913 .984",
               "graded": ".570 .866 .967"}),
    Benchmark("hemisphere", hemisphere, 6.825e7, 0.3, 0.04, QUARTERS, PINCH, "A", "u_x",
              0.0935,
              {kind: [(4, 4), (8, 8), (16, 16)] for kind in ("regular", "random", "graded")},
              {"regular": "1.030 .999 .995", "random": ".280 .666 .961",
               "graded": ".136 .730 .971"}, points="A: z middle"),
    Benchmark("twisted beam, in plane", twisted_beam, 29e6, 0.22, 0.32, "west: fixed",
              {"Loads/Point forces": "E: 0 0 1"}, "E", "u_z", 0.005424,
              {kind: [(12, 2), (24, 4), (48, 8)] for kind in ("regular", "random")},
              {"regular": ".988 .995 –", "random": "– .993 –"}),
    Benchmark("twisted beam, out of plane", twisted_beam, 29e6, 0.22, 0.32, "west: fixed",
              {"Loads/Point forces": "E: 0 1 0"}, "E", "u_y", 0.001754,
              {kind: [(12, 2), (24, 4), (48, 8)] for kind in ("regular", "random")},
              {"regular": ".915 .971 –", "random": "– .959 –"}),
    Benchmark("thin twisted beam, in plane", twisted_beam, 29e6, 0.22, 0.0032, "west: fixed",
              {"Loads/Point forces": "E: 0 0 1e-6"}, "E", "u_z", 0.005256,
              THIN_BEAM,
              {"regular": ".978 .991 –", "random": "– .502 – –"}),
    Benchmark("thin twisted beam, out of plane", twisted_beam, 29e6, 0.22, 0.0032,
              "west: fixed", {"Loads/Point forces": "E: 0 1e-6 0"}, "E", "u_y", 0.001294,
              THIN_BEAM,
              {"regular": ".973 .992 –", "random": "– .523 – –"}),
    Benchmark("skew plate", skew_plate(60), 1092, 0.3, 1,
              "south: z middle, north: z middle",
              {"Loads/Area force": "0, 0, 1e-4"}, "M", "u_z", 0.7945,
              {"regular": [(4, 4), (8, 8), (16, 16)]},
              {"regular": ".847 .956 .986"}, points="M: x middle; y middle, A: x middle"),
]


def run(runner, benchmark, kind, size, entries):
    name = f"{benchmark.name}_{kind}_{size[0]}".replace(" ", "_").replace(",", "")
    return runner.run(
        name, mapped(benchmark.surface, *size, kind),
        {**isotropic(benchmark.young, benchmark.poisson, benchmark.thickness),
         "Supports/Edge supports": benchmark.supports,
         "Supports/Point supports": benchmark.points, **benchmark.loads, **entries})


def linear_table(runner):
    rows = []
    for benchmark in BENCHMARKS:
        for kind, sizes in benchmark.cells.items():
            ratios = [displacement(run(runner, benchmark, kind, size, {}), benchmark.point,
                                   benchmark.component) / benchmark.published
                      for size in sizes]
            rows.append([benchmark.name if kind == "regular" else "",
                         kind, ", ".join(f"{n} × {m}" for n, m in sizes),
                         " ".join(f"{ratio:.3f}" for ratio in ratios),
                         benchmark.mitc4[kind]])
    return table(["Case", "Mesh", "Cells", "biface", "MITC4"], rows)


def divided_table(runner):
    pinched = next(b for b in BENCHMARKS if b.name == "hemisphere")
    rows = []
    for n in (1, 2, 3):
        row = [str(n), str(96 * 4**(n - 1))]
        for formula in ("x^2 + y^2 + z^2 - 10^2", ""):
            results = runner.run(
                f"divided_{n}_{'known' if formula else 'facets'}",
                triangles(mapped(hemisphere, 4, 4, "random")),
                {**isotropic(pinched.young, pinched.poisson, pinched.thickness),
                 "Supports/Edge supports": pinched.supports,
                 "Supports/Point supports": pinched.points, **pinched.loads,
                 "Surface/Mesh/Refine": n, "Surface/Mesh/Geometry": formula})
            row.append(f"{displacement(results, 'A', 'u_x') / pinched.published:.3f}")
        rows.append(row)
    return table(["Refine", "Cells", "with the formula of the sphere", "facets, no Geometry"],
                 rows)


def nonlinear_table(runner):
    pinched = next(b for b in BENCHMARKS if b.name == "hemisphere")
    rows = []
    for kind, mitc4 in (("regular", "3.957, 7.762"), ("random", "3.856, 7.400"),
                        ("graded", "3.593, 6.750")):
        results = run(runner, pinched, kind, (16, 16),
                      {"Stage 1/Strain theory": "nonlinear",
                       "Loads/Point forces": "A: 200 0 0, B: 0 -200 0"})
        rows.append([f"{kind}, 16 × 16",
                     f"{displacement(results, 'A', 'u_x'):.3f}, "
                     f"{-displacement(results, 'B', 'u_y'):.3f}",
                     "4.067, 8.178", mitc4,
                     str(int(results.history["iterations"].sum()))])
    return table(["Mesh", "biface", "Published (Sze)", "MITC4", "Iterations"], rows)


def run_joined(runner, name, mesh, young, poisson, thickness, entries):
    return runner.run(name, mesh, {"Surface/Mesh/Fold angle": 20,
                                   **isotropic(young, poisson, thickness), **entries})


def folded_strip_table(runner):
    length, young = 6, 1000
    rows = []
    for n in (8, 16, 32, 64):
        mesh = joined([(lambda u, v: (length * u, v, 0 * u), n, 1),
                       (lambda u, v: (length + 0 * u, v, length * u), n, 1)],
                      {"clamp": at(0, 0), "tip": at(2, length)}, {"T": (length, 0, length)})
        row = [str(n)]
        for thickness in (0.1, 0.5):
            bending = young * thickness**3 / 12
            results = run_joined(runner, f"strip_{n}_{thickness}", mesh, young, 0, thickness,
                                 {"Supports/Edge supports": "clamp: fixed",
                                  "Loads/Edge forces": "tip: 1e-6 0 0"})
            exact = 1e-6 * (4 / 3 * length**3 / bending
                            + length / (5 / 6 * young / 2 * thickness))
            row.append(f"{displacement(results, 'T', 'u_x') / exact:.4f}")
        moment = -young * 0.1**3 / 12 * np.pi / 2 / length
        results = run_joined(runner, f"rolled_{n}", mesh, young, 0, 0.1,
                             {"Supports/Edge supports": "clamp: fixed",
                              "Loads/Edge moments": f"tip: {moment!r} follower",
                              "Stage 1/Strain theory": "nonlinear", "Stage 1/Steps": 4})
        row.append(f"{length + displacement(results, 'T', 'u_x'):.3f}, "
                   f"{length + displacement(results, 'T', 'u_z'):.3f}")
        row.append(str(int(results.history["iterations"].sum())))
        rows.append(row)
    return table(["n", "h/L = 1/60", "h/L = 1/12", "rolled up, h/L = 1/60: x, z",
                  "iterations in 4 steps"], rows)


def torsion_of_tube(runner):
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]

    def side(k):
        (x, y), (to_x, to_y) = corners[k], corners[(k + 1) % 4]
        return lambda u, v: (x + (to_x - x) * u, y + (to_y - y) * u, 10 * v)

    def end(k):
        axis = 1 if k % 2 == 0 else 0
        return lambda x: abs(x[2] - 10) < 1e-9 and abs(x[axis] - corners[k][axis]) < 1e-9

    mesh = joined([(side(k), 4, 40) for k in range(4)],
                  {"root": at(2, 0), **{f"end{k}": end(k) for k in range(4)}},
                  {"A": (0, 0, 10), "C": (1, 1, 10), "R": (0, 0, 0), "S": (1, 0, 0),
                   "Q": (1, 1, 0)})
    flow = 1e-3
    results = run_joined(
        runner, "tube", mesh, 1000, 0, 0.02,
        {"Supports/Edge supports": "root: x middle; y middle",
         "Supports/Point supports": "R: z middle, S: z middle, Q: z middle",
         "Loads/Edge forces": f"end0: {flow} 0 0, end1: 0 {flow} 0, end2: -{flow} 0 0, "
                              f"end3: 0 -{flow} 0"})
    turn = sum(sign * (displacement(results, "C", component)
                       - displacement(results, "A", component))
               for sign, component in ((-1, "u_x"), (1, "u_y"))) / 2
    return f"{turn / (2 * flow * 10 / (500 * 0.02)):.4f}"


def z_section_table(runner):
    rows = []
    for k in (1, 2, 4, 8):
        mesh = joined([(lambda u, v: (10 * u, 0 * u, -1 + 2 * v), 8 * k, 2 * k),
                       (lambda u, v: (10 * u, v, 1 + 0 * u), 8 * k, k),
                       (lambda u, v: (10 * u, v - 1, -1 + 0 * u), 8 * k, k)],
                      {"root": at(0, 0),
                       "top": lambda x: at(0, 10)(x) and at(2, 1)(x),
                       "bottom": lambda x: at(0, 10)(x) and at(2, -1)(x)},
                      {"A": (2.5, 1, 1), "E": (10, 0, 1), "G": (10, 0, -1)})
        results = run_joined(runner, f"z_section_{k}", mesh, 210e9, 0.3, 0.1,
                             {"Supports/Edge supports": "root: fixed",
                              "Loads/Edge forces": "top: 0 6e5 0, bottom: 0 -6e5 0"})
        stress = results.plies().where(name="A", fraction=0.5)["s_11"][0]
        turn = (displacement(results, "E", "u_y") - displacement(results, "G", "u_y")) / 2
        rows.append([f"{8 * k} × ({k}, {2 * k}, {k})", f"{stress / 1e6:.1f}", f"{turn:.4f}"])
    return table(["cells", "stress at A, MPa", "rotation"], rows)


def nozzle_by_theory(head, nozzle, height, thickness, cover, young=210000, poisson=0.3):
    """Displacements of the joint and hoop stress in the nozzle there: the theory of thin
    shells of revolution for the unknowns u_r, u_z, rotation, and radial force, axial force
    and moment times the radius, from the joint up the nozzle and down the head."""
    opening = np.arcsin(nozzle / head)
    lengths = height, head * (np.pi / 2 - opening)
    plane = young * thickness / (1 - poisson**2)
    bending = plane * thickness**2 / 12
    shear = 5 / 6 * young / 2 / (1 + poisson) * thickness

    def place(part, x):
        """Radius, slope of the meridian, side of the normal, and pressure on the middle."""
        if part == 0:
            return nozzle + 0 * x, np.pi / 2 + 0 * x, -1, 1 - thickness / 2 / nozzle
        angle = opening + x * (np.pi / 2 - opening)
        return head * np.sin(angle), -angle, 1, (1 - thickness / 2 / head)**2

    def around(part, x, y):
        """The resultants along the meridian and around the axis."""
        radius, slope, _, _ = place(part, x)
        along = (y[3] * np.cos(slope) + y[4] * np.sin(slope)) / radius
        return along, plane * (1 - poisson**2) * y[0] / radius + poisson * along

    def rates(part, x, y):
        radius, slope, outward, pressure = place(part, x)
        c, s = np.cos(slope), np.sin(slope)
        along, hoop = around(part, x, y)
        across = (y[4] * c - y[3] * s) / radius
        stretch = along / plane - poisson * y[0] / radius
        turn = y[2] + across / shear
        twist = y[2] * c / radius
        moment = y[5] / radius
        hoop_moment = bending * (1 - poisson**2) * twist + poisson * moment
        return lengths[part] * np.array([
            stretch * c - turn * s, stretch * s + turn * c, moment / bending - poisson * twist,
            hoop + radius * outward * pressure * s, -radius * outward * pressure * c,
            hoop_moment * c - radius * across])

    gap = ((nozzle - thickness / 4 * (1 + np.sin(opening))) * thickness / 2
           * np.array([np.cos(opening), 1 - np.sin(opening), 0]))

    def ends(a, b):
        return np.concatenate([a[:3] - a[6:9], a[3:6] + a[9:] + gap,
                               [b[3], b[4] - cover * nozzle, b[5]], b[7:10]])

    x = np.linspace(0, 1, 400)**2
    y = solve_bvp(lambda x, y: np.vstack([rates(0, x, y[:6]), rates(1, x, y[6:])]), ends,
                  x, np.zeros((12, x.size)), tol=1e-6, max_nodes=20000).sol(0.)
    return y[0], y[1], float(around(0, np.array(0.), y)[1]) / thickness


def nozzle_table(runner):
    head, radius, height = 500, 100, 200
    opening = np.arcsin(radius / head)

    def graded(x):
        return (np.exp(2 * x) - 1) / (np.exp(2) - 1)

    def wall(u, v):
        return (radius * np.cos(np.pi / 2 * u), radius * np.sin(np.pi / 2 * u),
                np.sqrt(head**2 - radius**2) + height * graded(v))

    def dome(u, v):
        angle = opening + (np.pi / 2 - opening) * graded(1 - v)
        return (head * np.sin(angle) * np.cos(np.pi / 2 * u),
                head * np.sin(angle) * np.sin(np.pi / 2 * u), head * np.cos(angle))

    top = np.sqrt(head**2 - radius**2) + height
    rows = []
    for thickness in (10, 5):
        cover = (radius - thickness / 2)**2 / 2 / radius
        for k in (1, 2):
            mesh = joined([(wall, 16 * k, 15 * k), (dome, 16 * k, 30 * k)],
                          {"y = 0": at(1, 0), "x = 0": at(0, 0), "equator": at(2, 0),
                           "cover": at(2, top)}, {"joint": wall(0., 0.)})
            results = run_joined(
                runner, f"nozzle_{thickness}_{k}", mesh, 210000, 0.3, thickness,
                {"Surface/Mesh/Direction": "-y; x; 0",
                 "Supports/Edge supports": "y = 0: symmetry y, x = 0: symmetry x, "
                                           "equator: symmetry z",
                 "Stage 1/Pressure": 1, "Loads/Edge forces": f"cover: 0 0 {cover}"})
            rows.append([str(thickness), f"{16 * k} × ({15 * k} + {30 * k})",
                         f"{displacement(results, 'joint', 'u_x'):.5f}",
                         f"{displacement(results, 'joint', 'u_z'):.5f}",
                         f"{results.plies().where(name='joint', fraction=0.5)['s_11'][0]:.2f}"])
        u_r, u_z, hoop = nozzle_by_theory(head, radius, height, thickness, cover)
        rows.append([str(thickness), "theory", f"{u_r:.5f}", f"{u_z:.5f}", f"{hoop:.2f}"])
    return table(["thickness", "cells in a quarter", "u_r", "u_z", "hoop stress"], rows)


def hole_table(arguments):
    results = biface.run(Path(__file__).resolve().parents[2] / "prm/plate_with_hole.prm",
                         {"Output/Write VTU": False}, arguments.scratch / "hole",
                         program=arguments.program)
    stress = results.plies().where(name="top", fraction=0.5)["s_L"][0]
    ratio = 138000 / 9000
    exact = 1 + np.sqrt(2 * (np.sqrt(ratio) - 0.3) + 138000 / 4800)
    return table(["", "stress over that far away"],
                 [["biface", f"{stress / 100:.3f}"], ["Lekhnitskii", f"{exact:.3f}"]])


def main():
    arguments = parse_arguments("any_mesh", __doc__)
    runner = Runner(arguments)
    modes, excess = modes_table(runner)
    other, hook = other_table(runner)
    (arguments.output / "any_mesh.md").write_text(PAGE.format(
        linear=linear_table(runner), divided=divided_table(runner), nonlinear=nonlinear_table(runner),
        nafems=nafems_table(runner), thin=thin_elliptic_membrane(runner),
        modes=modes, excess=excess, other=other, hook=hook, large=large_table(runner),
        folded_strip=folded_strip_table(runner), torsion=torsion_of_tube(runner),
        z_section=z_section_table(runner), nozzle=nozzle_table(runner), hole=hole_table(arguments)))


if __name__ == "__main__":
    main()
