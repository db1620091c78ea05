# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of Gmsh's format, regular and irregular ones, and runs on them."""

from dataclasses import dataclass

import numpy as np

from example_page import biface


@dataclass
class Mesh:
    """Nodes, triangles and quadrilaterals counterclockwise, lines and points by name."""
    nodes: np.ndarray
    cells: list
    lines: dict
    points: dict

    def write(self, path):
        """As MSH 2.2."""
        names = ([(0, name) for name in self.points] + [(1, name) for name in self.lines]
                 + [(2, "shell")])
        numbers = {name: i + 1 for i, name in enumerate(names)}
        elements = [f"15 2 {numbers[0, name]} 0 {node + 1}"
                    for name, node in self.points.items()]
        elements += [f"1 2 {numbers[1, name]} 0 {a + 1} {b + 1}"
                     for name, sides in self.lines.items() for a, b in sides]
        elements += [f"{len(cell) - 1} 2 {numbers[2, 'shell']} 0 "
                     + " ".join(str(n + 1) for n in cell) for cell in self.cells]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(names)]
        lines += [f'{d} {number} "{name}"' for (d, name), number in numbers.items()]
        lines += ["$EndPhysicalNames", "$Nodes", len(self.nodes)]
        lines += [f"{i + 1} {x:.16g} {y:.16g} {z:.16g}"
                  for i, (x, y, z) in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", len(elements)]
        lines += [f"{i + 1} {element}" for i, element in enumerate(elements)]
        path.write_text("\n".join(str(line) for line in lines) + "\n$EndElements\n")


def unit_square(n, m, kind, kept=()):
    """The coordinates of the nodes of n x m cells in the unit square; the nodes (i, j)
    in kept do not move."""
    u, v = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, m + 1))
    if kind == "random":
        generator = np.random.default_rng(3)
        for x, size, axis in ((u, n, 1), (v, m, 0)):
            shift = generator.uniform(-0.25, 0.25, x.shape) / size
            shift.swapaxes(0, axis)[[0, -1]] = 0
            for i, j in kept:
                shift[j, i] = 0
            x += shift
    elif kind == "graded":
        def divided(size):
            return np.cumsum(np.arange(size + 1)) * 2 / (size * (size + 1))
        # intersections of straight lines between opposite edges
        s, t = np.meshgrid(divided(n), divided(m))
        ds, dt = np.meshgrid(1 - divided(n)[::-1], 1 - divided(m)[::-1])
        u = (s + (ds - s) * t) / (1 - (ds - s) * (dt - t))
        v = t + (dt - t) * u
    return u, v


def mapped(surface, n, m, kind, kept=()):
    """The mesh of a surface given over the unit square."""
    u, v = unit_square(n, m, kind, kept)
    def node(i, j):
        return j * (n + 1) + i
    cells = [(node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))
             for j in range(m) for i in range(n)]
    lines = {"south": [(node(i, 0), node(i + 1, 0)) for i in range(n)],
             "north": [(node(i, m), node(i + 1, m)) for i in range(n)],
             "west": [(node(0, j), node(0, j + 1)) for j in range(m)],
             "east": [(node(n, j), node(n, j + 1)) for j in range(m)]}
    points = {"A": node(0, 0), "B": node(n, 0), "C": node(n, m), "D": node(0, m),
              "E": node(n, m // 2), "M": node(n // 2, m // 2)}
    return Mesh(np.stack(surface(u, v), axis=-1).reshape(-1, 3), cells, lines, points)


def triangles(mesh):
    """The mesh with each quadrilateral cut into two triangles."""
    mesh.cells = [part for a, b, c, d in mesh.cells for part in ((a, b, c), (a, c, d))]
    return mesh


def joined(patches, lines, points):
    """One mesh of patches (surface, n, m), with lines and points by predicates and
    positions."""
    numbers, nodes, cells = {}, [], []
    for surface, n, m in patches:
        part = mapped(surface, n, m, "regular")
        own = []
        for x in part.nodes:
            number = numbers.setdefault(tuple(np.round(x, 9) + 0.0), len(nodes))
            if number == len(nodes):
                nodes.append(x)
            own.append(number)
        cells += [tuple(own[node] for node in cell) for cell in part.cells]
    nodes = np.array(nodes)
    sides = {tuple(sorted((cell[k], cell[k - 1]))) for cell in cells for k in range(4)}
    return Mesh(nodes, cells,
                {name: sorted(side for side in sides if all(on_line(nodes[i]) for i in side))
                 for name, on_line in lines.items()},
                {name: int(np.argmin(np.linalg.norm(nodes - np.array(x), axis=1)))
                 for name, x in points.items()})


def moved(mesh, onto):
    """The mesh with its nodes moved at random by up to 0.15 of their shortest side in each
    direction, but in the planes of coordinates, and then onto the surface; points stay."""
    sides = np.array(sorted({tuple(sorted((cell[k], cell[k - 1])))
                             for cell in mesh.cells for k in range(4)}))
    lengths = np.linalg.norm(mesh.nodes[sides[:, 0]] - mesh.nodes[sides[:, 1]], axis=1)
    size = np.full(len(mesh.nodes), np.inf)
    for ends in sides.T:
        np.minimum.at(size, ends, lengths)
    shift = np.random.default_rng(3).uniform(-0.15, 0.15, mesh.nodes.shape) * size[:, None]
    shift[np.abs(mesh.nodes) < 1e-9] = 0
    shift[list(mesh.points.values())] = 0
    mesh.nodes = onto(mesh.nodes + shift)
    return mesh


def at(axis, value):
    return lambda x: abs(x[axis] - value) < 1e-9


BASE = """set Materials        = m
set Number of stages = 1
subsection Surface
  set Type = mesh
  subsection Mesh
    set Fold angle = 45
  end
end
subsection Material m
  set Type = isotropic
end
subsection Laminate
  set Reference surface = middle
end
subsection Stage 1
  set Strain theory = linear
  set Load factor   = 1
end
"""


class Runner:
    def __init__(self, arguments):
        self.program, self.scratch = arguments.program, arguments.scratch
        (self.scratch / "base.prm").write_text(BASE)

    def run(self, name, mesh, entries):
        """A run on a mesh, linear unless entries say otherwise."""
        path = self.scratch / f"{name}.msh"
        mesh.write(path)
        return biface.run(
            self.scratch / "base.prm",
            {"Surface/Mesh/File": str(path.resolve()), "Output/Write VTU": False, **entries},
            self.scratch / name, program=self.program)


def isotropic(young, poisson, thickness):
    """Entries of a shell of one isotropic ply."""
    return {"Material m/E": young, "Material m/nu": poisson,
            "Laminate/Plies": f"m: {thickness} @ 0"}


def displacement(results, point, component):
    return results.probes().where(name=point)[component][-1]
