# SPDX-License-Identifier: LGPL-2.1-or-later
"""A view of the results of biface for ParaView.

In ParaView: File > Load State..., and choose this file; it asks nothing, and looks
for shell.pvd in the directory in which ParaView was started, or in the one that
the environment variable BIFACE_RESULTS names. Or, without a window:

    BIFACE_RESULTS=output pvbatch doc/paraview/biface.py --picture view.png

The pipeline, each part to be switched on and off by its eye:
  shell        both faces, colored by contact pressure
  footprint    the part of the outer face in contact
  plies        every ply, cut open in steps, colored by the stress along the fibers
  cords        the direction of the fibers of one ply
The last two are there if the run has written plies.pvd (Output/Write ply VTU).
"""

import argparse
import os
import sys
from pathlib import Path

from paraview import simple as pv


def show_shell(view, faces):
    """The deformed shell, colored by contact pressure."""
    half = pv.Clip(registrationName="shell, clipped", Input=faces)
    half.ClipType = "Plane"
    half.ClipType.Origin = [0, 0, 0]
    half.ClipType.Normal = [0, 0, 1]
    pv.Hide(half, view)
    display = pv.Show(faces, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.35, 0.35, 0.35]
    pv.ColorBy(display, ("POINTS", "contact_pressure"))
    display.RescaleTransferFunctionToDataRange(False)
    display.SetScalarBarVisibility(view, True)
    pv.GetScalarBar(pv.GetColorTransferFunction("contact_pressure"),
                    view).Title = "contact pressure"


def threshold(name, source, association, field, low, high):
    """The cells between two values of a field."""
    result = pv.Threshold(registrationName=name, Input=source)
    result.Scalars = [association, field]
    result.LowerThreshold = low
    result.UpperThreshold = high
    return result


def show_footprint(view, faces):
    """Where the outer face touches the plane; a node in contact is enough."""
    outer = threshold("outer face", faces, "POINTS", "outer_face", 0.5, 1)
    footprint = threshold("footprint", outer, "POINTS", "active", 0.5, 1)
    footprint.AllScalars = 0
    display = pv.Show(footprint, view)
    pv.ColorBy(display, ("POINTS", "contact_pressure"))
    display.LineWidth = 1
    display.Representation = "Surface With Edges"
    display.EdgeColor = [1, 1, 1]
    pv.Hide(outer, view)


def show_plies(view, plies):
    """The plies cut open, and on them the cords of the first ply, as lines."""
    half = pv.Clip(registrationName="plies, clipped", Input=plies)
    half.ClipType = "Plane"
    half.ClipType.Origin = [0, 0, 0]
    half.ClipType.Normal = [0, 0, 1]
    display = pv.Show(half, view)
    pv.ColorBy(display, ("POINTS", "s_L"))
    display.RescaleTransferFunctionToDataRange(False)
    display.SetScalarBarVisibility(view, True)
    pv.GetScalarBar(pv.GetColorTransferFunction("s_L"),
                    view).Title = "stress along fibers"

    ply = threshold("ply (choose one)", half, "POINTS", "ply", 0.5, 1.5)
    pv.Hide(ply, view)
    cords = pv.Glyph(registrationName="cords", Input=ply, GlyphType="Line")
    cords.OrientationArray = ["POINTS", "fiber"]
    cords.ScaleArray = ["POINTS", "No scale array"]
    cords.ScaleFactor = 0.02 * max(
        high - low for low, high in zip(plies.GetDataInformation().GetBounds()[::2],
                                        plies.GetDataInformation().GetBounds()[1::2]))
    # evenly over the surface, however large the cells
    cords.GlyphMode = "Uniform Spatial Distribution (Surface Sampling)"
    cords.MaximumNumberOfSamplePoints = 5000
    cords.Seed = 1
    display = pv.Show(cords, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = [0.1, 0.1, 0.1]
    display.LineWidth = 1.5


def main():
    """Build the pipeline; draw a picture if asked to."""
    parser = argparse.ArgumentParser(description="A view of results of biface.")
    parser.add_argument("--picture", type=Path, help="a PNG to write")
    parser.add_argument("--plies", action="store_true",
                        help="the picture shows plies and cords, not the faces")
    # ParaView's own words, if it loads this file, are none of ours
    arguments = parser.parse_args(sys.argv[1:] if "--picture" in sys.argv else [])

    results = Path(os.environ.get("BIFACE_RESULTS", ".")).absolute()
    if not (results / "shell.pvd").is_file():
        raise SystemExit(
            f"There is no shell.pvd in {results}. Start ParaView in the directory "
            "of the results, or set BIFACE_RESULTS to it.")

    pv._DisableFirstRenderCameraReset()
    view = pv.GetActiveViewOrCreate("RenderView")
    view.OrientationAxesVisibility = 1
    view.ViewSize = [1100, 800]
    faces = pv.PVDReader(registrationName="shell",
                         FileName=str(results / "shell.pvd"))
    # the last step
    last = faces.TimestepValues[-1] if len(faces.TimestepValues) else 0
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    pv.GetAnimationScene().AnimationTime = last
    faces.UpdatePipeline(last)
    show_shell(view, faces)
    show_footprint(view, faces)
    if (results / "plies.pvd").is_file():
        plies = pv.PVDReader(registrationName="plies",
                             FileName=str(results / "plies.pvd"))
        plies.UpdatePipeline(last)
        show_plies(view, plies)
        if not arguments.plies:
            for name in ("plies, clipped", "cords"):
                pv.Hide(pv.FindSource(name), view)
            pv.GetDisplayProperties(pv.FindSource("plies, clipped"), view
                                    ).SetScalarBarVisibility(view, False)
        pv.Hide(plies, view)
    if arguments.plies:
        for name in ("shell", "footprint"):
            pv.Hide(pv.FindSource(name), view)
        pv.GetDisplayProperties(pv.FindSource("shell"), view
                                ).SetScalarBarVisibility(view, False)

    # from the side of the plane, with its footprint in front
    view.ViewTime = last
    view.CameraViewUp = [0, 1, 0]
    view.CameraPosition = [2, 0.9, 1.2]
    view.CameraFocalPoint = [0, 0, 0]
    view.ResetCamera()
    pv.GetActiveCamera().Dolly(1.2 if arguments.plies else 1.5)
    pv.Render(view)
    if arguments.picture:
        pv.SaveScreenshot(str(arguments.picture), view,
                          ImageResolution=[1100, 800],
                          OverrideColorPalette="WhiteBackground")


main()
