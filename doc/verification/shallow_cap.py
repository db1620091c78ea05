#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""The critical pressures of clamped shallow spherical caps, from Marguerre's
equations and finite differences along the radius: references of the benchmarks
critical_cap and critical_cap_waves.

Prints, for lambda = [12 (1 - nu^2)]^(1/4) a/sqrt(R h), the maximum pressure of
the axisymmetric path with lambda = 4 and the pressure at which two waves around
the axis branch off with lambda = 6, relative to 2 E (h/R)^2/sqrt(3 (1 - nu^2)).

Usage: shallow_cap.py [number of intervals]
"""

import sys

import numpy as np

NU, H = 0.3, 2e-4  # Poisson's ratio, thickness; E = R = 1
D = H**3 / (12 * (1 - NU**2))
P_CLASSICAL = 2 * H**2 / np.sqrt(3 * (1 - NU**2))


class Cap:
    """Rotation b = dw/dr (w inward) and r N_r at the nodes 0..n of a radius."""

    def __init__(self, lam, n):
        self.n = n
        self.a = lam * np.sqrt(H) / (12 * (1 - NU**2)) ** 0.25
        self.d = self.a / n
        self.r = self.d * np.arange(n + 1)
        self.interior = np.arange(1, n)

    def laplacian(self, waves):
        """y'' + y'/r - waves^2 y/r^2 at the interior nodes."""
        i, d, r = self.interior, self.d, self.r[1:-1]
        matrix = np.zeros((self.n + 1, self.n + 1))
        matrix[i, i - 1] = 1 / d**2 - 1 / (2 * d * r)
        matrix[i, i] = -2 / d**2 - waves**2 / r**2
        matrix[i, i + 1] = 1 / d**2 + 1 / (2 * d * r)
        return matrix

    def end_slope(self):
        """y' at the edge, one-sided."""
        row = np.zeros(self.n + 1)
        row[-3:] = np.array([1, -4, 3]) / (2 * self.d)
        return row

    def equilibrium(self, start, deflection):
        """The axisymmetric solution with a mean deflection; the last number is
        the relative pressure."""
        n, i, r = self.n, self.interior, self.r[1:-1]
        m = n + 1
        bending = self.laplacian(1)
        weights = self.d * self.r**2 / self.a**2
        x = start.copy()
        for _ in range(50):
            b, force, q = x[:m], x[m:-1], x[-1] * P_CLASSICAL
            residual = np.zeros(2 * m + 1)
            tangent = np.zeros((2 * m + 1, 2 * m + 1))
            residual[i] = (D * bending @ b)[i] - q * r / 2 - force[i] * (1 + b[i] / r)
            residual[m + i] = (bending @ force)[i] + H * (b[i] + b[i] ** 2 / (2 * r))
            tangent[i, :m] = D * bending[i]
            tangent[i, i] -= force[i] / r
            tangent[i, m + i] = -(1 + b[i] / r)
            tangent[i, -1] = -P_CLASSICAL * r / 2
            tangent[m + i, m:-1] = bending[i]
            tangent[m + i, i] = H * (1 + b[i] / r)
            # zero at the center; clamped edge: b = 0 and N_t = nu N_r
            for row in (0, n, m):
                tangent[row, row] = 1
                residual[row] = x[row]
            tangent[2 * m - 1, m:-1] = self.a * self.end_slope()
            tangent[2 * m - 1, 2 * m - 1] -= NU
            residual[2 * m - 1] = tangent[2 * m - 1] @ x
            tangent[-1, :m] = -weights
            residual[-1] = -weights @ b - deflection
            change = np.linalg.solve(tangent, residual)
            x -= change
            if np.abs(change[:m]).max() < 1e-8 * np.abs(x[:m]).max():
                return x
        raise RuntimeError("no convergence")

    def sign_of_waves(self, x, waves):
        """The sign of the determinant of the equations of a small deflection
        w cos(waves t) with the stress function f cos(waves t); unknowns w, its
        Laplacian, f, its Laplacian."""
        n, i, r, k2 = self.n, self.interior, self.r[1:-1], waves**2
        m = n + 1
        b, force = x[:m], x[m:-1]
        laplacian, one = self.laplacian(waves), np.eye(m)
        first = np.zeros((m, m))
        first[i, i + 1], first[i, i - 1] = 1 / (2 * self.d), -1 / (2 * self.d)
        first[n] = self.end_slope()
        second = np.zeros((m, m))
        second[i, i - 1] = second[i, i + 1] = 1 / self.d**2
        second[i, i] = -2 / self.d**2

        def bracket(slope):
            curvature = np.gradient(slope, self.d, edge_order=2)
            matrix = np.zeros((m, m))
            matrix[i] = (curvature[i, None] * (first[i] - k2 / r[:, None] * one[i])
                         + slope[i, None] * second[i]) / r[:, None]
            return matrix

        shape, stress = bracket(self.r + b), bracket(force)
        w, lap_w, f, lap_f = (slice(k * m, (k + 1) * m) for k in range(4))
        matrix = np.zeros((4 * m, 4 * m))
        matrix[i, w], matrix[i, lap_w] = laplacian[i], -one[i]
        matrix[m + i, lap_w] = D * laplacian[i]
        matrix[m + i, w], matrix[m + i, f] = -stress[i], -shape[i]
        matrix[2 * m + i, f], matrix[2 * m + i, lap_f] = laplacian[i], -one[i]
        matrix[3 * m + i, lap_f], matrix[3 * m + i, w] = laplacian[i], H * shape[i]
        for row in range(4):
            matrix[row * m, row * m] = 1
        # clamped: w = w' = 0
        matrix[n, n] = 1
        matrix[m + n, w] = self.end_slope()
        # u = v = 0 at the edge: no strain along it, and compatibility with it
        radius = np.maximum(self.r, self.d)[:, None]
        n_r = np.hstack([first / radius - k2 / radius**2 * one, np.zeros((m, m))])
        n_t = np.hstack([-first / radius + k2 / radius**2 * one, one])
        n_rt = waves * (first[n] / self.a - one[n] / self.a**2)
        hoop = n_t - NU * n_r
        matrix[2 * m + n, 2 * m:] = hoop[n]
        matrix[3 * m + n, 2 * m:] = (self.a * self.end_slope() @ hoop
                                     - n_r[n] + NU * n_t[n])
        matrix[3 * m + n, f] -= 2 * (1 + NU) * waves * n_rt
        return np.linalg.slogdet(matrix / np.abs(matrix).max(axis=1)[:, None])[0]


def limit_pressure(lam, n):
    """The first maximum of the pressure over the mean deflection."""
    cap, x = Cap(lam, n), np.zeros(2 * n + 3)
    deflections, pressures = 0.01 * H * np.arange(1, 401), []
    for w in deflections:
        x = cap.equilibrium(x, w)
        pressures.append(x[-1])
        if len(pressures) > 4 and pressures[-3] > pressures[-2]:
            break
    fit = np.polyfit(np.arange(-2, 3), pressures[-5:], 4)
    return max(np.polyval(fit, np.linspace(-2, 2, 4001)))


def bifurcation_pressure(lam, waves, n):
    """The pressure at which waves around the axis branch off."""
    cap, low, step, found = Cap(lam, n), 1e-3 * H, 0.02 * H, False
    x = cap.equilibrium(np.zeros(2 * n + 3), low)
    sign = cap.sign_of_waves(x, waves)
    while step > 1e-6 * H:
        y = cap.equilibrium(x, low + step)
        if cap.sign_of_waves(y, waves) == sign:
            x, low = y, low + step
        else:
            found = True
        if found:
            step /= 2
    return x[-1]


if __name__ == "__main__":
    N = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    print(f"lambda = 4, maximum of the axisymmetric path: {limit_pressure(4, N):.5f}")
    print(f"lambda = 6, two waves: {bifurcation_pressure(6, 2, N):.5f}")
