// SPDX-License-Identifier: LGPL-2.1-or-later

// With cords that go slack, the bias tire has the displacement, the forces and
// the slack volume of the independent program of doc/bias_tire.md, in few
// iterations and without cuts.

#include <deal.II/base/utilities.h>

#include <iostream>
#include <map>

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace dealii;
using namespace Biface;

namespace
{
  struct Reference
  {
    std::string                 compression;
    std::map<double, double>    forces;
    std::pair<double, double>   slack;
    std::optional<double>       equator;
    std::optional<unsigned int> iterations;
  };


  void
  compare(const Reference &reference)
  {
    double     equator = 0, slack = 0;
    const auto reports =
      run_bias_tire({"Material cord/E_L compression=" + reference.compression,
                     "Contact/Multiplier mass=lumped",
                     "Stage 2/Steps=5"},
                    [&](const ShellEquations &equations,
                        const StepReport     &report,
                        const State          &state) {
                      for (const Node &node : equations.mesh.nodes)
                        if (report.step == 1 &&
                            std::hypot(node.alpha[0], node.alpha[1]) < 1e-9)
                          equator = equations.mesh.displacement(
                            state.displacement, node, Resultants::outer)[2];
                      slack = equations.internal_forces().slack_fraction(state);
                    });

    std::cout << "E_L compression = " << reference.compression << std::endl;
    check_true("  no cuts", reports.size() == 6);
    unsigned int n_iterations = 0;
    for (const StepReport &report : reports)
      {
        n_iterations += report.iterations;
        const auto force = reference.forces.find(report.level.travel);
        if (force != reference.forces.end())
          check_small("  P(" + Utilities::to_string(report.level.travel) + ")",
                      report.contact.force - force->second,
                      1e-5,
                      force->second);
      }
    if (reference.equator)
      check_small("  equator", equator - *reference.equator, 5e-6);
    if (reference.iterations)
      check_range("  iterations", n_iterations, 31, *reference.iterations);
    check_range(
      "  slack cords", slack, reference.slack.first, reference.slack.second);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare({"E_L", {{20, 1929.45}}, {0, 0}, {}, {}});
  compare(
    {"E_L/100", {{8, 525.14}, {20, 1563.67}}, {0.07, 0.08}, -1.82968, 37});
  compare({"E_L/10", {{20, 1626.57}}, {0.07, 0.08}, {}, 37});
}
