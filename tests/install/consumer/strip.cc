// SPDX-License-Identifier: LGPL-2.1-or-later

// Bends the strip of the parameter file through the library, and compares its
// deflection with p L^4/(384 D). The exit code is 0 where they agree.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>

#include <biface/analysis/simulation.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/step_report.h>

int
main(int argc, char *argv[])
{
  using namespace Biface;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Parameters               parameters;
  dealii::ParameterHandler prm;
  read_parameters(argv[1], {}, MPI_COMM_WORLD, parameters, prm);

  Simulation simulation(parameters, MPI_COMM_WORLD, std::cout);
  double     deflection = 0;
  const auto result =
    simulation.run([&](const StepReport &, const State &state) {
      const ShellMesh &shell = simulation.get_equations().mesh;
      const auto      &node =
        shell.nodes[shell.node_of_point("Named points", "middle")];
      for (unsigned int face = 0; face < 2; ++face)
        deflection += shell.displacement(state.displacement, node, face)[2] / 2;
    });

  const double length = 100, stiffness = 1, pressure = 3.84e-6;
  const double expected = pressure * std::pow(length, 4) / (384 * stiffness);
  std::cout << "deflection " << deflection << ", expected " << expected
            << std::endl;
  return result.success && std::abs(deflection / expected - 1) < 2e-3 ? 0 : 1;
}
