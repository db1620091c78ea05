# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns a directory of results of biface into one page of HTML.

    results     reads and checks the files of a run
    parameters  reads parameters.prm
    footprint   the contact zone in the plane of the foundation
    section     the plane of the deformed section
    drawing     how charts look, and how they get into the page
    charts      curves; maps: footprint and section; plies: stresses in plies
    rendering   what pictures by VTK have in common
    shell_view  the picture of the deformed shell
    page        HTML
    content     what the page says, section by section; summary: its head and
                numbers; point_content: the named points
"""
