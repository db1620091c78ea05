# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common parts of pictures drawn by VTK. Needs VTK and a display; a virtual one
(xvfb-run) will do."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

# Pictures are drawn larger by this factor and then reduced
OVERSAMPLING = 2


# ---------------------------------------------------------------- data


def read_grid(path):
    """The grid of a VTU file."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def positions(grid):
    """The points of a grid, one per row."""
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def point_values(grid, name):
    """Values of a field at the points of a grid."""
    return vtk_to_numpy(grid.GetPointData().GetArray(name)).astype(float)


def corners(grid, count):
    """The point numbers of each cell, one cell per row; all have count points."""
    return vtk_to_numpy(
        grid.GetCells().GetConnectivityArray()).reshape(-1, count)


def to_vtk_points(points):
    """Rows of positions as points of VTK."""
    result = vtk.vtkPoints()
    result.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    return result


def merge_points(points, decimals):
    """The numbers of distinct points, those that agree to some decimals counted
    once, and for each point its place among them."""
    _, first, which = np.unique(np.round(points, decimals), axis=0,
                                return_index=True, return_inverse=True)
    return first, which


# ---------------------------------------------------------------- actors


def lookup_table(colors, limits):
    """A color map of matplotlib over an interval of values."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, color in enumerate(colors(np.arange(256))):
        table.SetTableValue(i, *color)
    table.SetRange(*limits)
    return table


def use_colors(mapper, colors, limits):
    """Colors a mapper's data by its scalars."""
    mapper.SetLookupTable(lookup_table(colors, limits))
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()


def lit_actor(data, color):
    """A lit surface of one color."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    appearance = actor.GetProperty()
    appearance.SetColor(color)
    appearance.SetAmbient(0.25)
    appearance.SetDiffuse(0.75)
    appearance.SetSpecular(0.12)
    appearance.SetSpecularPower(25)
    return actor


def zone_actor(data, threshold, colors, limits):
    """The part of a surface where its scalars exceed a threshold, unlit, in the
    exact colors of the bar, in front of the surface itself."""
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(data)
    clip.SetValue(threshold)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(clip.GetOutputPort())
    use_colors(mapper, colors, limits)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -2)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def line_data(lines):
    """Polylines, each an array of points."""
    data, points, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line))
        for point in line:
            cells.InsertCellPoint(points.InsertNextPoint(point))
    data.SetPoints(points)
    data.SetLines(cells)
    return data


def line_actor(data, color, width, opacity=1):
    """Lines in front of the surface on which they lie."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -4)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetLineWidth(width * OVERSAMPLING)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().LightingOff()
    return actor


# ---------------------------------------------------------------- picture


def add_lights(renderer):
    """A key light from above the camera, and a fill light beside it."""
    renderer.RemoveAllLights()
    for position, intensity in (((0.5, 1, 1.5), 0.85), ((-1.5, 0.2, 0.7), 0.4)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def render(actors, size, place_camera):
    """The picture of some actors, as an array of RGB values from 0 to 1.

    size is its width and height; place_camera is called with the renderer."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    add_lights(renderer)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*(OVERSAMPLING * pixels for pixels in size))
    window.AddRenderer(renderer)
    place_camera(renderer)
    renderer.ResetCameraClippingRange()

    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.Update()
    image = picture.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    width, height, _ = image.GetDimensions()
    return reduce_size(pixels.reshape(height, width, 3)[::-1])


def fixed_camera(position, focal_point, view_angle):
    """A camera for render(), z upward."""
    def place(renderer):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(position)
        camera.SetFocalPoint(focal_point)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(view_angle)
    return place


def reduce_size(pixels):
    """Averages blocks of pixels, which smooths edges."""
    height, width, _ = pixels.shape
    blocks = pixels.reshape(height // OVERSAMPLING, OVERSAMPLING,
                            width // OVERSAMPLING, OVERSAMPLING, 3)
    return blocks.mean((1, 3)) / 255


def figure_of(pixels):
    """A figure that consists of a picture."""
    height, width, _ = pixels.shape
    figure = plt.figure(figsize=(width / 100, height / 100), dpi=100)
    axes = figure.add_axes([0, 0, 1, 1])
    axes.imshow(pixels, interpolation="none")
    axes.axis("off")
    return figure


def add_color_bar(figure, place, colors, limits, label, extend="neither"):
    """A color bar at a place, left, bottom, width and height from 0 to 1."""
    bar = figure.colorbar(
        plt.cm.ScalarMappable(plt.Normalize(*limits), colors),
        cax=figure.add_axes(place), extend=extend)
    bar.set_label(label, fontsize=17)
    bar.ax.tick_params(labelsize=15)
