# SPDX-License-Identifier: LGPL-2.1-or-later
"""Published benchmarks, most of NAFEMS, on regular and irregular meshes: tables of
any_mesh.md. Where a published value is not exact, or there is none, the target is
computed here."""

import numpy as np
from numpy.polynomial.legendre import Legendre, leggauss
from scipy.linalg import eigh

from example_page import table
from meshes import at, displacement, isotropic, joined, mapped, moved

KINDS = ("regular", "random")


def cells(sizes):
    return ", ".join(f"{n} × {m}" for n, m in sizes)


def rows_of(name, target, sizes, ratios, text=None):
    """The rows of a case: ratios[kind] over the published value, with each size."""
    return [[name if kind == "regular" else "", kind, text or cells(sizes),
             target if kind == "regular" else "",
             " ".join(f"{ratio:.3f}" for ratio in ratios[kind])] for kind in KINDS]


def stress(results, point, component, fraction, ply=1):
    return results.plies().where(name=point, ply=ply, fraction=fraction)[component][0]


# ---------------------------------------------------------------- statics of NAFEMS


def elliptic_membrane(runner, kind, size, thickness=0.1):
    """LE1: the stress at D, MPa."""
    def surface(u, v):
        angle = np.pi / 2 * v
        return (2 + 1.25 * u) * np.cos(angle), (1 + 1.75 * u) * np.sin(angle), 0 * u

    results = runner.run(
        f"le1_{kind}_{size[0]}_{thickness}", mapped(surface, *size, kind),
        {**isotropic(210e9, 0.3, thickness),
         # alpha_1 is normal to the outer edge
         "Surface/Mesh/Direction": "x/3.25^2; y/2.75^2; 0",
         "Supports/Edge supports": "south: symmetry y, north: symmetry x",
         "Supports/Point supports": "A: z middle",
         "Loads/Edge forces": f"east: {10e6 * thickness} 0 0 local"})
    return stress(results, "A", "s_22", 0.5) / 1e6


def cylindrical_patch(runner, kind, size, loads):
    """LE2: the hoop stresses at the middle of the patch, outside and on the middle
    surface, MPa."""
    def surface(u, v):
        angle = np.pi / 6 * u
        return np.sin(angle), 0.5 * v, np.cos(angle)

    results = runner.run(
        f"le2_{kind}_{size[0]}_{len(loads)}", mapped(surface, *size, kind),
        {**isotropic(210e9, 0.3, 0.01), "Surface/Mesh/Direction": "z; 0; -x",
         "Supports/Edge supports": "west: fixed, south: symmetry y, north: symmetry y",
         **loads})
    return [stress(results, "M", "s_11", fraction) / 1e6 for fraction in (1., 0.5)]


MOMENT = {"Loads/Edge moments": "east: 1000 dead"}
# on the inner face, whose radius is 0.995
PRESSURE = {"Loads/Pressure type": "dead", "Stage 1/Pressure": 0.6e6 / 0.995,
            # along the tangent at 30 degrees
            "Loads/Edge forces": f"east: {0.6e6 * np.cos(np.pi / 6)} 0 {-0.3e6}"}


def octant(n, kind):
    """An eighth of a sphere of radius 10 of three patches of n x n cells."""
    def patch(k):
        def surface(u, v):
            x = np.roll([1 + 0 * u, np.tan(np.pi / 4 * u), np.tan(np.pi / 4 * v)], k, axis=0)
            return tuple(10 * x / np.linalg.norm(x, axis=0))
        return surface

    mesh = joined([(patch(k), n, n) for k in range(3)], {"x = 0": at(0, 0), "y = 0": at(1, 0)},
                  {"A": (10, 0, 0), "C": (0, 10, 0), "E": (0, 0, 10)})
    return mesh if kind == "regular" else moved(
        mesh, lambda x: 10 * x / np.linalg.norm(x, axis=1, keepdims=True))


def hemisphere(runner, kind, n):
    """LE3: the displacement of A, m."""
    return displacement(runner.run(
        f"le3_{kind}_{n}", octant(n, kind),
        {**isotropic(68.25e9, 0.3, 0.04),
         "Supports/Edge supports": "x = 0: symmetry x, y = 0: symmetry y",
         "Supports/Point supports": "E: z middle",
         "Loads/Point forces": "A: 2000 0 0, C: 0 -2000 0"}), "A", "u_x")


def laminated_strip(runner, kind, size):
    """R0031/1: the deflection, mm, the bending stress and the interlaminar shear stress,
    MPa."""
    n, m = size
    load, shear = (n, 0), (11 * n // 15, 0)
    mesh = mapped(lambda u, v: (15 * u, 5 * v, 0 * u), n, m, kind, [shear])
    mesh.points = {"D": shear[0], "E": load[0]}
    constants = {"Type": "orthotropic", "E_1": 1e5, "E_2": 5e3, "E_3": 5e3, "G_12": 3e3,
                 "G_13": 2e3, "G_23": 2e3, "nu_12": 0.4, "nu_13": 0.3, "nu_23": 0.3}
    results = runner.run(
        f"r0031_{kind}_{n}", mesh,
        {**{f"Material m/{name}": value for name, value in constants.items()},
         "Laminate/Plies": "m: 0.1 @ 0, m: 0.1 @ 90, m: 0.1 @ 0, m: 0.4 @ 90, m: 0.1 @ 0, "
                           "m: 0.1 @ 90, m: 0.1 @ 0",
         "Laminate/Transverse shear": "equilibrium",
         "Supports/Edge supports": "west: z middle, east: symmetry x, south: symmetry y",
         "Loads/Edge forces": "east: 0 0 -5"})
    return (displacement(results, "E", "u_z"), stress(results, "E", "s_11", 0.),
            stress(results, "D", "interlaminar_t_13", 1.))


def nafems_table(runner):
    sizes = [(12, 18), (24, 36), (48, 72), (96, 144)]
    rows = rows_of("LE1 elliptic membrane: stress at D", "92.7 MPa", sizes,
                   {kind: [elliptic_membrane(runner, kind, size) / 92.7 for size in sizes]
                    for kind in KINDS})
    sizes = [(4, 4), (8, 8), (16, 16)]
    by_moment, by_pressure = ({kind: [np.array(cylindrical_patch(runner, kind, size, loads)) / 60
                                      for size in sizes] for kind in KINDS}
                              for loads in (MOMENT, PRESSURE))
    for name, results, place in (("by a moment: hoop stress outside", by_moment, 0),
                                 ("by pressure: hoop stress outside", by_pressure, 0),
                                 ("by pressure: in the middle of the wall", by_pressure, 1)):
        rows += rows_of(f"LE2 cylindrical patch {name}", "60 MPa", sizes,
                        {kind: [both[place] for both in results[kind]] for kind in KINDS})
    divisions = (4, 8, 16, 24)
    rows += rows_of("LE3 hemisphere: displacement at A", "0.185 m", None,
                    {kind: [hemisphere(runner, kind, n) / 0.185 for n in divisions]
                     for kind in KINDS},
                    ", ".join(f"3 × {n} × {n}" for n in divisions))
    sizes = [(30, 5), (60, 10), (120, 20)]
    strips = {kind: [laminated_strip(runner, kind, size) for size in sizes] for kind in KINDS}
    for i, (name, target, published) in enumerate((
            ("deflection at E", "-1.06 mm", -1.06), ("bending stress at E", "683.9 MPa", 683.9),
            ("interlaminar shear stress at D", "-4.1 MPa", -4.1))):
        rows += rows_of(f"R0031/1 laminated strip: {name}", target, sizes,
                        {kind: [values[i] / published for values in strips[kind]]
                         for kind in KINDS})
    return table(["Case", "Mesh", "Cells", "Target", "Computed over target"], rows)


def thin_elliptic_membrane(runner):
    return f"{elliptic_membrane(runner, 'regular', (96, 144), 0.001) / 92.7:.3f}"


# ---------------------------------------------------------------- vibrations of NAFEMS


def integrals(functions, i, j, weights):
    return (functions[i] * weights) @ functions[j].T


def frequencies_of_thin_plate(clamped, degree=14, poisson=0.3):
    """The least frequencies of the square plate of FV12 and FV16 by Kirchhoff's theory, Hz:
    Ritz's method with polynomials of both coordinates."""
    x, weights = leggauss(degree + 6)

    def basis(is_clamped):
        """Values and derivatives of the polynomials of a coordinate from -1 to 1, with the
        factor (1 + x)^2 if clamped at -1."""
        result = []
        for k in range(degree):
            p = Legendre.basis(k)
            if is_clamped:
                p = p * Legendre([1, 1])**2
            result.append([p(x), p.deriv()(x), p.deriv(2)(x)])
        return np.array(result).transpose(1, 0, 2)

    along, across = basis(clamped), basis(False)

    def product(i, j, k, l):
        return np.kron(integrals(along, i, j, weights), integrals(across, k, l, weights))

    stiffness = (product(2, 2, 0, 0) + product(0, 0, 2, 2)
                 + poisson * (product(2, 0, 0, 2) + product(0, 2, 2, 0))
                 + 2 * (1 - poisson) * product(1, 1, 1, 1))
    squares = eigh(stiffness, product(0, 0, 0, 0), eigvals_only=True, subset_by_index=[0, 11])
    rigid = 0 if clamped else 3
    bending = 200e9 * 0.05**3 / 12 / (1 - poisson**2)
    # half a side is 5
    return np.sqrt(squares[rigid:] * bending / (8000 * 0.05)) / 5**2 / (2 * np.pi)


def plate_frequencies(runner, kind, n, clamped):
    results = runner.run(
        f"plate_{kind}_{n}_{clamped}",
        mapped(lambda u, v: (10 * u, 10 * v, 0 * u), n, n, kind),
        {**isotropic(200e9, 0.3, 0.05), "Material m/Density": 8000,
         "Supports/Edge supports": "west: fixed" if clamped else "",
         "Stage 1/Modes": 6 if clamped else 12, "Stage 1/Load factor": "unchanged"})
    return results.modes()["frequency"][0 if clamped else 6:]


def modes_table(runner):
    """The table, and the percentage by which published frequencies are too high at most."""
    divisions = (8, 16, 32)
    rows, excess = [], 0
    for name, clamped, published in (
            ("FV12 free plate", False, (1.622, 2.360, 2.922, 4.233, 4.233, 7.416)),
            ("FV16 cantilevered plate", True, (0.421, 1.029, 2.582, 3.306, 3.753, 6.555))):
        exact = frequencies_of_thin_plate(clamped)
        computed = {kind: [plate_frequencies(runner, kind, n, clamped) for n in divisions]
                    for kind in KINDS}
        excess = max(excess, *(100 * (f / e - 1) for f, e in zip(published, exact)))
        for i, frequency in enumerate(published):
            rows.append([f"{name}: mode {i + (1 if clamped else 7)}", f"{frequency:.3f}",
                         f"{exact[i]:.4f}"]
                        + [" ".join(f"{values[i] / exact[i]:.3f}" for values in computed[kind])
                           for kind in KINDS])
    return (table(["Mode", "NAFEMS, Hz", "Ritz, Hz", "regular over Ritz", "random over Ritz"],
                  rows), f"{excess:.1f}")


# ---------------------------------------------------------------- other linear benchmarks


def cook_membrane(runner, kind, n):
    results = runner.run(
        f"cook_{kind}_{n}",
        mapped(lambda u, v: (48 * u, 44 * u + (44 - 28 * u) * v, 0 * u), n, n, kind,
               [(n, n // 2)]),
        {**isotropic(1, 1 / 3, 1), "Supports/Edge supports": "west: fixed",
         "Loads/Edge forces": "east: 0 0.0625 0"})
    return displacement(results, "E", "u_y")


def deflection_of_skew_plate(degree=30):
    """The deflection at the center of Morley's plate of 30 degrees by Kirchhoff's theory,
    over q a^4/D. The sum of the curvatures is zero at straight edges that are simply
    supported, so that it is that of two membranes: Ritz's method in skew coordinates."""
    x, weights = leggauss(degree + 6)
    polynomials = [Legendre.basis(k) - Legendre.basis(k + 2) for k in range(degree)]
    basis = np.array([[p(x), p.deriv()(x)] for p in polynomials]).transpose(1, 0, 2)
    mass, mixed, stiffness = (integrals(basis, i, j, weights)
                              for i, j in ((0, 0), (1, 0), (1, 1)))
    cosine, sine = np.cos(np.pi / 6), np.sin(np.pi / 6)
    membrane = (np.kron(stiffness, mass) + np.kron(mass, stiffness)
                - cosine * (np.kron(mixed, mixed.T) + np.kron(mixed.T, mixed))) / sine
    area = sine / 4
    load = np.kron(basis[0] @ weights, basis[0] @ weights) * area
    moment = np.linalg.solve(membrane, load)
    deflection = np.linalg.solve(membrane, np.kron(mass, mass) * area @ moment)
    center = np.array([p(0.) for p in polynomials])
    return deflection @ np.kron(center, center)


def skew_plate(runner, kind, n, thickness):
    """The deflection of the center of Morley's plate over q a^4/D; cells are small at the
    edges."""
    def surface(u, v):
        s, t = (48 * (1 - np.cos(np.pi * w)) + 4 * w for w in (u, v))
        return s + t * np.cos(np.pi / 6), t * np.sin(np.pi / 6), 0 * s

    stiffness = 1e7 * thickness**3 / 12 / (1 - 0.3**2)
    results = runner.run(
        f"morley_{kind}_{n}_{thickness}", mapped(surface, n, n, kind, [(n // 2, n // 2)]),
        {**isotropic(1e7, 0.3, thickness),
         "Supports/Edge supports": ", ".join(f"{edge}: z middle" for edge in
                                             ("west", "east", "south", "north")),
         "Supports/Point supports": "A: x middle; y middle, B: y middle",
         "Loads/Area force": f"0, 0, {stiffness / 100**4!r}"})
    return displacement(results, "M", "u_z")


def hook(u, v):
    """Arcs of the radii 14 and 46 and of 60 and 150 degrees."""
    angle = 210 * u
    first, second = np.radians(np.minimum(angle, 60)), np.radians(np.maximum(angle, 60) - 30)
    center = (14 * np.sin(np.pi / 3) + 46 * np.cos(np.pi / 6),
              14 * (1 - np.cos(np.pi / 3)) - 46 * np.sin(np.pi / 6))
    return (np.where(angle < 60, 14 * np.sin(first), center[0] - 46 * np.cos(second)),
            np.where(angle < 60, 14 * (1 - np.cos(first)), center[1] + 46 * np.sin(second)),
            20 * v)


def raasch_hook(runner, kind, size):
    results = runner.run(
        f"hook_{kind}_{size[0]}", mapped(hook, *size, kind),
        {**isotropic(3300, 0.35, 2), "Laminate/Transverse shear": "equilibrium",
         "Supports/Edge supports": "west: fixed", "Loads/Edge forces": "east: 0 0 0.05",
         "Output/Write VTU": True})
    return displacement(results, "E", "u_z")


YOUNG, POISSON, COSINE = 2e11, 1 / 3, 1e6


def energy_of_hyperboloid(thickness, clamped, degree=24):
    """The strain energy of the hyperboloid r^2 = 1 + y^2 under the pressure COSINE cos 2 theta
    on its middle surface, by three-dimensional elasticity: Ritz's method with polynomials
    along the meridian, quadratic over the thickness."""
    y, along = leggauss(2 * degree + 10)
    y, along = (y + 1) / 2, along / 2
    z, over = leggauss(5)
    over = over * thickness / 2
    radius = np.sqrt(1 + y**2)
    slope, curvature = y / radius, 1 / radius**3
    length = np.sqrt(1 + slope**2)
    normal = np.array([1 / length, -slope / length])
    rate = np.array([-slope * curvature / length**3,
                     -curvature / length + slope**2 * curvature / length**3])

    def at_points(a):
        return a[..., None] + 0 * z

    height = z * thickness / 2
    r = at_points(radius) + height * at_points(normal[0])
    r_y = at_points(slope) + height * at_points(rate[0])
    y_y = 1 + height * at_points(rate[1])
    r_z, y_z = at_points(normal[0]), at_points(normal[1])
    determinant = r_y * y_z - r_z * y_y
    # both halves; the integral of the square of the cosine
    root = np.sqrt(2 * np.pi * np.abs(determinant) * r * along[:, None] * over)
    bound = np.array([1 - y**2, -2 * y]) if clamped else np.array([1 + 0 * y, 0 * y])
    strains, forces = [], []
    for component in ("r", "theta", "y"):
        for k in range(degree):
            p = Legendre.basis(2 * k + (component == "y"))
            value = p(y) * bound[0]
            derivative = p.deriv()(y) * bound[0] + p(y) * bound[1]
            for power in range(3):
                f = value[:, None] * z**power
                f_y = derivative[:, None] * z**power
                f_z = value[:, None] * (power * z**max(power - 1, 0) * 2 / thickness)
                by_r = (f_y * y_z - f_z * y_y) / determinant
                by_y = (r_y * f_z - r_z * f_y) / determinant
                none = 0 * f
                # normal strains r, theta, y; shear strains r theta, theta y, y r
                strain = {"r": (by_r, f / r, none, -2 * f / r, none, by_y),
                          "theta": (none, 2 * f / r, none, by_r - f / r, by_y, none),
                          "y": (none, none, by_y, none, -2 * f / r, by_r)}[component]
                strains.append([(e * root).ravel() for e in strain])
                outward = {"r": normal[0], "theta": 0 * y, "y": normal[1]}[component]
                forces.append(0 if power else 2 * np.pi * COSINE * np.sum(
                    along * length * radius * value * outward))
    strains, forces = np.array(strains).transpose(1, 0, 2), np.array(forces)
    trace = strains[:3].sum(axis=0)
    shear = YOUNG / 2 / (1 + POISSON)
    stiffness = (YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON) * trace @ trace.T
                 + sum((2 if i < 3 else 1) * shear * e @ e.T for i, e in enumerate(strains)))
    scale = 1 / np.sqrt(np.diag(stiffness))
    motion = np.linalg.lstsq(stiffness * scale[:, None] * scale, forces * scale, rcond=1e-15)[0]
    return motion @ (forces * scale) / 2


def hyperboloid(runner, kind, n, thickness, clamped):
    """The strain energy of the whole, from an eighth."""
    def surface(u, v):
        radius = np.sqrt(1 + v**2)
        return radius * np.cos(np.pi / 2 * u), v, -radius * np.sin(np.pi / 2 * u)

    results = runner.run(
        f"hyperboloid_{kind}_{n}_{thickness}_{clamped}", mapped(surface, n, n, kind),
        {**isotropic(YOUNG, POISSON, thickness),
         "Supports/Edge supports": "west: symmetry z, east: symmetry x, south: symmetry y"
                                   + (", north: fixed" if clamped else ""),
         "Loads/Pressure type": "dead", "Stage 1/Pressure": COSINE,
         "Loads/Pressure distribution": "(x^2-z^2)/(x^2+z^2)"})
    return 8 * results.history["strain_energy"][-1]


def other_table(runner):
    """The table, and the displacement of the hook over that of Knight."""
    sizes = [(8, 8), (16, 16), (32, 32), (64, 64)]
    rows = rows_of("Cook's membrane", "23.96", sizes,
                   {kind: [cook_membrane(runner, kind, n) / 23.96 for n, _ in sizes]
                    for kind in KINDS})
    exact = deflection_of_skew_plate()
    sizes = [(16, 16), (32, 32), (64, 64), (128, 128)]
    for slenderness, target in ((10000, exact), (100, 0.424e-3)):
        rows += rows_of(f"skew plate of 30 degrees, h/a = 1/{slenderness}",
                        f"{1e3 * target:.3f}", sizes,
                        {kind: [skew_plate(runner, kind, n, 100 / slenderness) / target
                                for n, _ in sizes] for kind in KINDS})
    sizes = [(28, 4), (56, 8), (112, 16), (224, 32)]
    hooks = {kind: [raasch_hook(runner, kind, size) for size in sizes] for kind in KINDS}
    rows += rows_of("Raasch's hook", "5.02 in", sizes,
                    {kind: [u / 5.02 for u in hooks[kind]] for kind in KINDS})
    sizes = [(8, 8), (16, 16), (32, 32), (64, 64)]
    for ends, clamped in (("free", False), ("clamped", True)):
        for thickness in (0.01, 0.001):
            energy = energy_of_hyperboloid(thickness, clamped)
            rows += rows_of(f"hyperboloid, {ends} ends, h = {thickness}",
                            f"{energy:.3e} J".replace("e+0", "e"), sizes,
                            {kind: [hyperboloid(runner, kind, n, thickness, clamped) / energy
                                    for n, _ in sizes] for kind in KINDS})
    return (table(["Case", "Mesh", "Cells", "Target", "Computed over target"], rows),
            f"{hooks['random'][-1] / 4.9352:.3f}")


# ---------------------------------------------------------------- large displacements


NONLINEAR = {"Stage 1/Strain theory": "nonlinear"}


def cylinder(radius, length, angle):
    return lambda u, v: (length * u, radius * np.sin(angle * v), radius * np.cos(angle * v))


def iterations(results):
    return int(results.history["iterations"].sum())


def at_load(results, point, component, factor):
    probes = results.probes().where(name=point)
    return probes[component][np.argmin(np.abs(probes["load_factor"] - factor))]


def slit_annulus(runner, kind, size):
    """The displacements of the lip over those of Sze, and the iterations."""
    def surface(u, v):
        # nodes of both lips at the same place are refused
        angle = 2 * np.pi * (1 - 1e-5) * v
        return (6 + 4 * u) * np.cos(angle), (6 + 4 * u) * np.sin(angle), 0 * u

    results = runner.run(
        f"annulus_{kind}_{size[0]}", mapped(surface, *size, kind),
        {**isotropic(21e6, 0, 0.03), **NONLINEAR, "Supports/Edge supports": "south: fixed",
         "Loads/Edge forces": "north: 0 0 0.8", "Output/Write VTU": True})
    return ([displacement(results, "D", "u_z") / 13.891,
             displacement(results, "C", "u_z") / 17.528], iterations(results))


def open_cylinder(runner, kind, size):
    """Displacements under the force, beside it and at the end over those of Sze, at a quarter
    of the load and at the whole load, and the iterations."""
    results = runner.run(
        f"open_cylinder_{kind}_{size[0]}",
        mapped(cylinder(4.953, 5.175, np.pi / 2), *size, kind),
        {**isotropic(10.5e6, 0.3125, 0.094), **NONLINEAR,
         "Supports/Edge supports": "west: symmetry x, south: symmetry y, north: symmetry z",
         "Loads/Point forces": "A: 0 0 10000", "Stage 1/Steps": 20, "Output/Write VTU": True})
    return ([at_load(results, point, component, factor) / published
             for factor, values in ((0.25, (2.180, -3.087, -3.310)), (1, (2.768, -4.551, -3.269)))
             for (point, component), published in zip((("A", "u_z"), ("D", "u_y"), ("C", "u_y")),
                                                      values)], iterations(results))


def hinged_roof(runner, kind, size, thickness):
    """The first maximum and minimum of the load along the path, and the iterations."""
    thick = thickness == 12.7
    results = runner.run(
        f"roof_{kind}_{size[0]}_{thickness}", mapped(cylinder(2540, 254, 0.1), *size, kind),
        {**isotropic(3102.75, 0.3, thickness), **NONLINEAR,
         "Supports/Edge supports": "west: symmetry x, south: symmetry y, north: hinged",
         "Loads/Point forces": "A: 0 0 -750", "Stage 1/Control": "arc length",
         "Stage 1/Load factor": 1.08 if thick else 0.3, "Stage 1/Steps": 10 if thick else 20,
         "Step control/Maximum growth": 1.5})
    load = np.concatenate([[0], results.history["load_factor"]])

    def extremum(sign):
        """That of the parabola through three steps."""
        i = next(i for i in range(1, len(load) - 1)
                 if sign * load[i] > sign * load[i - 1] and sign * load[i] >= sign * load[i + 1])
        return load[i] - (load[i + 1] - load[i - 1])**2 / 8 / (
            load[i + 1] - 2 * load[i] + load[i - 1])
    published = ((1, 0.7421), (-1, 0.1729)) if thick else ((1, 0.1953),)
    return [extremum(sign) / value for sign, value in published], iterations(results)


def large_table(runner):
    rows = []
    for name, target, sizes, case in (
            ("slit annular plate: inner and outer end of the lip", "13.891, 17.528",
             [(5, 40), (10, 80), (20, 160)], slit_annulus),
            ("open cylinder, pulled: three points at P/4 and at P",
             "2.180, 3.087, 3.310; 2.768, 4.551, 3.269", [(14, 21), (28, 42)], open_cylinder),
            ("hinged roof, h = 12.7: limit loads", "0.7421, 0.1729", [(8, 8), (16, 16)],
             lambda *arguments: hinged_roof(*arguments, 12.7)),
            ("hinged roof, h = 6.35: limit load", "0.1953", [(8, 8), (16, 16)],
             lambda *arguments: hinged_roof(*arguments, 6.35))):
        for kind in KINDS:
            for size in sizes:
                ratios, count = case(runner, kind, size)
                first = kind == "regular" and size == sizes[0]
                rows.append([name if first else "", kind, cells([size]), target if first else "",
                             " ".join(f"{ratio:.3f}" for ratio in ratios), str(count)])
    return table(["Case", "Mesh", "Cells", "Sze", "Computed over Sze", "Iterations"], rows)
