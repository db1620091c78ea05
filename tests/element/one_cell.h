// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_element_one_cell_h
#define biface_tests_element_one_cell_h

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <biface/element/formulation.h>
#include <biface/element/mixed_element.h>
#include <biface/element/shell_fe_values.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/plane.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/surface_of_revolution.h>

#include <name_of.h>

/** The torus of the bias tire. */
inline Biface::SurfaceOfRevolution
torus()
{
  return Biface::SurfaceOfRevolution(
    std::make_shared<Biface::CircularArc>(Biface::CircularArc::Parameters()));
}


/** All elements there are. */
inline std::vector<Biface::Formulation>
all_elements()
{
  using Biface::Formulation;
  return {Formulation::paper, Formulation::vertices, Formulation::standard};
}


/** A cell of a grid with the data needed by tests. */
struct TestCell
{
  Biface::ElementGeometry             geometry;
  std::array<unsigned int, 4>         vertices;
  std::array<Biface::SurfacePoint, 4> points;
};


/** Add a displacement of a face at a vertex. */
inline void
add_face_displacement(const dealii::Tensor<1, 3>        &u,
                      const unsigned int                 vertex,
                      const unsigned int                 face,
                      Biface::MixedElement::NodalVector &V)
{
  // unknowns are the mean and half the difference
  for (unsigned int i = 0; i < 3; ++i)
    {
      V[6 * vertex + 2 * i] += u[i] / 2;
      V[6 * vertex + 2 * i + 1] += (face == 0 ? -1 : 1) * u[i] / 2;
    }
}


/** Biface::Laminate::face_heights() as a function of the first coordinate. */
using FaceHeights = std::function<std::array<double, 2>(const double alpha_1)>;


/** The cells of a grid on a surface; see Biface::ChartGrid for the intervals.
 * @param normal_thickness see Biface::ElementGeometry. */
inline std::vector<TestCell>
make_cells(const Biface::ReferenceSurface   &surface,
           const std::array<std::string, 2> &intervals,
           const FaceHeights                &face_heights,
           const Biface::Formulation formulation = Biface::Formulation::paper,
           const bool                normal_thickness = false)
{
  using namespace dealii;

  Biface::ChartGrid::Parameters parameters;
  for (unsigned int a = 0; a < 2; ++a)
    parameters.intervals[a] =
      Biface::parse_intervals("intervals", intervals[a]);
  parameters.closed = false;
  Triangulation<2, 3> triangulation;
  Biface::create_triangulation(
    surface, Biface::ChartGrid(parameters, surface), triangulation);

  Biface::ShellFEValues fe_values(surface, formulation, normal_thickness);
  std::vector<TestCell> cells;
  for (const auto &cell : triangulation.active_cell_iterators())
    {
      TestCell                           result;
      Biface::ShellFEValues::FaceHeights heights;
      for (unsigned int v = 0; v < 4; ++v)
        {
          result.vertices[v] = cell->vertex_index(v);
          heights[v] = face_heights(surface.pull_back(cell->vertex(v))[0]);
        }
      fe_values.reinit(cell, heights);
      result.geometry = fe_values.get_geometry();
      for (unsigned int v = 0; v < 4; ++v)
        result.points[v] = fe_values.surface_at_vertex(v);
      cells.push_back(result);
    }
  return cells;
}


/** The same, of constant thickness. */
inline std::vector<TestCell>
make_cells(const Biface::ReferenceSurface   &surface,
           const std::array<std::string, 2> &intervals,
           const std::array<double, 2>      &heights,
           const Biface::Formulation formulation = Biface::Formulation::paper,
           const bool                normal_thickness = false)
{
  return make_cells(surface,
                    intervals,
                    FaceHeights([heights](const double) { return heights; }),
                    formulation,
                    normal_thickness);
}


/** An element with a linear law and initial resultants, whose force is the
 * derivative of its energy by the displacements. */
struct ElasticElement
{
  const Biface::ElementGeometry &geometry;
  const Biface::ModeStiffness   &stiffness;
  const Biface::Modes::Vector    initial_resultants;

  Biface::MixedElement::NodalVector
  force(const Biface::MixedElement::NodalVector &V) const
  {
    const Biface::MixedElement element(geometry, V);
    return element.internal_force(stiffness.resultants(element.strain()),
                                  initial_resultants);
  }

  double
  energy(const Biface::MixedElement::NodalVector &V) const
  {
    using namespace Biface;
    const MixedElement  element(geometry, V);
    const Modes::Vector E = element.strain();
    return geometry.weight *
           (Modes::mean_product(stiffness.resultants(E), E) / 2 +
            Modes::mean_product(initial_resultants,
                                element.nonlinear_strain()));
  }
};


/** The norm of what a tangent differs by from central differences of the
 * forces. */
template <typename Force>
double
deviation_of_tangent(const Biface::MixedElement::NodalMatrix &K,
                     const Force                             &force_at,
                     const Biface::MixedElement::NodalVector &V,
                     const double                             step)
{
  double deviation = 0;
  for (unsigned int j = 0; j < Biface::MixedElement::n_dofs; ++j)
    {
      Biface::MixedElement::NodalVector unit;
      unit[j] = step;
      const Biface::MixedElement::NodalVector difference =
        (force_at(V + unit) - force_at(V - unit)) / (2 * step);
      for (unsigned int i = 0; i < Biface::MixedElement::n_dofs; ++i)
        deviation = std::hypot(deviation, std::abs(K[i][j] - difference[i]));
    }
  return deviation;
}


/** The maximum of the entries of a tangent. */
inline double
maximum_entry(const Biface::MixedElement::NodalMatrix &K)
{
  double maximum = 0;
  for (const auto &row : K)
    for (const double entry : row)
      maximum = std::max(maximum, std::abs(entry));
  return maximum;
}


/** Pseudo-random numbers between -1 and 1, the same on every machine. */
inline double
some_number(const unsigned int i)
{
  return std::sin(1 + 12.9898 * i + 0.01 * i * i);
}

#endif
