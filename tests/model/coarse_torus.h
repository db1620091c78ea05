// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_coarse_torus_h
#define biface_tests_model_coarse_torus_h

#include <deal.II/base/mpi.h>

#include <memory>

#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/surface_of_revolution.h>

/** A section of the torus of the bias tire on a coarse, uneven grid, held at
 * its edges in the first coordinate; or the full turn. */
inline std::unique_ptr<Biface::ShellMesh>
coarse_torus(const Biface::Layup      &layup,
             const Biface::Formulation formulation = Biface::Formulation::paper,
             const bool                closed      = false)
{
  using namespace Biface;

  auto surface = std::make_unique<SurfaceOfRevolution>(
    std::make_shared<CircularArc>(CircularArc::Parameters()));
  Supports supports;
  supports.edges[0] = supports.edges[1] = parse_support("support", "fixed", 0);
  ChartGrid::Parameters parameters;
  parameters.intervals = {{parse_intervals("intervals", "-60:50:5:1.1"),
                           parse_intervals("intervals",
                                           closed ? "-180:-30:4, -30:30:7, "
                                                    "30:180:5"
                                                  : "-30:30:6")}};
  parameters.closed    = closed;
  const ChartGrid grid(parameters, *surface);
  return std::make_unique<ShellMesh>(MPI_COMM_WORLD,
                                     std::move(surface),
                                     grid,
                                     layup,
                                     supports,
                                     std::vector<NamedPoint>(),
                                     formulation);
}


/** A pseudo-random displacement, the same for any number of ranks, zero where
 * the shell is held. The largest entry is about @p size. */
inline Biface::LA::Vector
some_displacement(const Biface::ShellMesh &mesh,
                  const double             size,
                  const unsigned int       seed)
{
  Biface::LA::Vector V = mesh.owned_vector();
  for (const Biface::Node &node : mesh.nodes)
    if (node.locally_owned)
      for (unsigned int i = 0; i < node.dofs.size(); ++i)
        if (!mesh.constraints.is_constrained(node.dofs[i]))
          V(node.dofs[i]) = size * std::sin(seed + 131.7 * node.alpha[0] +
                                            77.3 * node.alpha[1] + 2.1 * i);
  V.compress(dealii::VectorOperation::insert);
  return V;
}


/** The state with displacement @p V, its resultants, and the active set of
 * @p state. */
inline Biface::State
at(const Biface::ShellEquations &equations,
   const Biface::State          &state,
   const Biface::LA::Vector     &V)
{
  Biface::State result = state;
  result.displacement  = V;
  equations.internal_forces().settle_resultants(result);
  return result;
}

#endif
