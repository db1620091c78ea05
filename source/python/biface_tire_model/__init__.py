# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tire models for vehicle dynamics: the Magic Formula, its files, and its fit.

    from biface_tire_model import read_tir
    formula = read_tir("tire.tir").formula()
    forces = formula.evaluate(4000, alpha=[0, 0.05])    # newtons, radians
    forces.F_y                                          # a NumPy array

Everything is in SI units and radians, and in the W axes of ISO 8855; doc/tire_model.md
tells more. Everything that goes wrong raises a BifaceError.

    magic_formula     forces and moments by slip, load, camber and pressure
    coefficients      what coefficients there are, their bounds and neutral values
    tir_file          .tir files
    check             what is missing or unusual in one
    channels          the columns of a table of a tire test
    table             reads and writes such a table
    axes              ISO, SAE and adapted ISO signs
    units             names of units
    tydex             TYDEX files
    fitting           coefficients by least squares
    vertical          vertical stiffness and radius without load
    structure         stiffnesses, footprints and modes of results of biface
    stiffness_fit     stiffness over load and pressure
    mode_names        the modes of a rigid ring
    relaxation        relaxation lengths
    structural        what these give for a .tir file
    structure_tables  tables of them
    fitted_file       the .tir file of a fit
    text              what the command prints
    picture           curves and points
"""

from importlib import import_module

# Where each name is; it is imported once it is asked for, so that the command can tell
# what is missing
_MODULES = {"Forces": "magic_formula", "MF52": "magic_formula", "MF61": "magic_formula",
            "Measurements": "table", "Structural": "structural", "TirFile": "tir_file",
            "convert": "axes", "fit": "fitting", "make_tir": "fitted_file",
            "mirror": "axes", "read_structure": "structure", "read_table": "table",
            "read_tir": "tir_file", "read_tydex": "tydex",
            "structure_tables": "structure_tables", "vertical": "vertical",
            "write_tydex": "tydex"}
__all__ = list(_MODULES)


def __getattr__(name):
    if name not in _MODULES:
        raise AttributeError(f"biface_tire_model has no {name}")
    return getattr(import_module("." + _MODULES[name], __name__), name)
