// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_cord_shells_h
#define biface_tests_model_cord_shells_h

#include <deal.II/base/mpi.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <biface/laminate/layup.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/state.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/plane.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/straight_line.h>
#include <biface/surface/surface_of_revolution.h>

#include <cord_ply.h>

inline const std::string thick_ply = "cord: 1.5 @ 30";


/** A shell of cord_ply().
 * @param points on the surface, for supports. */
inline std::unique_ptr<Biface::ShellMesh>
cord_shell(
  std::unique_ptr<Biface::ReferenceSurface> surface,
  const std::array<std::string, 2>         &intervals,
  const bool                                closed,
  const std::string                        &plies,
  const std::string                        &reference,
  const Biface::Supports                   &supports = {},
  const std::vector<Biface::NamedPoint>    &points   = {},
  const std::string                        &layers   = "one",
  const Biface::Formulation formulation = Biface::Formulation::standard)
{
  using namespace Biface;

  ChartGrid::Parameters parameters;
  for (unsigned int a = 0; a < 2; ++a)
    parameters.intervals[a] = parse_intervals("intervals", intervals[a]);
  parameters.closed = closed;
  const ChartGrid   grid(parameters, *surface);
  Layup::Parameters layup;
  layup.plies     = parse_plies("plies", plies);
  layup.reference = parse_thickness_position("reference", reference);
  layup.layers    = parse_layers("layers", layers);
  return std::make_unique<ShellMesh>(MPI_COMM_WORLD,
                                     std::move(surface),
                                     grid,
                                     Layup(layup, cord_ply()),
                                     supports,
                                     points,
                                     formulation);
}


/** A shell without supports, so that all nodal forces remain. With the default
 * plies, the inner face is at -0.5 and the outer one at 1. */
inline std::unique_ptr<Biface::ShellMesh>
free_shell(
  std::unique_ptr<Biface::ReferenceSurface> surface,
  const std::array<std::string, 2>         &intervals,
  const bool                                closed = false,
  const std::string                        &plies  = thick_ply,
  const Biface::Formulation formulation = Biface::Formulation::standard)
{
  return cord_shell(std::move(surface),
                    intervals,
                    closed,
                    plies,
                    "0.5",
                    {},
                    {},
                    "one",
                    formulation);
}


/** A plate of size 4 by 2. */
inline std::unique_ptr<Biface::ShellMesh>
plate(const Biface::Formulation formulation = Biface::Formulation::standard)
{
  return free_shell(std::make_unique<Biface::Plane>(),
                    {{"0:4:5", "0:2:3"}},
                    false,
                    thick_ply,
                    formulation);
}


/** A cylinder about the y axis, of radius 10, from y = 0 to 6. */
inline std::unique_ptr<Biface::ShellMesh>
cylinder(const std::string        &intervals_around,
         const bool                closed,
         const Biface::Formulation formulation = Biface::Formulation::standard)
{
  using namespace Biface;

  StraightLine::Parameters line;
  line.start = dealii::Point<2>(10, 0);
  line.end   = dealii::Point<2>(10, 6);
  return free_shell(
    std::make_unique<SurfaceOfRevolution>(std::make_shared<StraightLine>(line)),
    {{"0:6:4", intervals_around}},
    closed,
    thick_ply,
    formulation);
}


/** A closed section of a torus about the y axis: an arc of radius 50 about 200,
 * from -30 to 90 degrees. */
inline std::unique_ptr<Biface::ShellMesh>
torus(const unsigned int        n_cells,
      const unsigned int        n_around    = 8,
      const std::string        &plies       = thick_ply,
      const Biface::Formulation formulation = Biface::Formulation::standard)
{
  using namespace Biface;

  return free_shell(std::make_unique<SurfaceOfRevolution>(
                      std::make_shared<CircularArc>(CircularArc::Parameters())),
                    {{"-30:90:" + std::to_string(n_cells),
                      "0:360:" + std::to_string(n_around)}},
                    true,
                    plies,
                    formulation);
}


/** The sums of nodal forces on all faces and of their moments about the
 * origin. */
struct Total
{
  dealii::Tensor<1, 3> force, moment;

  Total(const Biface::ShellMesh &mesh, const Biface::LA::Vector &nodal_forces)
    : Total(mesh, nodal_forces, Biface::State(mesh).displacement)
  {}

  /** @param displacement in which the moments are taken. */
  Total(const Biface::ShellMesh  &mesh,
        const Biface::LA::Vector &nodal_forces,
        const Biface::LA::Vector &displacement)
  {
    for (const Biface::Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
          {
            const dealii::Tensor<1, 3> x =
              mesh.position_of_any_face(displacement, node, face);
            const dealii::Tensor<1, 3> f = node.surface.from_frame(
              mesh.force_on_any_face(nodal_forces, node, face));
            force += f;
            moment += dealii::cross_product_3d(x, f);
          }
    force  = dealii::Utilities::MPI::sum(force, MPI_COMM_WORLD);
    moment = dealii::Utilities::MPI::sum(moment, MPI_COMM_WORLD);
  }
};

#endif
