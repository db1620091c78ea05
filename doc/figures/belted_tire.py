#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the plies of the belted tire, cut open in steps.

Reads a plies-NNNN.vtu of prm/belted_tire.prm and writes a PNG. Needs VTK and a
display; a virtual one (xvfb-run) will do.
"""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

# Pixels of the picture, and how much larger it is drawn before it is reduced
WIDTH, HEIGHT, OVERSAMPLING = 1000, 860, 2

# Each ply by its number: the angle around the axle (degrees) at which it is cut
# off, so that the ply below comes to light
CUTS = {1: -48, 2: -36, 3: -24, 4: -6, 5: 12, 6: 30}
# Plies of rubber have no cords
RUBBER_PLIES = {1: (0.80, 0.81, 0.83), 6: (0.50, 0.53, 0.57)}
STRESS_RANGE = (-40, 40)
COLORS = plt.get_cmap("coolwarm")


class Plies:
    """All hexahedra: the points of each, deformed, the stress along the cords
    there, the number of the ply, and the angle around the axle."""

    def __init__(self, path):
        """Reads a VTU file."""
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())

        def of_cells(array):
            values = vtk_to_numpy(array).astype(float)
            return values[cells.reshape(-1, 8)]

        data = grid.GetPointData()
        self.points = of_cells(grid.GetPoints().GetData())
        self.stress = of_cells(data.GetArray("s_L"))
        self.number = of_cells(data.GetArray("ply"))[:, 0]
        center = (self.points - of_cells(data.GetArray("displacement"))).mean(1)
        self.angle = np.degrees(np.arctan2(center[:, 2], center[:, 0]))

    def surface(self, number):
        """A ply from its cut on, as a smooth surface. Each cell of the file has
        points of its own: they are joined, and their stresses averaged."""
        chosen = (self.number == number) & (self.angle > CUTS[number])
        points = self.points[chosen].reshape(-1, 3)
        _, first, which = np.unique(np.round(points, 2), axis=0,
                                    return_index=True, return_inverse=True)
        stress = np.bincount(which, self.stress[chosen].ravel())
        stress /= np.bincount(which)

        grid = vtk.vtkUnstructuredGrid()
        vtk_points = vtk.vtkPoints()
        vtk_points.SetData(numpy_to_vtk(points[first], deep=True))
        grid.SetPoints(vtk_points)
        grid.GetPointData().SetScalars(numpy_to_vtk(stress, deep=True))
        for corners in which.reshape(-1, 8):
            grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, corners)

        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(grid)
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputConnection(surface.GetOutputPort())
        normals.SetFeatureAngle(40)
        normals.Update()
        return normals.GetOutput()


def ply_actor(plies, number):
    """A ply, colored by the stress along its cords if it has any."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(plies.surface(number))
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if number in RUBBER_PLIES:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(RUBBER_PLIES[number])
    else:
        table = vtk.vtkLookupTable()
        table.SetNumberOfTableValues(256)
        for i, color in enumerate(COLORS(np.arange(256))):
            table.SetTableValue(i, *color)
        table.SetRange(*STRESS_RANGE)
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.65)
    return actor


def render(actors):
    """The picture of some actors, as an array of RGB values."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    renderer.RemoveAllLights()
    for position, intensity in (((0.5, 1, 1.5), 0.85), ((-1.5, 0.2, 0.7), 0.4)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(OVERSAMPLING * WIDTH, OVERSAMPLING * HEIGHT)
    window.AddRenderer(renderer)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(1000, 470, -150)
    camera.SetFocalPoint(60, 20, 35)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(31)
    renderer.ResetCameraClippingRange()

    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.Update()
    image = picture.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    width, height, _ = image.GetDimensions()
    pixels = pixels.reshape(height, width, 3)[::-1]
    # averages of blocks smooth all edges
    blocks = pixels.reshape(height // OVERSAMPLING, OVERSAMPLING,
                            width // OVERSAMPLING, OVERSAMPLING, 3)
    return blocks.mean((1, 3)) / 255


def write_picture(pixels, path):
    """Adds a color bar and writes the PNG."""
    figure = plt.figure(figsize=(WIDTH / 100, HEIGHT / 100), dpi=100)
    axes = figure.add_axes([0, 0, 1, 1])
    axes.imshow(pixels, interpolation="none")
    axes.axis("off")
    bar = figure.colorbar(
        plt.cm.ScalarMappable(plt.Normalize(*STRESS_RANGE), COLORS),
        cax=figure.add_axes([0.86, 0.25, 0.024, 0.5]), extend="both")
    bar.set_label("stress along the cords (MPa)", fontsize=17)
    bar.ax.tick_params(labelsize=15)
    figure.savefig(path)
    plt.close(figure)


def main():
    """Draw the plies of one VTU file."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("plies", type=Path, help="plies-NNNN.vtu")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    arguments = parser.parse_args()
    plies = Plies(arguments.plies)
    actors = [ply_actor(plies, number) for number in CUTS]
    write_picture(render(actors), arguments.picture)


if __name__ == "__main__":
    main()
