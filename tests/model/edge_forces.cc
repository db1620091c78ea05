// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces along edges add up to the force per length times the length of the
// edge: that on the reference surface, or the true one at the height of the
// face or the ply where the force acts, about which it turns the shell.

#include <biface/base/errors.h>
#include <biface/model/forces/dead_loads.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** Faces at -0.5 and 1, middles of plies at -0.25 and 0.5. */
  const std::string plies = "cord: 0.5 @ 0, cord: 1 @ 30";


  void
  check(const std::string  &what,
        const ShellMesh    &mesh,
        const std::string  &text,
        const Tensor<1, 3> &force,
        const Tensor<1, 3> &moment)
  {
    DeadLoads loads;
    loads.edge_forces = parse_edge_forces("forces", text);
    const Total total(mesh, loads.assemble(mesh)[0]);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << what << ", " << text << std::endl;
    check_small("  force", (total.force - force).norm(), 1e-12, 100);
    check_small("  moment", (total.moment - moment).norm(), 1e-12, 1000);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double pi = numbers::PI;

  // the edge x = 4 has the length 2 and its middle at y = 1
  const auto plate =
    free_shell(std::make_unique<Plane>(), {{"0:4:5", "0:2:3"}}, false, plies);
  for (const auto &place : {std::make_pair("", 0.25),
                            std::make_pair(" inner", -0.5),
                            std::make_pair(" outer true length", 1.),
                            std::make_pair(" ply 1", -0.25),
                            std::make_pair(" local ply 2 true length", 0.5)})
    check("plate",
          *plate,
          std::string("alpha_1 max: 3 0 0") + place.first,
          Tensor<1, 3>({6, 0, 0}),
          Tensor<1, 3>({0, 6 * place.second, -6}));

  // a circle of radius 10 about the y axis; e_1 is along the axis
  StraightLine::Parameters line;
  line.start      = Point<2>(10, 0);
  line.end        = Point<2>(10, 6);
  const auto tube = free_shell(
    std::make_unique<SurfaceOfRevolution>(std::make_shared<StraightLine>(line)),
    {{"0:6:4", "0:360:7"}},
    true,
    plies);
  for (const auto &place : {std::make_pair(" inner", 10.),
                            std::make_pair(" ply 2", 10.),
                            std::make_pair(" true length", 10.25),
                            std::make_pair(" inner true length", 9.5),
                            std::make_pair(" outer true length", 11.),
                            std::make_pair(" ply 1 true length", 9.75),
                            std::make_pair(" ply 2 true length", 10.5)})
    check("tube",
          *tube,
          std::string("alpha_1 max: 3 0 0 local") + place.first,
          Tensor<1, 3>({0, 6 * pi * place.second, 0}),
          Tensor<1, 3>());

  // the edge phi = 0 is an arc of 120 degrees about (200, 0, 0); e_2 there is
  // -z, the moment about the axis is that of the arc's mean radius
  const auto torus =
    free_shell(std::make_unique<SurfaceOfRevolution>(
                 std::make_shared<CircularArc>(CircularArc::Parameters())),
               {{"-60:60:400", "0:30:1"}},
               false,
               plies);
  for (const auto &place : {std::make_pair(" ply 2", 50.),
                            std::make_pair(" ply 2 true length", 50.5),
                            std::make_pair(" inner true length", 49.5)})
    {
      DeadLoads loads;
      loads.edge_forces = parse_edge_forces(
        "forces", std::string("alpha_2 min: 0 0 2") + place.first);
      const Total total(*torus, loads.assemble(*torus)[0]);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      std::cout << "torus" << place.first << std::endl;
      check_small(
        "  force",
        (total.force - Tensor<1, 3>({0, 0, 2 * place.second * 2 * pi / 3}))
          .norm(),
        1e-12,
        100);
    }

  // a ply that is not there
  DeadLoads loads;
  loads.edge_forces = parse_edge_forces("forces", "alpha_1 max: 1 0 0 ply 3");
  try
    {
      loads.assemble(*plate);
    }
  catch (const InputError &error)
    {
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << error.what() << std::endl;
    }
  return 0;
}
