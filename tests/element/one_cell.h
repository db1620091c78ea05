// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_element_one_cell_h
#define biface_tests_element_one_cell_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_manifold.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <biface/element/geometry.h>
#include <biface/element/mixed_element.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/plane.h>
#include <biface/surface/surface_of_revolution.h>

/** The torus of the bias tire. */
inline Biface::SurfaceOfRevolution
torus()
{
  return Biface::SurfaceOfRevolution(
    std::make_shared<Biface::CircularArc>(Biface::CircularArc::Parameters()));
}


/** A cell of a grid with the data needed by tests. */
struct TestCell
{
  Biface::ElementGeometry             geometry;
  std::array<unsigned int, 4>         vertices;
  std::array<Biface::SurfacePoint, 4> points;
};


/** Biface::Laminate::faces() as a function of the first coordinate. */
using Faces = std::function<std::array<double, 2>(const double alpha_1)>;


/** The cells of a grid on a surface; see Biface::ChartGrid for the intervals.
 */
inline std::vector<TestCell>
make_cells(const Biface::ReferenceSurface   &surface,
           const std::array<std::string, 2> &intervals,
           const Faces                      &faces)
{
  using namespace dealii;

  Biface::ChartGrid::Parameters parameters;
  parameters.intervals = intervals;
  parameters.closed    = false;
  Triangulation<2, 3> triangulation;
  Biface::create_triangulation(
    surface, Biface::ChartGrid(parameters, surface), triangulation);

  const MappingManifold<2, 3> mapping;
  const FE_Q<2, 3>            fe(1);
  FEValues<2, 3>              at_vertices(
    mapping, fe, QTrapezoid<2>(), update_quadrature_points | update_gradients);
  FEValues<2, 3> at_center(
    mapping, fe, QMidpoint<2>(), update_quadrature_points | update_JxW_values);

  std::vector<TestCell> cells;
  for (const auto &cell : triangulation.active_cell_iterators())
    {
      at_vertices.reinit(cell);
      at_center.reinit(cell);
      TestCell                             result;
      std::array<std::array<double, 2>, 4> faces_at_vertices;
      for (unsigned int v = 0; v < 4; ++v)
        {
          result.vertices[v] = cell->vertex_index(v);
          result.points[v] =
            surface.evaluate(surface.pull_back(cell->vertex(v)));
          faces_at_vertices[v] = faces(surface.pull_back(cell->vertex(v))[0]);
        }
      result.geometry = Biface::compute_element_geometry(
        at_vertices, at_center, surface, faces_at_vertices);
      cells.push_back(result);
    }
  return cells;
}


/** The same, of constant thickness. */
inline std::vector<TestCell>
make_cells(const Biface::ReferenceSurface   &surface,
           const std::array<std::string, 2> &intervals,
           const std::array<double, 2>      &faces)
{
  return make_cells(
    surface, intervals, Faces([faces](const double) { return faces; }));
}


/** Pseudo-random numbers between -1 and 1, the same on every machine. */
inline double
some_number(const unsigned int i)
{
  return std::sin(1 + 12.9898 * i + 0.01 * i * i);
}

#endif
