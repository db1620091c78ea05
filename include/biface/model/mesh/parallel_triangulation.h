// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_parallel_triangulation_h
#define biface_model_mesh_parallel_triangulation_h

#include <deal.II/distributed/tria_base.h>
#include <deal.II/grid/tria.h>

#include <mpi.h>

#include <functional>
#include <memory>

#include <biface/surface/chart_grid.h>

namespace Biface
{
  /** A triangulation whose cells are distributed over the ranks.
   * @param create makes all coarse cells.
   * @param partition gives them to ranks.
   * @param manifold that of all cells, kept by reference; null for none. */
  std::unique_ptr<dealii::parallel::TriangulationBase<2, 3>>
  make_parallel_triangulation(
    const MPI_Comm                                            communicator,
    const MeshDistribution                                    distribution,
    const std::function<void(dealii::Triangulation<2, 3> &)> &create,
    const std::function<void(dealii::Triangulation<2, 3> &)> &partition,
    const dealii::Manifold<2, 3>                             *manifold);
} // namespace Biface

#endif
