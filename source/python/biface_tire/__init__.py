# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tires from their size: parameter files of biface, and a judgment of the results.

    from biface_tire.design import Design, Options
    design = Design("195/65 R15 91V", Options(rim="6J"))
    design.width, design.diameter, design.load      # mm, mm, N

Lengths are in mm, forces in N, pressures in MPa, angles in degrees from the
circumference; doc/tire_from_size.md has the rules and their sources. Everything that
goes wrong raises a BifaceError.

    size            sizes in all usual notations
    rim             names of rims
    service         load index, speed symbol, load range
    cords           cords and the plies that they make
    bias, radial    tires from outer dimensions, rim and pressure
    design          a tire from its size
    contour         a measured contour
    parameter_file  its parameter file
    nasa            the formulas of NASA TR R-64
    judge           results beside formulas and ratings
    protocol        tables of what is to be tested
    runs            the runs of the program that they need
    series          runs that go on where they were interrupted
    model           a tire model of their results
    model_report    the page about it
    program         the command line
"""
