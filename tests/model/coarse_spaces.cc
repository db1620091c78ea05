// SPDX-License-Identifier: LGPL-2.1-or-later

// The functions of coarser meshes contain the rigid motions of a plate and the
// translations of a tube; the distance to its rotations is of second order in
// the size of the cells.

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <cmath>

#include <biface/model/mesh/coarse_spaces.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/surface/reference_surface.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The normal matrix of a chain of interpolations. */
  class Normal
  {
  public:
    Normal(const NestedSpaces &spaces, const MPI_Comm communicator)
      : spaces(spaces)
    {
      for (const CoarseSpace &space : spaces.coarse)
        {
          vectors.emplace_back(
            space.interpolation.locally_owned_range_indices(), communicator);
          coarsest.reinit(space.interpolation.locally_owned_domain_indices(),
                          communicator);
        }
    }

    void
    interpolate(LA::Vector &fine, const LA::Vector &coarse) const
    {
      const LA::Vector *from = &coarse;
      for (unsigned int l = spaces.coarse.size(); l-- > 0;)
        {
          LA::Vector &to = (l == 0 ? fine : vectors[l]);
          spaces.coarse[l].interpolation.vmult(to, *from);
          from = &to;
        }
    }

    void
    restrict_to(LA::Vector &coarse, const LA::Vector &fine) const
    {
      const LA::Vector *from = &fine;
      for (unsigned int l = 0; l < spaces.coarse.size(); ++l)
        {
          LA::Vector &to =
            (l + 1 == spaces.coarse.size() ? coarse : vectors[l + 1]);
          spaces.coarse[l].interpolation.Tvmult(to, *from);
          from = &to;
        }
    }

    void
    vmult(LA::Vector &y, const LA::Vector &x) const
    {
      interpolate(vectors[0], x);
      const LA::Vector fine = vectors[0];
      restrict_to(y, fine);
    }

    LA::Vector coarsest;

  private:
    const NestedSpaces             &spaces;
    mutable std::vector<LA::Vector> vectors;
  };


  /** The maximum of the distances of translations and of rotations from the
   * coarsest of two meshes, relative to the motion. */
  std::array<double, 2>
  distances(std::unique_ptr<ReferenceSurface> surface,
            const std::array<std::string, 2> &intervals,
            const bool                        closed)
  {
    const auto mesh = cord_shell(
      std::move(surface), intervals, closed, "cord: 0.2 @ 0", "middle");
    NestedSpaces spaces = make_nested_spaces(*mesh, 1);
    while (spaces.coarse.size() > 2)
      spaces.coarse.pop_back();
    Normal normal(spaces, MPI_COMM_WORLD);

    std::array<double, 2> result{};
    const auto            motions = rigid_motions(*mesh);
    for (unsigned int m = 0; m < motions.size(); ++m)
      {
        LA::Vector motion  = mesh->owned_vector(),
                   nearest = mesh->owned_vector();
        std::copy(motions[m].begin(), motions[m].end(), motion.begin());
        LA::Vector right_hand_side(normal.coarsest), x(normal.coarsest);
        normal.restrict_to(right_hand_side, motion);
        ReductionControl control(5000, 0, 1e-12);
        SolverCG<LA::Vector>(control).solve(
          normal, x, right_hand_side, PreconditionIdentity());
        normal.interpolate(nearest, x);
        const double size = motion.linfty_norm();
        nearest -= motion;
        result[m / 3] = std::max(result[m / 3], nearest.linfty_norm() / size);
      }
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  const auto plate =
    distances(std::make_unique<Plane>(), {{"0:2:9:1.2", "0:1:12"}}, false);
  StraightLine::Parameters line;
  const auto               tube = [&](const std::string &n) {
    return distances(std::make_unique<SurfaceOfRevolution>(
                       std::make_shared<StraightLine>(line)),
                     {{"0:1:8", "-180:180:" + n}},
                     true);
  };
  const auto coarse = tube("32"), fine = tube("64");
  if (root)
    {
      check_small("translations of a plate", plate[0], 1e-9);
      check_small("rotations of a plate", plate[1], 1e-9);
      check_small("translations of a tube", fine[0], 1e-9);
      check_range(
        "order of its rotations", std::log2(coarse[1] / fine[1]), 1.8, 4.2);
    }
}
