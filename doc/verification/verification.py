#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the benchmarks on three meshes each and compare with published values.

Runs every parameter file of tests/verification as it is, with half and with
twice the cells in each direction, and writes

    verification.md      the page: problems, values, deviations, orders
    verification/*.png   load against displacement, where a path is known

The published values are the comments '# expect:' of the parameter files, see
tests/verification/verify.cc. The published paths are tests/data/sze_*.csv, the
exact ones exact_*.csv. A run is repeated only if the program or its parameter
file has changed.
"""

import argparse
import csv
import math
import re
import subprocess
import sys
import textwrap
from collections import namedtuple
from fractions import Fraction
from pathlib import Path

import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source/python"))

from biface_report.drawing import STYLE

# Cells in each direction, relative to the parameter file
FACTORS = (Fraction(1, 2), Fraction(1), Fraction(2))

# Headings that do not follow from the file names
HEADINGS = {
    "buckling_column": "Euler's column",
    "buckling_cylinder": "Buckling of a cylinder under axial compression",
    "buckling_plate": "Buckling of a square plate under compression",
    "buckling_ring": "Buckling of a long cylinder under pressure",
    "buckling_ring_dead": "Buckling of a long cylinder under dead pressure",
    "critical_column": "Elastica beyond Euler's load",
    "critical_cap": "Snap-through of a shallow cap",
    "critical_cap_waves": "Buckling of a shallow cap in two waves",
    "critical_roof": "Limit point of the hinged roof",
    "critical_cylinder_with_waves": "Buckling of a cylinder with axisymmetric waves",
    "cantilever_end_shear": "Cantilever under end shear",
    "cantilever_roll_up": "Cantilever bent into a circle",
    "clamped_semicylinder": "Clamped semi-cylinder",
    "clamped_semicylinder_0_90_0": "Clamped semi-cylinder, [0/90/0]",
    "clamped_semicylinder_90_0_90": "Clamped semi-cylinder, [90/0/90]",
    "hemisphere": "Hemisphere, small load",
    "hemisphere_large": "Hemisphere, large load, one step",
    "hemisphere_path": "Hemisphere, large load",
    "hinged_roof": "Hinged roof, thickness 12.7",
    "hinged_roof_0_90_0": "Hinged roof, thickness 12.7, [0/90/0]",
    "hinged_roof_90_0_90": "Hinged roof, thickness 12.7, [90/0/90]",
    "hinged_roof_two_stages": "Hinged roof, thickness 12.7, two stages",
    "hinged_roof_thin": "Hinged roof, thickness 6.35",
    "hinged_roof_thin_0_90_0": "Hinged roof, thickness 6.35, [0/90/0]",
    "hinged_roof_thin_90_0_90": "Hinged roof, thickness 6.35, [90/0/90]",
    "linear_under_pressure": "Ring under pressure",
    "membrane_on_sphere": "Membrane on a sphere",
    "modes_fv52": "Vibration of a thick square plate, NAFEMS FV52",
    "modes_khdeir_30_2": "Vibration of a square plate of 2 plies [30/-30]",
    "modes_khdeir_30_4": "Vibration of a square plate of 4 plies [30/-30]",
    "modes_khdeir_30_10": "Vibration of a square plate of 10 plies [30/-30]",
    "modes_khdeir_45_2": "Vibration of a square plate of 2 plies [45/-45]",
    "modes_khdeir_45_4": "Vibration of a square plate of 4 plies [45/-45]",
    "modes_khdeir_45_10": "Vibration of a square plate of 10 plies [45/-45]",
    "modes_membrane": "Vibration of a membrane under tension",
    "modes_ring": "Vibration of a ring under pressure",
    "modes_string": "Vibration of a string under tension",
    "nafems_cylinder": "Wrapped thick cylinder, NAFEMS R0031/2",
    "nafems_sandwich": "Sandwich plate, NAFEMS R0031/3",
    "nafems_sandwich_soft": "Sandwich plate, edges free to move along",
    "nafems_strip": "Laminated strip, NAFEMS R0031/1",
    "open_cylinder": "Cylinder with open ends, pulled",
    "pagano_0_4": "Strip [0], length over thickness 4",
    "pagano_0_10": "Strip [0], length over thickness 10",
    "pagano_0_90_4": "Strip [0/90], length over thickness 4",
    "pagano_0_90_10": "Strip [0/90], length over thickness 10",
    "pagano_4": "Strip [0/90/0], length over thickness 4, constant shear strain",
    "pagano_4_equilibrium": "Strip [0/90/0], length over thickness 4",
    "pagano_10": "Strip [0/90/0], length over thickness 10, constant shear strain",
    "pagano_10_equilibrium": "Strip [0/90/0], length over thickness 10",
    "pagano_20_equilibrium": "Strip [0/90/0], length over thickness 20",
    "pagano_50": "Strip [0/90/0], length over thickness 50, constant shear strain",
    "pagano_100":
        "Strip [0/90/0], length over thickness 100, constant shear strain",
    "pagano_4_plies": "Strip [0/90/0], length over thickness 4, three layers",
    "pagano_4_stack": "Strip [0/90/0], length over thickness 4, twelve layers",
    "pagano_10_stack": "Strip [0/90/0], length over thickness 10, twelve layers",
    "ren_panel_4_stack": "Panel [90/0/90], radius over thickness 4, twelve layers",
    "nafems_sandwich_stack": "Sandwich plate, NAFEMS R0031/3, three layers",
    "pagano_square_4": "Square plate [0/90/0], side over thickness 4",
    "pagano_square_10": "Square plate [0/90/0], side over thickness 10",
    "patch_bending": "Patch test, bending",
    "patch_membrane": "Patch test, membrane",
    "clamped_plate_thin": "Clamped plate, length over thickness 1e5",
    "pinched_cylinder": "Pinched cylinder, small load",
    "pinched_free_cylinder": "Pinched cylinder with free ends",
    "pinched_free_cylinder_100":
        "Pinched cylinder with free ends, radius over thickness 1e2",
    "pinched_free_cylinder_10000":
        "Pinched cylinder with free ends, radius over thickness 1e4",
    "pinched_free_cylinder_1000000":
        "Pinched cylinder with free ends, radius over thickness 1e6",
    "pinched_cylinder_large": "Pinched cylinder, large load",
    "ren_panel_4": "Panel [90/0/90], radius over thickness 4",
    "ren_panel_10": "Panel [90/0/90], radius over thickness 10",
    "ren_panel_50": "Panel [90/0/90], radius over thickness 50",
    "ren_panel_0_90_10": "Panel [0/90], radius over thickness 10",
    "ren_panel_0_90_50": "Panel [0/90], radius over thickness 50",
    "relaxation_creep": "Creep of a cylinder under pressure",
    "relaxation_ramp": "Relaxation after a ramp, at two temperatures",
    "relaxation_rubber": "Relaxation of stretched rubber",
    "rubber_balloon": "Balloon of Ogden's rubber, sixfold radius",
    "rubber_bending": "Strip of rubber bent into a ring",
    "rubber_bending_layers": "Strip of eight layers of rubber bent by a moment",
    "rubber_disk": "Inflated disk of Mooney-Rivlin rubber",
    "rubber_shear": "Block of rubber sheared under pressure",
    "rubber_sphere": "Inflated sphere of neo-Hookean rubber",
    "rubber_sphere_limit": "Limit point of a thin sphere of rubber",
    "rubber_stack": "Strip of two layers of rubber, small load",
    "rubber_tube": "Inflated tube of neo-Hookean rubber",
    "rubber_tube_stack": "Inflated tube of rubber in four layers",
    "scordelis_lo": "Scordelis-Lo roof",
    "slack_strip": "Strip of cords with two moduli, pulled and pushed",
    "slack_strip_bending": "Strip of cords with two moduli, bent",
    "slack_strip_bending_one_ply":
        "Strip of cords with two moduli, bent, a single ply",
    "slit_annulus": "Slit annular plate",
    "stepped_strip": "Strip with a step of thickness",
    "strip_on_drum": "Strip on a drum",
    "strip_on_flat": "Strip on a rigid flat",
    "thin_strip": "Strip, length over thickness 1e5",
    "torus_membrane": "Torus under pressure",
}

# What the benchmarks are for: title, a sentence, and the names of the files
PURPOSES = [
    ("The element",
     "Exact states of strain on distorted cells, and shells so thin that locking "
     "would show.",
     ["patch_membrane", "patch_bending", "thin_strip", "clamped_plate",
      "clamped_plate_thin", "pinched_free_cylinder",
      "pinched_free_cylinder_100", "pinched_free_cylinder_10000",
      "pinched_free_cylinder_1000000", "stepped_strip", "eccentric_pull"]),
    ("Linear shells",
     "Bending and membrane action of curved shells, with small displacements.",
     ["scordelis_lo", "pinched_cylinder", "hemisphere", "torus_membrane",
      "linear_under_pressure", "sphere_under_pressure"]),
    ("Large displacements and rotations",
     "Deviations of one percent are those of the quadratic terms of the strains, "
     "see the hinged roof of thickness 12.7, or of the published values.",
     ["cantilever_end_shear", "cantilever_roll_up", "slit_annulus",
      "hemisphere_path", "hemisphere_large", "open_cylinder",
      "pinched_cylinder_large", "clamped_semicylinder",
      "clamped_semicylinder_0_90_0", "clamped_semicylinder_90_0_90",
      "inflated_cylinder", "spinning_ring"]),
    ("Snap-through and buckling",
     "Limit points, bifurcations and paths beyond them.",
     ["hinged_roof", "hinged_roof_0_90_0", "hinged_roof_90_0_90",
      "hinged_roof_thin", "hinged_roof_thin_0_90_0",
      "hinged_roof_thin_90_0_90", "hinged_roof_two_stages", "critical_roof",
      "disk_spring", "critical_cap", "critical_cap_waves", "buckling_column",
      "critical_column", "buckling_plate", "buckling_cylinder",
      "critical_cylinder_with_waves",
      "buckling_ring", "buckling_ring_dead"]),
    ("Vibration", "Natural frequencies, also of shells under tension or pressure.",
     ["modes_string", "modes_membrane", "modes_ring", "modes_fv52",
      "modes_khdeir_30_2", "modes_khdeir_30_4", "modes_khdeir_30_10",
      "modes_khdeir_45_2", "modes_khdeir_45_4", "modes_khdeir_45_10"]),
    ("Thick laminates",
     "Where the assumptions on the thickness end: displacements that are linear "
     "from face to face, a constant thickness stress, and the two laws of "
     "transverse shear, `constant strain` and `equilibrium`. The deviations, up "
     "to a quarter, are those of the model; they do not vanish on fine meshes.",
     ["nafems_strip", "nafems_cylinder", "nafems_sandwich",
      "nafems_sandwich_soft", "pagano_4", "pagano_10", "pagano_50",
      "pagano_100", "pagano_4_equilibrium", "pagano_10_equilibrium",
      "pagano_20_equilibrium", "pagano_0_4", "pagano_0_10", "pagano_0_90_4",
      "pagano_0_90_10", "pagano_square_4", "pagano_square_10", "ren_panel_4",
      "ren_panel_10", "ren_panel_50", "ren_panel_0_90_10",
      "ren_panel_0_90_50", "pagano_4_plies", "pagano_4_stack",
      "pagano_10_stack", "ren_panel_4_stack", "nafems_sandwich_stack"]),
    ("Cords",
     "The shape and the tension of cords under pressure, and cords that go slack.",
     ["cord_equilibrium", "cord_tension", "slack_strip", "slack_strip_bending",
      "slack_strip_bending_one_ply"]),
    ("Rubber",
     "Neo-Hookean, Mooney-Rivlin and Ogden's laws at large strains, beside exact "
     "solutions for incompressible rubber. States that are the same all over the "
     "shell have a single cell; what deviates there is the thickness of a layer, in "
     "which strains are linear.",
     ["rubber_tube", "rubber_tube_stack", "rubber_sphere", "rubber_sphere_limit",
      "rubber_balloon", "rubber_disk", "rubber_bending", "rubber_bending_layers",
      "rubber_stack",
      "rubber_shear"]),
    ("Relaxation",
     "Stresses that relax by a Prony series in stages with a duration.",
     ["relaxation_ramp", "relaxation_rubber", "relaxation_creep"]),
    ("Initial stresses", "Stresses in the undeformed shell, and starts from prestress.",
     ["tensioned_strip", "initial_resultants", "prestressed_strip",
      "pulled_cylinder"]),
    ("Contact and friction",
     "The deviations of strips and membranes on rigid bodies decrease with the "
     "first or second power of the cell size: only nodes make contact.",
     ["strip_on_flat", "strip_on_drum", "membrane_on_sphere",
      "squeezed_cylinder", "rough_plane"]),
]

# Runs besides those on three meshes: settings by the name in the tables
FURTHER_RUNS = {
    "pinched_cylinder_large": {"in 40 steps": ["Stage 1/Steps=40"]},
    "slit_annulus": {"in 20 steps": ["Stage 1/Steps=20"]},
}

# A curve of a path: column of the file of the reference, name of the point,
# column of probes.csv, sign, symbol
Curve = namedtuple("Curve", "reference point column sign symbol")

PATHS = {
    "cantilever_end_shear": [
        Curve("minus_U_tip", "tip", "u_x", -1, "$-u_x$ of the tip"),
        Curve("W_tip", "tip", "u_z", 1, "$u_z$ of the tip")],
    "cantilever_roll_up": [
        Curve("minus_U_tip", "tip", "u_x", -1, "$-u_x$ of the tip"),
        Curve("W_tip", "tip", "u_z", 1, "$u_z$ of the tip")],
    "clamped_semicylinder": [
        Curve("minus_W", "crown", "u_x", -1, "$-u_x$ of the crown")],
    "hemisphere_path": [
        Curve("V_pull", "pull", "u_x", 1, "$u_x$ of the pulled point"),
        Curve("minus_U_push", "push", "u_z", -1, "$-u_z$ of the pushed point")],
    "hinged_roof": [
        Curve("minus_W_centre", "center", "u_x", -1, "$-u_x$ of the center")],
    "open_cylinder": [
        Curve("W_A", "pull", "u_x", 1, "$u_x$ under the force"),
        Curve("minus_U_B", "side", "u_z", -1, "$-u_z$ of the side"),
        Curve("minus_U_C", "end", "u_z", -1, "$-u_z$ of the end")],
    "pinched_cylinder_large": [
        Curve("minus_W_A", "load", "u_x", -1, "$-u_x$ of load"),
        Curve("U_B", "side", "u_z", 1, "$u_z$ of side")],
    "slit_annulus": [
        Curve("W_inner", "inner", "u_y", 1, "$u_y$, inner radius"),
        Curve("W_outer", "outer", "u_y", 1, "$u_y$, outer radius")],
}

# Position of the legend, where none of the automatic ones is free
LEGENDS = {"pinched_cylinder_large": {"loc": "center",
                                      "bbox_to_anchor": (0.61, 0.5)}}

# Remarks on the results. {0}, {1} ... are the values on the finest mesh, in the
# order of the parameter file, {d[0]} ... their deviations.
REMARKS = {
    "cantilever_roll_up":
        "The moment rotates with the end. With the 16 × 1 cells of the literature "
        "`u_x` deviates by -2.9 % at the full circle, and `u_z` by -8.9 % at "
        "load factor 0.75, where it falls rapidly. An error of 0.2 % of the angle "
        "of the end remains on fine meshes. It is of the order of (thickness over "
        "radius)², here 0.27 %, and a quarter of it remains at half the "
        "thickness. For its cause see the hinged roof of thickness 12.7.",
    "clamped_semicylinder":
        "At a quarter of the load the path is so flat that small changes of the "
        "load cause large changes of the displacement: the displacement deviates "
        "by {d[0]:+.1f} % on the finest mesh; beyond this point, the load at equal "
        "displacement deviates by -0.8 to -1.3 %.",
    "clamped_semicylinder_0_90_0":
        "No step converges beyond 84 % of "
        "the load, with `Formulation = paper` beyond 71 %, where the strain of the inner "
        "face comes close to -1/3 at the fold.",
    "clamped_semicylinder_90_0_90":
        "With `Formulation = paper` a negative pivot appears at 45 % of "
        "the load, and no step converges beyond 51 %: the checkerboard of the "
        "element in compression, see [theory.md](theory.md), section 3.",
    "hemisphere":
        "The reference is the middle of the range of published values, which "
        "spans 1.7 %.",
    "hinged_roof":
        "A limit load is the extremum of the parabola through three steps of the "
        "path. **Here the results deviate from the reference**: with mesh "
        "refinement the upper limit load converges to {0:.4f}, {d[0]:+.1f} % off "
        "the reference. The lower one is {1:.4f} on the finest mesh, "
        "{d[1]:+.1f} % off. The references are the maximum and minimum values of "
        "a table; parabolas through its points have their extrema at 0.7437 and "
        "0.1717, and the upper limit load deviates by -1.1 % from the former. "
        "The cause is the strain, which is linear between the two faces as in "
        "eq. (1) of the paper: its quadratic terms replace the mean h²/12 of z² "
        "over the thickness h by h²/4. Therefore bending strains the middle "
        "surface more than it should, which reduces the stiffness in proportion "
        "to h². A plane arch of the same section confirms this: its limit load is "
        "0.8 % below that of a geometrically exact beam, of which 0.3 % are due "
        "to terms of Green's strain that such a beam neglects. The limit loads of "
        "roofs of half the thickness, below, deviate by half as much or less. No "
        "order is given, since limit loads also depend slightly on the positions "
        "of the steps.",
    "hinged_roof_0_90_0":
        "The deviation is that of the isotropic roof, see there.",
    "hinged_roof_90_0_90":
        "The deviation is that of the isotropic roof, see there.",
    "hinged_roof_thin_0_90_0":
        "The load at the end of the stage is the load at the displacement of the "
        "table. The path falls there, by 3 % in the last of the 20 steps.",
    "nafems_cylinder":
        "**The cylinder is too thick for the assumptions on its thickness.** "
        "Displacements are linear over it, the thickness stress is constant, and "
        "the integrals over the thickness are those of a plate. In the "
        "three-dimensional solution the radial stress goes from -200 to 0 MPa, "
        "and the hoop stresses change accordingly by Poisson's ratio. Stresses "
        "deviate by up to {d[3]:+.1f} %, but their resultant by only 2 %. "
        "Transverse shear has no part in this.",
    "nafems_sandwich":
        "The references of NAFEMS are a series solution for thin face sheets. "
        "With constant shear strain the deflection is -0.0845 in, -31 % off. The "
        "three-dimensional solution with a core that is stiff in thickness "
        "direction is -0.1222 in.",
    "nafems_sandwich_soft":
        "This deflection, 11 % larger than that of NAFEMS, has been attributed to "
        "the compression of the core. It is that of the other support: with the "
        "supports of NAFEMS three-dimensional elasticity gives -0.122 in.",
    "open_cylinder":
        "Near half the load the side of the cylinder snaps outward. On the "
        "coarsest mesh it has already snapped at load factor 0.5, on the others "
        "and in the reference it has not.",
    "pagano_4":
        "**The law of the paper, the default of laminates, is too stiff in transverse "
        "shear for so thick a one.** "
        "Displacements are linear from face to face, so that all plies have the "
        "same transverse shear strain. In reality it is larger in the 90 degree "
        "ply, whose shear modulus is 2.5 times smaller, and varies within the "
        "plies. With mesh refinement the results converge to first-order plate "
        "theory, the second value, and not to the three-dimensional solution: the "
        "deflection is too small by 27.5 % at length over thickness 4, 18.1 % at "
        "10, 1.4 % at 50 and 0.4 % at 100, see the sections below. `Laminate/"
        "Transverse shear = equilibrium` corrects this, see below; "
        "theory.md, section 4, derives it. The three-dimensional "
        "values were recomputed from the equations of equilibrium: 2.88723, "
        "0.93164, 0.52698, 0.51399.",
    "pagano_4_equilibrium":
        "The deflection is too large, since at this length cross sections warp so "
        "much that their bending is no longer that of first-order theory. At "
        "length over thickness 10 it is off by +1.4 %, and at 20 by +0.2 %, see "
        "below.",
    "pagano_0_90_4":
        "In such a laminate the thickness stress, constant here, also bends the "
        "strip: without the thickness strain, the deflection of first-order theory "
        "with this shear stiffness is off by +2.7 %.",
    "pagano_square_4":
        "With constant shear strain the deflection is off by -21.8 %.",
    "pagano_square_10":
        "With constant shear strain the deflection is off by -16.3 %. The large "
        "deviation of `interlaminar_t_23` does not vanish for thin plates: a part of "
        "this shear force comes from twisting, and is distributed as if it came "
        "from bending, see theory.md, section 4.",
    "ren_panel_4":
        "With constant shear strain the deflection is off by -27.6 %, at radius "
        "over thickness 10 by -17.5 %, and at 50 by -1.3 %.",
    "ren_panel_0_90_10":
        "With the integrals of a plate, `Laminate/Integrals = plate`, the deflection "
        "is off by -5.7 %, at radius over thickness 50 by -1.3 %: plies of "
        "different stiffness lie at different radii.",
    "pinched_cylinder":
        "The reference is the solution of a thin shell without transverse shear "
        "strain. Here this strain increases the displacement, which is unbounded "
        "under a point force F: it grows by F ln 2/(2 π G h), 0.17 % of the "
        "reference, with each halving of the cell size. The limit above is "
        "therefore meaningless. With transverse shear moduli 1000 times as large the "
        "deviation is -1.15, -0.57 and -0.44 % on 32 × 32, 64 × 64 and 96 × 96 "
        "cells, instead of +0.10, +0.84 and +1.06 %: on the last mesh transverse "
        "shear contributes 1.5 %.",
    "pinched_free_cylinder_100":
        "With mesh refinement c converges to 1.969, and not to the published 1.997. "
        "For thinner walls, below, the same model meets the published values.",
    "pinched_free_cylinder_1000000":
        "This is the limit of double precision: the stiffnesses against stretching "
        "and bending differ by a factor of 1e12, and round-off in the tangent "
        "changes the displacement by some tenths of a percent. On the finest mesh "
        "the iteration no longer converges; with `Formulation = paper` "
        "it does, to 0.15 %.",
    "pinched_cylinder_large":
        "The diaphragm holds the middle surface, `v_2 middle; v_3 middle`, and not "
        "both faces as under the small load: where the wall rotates by a large "
        "angle, the radial extent of its thickness must be free to decrease. "
        "Otherwise the edge is nearly clamped, and the displacement at load "
        "factor 0.25 is 10 % too small. **The side moves by more than published**, "
        "at load factor 0.25 by {d[5]:+.1f} % on the finest mesh, where its path "
        "is flat. If the edge is also kept from rotating about the axis, "
        "`v_2 both; v_3 middle`, all values on 80 × 80 cells are within 2.1 % of "
        "the reference, and those at the whole load within 1.7 %: probably this is "
        "its diaphragm, with 40 × 40 cells of another element. On 40 × 40 cells "
        "they are up to 3.3 % too small under the force and 6.8 % at the side. The "
        "waves of the path are an effect of the mesh: the rim of the dent moves "
        "from cell to cell.",
    "rubber_bending":
        "At k h = 0.6 the limit of `u_x` is the error of two layers. With eight "
        "layers on the finest mesh no step converges beyond 81 % of the last "
        "moment: the faces at the loaded end have many negative pivots.",
    "rubber_disk":
        "The cells of the coarsest mesh are 4 mm wide, too wide for so thin a "
        "rubber wall under a pressure (see [limits.md](limits.md)): negative "
        "pivots appear that no shell has, and on the way to 45 psi steps get "
        "smaller until none converges. With K = 1.4e4 the pressures are up to "
        "0.1 % smaller.",
    "rubber_stack":
        "The limit is that of the `Gradient factor` of 8, the default of several "
        "layers: with 1 the deflection on the finest mesh is off by +0.01 %.",
    "scordelis_lo":
        "Other published values are as low as 0.3006.",
    "slit_annulus":
        "The parameter file applies the whole load in one step. The path in the "
        "picture is a run in 20 steps.",
    "squeezed_cylinder":
        "The reference neglects the stretching of the cylinder, 0.01 %. The "
        "contact area is that of the nodes in contact and changes by whole "
        "cells, so that its order means little.",
    "strip_on_drum":
        "The contact area is that of the nodes in contact and changes by whole "
        "cells.",
    "strip_on_flat":
        "The contact area is that of the nodes in contact and changes by whole "
        "cells; here it extends one cell beyond the exact edge.",
}

# Those of 'Formulation' that are compared
FORMULATIONS = "standard", "paper"

FORMULATION = (
    "The same problems with the standard element and with that of the paper (`Formulation`, "
    "see [theory.md](theory.md), section 3), where the shell is curved or its frames "
    "turn: the largest deviation of each problem on meshes with half, with all and "
    "with twice the cells of the parameter file. A dash means that a step did not "
    "converge. `paper` is exact for what is the same all around an axis, however "
    "wide the cells; `standard` is not: the torus, the cords and the spinning ring have "
    "wide cells, and so does the pinched cylinder, which bends without stretching.")

# Thick laminates, and the walls that are compared on them
STACKED = [
    "nafems_strip", "nafems_cylinder", "nafems_sandwich", "nafems_sandwich_soft",
    "pagano_4_equilibrium", "pagano_10_equilibrium", "pagano_20_equilibrium",
    "pagano_50", "pagano_100", "pagano_0_4", "pagano_0_10", "pagano_0_90_4",
    "pagano_0_90_10", "pagano_square_4", "pagano_square_10", "ren_panel_4",
    "ren_panel_10", "ren_panel_50", "ren_panel_0_90_10", "ren_panel_0_90_50"]
WALLS = {
    "one layer": ["Laminate/Layers=one", "Laminate/Transverse shear=constant strain"],
    "one layer, equilibrium": ["Laminate/Layers=one",
                               "Laminate/Transverse shear=equilibrium"],
    "one per ply": ["Laminate/Layers=one per ply",
                    "Laminate/Transverse shear=constant strain"],
    "four per ply": ["Laminate/Layers=4 per ply",
                     "Laminate/Transverse shear=constant strain"],
}
STACKS = (
    "Every thick laminate of this page on the mesh of its file, as a single layer "
    "with both laws of transverse shear, and as a stack with one and with four "
    "layers per ply and a constant shear strain in each (`Laminate/Layers`, see "
    "[theory.md](theory.md)): first the largest deviation of a deflection, then that "
    "of a stress. Deflections of stacks are those in the middle of the thickness "
    "where a face lies there, and otherwise the mean of the outermost faces. Where a "
    "file holds the deflection of the middle of an edge, that of all faces is held in "
    "stacks. A dash "
    "means that there is no such published value. The published value of the sandwich "
    "plate R0031/3 is rounded; the parameter file with three layers has one with more "
    "digits.")

# The factors that are compared, and the change in percent from which a problem is
# listed
GRADIENT_FACTORS = 1, 8
LISTED_CHANGE = 0.01
GRADIENT = (
    "Every problem of this page on the mesh of its file, with a `Laminate/Gradient "
    "factor` of 1, the default of a single layer, and of 8, that of several, which "
    "keeps faces from wrinkling on fine meshes (see [theory.md](theory.md), section "
    "4). The first column is the largest change of a published value by the factor, "
    "the others are the largest deviations from published values; a dash means that "
    "a step did not converge. The problems that are not listed change by less than "
    "0.01 %. Stresses of the short strip [0/90] hardly change, but its deflection "
    "comes closer to the exact one, +2.4 % off in place of +3.5 %. In the deep fold of "
    "the semi-cylinder [0/90/0] the inner face is compressed beyond the strain -1/3. "
    "Whether the whole load is reached there is chance with any factor, and varies with the "
    "number of steps.")

COLORS = "#1f5fa8", "#c0392b", "#2e7d32"

# The reference of a path, by the start of its file name
REFERENCES = {"sze": "Sze, Liu, Lo (2004)", "exact": "exact"}

# Positions in a ply, by the column 'fraction' of plies-NNNN.csv
PLACES = {"0": "inner side of", "0.5": "middle of", "1": "outer side of"}

# A published value: quantity and reference as given in the parameter file
Expected = namedtuple("Expected", "quantity reference")

# A run: cells relative to the file (None for a further run), name in tables, rows
# of history.csv and probes.csv, whether it was completed, its directory
Run = namedtuple("Run", "factor name history probes complete directory")

# A parameter file with its runs
Benchmark = namedtuple("Benchmark", "name problem expected runs")


# ---------------------------------------------------------------- parameter files


def read_problem(prm):
    """The comment at the head of a parameter file, without published values."""
    lines = []
    for line in prm.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#") or line.startswith("# expect:"):
            break
        lines.append(line[1:].strip())
    return " ".join(lines)


def read_expected(prm):
    """The published values of a parameter file."""
    text = prm.read_text(encoding="utf-8")
    expected = []
    for line in re.findall(r"^# expect: (.*)$", text, re.MULTILINE):
        match = re.fullmatch(r"(.*) is (\S+) within \S+", line)
        expected.append(Expected(*match.groups()) if match else
                        Expected("iterations", line.rsplit(" ", 1)[0]))
    return expected


def read_intervals(prm, direction):
    """The entry 'Mesh/Intervals alpha_1' (or 2), 'begin:end:cells, ...'."""
    pattern = rf"^\s*set\s+Intervals alpha_{direction}\s*=\s*(.*?)\s*$"
    entry = re.search(pattern, prm.read_text(encoding="utf-8"), re.MULTILINE)
    return [interval.strip().split(":") for interval in entry[1].split(",")]


def count_cells(intervals):
    """The number of cells of all intervals of a direction."""
    return sum(int(interval[2]) for interval in intervals)


def refine(intervals, factor):
    """The intervals with their cells multiplied by a factor; a single cell stays."""
    if count_cells(intervals) == 1:
        return intervals
    return [[begin, end, str(max(1, int(int(cells) * factor))), *grading]
            for begin, end, cells, *grading in intervals]


def natural_order(prm):
    """A sort key that compares numbers in names as numbers."""
    return [int(word) if word.isdigit() else word
            for word in re.split(r"(\d+)", prm.stem)]


def mesh_of(prm, factor):
    """Settings that multiply the cells by a factor, and the name of the mesh."""
    settings, cells = [], []
    for direction in (1, 2):
        intervals = refine(read_intervals(prm, direction), factor)
        entry = ", ".join(":".join(interval) for interval in intervals)
        settings.append(f"Mesh/Intervals alpha_{direction}={entry}")
        cells.append(str(count_cells(intervals)))
    return ([] if factor == 1 else settings), " × ".join(cells)


# ---------------------------------------------------------------- runs


def read_csv(path):
    """The rows of a CSV file as dictionaries; comments are skipped."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if line[0] != "#"))


def run_program(program, prm, settings, directory):
    """Run the program unless its results are up to date; return its exit code."""
    command = [str(program), "--output", str(directory)]
    for setting in settings:
        command += ["--set", setting]
    command.append(str(prm))

    done = directory.with_suffix(".done")
    newest = max(program.stat().st_mtime, prm.stat().st_mtime)
    if done.exists() and done.stat().st_mtime > newest:
        *words, code = done.read_text(encoding="utf-8").splitlines()
        if words == command:
            return int(code)

    print(f"Running {prm.name} {' '.join(settings)}", flush=True)
    with open(directory.with_suffix(".log"), "w", encoding="utf-8") as log:
        code = subprocess.run(command, stdout=log, stderr=log,
                              check=False).returncode
    # a step that did not converge is a result, too
    if code not in (0, 2):
        raise SystemExit(f"{prm.name} failed with exit code {code}; see {log.name}")
    done.write_text("\n".join([*command, str(code)]), encoding="utf-8")
    return code


def make_run(arguments, prm, factor, name, settings):
    """Run the program with these settings and read the results."""
    directory = arguments.scratch / re.sub(r"\W+", "_", f"{prm.stem} {name}")
    code = run_program(arguments.program, prm, settings, directory)
    probes = directory / "probes.csv"
    return Run(factor, name, read_csv(directory / "history.csv"),
               read_csv(probes) if probes.exists() else [], code == 0,
               directory)


def on_meshes(arguments, prm, name="", further=()):
    """The runs on the three meshes, with further settings."""
    runs = []
    for factor in FACTORS:
        settings, mesh = mesh_of(prm, factor)
        runs.append(make_run(arguments, prm, factor, mesh + name,
                             [*settings, *further]))
    return runs


def make_benchmark(arguments, prm):
    """All runs of a parameter file: three meshes, then the further runs."""
    runs = on_meshes(arguments, prm)
    _, mesh = mesh_of(prm, 1)
    for name, settings in FURTHER_RUNS.get(prm.stem, {}).items():
        runs.append(make_run(arguments, prm, None, f"{mesh}, {name}", settings))
    return Benchmark(prm.stem, read_problem(prm), read_expected(prm), runs)


# ---------------------------------------------------------------- values


def turning_value(y, i):
    """The extremum of the parabola through the three values of y around i."""
    slope = (y[i + 1] - y[i - 1]) / 2
    curvature = y[i + 1] - 2 * y[i] + y[i - 1]
    return y[i] - slope ** 2 / (2 * curvature)


def limit_load(run, sign):
    """The first maximum (sign 1) or minimum (-1) of the load factor."""
    y = [0] + [float(row["load_factor"]) for row in run.history]
    for i in range(1, len(y) - 1):
        if sign * y[i] > sign * y[i - 1] and sign * y[i] >= sign * y[i + 1]:
            return turning_value(y, i)
    return None


def find_step(run, when):
    """The last row of history.csv of a stage ('end of STAGE') or with a load
    factor; None if not reached."""
    stage = re.fullmatch("end of (.*)", when)
    # the last stage of an incomplete run may be incomplete
    if stage and not run.complete and run.history[-1]["stage"] == stage[1]:
        return None
    rows = [row for row in run.history
            if (row["stage"] == stage[1] if stage else
                math.isclose(float(row["load_factor"]), float(when),
                             abs_tol=1e-9))]
    return rows[-1] if rows else None


def find_value(run, words, when):
    """A column of history.csv ('history COLUMN'), of plies-NNNN.csv ('plies
    NAME PLY PLACE COLUMN'), of modes.csv ('modes MODE COLUMN') and likewise of
    buckling.csv, or of probes.csv ('NAME FACE COLUMN') at the end of a stage or at
    a load factor; None if not reached."""
    step = find_step(run, when)
    if step is None:
        return None
    if words[0] == "history":
        return float(step[words[1]])
    if words[0] == "plies":
        path = run.directory / f"plies-{int(step['step']):04d}.csv"
        for row in read_csv(path):
            if [row["name"], row["ply"], row["fraction"]] == words[1:4]:
                return float(row[words[4]])
        return None
    if words[0] in ("modes", "buckling"):
        for row in read_csv(run.directory / f"{words[0]}.csv"):
            if [row["step"], row["mode"]] == [step["step"], words[1]]:
                return float(row[words[2]])
        return None
    if words[0] == "critical_points":
        for row in read_csv(run.directory / "critical_points.csv"):
            if (row["stage"] == step["stage"] and
                    row["kind"].startswith(words[1])):
                return float(row[words[2]])
        return None
    for row in run.probes:
        if [row["step"], row["name"], row["face"]] == [step["step"], *words[:2]]:
            return float(row[words[2]])
    return None


def count_iterations(run):
    """The total number of Newton iterations of all converged steps."""
    return sum(int(row["iterations"]) for row in run.history)


def evaluate(run, quantity):
    """The value of a quantity of the parameter file in a run, None if missing."""
    if quantity == "iterations":
        return count_iterations(run)
    if quantity.endswith("load factor"):
        return limit_load(run, 1 if quantity.startswith("maximum") else -1)
    what, when = quantity.split(" at ")
    return find_value(run, what.split(), when)


def is_column(expected):
    """Whether the quantity is a column of the results at some step."""
    return " at " in expected.quantity


def deviation(computed, reference):
    """The deviation from a published value in percent, None if one is missing."""
    try:
        return 100 * (computed / float(reference) - 1)
    except (TypeError, ValueError):
        return None


def convergence(benchmark, quantity):
    """Order and limit by Richardson's extrapolation from three meshes.

    The values are those for cells of size 4 h, 2 h, h; the error is assumed to be
    C h^p. None if the values do not approach a limit monotonically, if p < 1 (the
    meshes are too coarse for the formula), or if the values differ by little more
    than round-off.
    """
    values = [evaluate(run, quantity) for run in benchmark.runs if run.factor]
    if None in values:
        return None
    coarse, middle, fine = values
    if (abs(fine - middle) <= 1e-8 * abs(fine) or
            (middle - coarse) / (fine - middle) < 2):
        return None
    ratio = (middle - coarse) / (fine - middle)
    return math.log2(ratio), fine + (fine - middle) / (ratio - 1)


# ---------------------------------------------------------------- pictures


def path_run(benchmark):
    """The run whose path is drawn: the mesh of the file, with the most steps."""
    return max((run for run in benchmark.runs if run.factor in (1, None)),
               key=lambda run: len(run.history))


def plot_computed(axes, run, curve, color):
    """Draw the path of a run, starting at the origin."""
    rows = [row for row in run.probes
            if (row["name"], row["face"]) == (curve.point, "middle")]
    axes.plot([0] + [curve.sign * float(row[curve.column]) for row in rows],
              [0] + [float(row["load_factor"]) for row in rows], color=color,
              label=f"{curve.symbol}, computed")


def plot_reference(axes, rows, curve, name):
    """Draw the reference path as circles."""
    axes.plot([float(row[curve.reference]) for row in rows],
              [float(row["P_over_Pmax"]) for row in rows], "o", color="black",
              markersize=5, markerfacecolor="none", zorder=3, label=name)


def draw_path(benchmark, data, output):
    """Draw the load factor against displacements, computed and reference."""
    curves = PATHS[benchmark.name]
    run = path_run(benchmark)
    [file] = data.glob(f"*_{benchmark.name}.csv")
    rows = read_csv(file)
    figure, axes = plt.subplots(figsize=(7, 4.6))
    for curve, color in zip(curves, COLORS):
        plot_computed(axes, run, curve, color)
    for curve in curves:
        plot_reference(axes, rows, curve, REFERENCES[file.stem.split("_")[0]]
                       if curve is curves[-1] else None)
    least = min(min(line.get_xdata()) for line in axes.lines)
    axes.set(xlabel="displacement", ylabel="load factor",
             xlim=(1.2 * least, None), ylim=(0, None))
    axes.legend(fontsize=11, **LEGENDS.get(benchmark.name, {"loc": "best"}))
    figure.savefig(output / f"{benchmark.name}.png", bbox_inches="tight",
                   pad_inches=0.08)
    plt.close(figure)


# ---------------------------------------------------------------- page

INTRODUCTION = """\
# Verification

Benchmarks with published or exact closed-form solutions, as the tests run them and on
coarser and finer meshes. The parameter files are in `tests/verification`. A script
writes this page from runs of the program:

```sh
cmake --build build --target verification
```

It takes 25 minutes and needs Python with matplotlib (on Debian
`python3-matplotlib`; run cmake again after installing it). Runs are repeated
only if the program or their parameter file has changed.

Lengths, forces and moduli are given without units: any consistent set will do.
Displacements are those of points named in the parameter file, on the middle
surface (the mean of both faces) unless a face is named; the load factor is the
fraction of the load applied. Other quantities are columns of `history.csv`, see
[output.md](output.md). The mesh is given as the number of cells along `alpha_1` and
`alpha_2`. The mesh of the parameter file is in bold; the others have half and twice
its cells in each direction that has more than one. The deviation is computed minus
reference, in percent of the reference.

The order is that of the quantity, by Richardson extrapolation from the three
meshes. If the error is proportional to the power $`p`$ of the cell size,
$`p = \\log_2 \\bigl((u_{\\mathrm{middle}} - u_{\\mathrm{coarse}}) / (u_{\\mathrm{fine}} - u_{\\mathrm{middle}})\\bigr)`$.
The limit is the extrapolated value for cells of size zero. Both are omitted if the
values do not approach a limit monotonically, if the order would be below 1, which
means that the meshes are too coarse for the formula, or if the values differ by
little more than round-off. Under a point force the order is not that of a smooth
problem.

Newton iterations are summed over the converged steps.

Three authors are the reference for many problems:

- K. Y. Sze, X. H. Liu, S. H. Lo, Popular benchmark problems for geometric
  nonlinear analysis of shells, Finite Elements in Analysis and Design 40 (2004)
  1551-1569. Its values are computed, too, with a different shell element and
  different meshes, so that a small deviation need not be an error of either. The
  values of 3.4 to 3.6, and those of 3.8 except for the isotropic roof of thickness
  12.7, were taken from transcriptions in other programs.
- N. J. Pagano, Exact solutions for composite laminates in cylindrical bending,
  Journal of Composite Materials 3 (1969) 398-411, and Exact solutions for
  rectangular bidirectional composites and sandwich plates, 4 (1970) 20-34. His values
  and those of J. G. Ren, Exact solutions for laminated cylindrical shells in
  cylindrical bending, Composites Science and Technology 29 (1987) 169-187, were
  recomputed from the equations of elasticity.

The problems are listed by what they verify, each group with the largest deviation of
each problem:
"""


def heading(name):
    """The heading of a benchmark."""
    return HEADINGS.get(name, name.replace("_", " ").capitalize())


def fill(text):
    """A paragraph wrapped to the width of the other pages."""
    return textwrap.fill(text, 80, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def percent(value):
    """A deviation in percent, or a dash if there is none."""
    return "–" if value is None else f"{round(value, 2) + 0:+.2f}"


def digits(value):
    """A computed value with five digits; integers as they are."""
    return str(value) if isinstance(value, int) else f"{value:#.5g}"


def label(quantity):
    """The name of a quantity in the tables."""
    if " at " not in quantity:
        return {"iterations": "Newton iterations"}.get(quantity, quantity)
    what, when = quantity.split(" at ")
    stage = re.fullmatch("end of (.*)", when)
    when = f"the end of `{stage[1]}`" if stage else f"load factor {when}"
    words = what.split()
    if words[0] == "history":
        return f"`{words[1]}` at {when}"
    if words[0] == "plies":
        _, name, ply, fraction, column = words
        place = PLACES.get(fraction, f"at {fraction} of the thickness of")
        return f"`{column}` at `{name}`, {place} ply {ply}, at {when}"
    if words[0] in ("modes", "buckling"):
        return f"`{words[2]}` of mode {words[1]} at {when}"
    if words[0] == "critical_points":
        return f"`{words[2]}` of the {words[1]} point before {when}".replace(
            "bifurcation point", "bifurcation")
    face = "" if words[1] == "middle" else f", {words[1]} face,"
    return f"`{words[2]}` of `{words[0]}`{face} at {when}"


def table(header, rows, n_words):
    """A table in Markdown; columns after the first n_words contain numbers."""
    ruler = ["---" if i < n_words else "---:" for i in range(len(header))]
    return "".join("| " + " | ".join(row) + " |\n"
                   for row in [header, ruler, *rows])


def run_name(run):
    """The name of a run in tables; the mesh of the parameter file in bold."""
    return f"**{run.name}**" if run.factor == 1 else run.name


def distinct(benchmark):
    """The runs; only that of the parameter file if its mesh is a single cell."""
    [mesh] = [run.name for run in benchmark.runs if run.factor == 1]
    return [run for run in benchmark.runs if run.factor == 1 or run.name != mesh]


def value_rows(benchmark):
    """Each published value with those of all runs."""
    rows = []
    for expected in benchmark.expected:
        for run in distinct(benchmark):
            # a bound on the iterations of one step does not apply to many steps
            if expected.quantity == "iterations" and run.factor is None:
                continue
            value = evaluate(run, expected.quantity)
            rows.append([run_name(run), label(expected.quantity),
                         expected.reference,
                         "not reached" if value is None else digits(value),
                         percent(deviation(value, expected.reference))])
    return rows


def reached(run):
    """The load factor of the last step, zero if there is none."""
    return float(run.history[-1]["load_factor"]) if run.history else 0


def step_rows(benchmark):
    """Steps and iterations of all runs."""
    return [[run_name(run),
             "yes" if run.complete else
             f"no, up to load factor {reached(run):.4f}",
             str(len(run.history)), str(count_iterations(run))]
            for run in distinct(benchmark)]


def order_rows(benchmark):
    """Order and limit of columns of results, if any."""
    rows = []
    for expected in filter(is_column, benchmark.expected):
        result = convergence(benchmark, expected.quantity)
        if result:
            order, limit = result
            rows.append([label(expected.quantity),
                         f"{order:.1f}", digits(limit),
                         percent(deviation(limit, expected.reference))])
    return rows


def remark(benchmark):
    """The remark on a benchmark with its values filled in."""
    finest = benchmark.runs[len(FACTORS) - 1]
    values = [evaluate(finest, expected.quantity)
              for expected in benchmark.expected]
    deviations = [deviation(value, expected.reference)
                  for value, expected in zip(values, benchmark.expected)]
    return REMARKS[benchmark.name].format(*values, d=deviations)


def section(benchmark):
    """The section of the page on one benchmark."""
    parts = [f"### {heading(benchmark.name)}\n", fill(benchmark.problem),
             fill(f"Parameter file: `tests/verification/{benchmark.name}.prm`.")]
    if benchmark.name in PATHS:
        parts.append(f"![{heading(benchmark.name)}: load factor against "
                     f"displacement](verification/{benchmark.name}.png)\n")
        parts.append(f"*The path is computed on the mesh "
                     f"{path_run(benchmark).name}.*\n")
    parts.append(table(["Mesh", "Quantity", "Reference", "Computed",
                        "Deviation (%)"], value_rows(benchmark), 2))
    orders = order_rows(benchmark)
    if orders:
        parts.append(table(["Quantity", "Order", "Limit",
                            "Deviation of limit (%)"], orders, 1))
    parts.append(table(["Mesh", "Whole load", "Steps", "Newton iterations"],
                       step_rows(benchmark), 2))
    if not all(run.complete for run in benchmark.runs):
        parts.append(fill("Where the whole load is not reached, a step did not "
                          "converge after several bisections."))
    if benchmark.name in REMARKS:
        parts.append(fill(remark(benchmark)))
    return "\n".join(parts)


def deviations(run, expected):
    """The deviations of a run from the published values, None if a step failed before
    a value was reached."""
    return [deviation(evaluate(run, quantity), reference)
            for quantity, reference in expected if quantity != "iterations"]


def summary(benchmarks):
    """The maximum deviation of each benchmark on each mesh."""
    rows = []
    for benchmark in benchmarks:
        row = [heading(benchmark.name)]
        for run in (run for run in benchmark.runs if run.factor):
            found = [d for d in deviations(run, benchmark.expected)
                     if d is not None]
            worst = max(found, key=abs, default=None)
            row.append(percent(worst) +
                       ("" if run.complete else " (part of the load)"))
        rows.append(row)
    return table(["Largest deviation (%)", "Half the cells", "As in the file",
                  "Twice the cells"], rows, 1)


def is_curved(prm):
    """Whether the interpolation matters: the frames turn."""
    return not re.search(r"^\s*set\s+Type\s*=\s*plane\s*$",
                         prm.read_text(encoding="utf-8"), re.MULTILINE)


def has_both(arguments, prm):
    """Whether the element of the paper is possible, too."""
    return subprocess.run([arguments.program, "--check", prm, "--set", "Formulation=paper"],
                          check=False, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0


def formulations(arguments, prms):
    """The chapter that compares those of 'Formulation'."""
    rows = []
    for prm in prms:
        if not is_curved(prm) or not has_both(arguments, prm):
            continue
        expected = read_expected(prm)
        found = {name: [deviations(run, expected) for run in
                        on_meshes(arguments, prm, f" {name}",
                                  [f"Formulation={name}"])]
                 for name in FORMULATIONS}
        worst = {name: [None if None in run else max(run, key=abs) for run in runs]
                 for name, runs in found.items()}
        rows.append([heading(prm.stem)] +
                    [percent(worst[name][i]) for i in range(len(FACTORS))
                     for name in FORMULATIONS])
    header = ["Largest deviation (%)"] + [
        f"{mesh}: {name}" for mesh in ("half", "file", "twice")
        for name in FORMULATIONS]
    return ["## Formulation\n", fill(FORMULATION), table(header, rows, 1)]


def in_the_middle(expected, run):
    """Published values in the middle surface, as those of the face there, if there is
    one among the faces between layers."""
    faces = {row["face"] for row in run.probes if row["face"].startswith("face_")}
    if len(faces) % 2 == 0:
        return expected
    middle = f" face_{(len(faces) + 1) // 2} "
    return [Expected(quantity.replace(" middle ", middle), reference)
            for quantity, reference in expected]


def support_of_all_faces(prm):
    """Settings that hold the deflection of all faces where the file holds that of
    the middle: in a stack, the mean of the outermost faces would be held."""
    return [f"Supports/{edge}={support.replace('v_3 middle', 'v_3 both')}"
            for edge, support in re.findall(
                r"^\s*set\s+(alpha_\d m..)\s*=\s*(.*v_3 middle.*?)\s*$",
                prm.read_text(encoding="utf-8"), re.MULTILINE)]


def stacks(arguments, prms):
    """The chapter that compares one layer with several."""
    rows = []
    for prm in (prm for name in STACKED for prm in prms if prm.stem == name):
        # the first value of a quantity is the published one
        expected = list({item.quantity: item
                         for item in reversed(read_expected(prm))}.values())
        row = [heading(prm.stem)]
        _, mesh = mesh_of(prm, 1)
        runs = [make_run(arguments, prm, 1, f"{mesh} {name}",
                         settings + ([] if settings[0].endswith("=one") else
                                     support_of_all_faces(prm)))
                for name, settings in WALLS.items()]
        for wanted in (True, False):
            for run in runs:
                chosen = [item for item in in_the_middle(expected, run)
                          if (" u_" in item.quantity) == wanted]
                found = deviations(run, chosen)
                row.append(percent(None if not found or None in found
                                   else max(found, key=abs)))
        rows.append(row)
    header = ["Largest deviation (%)"] + [
        f"{what}: {name}" for what in ("deflection", "stress") for name in WALLS]
    return ["## Stacks of layers\n", fill(STACKS), table(header, rows, 1)]


def gradient_factors(arguments, prms):
    """The chapter that compares values of 'Laminate/Gradient factor'."""
    rows = []
    for prm in prms:
        expected = [item for item in read_expected(prm)
                    if item.quantity != "iterations"]
        _, mesh = mesh_of(prm, 1)
        runs = [make_run(arguments, prm, 1, f"{mesh} gradient factor {factor}",
                         [f"Laminate/Gradient factor={factor}"])
                for factor in GRADIENT_FACTORS]
        found = [deviations(run, expected) for run in runs]
        first, second = ([evaluate(run, item.quantity) for item in expected]
                         for run in runs)
        change = max((100 * (new / old - 1) for old, new in zip(first, second)
                      if old and new), key=abs, default=0)
        worst = [None if None in run else max(run, key=abs) for run in found]
        if abs(change) >= LISTED_CHANGE or None in worst:
            rows.append((change, [heading(prm.stem), percent(change),
                                  *map(percent, worst)]))
    rows.sort(key=lambda row: -abs(row[0]))
    header = ["Problem", "Change (%)"] + [
        f"Largest deviation (%): factor {factor}" for factor in GRADIENT_FACTORS]
    return ["## Gradient factor\n", fill(GRADIENT),
            table(header, [row for _, row in rows], 1)]


def contents():
    """The list of purposes."""
    return "\n".join(f"- {title}" for title, _, _ in PURPOSES) + (
        "\n- Stacks of layers: thick laminates as one layer and as several, compared"
        "\n- Formulation: the standard element and that of the paper, compared"
        "\n- Gradient factor: stiffness against wrinkles of a face, compared\n")


def chapters(benchmarks):
    """All benchmarks by their purpose, each with a table of deviations."""
    by_name = {benchmark.name: benchmark for benchmark in benchmarks}
    listed = [name for _, _, names in PURPOSES for name in names]
    if sorted(listed) != sorted(by_name):
        sys.exit("PURPOSES must list each benchmark once: "
                 + ", ".join(set(listed) ^ set(by_name)))
    parts = []
    for title, sentence, names in PURPOSES:
        chosen = [by_name[name] for name in names]
        parts += [f"## {title}\n", fill(sentence), summary(chosen),
                  *map(section, chosen)]
    return parts


# ---------------------------------------------------------------- program


def parse_arguments():
    """The program, its parameter files, and the directories of the results."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name, text in (("program", "the program biface"),
                       ("parameters", "directory of the parameter files"),
                       ("data", "directory of the reference paths"),
                       ("scratch", "directory for the results of the runs"),
                       ("output", "directory of the page, doc/")):
        parser.add_argument(f"--{name}", type=Path, required=True, help=text)
    return parser.parse_args()


def main():
    """Run all benchmarks, draw the pictures, write the page."""
    arguments = parse_arguments()
    arguments.scratch.mkdir(parents=True, exist_ok=True)
    pictures = arguments.output / "verification"
    pictures.mkdir(parents=True, exist_ok=True)
    plt.rcParams.update(STYLE | {"lines.linewidth": 1.8})
    # meshes from files have no half and double: any_mesh.md; steps in time: dynamics.md
    prms = sorted((prm for prm in arguments.parameters.glob("*.prm")
                   if not re.search(r"\.msh|# file: |Inertia", prm.read_text())),
                  key=natural_order)
    benchmarks = [make_benchmark(arguments, prm) for prm in prms]
    for benchmark in benchmarks:
        if benchmark.name in PATHS:
            draw_path(benchmark, arguments.data, pictures)
    page = "\n".join([INTRODUCTION, contents(), *chapters(benchmarks),
                      *stacks(arguments, prms), *formulations(arguments, prms),
                      *gradient_factors(arguments, prms)])
    (arguments.output / "verification.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
