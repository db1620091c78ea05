# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns a directory of biface results into one page of HTML.

    command_line   what the commands have in common
    units          what to call units
    loading        what changes from step to step
    ground     the plane, drum or sphere, and where it stands
    zone           the edge of the contact zone between the nodes
    footprint      the contact zone, projected along the direction of travel
    curved         smooth curves and cells through nodes
    section        the plane of the deformed section
    drawing        the look of charts, and how they get into the page
    charts         curves
    maps           pictures of the footprint and the section
    shapes         pictures and views of modes and of shapes of buckling
    modes          modes of vibration
    buckling       buckling loads and critical points
    stiffness      stiffnesses against motions of the ground
    wheel          forces in wheel axes, and where the footprint slips
    rolling        forces over the slip angle and the slip
    sensitivities  derivatives by numbers of the parameter file
    plies          charts of ply stresses
    view           views of the shell that turn
    view_data      the contents of VTU files for them
    bodies         the ground and other rigid bodies in them
    sectors        copies of a sector that fill a turn
    view*.js       draw them in the browser
    page           HTML
    summary        the head of the page and the table of numbers
    point_content  the sections on named points
    content        all other sections, and the whole page
    comparison     the page about two runs
"""
