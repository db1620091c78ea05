// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/grid/tria_description.h>

#include <biface/model/mesh/parallel_triangulation.h>

#include <boost/signals2/connection.hpp>

namespace Biface
{
  using namespace dealii;

  std::unique_ptr<parallel::TriangulationBase<2, 3>>
  make_parallel_triangulation(
    const MPI_Comm                                    communicator,
    const MeshDistribution                            distribution,
    const std::function<void(Triangulation<2, 3> &)> &create,
    const std::function<void(Triangulation<2, 3> &)> &partition,
    const Manifold<2, 3>                             *manifold)
  {
    if (distribution == MeshDistribution::shared)
      {
        auto shared = std::make_unique<parallel::shared::Triangulation<2, 3>>(
          communicator,
          Triangulation<2, 3>::none,
          true,
          parallel::shared::Triangulation<2, 3>::partition_custom_signal);
        const boost::signals2::scoped_connection connection =
          shared->signals.create.connect(
            [&partition, whole = shared.get()] { partition(*whole); });
        create(*shared);
        return shared;
      }

    // the first rank holds all cells for a while, to partition them
    const auto description = TriangulationDescription::Utilities::
      create_description_from_triangulation_in_groups<2, 3>(
        create,
        [&](Triangulation<2, 3> &whole, const MPI_Comm &, unsigned int) {
          partition(whole);
        },
        communicator,
        Utilities::MPI::n_mpi_processes(communicator));
    auto distributed =
      std::make_unique<parallel::fullydistributed::Triangulation<2, 3>>(
        communicator);
    if (manifold)
      distributed->set_manifold(0, *manifold);
    distributed->create_triangulation(description);
    return distributed;
  }
} // namespace Biface
