// SPDX-License-Identifier: LGPL-2.1-or-later

// A column with an imperfection like its buckling shape has no forces without
// load, and under the part s of Euler's force 1/(1 - s) times the imperfection
// (Timoshenko and Gere, Theory of Elastic Stability, section 1.12).

#include <cmath>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/internal_forces.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double    amplitude = 0.02;
  std::vector<double> deflections;
  double              unbalanced = 0;
  run_analysis(
    DATA_DIR "/imperfect_column.prm",
    {},
    [&](const ShellEquations &equations,
        const StepReport & /*report*/,
        const State &state) {
      double largest = 0;
      for (const Node &node : equations.mesh.nodes)
        largest = std::max(largest,
                           std::abs(equations.mesh.displacement(
                             state.displacement, node, Resultants::inner)[2]));
      deflections.push_back(
        dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD));
      if (deflections.size() == 1)
        unbalanced = equations.internal_forces().strain_energy(state);
    });
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    return 0;
  check_small("energy without load", unbalanced, 1e-20, 1.);
  check_small("without load", deflections[0] - amplitude, 1e-12, amplitude);
  check_small("at 0.5", deflections[1] - 2 * amplitude, 1e-3, amplitude);
  check_small("at 0.8", deflections[2] - 5 * amplitude, 1e-2, amplitude);
}
