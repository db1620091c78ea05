# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Magic Formula: forces and moments of a tire that rolls steadily.

Equation numbers, such as (4.E19), are those of Pacejka, Tire and Vehicle Dynamics, third
edition, 2012, section 4.3.2. MF 5.2, which Adams calls PAC2002, is that of the second
edition. Left out: turn slip (all zeta are 1), rolling backward, standstill, the decay of
friction with slip speed (lambda_muV is 0) and relaxation lengths.

Where the book, its files and other programs differ, see "Doubtful readings" in
doc/tire_model.md.
"""

from collections import namedtuple
from types import SimpleNamespace

import numpy as np

from biface.errors import BifaceError
from .coefficients import NEUTRAL, NEUTRAL_52

# Of the road on the tire, in the W axes of ISO 8855 (see axes.py); newtons and newton
# meters, arrays of the same shape
Forces = namedtuple("Forces", "F_x F_y M_x M_y M_z")

# Factors of a curve: its value, slope at zero slip, stiffness, shape and peak factor,
# horizontal and vertical shift
Curve = namedtuple("Curve", "value slope B C D S_H S_V")

# Without an entry LONGVL
REFERENCE_VELOCITY = 16.7


def argument(B, E, x):
    """What the sine and the cosine have behind the shape factor."""
    return np.arctan(B * x - E * (B * x - np.arctan(B * x)))


def sine(B, C, D, E, x):
    """The curve of a force, (4.E9) without shifts."""
    return D * np.sin(C * argument(B, E, x))


def cosine(B, C, E, x):
    """The curve of a trail or of a reduction, 1 at the slip 0."""
    return np.cos(C * argument(B, E, x))


def ratio(a, b):
    """a / b, and 0 where b is 0, which happens without a load. The book adds a small
    epsilon to b."""
    a, b = np.broadcast_arrays(a, b)
    return np.divide(a, b, out=np.zeros(b.shape), where=b != 0)


def arctan_of_ratio(a, b):
    """The arctangent of a / b, and its limit where b is 0."""
    a, b = np.broadcast_arrays(a, b)
    return np.arctan(np.divide(a, b, out=np.where(a == 0, 0.0, np.copysign(np.inf, a)),
                               where=b != 0))


def sign(x):
    """The sign of x, 1 for 0."""
    return np.where(x < 0, -1.0, 1.0)


class MagicFormula:
    """What MF 5.2 and MF 6.1 have in common. Use MF52 or MF61.

    coefficients  a dictionary of numbers by the names of a .tir file, with FNOMIN [N] and,
                  for moments, UNLOADED_RADIUS [m]; coefficients that are missing are neutral
    starred       whether tan(alpha) and sin(gamma) of (4.E3) and (4.E4) replace the angles
    mirrored      whether forces and moments are those of the mirror image of the tire

    Raises BifaceError if a needed constant is missing or not positive.
    """

    name = ""
    neutral = NEUTRAL

    def __init__(self, coefficients, starred=False, mirrored=False):
        self.coefficients, self.starred = dict(coefficients), starred
        self.mirrored, self._side = mirrored, -1 if mirrored else 1
        if "FNOMIN" not in self.coefficients:
            raise BifaceError("FNOMIN is missing, which the Magic Formula needs.")
        for name in ("FNOMIN", "UNLOADED_RADIUS", "LFZO"):
            if not self.coefficients.get(name, 1) > 0:
                raise BifaceError(f"{name} is {self.coefficients[name]:g}, but must be "
                                  "positive.")
        self.p = SimpleNamespace(**{"UNLOADED_RADIUS": np.nan, **self.neutral,
                                    **self.coefficients})
        self.nominal_pressure = self.coefficients.get("NOMPRES")
        self.velocity = self.coefficients.get("LONGVL", REFERENCE_VELOCITY)

    def with_coefficients(self, changes):
        """The same formula with some coefficients changed."""
        return type(self)({**self.coefficients, **changes}, self.starred, self.mirrored)

    @property
    def has_radius(self):
        """Whether there is a radius, without which moments are NaN."""
        return "UNLOADED_RADIUS" in self.coefficients

    def need_radius(self):
        """Raises BifaceError if there is no radius."""
        if not self.has_radius:
            raise BifaceError("UNLOADED_RADIUS is missing, which moments need.")

    # ---- inputs

    def _inputs(self, F_z, kappa, alpha, gamma, pressure):
        """The inputs as arrays of one shape, with the increments (4.E2a) and (4.E2b)."""
        p = self.p
        default = self.coefficients.get("INFLPRES", self.nominal_pressure)
        if pressure is not None and not self.nominal_pressure:
            raise BifaceError("the pressure is given, but the file has no nominal one, "
                              "NOMPRES.")
        given = (1.0 if default is None else default) if pressure is None else pressure
        F_z, kappa, alpha, gamma, given = (
            np.array(value, float) for value in
            np.broadcast_arrays(F_z, kappa, alpha, gamma, given))
        if (F_z < 0).any():
            raise BifaceError(f"the load F_z is {F_z.min():g} N, but must not be "
                              "negative.")
        if (given <= 0).any():
            raise BifaceError(f"the pressure is {given.min():g} Pa, but must be positive.")
        nominal = self.nominal_pressure or given
        alpha, gamma = self._side * alpha, self._side * gamma
        F_z0 = p.LFZO * p.FNOMIN
        return SimpleNamespace(
            F_z=F_z, kappa=kappa, alpha=alpha, gamma=gamma, F_z0=F_z0,
            df=(F_z - F_z0) / F_z0, dp=given / nominal - 1, pressure=given / nominal,
            alpha_star=np.tan(alpha) if self.starred else alpha,
            gamma_star=np.sin(gamma) if self.starred else gamma)

    # ---- pure slip

    def _friction_x(self, s):
        p = self.p
        return ((p.PDX1 + p.PDX2 * s.df) * (1 + p.PPX3 * s.dp + p.PPX4 * s.dp ** 2)
                * (1 - p.PDX3 * (s.gamma * p.LGAX) ** 2) * p.LMUX)

    def _slip_stiffness(self, s):
        p = self.p
        return (s.F_z * (p.PKX1 + p.PKX2 * s.df) * np.exp(p.PKX3 * s.df)
                * (1 + p.PPX1 * s.dp + p.PPX2 * s.dp ** 2) * p.LKX)

    def _longitudinal(self, s):
        """(4.E9) to (4.E18)."""
        p = self.p
        C = p.PCX1 * p.LCX
        D = self._friction_x(s) * s.F_z
        K = self._slip_stiffness(s)
        B = ratio(K, C * D)
        S_H = (p.PHX1 + p.PHX2 * s.df) * p.LHX
        S_V = s.F_z * (p.PVX1 + p.PVX2 * s.df) * p.LVX * p.LMUX
        x = s.kappa + S_H
        E = np.minimum((p.PEX1 + p.PEX2 * s.df + p.PEX3 * s.df ** 2)
                       * (1 - p.PEX4 * sign(x)) * p.LEX, 1)
        return Curve(sine(B, C, D, E, x) + S_V, K, B, C, D, S_H, S_V)

    def _friction_y(self, s):
        p = self.p
        return ((p.PDY1 + p.PDY2 * s.df) * (1 + p.PPY3 * s.dp + p.PPY4 * s.dp ** 2)
                * (1 - p.PDY3 * (s.gamma_star * p.LGAY) ** 2) * p.LMUY)

    def _cornering_stiffness(self, s, gamma):
        """(4.E25), where @p gamma is scaled."""
        p = self.p
        peak = (p.PKY2 + p.PKY5 * gamma ** 2) * (1 + p.PPY2 * s.dp)
        return (p.PKY1 * s.F_z0 * (1 + p.PPY1 * s.dp) * (1 - p.PKY3 * np.abs(gamma))
                * np.sin(p.PKY4 * arctan_of_ratio(s.F_z / s.F_z0, peak)) * p.LKY)

    def _shift_by_camber(self, s, gamma, K, S_V):
        """The horizontal shift of F_y by camber; @p S_V is the vertical one."""
        raise NotImplementedError

    def _lateral(self, s):
        """(4.E19) to (4.E30)."""
        p = self.p
        gamma = s.gamma_star * p.LGAY
        C = p.PCY1 * p.LCY
        D = self._friction_y(s) * s.F_z
        K = self._cornering_stiffness(s, gamma)
        B = ratio(K, C * D)
        S_V_gamma = s.F_z * (p.PVY3 + p.PVY4 * s.df) * gamma * p.LKYC * p.LMUY
        S_V = s.F_z * (p.PVY1 + p.PVY2 * s.df) * p.LVY * p.LMUY + S_V_gamma
        S_H = ((p.PHY1 + p.PHY2 * s.df) * p.LHY
               + self._shift_by_camber(s, gamma, K, S_V_gamma))
        x = s.alpha_star + S_H
        E = np.minimum((p.PEY1 + p.PEY2 * s.df)
                       * (1 + p.PEY5 * gamma ** 2
                          - (p.PEY3 + p.PEY4 * gamma) * sign(x)) * p.LEY, 1)
        return Curve(sine(B, C, D, E, x) + S_V, K, B, C, D, S_H, S_V)

    # ---- combined slip

    def _reduction_x(self, s):
        """The factor of F_x by the slip angle, (4.E51) to (4.E57)."""
        p = self.p
        E = np.minimum(p.REX1 + p.REX2 * s.df, 1)
        B = ((p.RBX1 + p.RBX3 * s.gamma_star ** 2) * np.cos(np.arctan(p.RBX2 * s.kappa))
             * p.LXAL)
        return (cosine(B, p.RCX1, E, s.alpha_star + p.RHX1)
                / cosine(B, p.RCX1, E, p.RHX1))

    def _reduction_y(self, s):
        """The factor of F_y by longitudinal slip, (4.E59) to (4.E65), and the force
        that this slip adds, (4.E66) and (4.E67)."""
        p = self.p
        E = np.minimum(p.REY1 + p.REY2 * s.df, 1)
        B = ((p.RBY1 + p.RBY4 * s.gamma_star ** 2)
             * np.cos(np.arctan(p.RBY2 * (s.alpha_star - p.RBY3))) * p.LYKA)
        S_H = p.RHY1 + p.RHY2 * s.df
        factor = cosine(B, p.RCY1, E, s.kappa + S_H) / cosine(B, p.RCY1, E, S_H)
        D = (self._friction_y(s) * s.F_z
             * (p.RVY1 + p.RVY2 * s.df + p.RVY3 * s.gamma_star)
             * np.cos(np.arctan(p.RVY4 * s.alpha_star)))
        return factor, D * np.sin(p.RVY5 * np.arctan(p.RVY6 * s.kappa)) * p.LVYKA

    def _force_with_trail(self, s, lateral, reduction):
        """The part of F_y that acts behind the contact center by the trail."""
        raise NotImplementedError

    def _aligning(self, s, lateral, reduction, K_x, F_x, F_y):
        """(4.E33) to (4.E47) and (4.E71) to (4.E78)."""
        p = self.p
        gamma = s.gamma_star * p.LGAZ
        R = p.UNLOADED_RADIUS
        B = ((p.QBZ1 + p.QBZ2 * s.df + p.QBZ3 * s.df ** 2)
             * (1 + p.QBZ4 * gamma + p.QBZ5 * np.abs(gamma) + p.QBZ6 * gamma ** 2)
             * ratio(p.LKY, p.LMUY))
        D = (s.F_z * R / p.FNOMIN * (p.QDZ1 + p.QDZ2 * s.df) * (1 - p.PPZ1 * s.dp)
             * (1 + p.QDZ3 * gamma + p.QDZ4 * gamma ** 2) * p.LTR)
        alpha_t = (s.alpha_star + p.QHZ1 + p.QHZ2 * s.df
                   + (p.QHZ3 + p.QHZ4 * s.df) * gamma)
        E = np.minimum((p.QEZ1 + p.QEZ2 * s.df + p.QEZ3 * s.df ** 2)
                       * (1 + (p.QEZ4 + p.QEZ5 * gamma) * 2 / np.pi
                          * np.arctan(B * p.QCZ1 * alpha_t)), 1)
        alpha_r = s.alpha_star + lateral.S_H + ratio(lateral.S_V, lateral.slope)
        B_r = p.QBZ9 * ratio(p.LKY, p.LMUY) + p.QBZ10 * lateral.B * lateral.C
        D_r = (s.F_z * R * ((p.QDZ6 + p.QDZ7 * s.df) * p.LRES
                            + ((p.QDZ8 + p.QDZ9 * s.df) * (1 + p.PPZ2 * s.dp)
                               + (p.QDZ10 + p.QDZ11 * s.df) * np.abs(gamma))
                            * gamma * p.LKZC) * p.LMUY)
        slip = ratio(K_x, lateral.slope) * s.kappa
        trail = D * cosine(B, p.QCZ1, E, equivalent(alpha_t, slip)) * np.cos(s.alpha)
        residual = (D_r * np.cos(np.arctan(B_r * equivalent(alpha_r, slip)))
                    * np.cos(s.alpha))
        arm = R * (p.SSZ1 + p.SSZ2 * F_y / p.FNOMIN
                   + (p.SSZ3 + p.SSZ4 * s.df) * s.gamma) * p.LS
        return (-trail * self._force_with_trail(s, lateral, reduction) + residual
                + arm * F_x)

    def _overturning(self, s, F_y):
        """(4.E69), with the terms of QSX12 to QSX14 of later files."""
        p = self.p
        R, load, force = p.UNLOADED_RADIUS, s.F_z / p.FNOMIN, F_y / p.FNOMIN
        return p.LMX * R * (s.F_z * (
            p.QSX1 * p.LVMX - p.QSX2 * s.gamma * (1 + p.PPMX1 * s.dp) + p.QSX3 * force
            + p.QSX4 * np.cos(p.QSX5 * np.arctan((p.QSX6 * load) ** 2))
            * np.sin(p.QSX7 * s.gamma + p.QSX8 * np.arctan(p.QSX9 * force))
            + p.QSX10 * np.arctan(p.QSX11 * load) * s.gamma
            - p.QSX12 * s.gamma * np.abs(s.gamma))
            + F_y * (p.QSX13 + p.QSX14 * np.abs(s.gamma)))

    def _load_of_rolling(self, load):
        """The load over its nominal value as it enters the rolling resistance."""
        raise NotImplementedError

    def _rolling(self, s, F_x, velocity):
        """(4.E70), with the sign that resists rolling forward."""
        p = self.p
        if velocity is not None and not self.velocity > 0:
            raise BifaceError(f"LONGVL is {self.velocity:g}, but must be positive where a "
                              "velocity is given.")
        V = 1.0 if velocity is None else np.asarray(velocity) / self.velocity
        load = s.F_z / p.FNOMIN
        return (-p.UNLOADED_RADIUS * p.FNOMIN * self._load_of_rolling(load)
                * (p.QSY1 + p.QSY2 * F_x / p.FNOMIN + p.QSY3 * np.abs(V) + p.QSY4 * V ** 4
                   + (p.QSY5 + p.QSY6 * load) * s.gamma ** 2)
                * s.pressure ** p.QSY8 * p.LMY)

    # ---- what is asked for

    def evaluate(self, F_z, kappa=0, alpha=0, gamma=0, pressure=None, velocity=None):
        """Forces and moments at combined slip, a Forces of arrays.

        F_z       load [N], not negative
        kappa     longitudinal slip, -1 for a locked wheel
        alpha     slip angle [rad], positive to the left
        gamma     inclination angle [rad], positive to the right
        pressure  inflation pressure [Pa]; that of the file by default
        velocity  forward [m/s], for M_y; LONGVL by default

        Numbers or arrays that broadcast to one shape. Without a radius moments are NaN.
        Raises BifaceError for a negative load, a pressure that is not positive, or one
        without a NOMPRES in the file."""
        s, side = self._inputs(F_z, kappa, alpha, gamma, pressure), self._side
        longitudinal, lateral = self._longitudinal(s), self._lateral(s)
        reduction, added = self._reduction_y(s)
        F_x = longitudinal.value * self._reduction_x(s)
        F_y = lateral.value * reduction + added
        M_z = self._aligning(s, lateral, reduction, longitudinal.slope, F_x, F_y)
        return Forces(F_x, side * F_y, side * self._overturning(s, F_y),
                      self._rolling(s, F_x, velocity), side * M_z)

    def longitudinal_force(self, F_z, kappa=0, alpha=0, gamma=0, pressure=None):
        """F_x at combined slip [N], (4.E50), without the work for the others; arguments as
        in evaluate()."""
        s = self._inputs(F_z, kappa, alpha, gamma, pressure)
        return self._longitudinal(s).value * self._reduction_x(s)

    def lateral_force(self, F_z, kappa=0, alpha=0, gamma=0, pressure=None):
        """F_y at combined slip [N], (4.E58); arguments as in evaluate()."""
        s = self._inputs(F_z, kappa, alpha, gamma, pressure)
        reduction, added = self._reduction_y(s)
        return self._side * (self._lateral(s).value * reduction + added)

    def overturning_moment(self, F_z, F_y, gamma=0, pressure=None):
        """M_x of a given lateral force [N m], (4.E69); arguments as in evaluate()."""
        self.need_radius()
        s = self._inputs(F_z, 0, 0, gamma, pressure)
        return self._side * self._overturning(s, self._side * F_y)

    def rolling_resistance_moment(self, F_z, F_x=0, gamma=0, pressure=None,
                                  velocity=None):
        """M_y of a given longitudinal force [N m], negative for a wheel that rolls forward,
        (4.E70); arguments as in evaluate()."""
        self.need_radius()
        return self._rolling(self._inputs(F_z, 0, 0, gamma, pressure), F_x, velocity)

    def longitudinal(self, F_z, kappa=0, gamma=0, pressure=None):
        """F_x of pure longitudinal slip, and its factors: a Curve, whose slope is the slip
        stiffness at zero slip [N]; arguments as in evaluate()."""
        return self._longitudinal(self._inputs(F_z, kappa, 0, gamma, pressure))

    def lateral(self, F_z, alpha=0, gamma=0, pressure=None):
        """F_y of pure lateral slip, and its factors: a Curve, whose slope is the cornering
        stiffness [N/rad], negative in these axes; arguments as in evaluate()."""
        curve = self._lateral(self._inputs(F_z, 0, alpha, gamma, pressure))
        return curve._replace(value=self._side * curve.value, S_H=self._side * curve.S_H,
                              S_V=self._side * curve.S_V)

    def aligning_moment(self, F_z, alpha=0, gamma=0, pressure=None):
        """M_z of pure lateral slip [N m], (4.E31); arguments as in evaluate()."""
        self.need_radius()
        s = self._inputs(F_z, 0, alpha, gamma, pressure)
        curve = self._lateral(s)
        return self._side * self._aligning(s, curve, 1, 0, 0, curve.value)


def equivalent(angle, slip):
    """The slip angle that stands for both slips in trail and residual moment, (4.E77) and
    (4.E78) with the arctangent of MF 5.2; @p slip is the longitudinal one times the ratio
    of the slip stiffnesses. Its sign is left out: both curves are even."""
    return np.arctan(np.hypot(np.tan(angle), slip))


class MF52(MagicFormula):
    """MF-Tyre 5.2 and Adams's PAC2002, with the pressure of the latter."""

    name = "5.2"
    neutral = NEUTRAL_52

    def _shift_by_camber(self, s, gamma, K, S_V):
        return self.p.PHY3 * gamma * self.p.LKYC

    def _force_with_trail(self, s, lateral, reduction):
        return lateral.value * reduction

    def _load_of_rolling(self, load):
        return load * load ** self.p.QSY7


class MF61(MagicFormula):
    """MF-Tyre 6.1; 6.2 has the same forces and moments."""

    name = "6.1"

    def _shift_by_camber(self, s, gamma, K, S_V):
        p = self.p
        stiffness = s.F_z * (p.PKY6 + p.PKY7 * s.df) * (1 + p.PPY5 * s.dp) * p.LKYC
        return ratio(stiffness * gamma - S_V, K)

    def _force_with_trail(self, s, lateral, reduction):
        # (4.E74): without camber, whose thrust does not act behind the center
        upright = SimpleNamespace(**{**vars(s), "gamma": 0 * s.gamma,
                                     "gamma_star": 0 * s.gamma})
        return self._lateral(upright).value * reduction

    def _load_of_rolling(self, load):
        return load ** self.p.QSY7


FORMULAS = {formula.name: formula for formula in (MF52, MF61)}
