# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coefficients of the Magic Formula: where they stand in a .tir file, their neutral
values, usual bounds, and which variations of a tire test they need."""

from collections import namedtuple

# section   in which a .tir file has it
# neutral   the value without an effect, or a usual one where every value has an effect
# low, high usual bounds, within which fits search
# needs     levels that data must have: l more than one load, ll more than two; p, pp
#           pressures; v, vv velocities; c an inclination angle that is not zero
# formulas  which have it: "5.2", "6.1", or both
# meaning   for the comment in the file
Coefficient = namedtuple("Coefficient",
                         "name section neutral low high needs formulas meaning")

BOTH, OLD, NEW = ("5.2", "6.1"), ("5.2",), ("6.1",)

LONGITUDINAL = "LONGITUDINAL_COEFFICIENTS"
LATERAL = "LATERAL_COEFFICIENTS"
ALIGNING = "ALIGNING_COEFFICIENTS"
OVERTURNING = "OVERTURNING_COEFFICIENTS"
ROLLING = "ROLLING_COEFFICIENTS"
SCALING = "SCALING_COEFFICIENTS"


def _coefficients(section, rows):
    return {row[0]: Coefficient(row[0], section, *row[1:]) for row in rows}


PURE_LONGITUDINAL = _coefficients(LONGITUDINAL, (
    ("PCX1", 1.65, 1, 2.5, "", BOTH, "shape factor of F_x"),
    ("PDX1", 1, 0.05, 4, "", BOTH, "friction at the nominal load"),
    ("PDX2", 0, -2, 2, "l", BOTH, "variation of the friction with load"),
    ("PDX3", 0, -100, 100, "c", BOTH, "variation of the friction with camber squared"),
    ("PEX1", 0, -20, 1, "", BOTH, "curvature factor at the nominal load"),
    ("PEX2", 0, -20, 20, "l", BOTH, "variation of the curvature with load"),
    ("PEX3", 0, -20, 20, "ll", BOTH, "variation of the curvature with load squared"),
    ("PEX4", 0, -5, 5, "", BOTH, "asymmetry of the curvature, driving and braking"),
    ("PKX1", 20, 0.5, 300, "", BOTH, "slip stiffness over load at the nominal load"),
    ("PKX2", 0, -100, 100, "l", BOTH, "variation of the slip stiffness with load"),
    ("PKX3", 0, -5, 5, "ll", BOTH, "exponent of the slip stiffness with load"),
    ("PHX1", 0, -0.1, 0.1, "", BOTH, "horizontal shift at the nominal load"),
    ("PHX2", 0, -0.1, 0.1, "l", BOTH, "variation of the horizontal shift with load"),
    ("PVX1", 0, -0.5, 0.5, "", BOTH, "vertical shift over load at the nominal load"),
    ("PVX2", 0, -0.5, 0.5, "l", BOTH, "variation of the vertical shift with load"),
    ("PPX1", 0, -10, 10, "p", BOTH, "slip stiffness with pressure"),
    ("PPX2", 0, -10, 10, "pp", BOTH, "slip stiffness with pressure squared"),
    ("PPX3", 0, -10, 10, "p", BOTH, "friction with pressure"),
    ("PPX4", 0, -10, 10, "pp", BOTH, "friction with pressure squared")))

COMBINED_LONGITUDINAL = _coefficients(LONGITUDINAL, (
    ("RBX1", 0, -100, 100, "", BOTH, "stiffness of the reduction of F_x by slip angle"),
    ("RBX2", 0, -100, 100, "", BOTH, "its variation with longitudinal slip"),
    ("RBX3", 0, -3000, 3000, "c", NEW, "its variation with camber squared"),
    ("RCX1", 1, 0.4, 2.5, "", BOTH, "shape factor of the reduction"),
    ("REX1", 0, -20, 1, "", BOTH, "curvature factor of the reduction"),
    ("REX2", 0, -20, 20, "l", BOTH, "its variation with load"),
    ("RHX1", 0, -0.2, 0.2, "", BOTH, "shift of the reduction")))

PURE_LATERAL = _coefficients(LATERAL, (
    ("PCY1", 1.3, 0.8, 2.5, "", BOTH, "shape factor of F_y"),
    ("PDY1", 1, 0.05, 4, "", BOTH, "friction at the nominal load"),
    ("PDY2", 0, -2, 2, "l", BOTH, "variation of the friction with load"),
    ("PDY3", 0, -100, 100, "c", BOTH, "variation of the friction with camber squared"),
    ("PEY1", 0, -20, 1, "", BOTH, "curvature factor at the nominal load"),
    ("PEY2", 0, -20, 20, "l", BOTH, "variation of the curvature with load"),
    ("PEY3", 0, -20, 20, "", BOTH, "asymmetry of the curvature"),
    ("PEY4", 0, -1000, 1000, "c", BOTH, "variation of the curvature with camber"),
    ("PEY5", 0, -2000, 2000, "c", NEW, "variation of the curvature with camber squared"),
    ("PKY1", -15, -200, 200, "", BOTH, "largest cornering stiffness over nominal load"),
    ("PKY2", 2, 0.1, 50, "l", BOTH, "load of the largest stiffness over nominal load"),
    ("PKY3", 0, -10, 10, "c", BOTH, "variation of the cornering stiffness with camber"),
    ("PKY4", 2, 0.5, 10, "ll", NEW, "curvature of the cornering stiffness over load"),
    ("PKY5", 0, -500, 500, "lc", NEW, "variation of PKY2 with camber squared"),
    ("PKY6", 0, -20, 20, "c", NEW, "camber stiffness over load at the nominal load"),
    ("PKY7", 0, -20, 20, "lc", NEW, "variation of the camber stiffness with load"),
    ("PHY1", 0, -0.1, 0.1, "", BOTH, "horizontal shift at the nominal load"),
    ("PHY2", 0, -0.1, 0.1, "l", BOTH, "variation of the horizontal shift with load"),
    ("PHY3", 0, -2, 2, "c", OLD, "variation of the horizontal shift with camber"),
    ("PVY1", 0, -0.5, 0.5, "", BOTH, "vertical shift over load at the nominal load"),
    ("PVY2", 0, -0.5, 0.5, "l", BOTH, "variation of the vertical shift with load"),
    ("PVY3", 0, -5, 5, "c", BOTH, "variation of the vertical shift with camber"),
    ("PVY4", 0, -5, 5, "lc", BOTH, "its variation with load"),
    ("PPY1", 0, -10, 10, "p", BOTH, "cornering stiffness with pressure"),
    ("PPY2", 0, -10, 10, "lp", BOTH, "load of the largest stiffness with pressure"),
    ("PPY3", 0, -10, 10, "p", BOTH, "friction with pressure"),
    ("PPY4", 0, -10, 10, "pp", BOTH, "friction with pressure squared"),
    ("PPY5", 0, -10, 10, "pc", NEW, "camber stiffness with pressure")))

COMBINED_LATERAL = _coefficients(LATERAL, (
    ("RBY1", 0, -100, 100, "", BOTH, "stiffness of the reduction of F_y by slip"),
    ("RBY2", 0, -100, 100, "", BOTH, "its variation with slip angle"),
    ("RBY3", 0, -1, 1, "", BOTH, "shift of the slip angle in it"),
    ("RBY4", 0, -5000, 5000, "c", NEW, "its variation with camber squared"),
    ("RCY1", 1, 0.4, 2.5, "", BOTH, "shape factor of the reduction"),
    ("REY1", 0, -20, 1, "", BOTH, "curvature factor of the reduction"),
    ("REY2", 0, -20, 20, "l", BOTH, "its variation with load"),
    ("RHY1", 0, -0.2, 0.2, "", BOTH, "shift of the reduction"),
    ("RHY2", 0, -0.2, 0.2, "l", BOTH, "its variation with load"),
    ("RVY1", 0, -2, 2, "", BOTH, "F_y by longitudinal slip over friction and load"),
    ("RVY2", 0, -2, 2, "l", BOTH, "its variation with load"),
    ("RVY3", 0, -20, 20, "c", BOTH, "its variation with camber"),
    ("RVY4", 0, -200, 200, "", BOTH, "its variation with slip angle"),
    ("RVY5", 1.9, -5, 5, "", BOTH, "its shape factor over longitudinal slip"),
    ("RVY6", 10, -100, 100, "", BOTH, "its stiffness factor over longitudinal slip")))

PURE_ALIGNING = _coefficients(ALIGNING, (
    ("QBZ1", 10, -60, 60, "", BOTH, "stiffness factor of the trail"),
    ("QBZ2", 0, -60, 60, "l", BOTH, "its variation with load"),
    ("QBZ3", 0, -60, 60, "ll", BOTH, "its variation with load squared"),
    ("QBZ4", 0, -50, 50, "c", BOTH, "its variation with camber"),
    ("QBZ5", 0, -50, 50, "c", BOTH, "its variation with the absolute camber"),
    ("QBZ9", 0, -500, 500, "", BOTH, "stiffness factor of the residual moment"),
    ("QBZ10", 0, -100, 100, "l", BOTH, "its part in proportion to that of F_y"),
    ("QCZ1", 1.1, 0.5, 2.5, "", BOTH, "shape factor of the trail"),
    ("QDZ1", 0, -1, 1, "", BOTH, "largest trail over radius at the nominal load"),
    ("QDZ2", 0, -1, 1, "l", BOTH, "its variation with load"),
    ("QDZ3", 0, -50, 50, "c", BOTH, "its variation with camber"),
    ("QDZ4", 0, -500, 500, "c", BOTH, "its variation with camber squared"),
    ("QDZ6", 0, -0.2, 0.2, "", BOTH, "residual moment over load and radius"),
    ("QDZ7", 0, -0.2, 0.2, "l", BOTH, "its variation with load"),
    ("QDZ8", 0, -10, 10, "c", BOTH, "its variation with camber"),
    ("QDZ9", 0, -10, 10, "lc", BOTH, "its variation with camber and load"),
    ("QDZ10", 0, -50, 50, "c", NEW, "its variation with camber squared"),
    ("QDZ11", 0, -50, 50, "lc", NEW, "its variation with camber squared and load"),
    ("QEZ1", 0, -50, 1, "", BOTH, "curvature factor of the trail"),
    ("QEZ2", 0, -50, 50, "l", BOTH, "its variation with load"),
    ("QEZ3", 0, -50, 50, "ll", BOTH, "its variation with load squared"),
    ("QEZ4", 0, -20, 20, "", BOTH, "asymmetry of the curvature"),
    ("QEZ5", 0, -1000, 1000, "c", BOTH, "asymmetry of the curvature with camber"),
    ("QHZ1", 0, -0.1, 0.1, "", BOTH, "shift of the trail"),
    ("QHZ2", 0, -0.1, 0.1, "l", BOTH, "its variation with load"),
    ("QHZ3", 0, -5, 5, "c", BOTH, "its variation with camber"),
    ("QHZ4", 0, -5, 5, "lc", BOTH, "its variation with camber and load"),
    ("PPZ1", 0, -10, 10, "p", BOTH, "trail with pressure"),
    ("PPZ2", 0, -10, 10, "pc", BOTH, "residual moment by camber with pressure")))

COMBINED_ALIGNING = _coefficients(ALIGNING, (
    ("SSZ1", 0, -1, 1, "", BOTH, "arm of F_x over radius"),
    ("SSZ2", 0, -5, 5, "", BOTH, "its variation with F_y"),
    ("SSZ3", 0, -20, 20, "c", BOTH, "its variation with camber"),
    ("SSZ4", 0, -20, 20, "lc", BOTH, "its variation with camber and load")))

OVERTURNING_MOMENT = _coefficients(OVERTURNING, (
    ("QSX1", 0, -1, 1, "", BOTH, "shift of M_x over load and radius"),
    ("QSX2", 0, -50, 50, "c", BOTH, "M_x by camber"),
    ("QSX3", 0, -10, 10, "", BOTH, "M_x by F_y"),
    ("QSX4", 0, -50, 50, "", NEW, "M_x by load, camber and F_y"),
    ("QSX5", 0, -10, 10, "l", NEW, "its shape factor over load"),
    ("QSX6", 1, 0, 20, "l", NEW, "its stiffness factor over load"),
    ("QSX7", 0, -50, 50, "c", NEW, "its variation with camber"),
    ("QSX8", 0, -50, 50, "", NEW, "its shape factor over F_y"),
    ("QSX9", 1, -50, 50, "", NEW, "its stiffness factor over F_y"),
    ("QSX10", 0, -50, 50, "lc", NEW, "M_x by camber and load"),
    ("QSX11", 1, -50, 50, "llc", NEW, "its stiffness factor over load"),
    ("PPMX1", 0, -10, 10, "pc", BOTH, "M_x by camber with pressure")))

ROLLING_RESISTANCE = _coefficients(ROLLING, (
    ("QSY1", 0, -0.5, 0.5, "", BOTH, "rolling resistance coefficient"),
    ("QSY2", 0, -5, 5, "", BOTH, "its variation with F_x"),
    ("QSY3", 0, -0.5, 0.5, "v", BOTH, "its variation with velocity"),
    ("QSY4", 0, -0.5, 0.5, "vv", BOTH, "its variation with velocity to the fourth"),
    ("QSY5", 0, -50, 50, "c", NEW, "its variation with camber squared"),
    ("QSY6", 0, -50, 50, "lc", NEW, "its variation with camber squared and load"),
    ("QSY7", 1, 0, 3, "l", NEW, "exponent of the load"),
    ("QSY8", 0, -3, 3, "p", NEW, "exponent of the pressure")))

# Coefficients that are evaluated where a file has them, but not fitted: of Adams's
# PAC2002, MF 6.2, and the book
EXTRA = _coefficients(OVERTURNING, (
    ("QSX12", 0, -50, 50, "c", BOTH, "M_x by camber and its absolute value"),
    ("QSX13", 0, -10, 10, "", BOTH, "M_x by F_y"),
    ("QSX14", 0, -50, 50, "c", BOTH, "M_x by F_y and the absolute camber"))) \
    | _coefficients(ALIGNING, (
        ("QBZ6", 0, -500, 500, "c", BOTH,
         "stiffness factor of the trail with camber squared"),))

SCALES = _coefficients(SCALING, tuple(
    (name, 1, 0, 10, "", formulas, "scale of " + meaning)
    for name, formulas, meaning in (
        ("LFZO", BOTH, "the nominal load"),
        ("LCX", BOTH, "the shape factor of F_x"),
        ("LMUX", BOTH, "the friction in x"),
        ("LEX", BOTH, "the curvature of F_x"),
        ("LKX", BOTH, "the slip stiffness"),
        ("LHX", BOTH, "the horizontal shift of F_x"),
        ("LVX", BOTH, "the vertical shift of F_x"),
        ("LGAX", OLD, "camber for F_x"),
        ("LCY", BOTH, "the shape factor of F_y"),
        ("LMUY", BOTH, "the friction in y"),
        ("LEY", BOTH, "the curvature of F_y"),
        ("LKY", BOTH, "the cornering stiffness"),
        ("LKYC", BOTH, "the camber stiffness"),
        ("LHY", BOTH, "the horizontal shift of F_y"),
        ("LVY", BOTH, "the vertical shift of F_y"),
        ("LGAY", OLD, "camber for F_y"),
        ("LTR", BOTH, "the pneumatic trail"),
        ("LRES", BOTH, "the residual moment"),
        ("LKZC", NEW, "the residual moment by camber"),
        ("LGAZ", OLD, "camber for M_z"),
        ("LXAL", BOTH, "the effect of the slip angle on F_x"),
        ("LYKA", BOTH, "the effect of longitudinal slip on F_y"),
        ("LVYKA", BOTH, "F_y by longitudinal slip"),
        ("LS", BOTH, "the arm of F_x"),
        ("LVMX", BOTH, "the shift of M_x"),
        ("LMX", BOTH, "the overturning moment"),
        ("LMY", BOTH, "the rolling resistance moment"))))

# All that the formulas use
COEFFICIENTS = {**PURE_LONGITUDINAL, **COMBINED_LONGITUDINAL, **PURE_LATERAL,
                **COMBINED_LATERAL, **PURE_ALIGNING, **COMBINED_ALIGNING,
                **OVERTURNING_MOMENT, **ROLLING_RESISTANCE, **EXTRA, **SCALES}

# Reductions of F_x and F_y by each other, without their shifts, of a passenger car tire
# 205/60 R15 @cite TNO2013, for data without combined slip
TYPICAL = {"RBX1": 12.531, "RBX2": 9.532, "RCX1": 1.019, "REX1": -0.4487,
           "RBY1": 10.615, "RBY2": 7.705, "RCY1": 1.0585, "REY1": 0.3132}
TYPICAL_TIRE = "a 205/60 R15 of TNO"

NEUTRAL = {name: coefficient.neutral for name, coefficient in COEFFICIENTS.items()}

# Rolling resistance is proportional to the load in both formulas if a file does not tell
# its exponent, which MF 5.2 adds to 1 and MF 6.1 does not
NEUTRAL_52 = {**NEUTRAL, "QSY7": 0}

# Other names of the same, in Adams's PAC2002 and in older files
ALIASES = {"LFZ0": "LFZO", "LKYG": "LKYC", "LKG": "LKYC", "LKZG": "LKZC", "LMR": "LRES",
           "QPZ1": "PPZ1", "QPZ2": "PPZ2", "QPX1": "PPMX1", "IP": "INFLPRES",
           "IP_NOM": "NOMPRES"}

# Those names in a file of MF 5.2 that the program writes
NAMES_52 = {"PPZ1": "QPZ1", "PPZ2": "QPZ2", "PPMX1": "QPX1", "INFLPRES": "IP",
            "NOMPRES": "IP_NOM"}

# Entries that a formula needs beside the coefficients
CONSTANTS = ("FNOMIN", "UNLOADED_RADIUS", "LONGVL", "INFLPRES", "NOMPRES")
