// SPDX-License-Identifier: LGPL-2.1-or-later

// A layer of almost no stiffness that ends midway changes nothing in the
// bending of a strip of two layers, on whatever face the reference surface is.

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace Biface;

namespace
{
  /** The displacement of the end by a force across it. */
  double
  deflection(const std::string &plies,
             const std::string &layers,
             const std::string &reference)
  {
    double result = 0;
    run_analysis(SOURCE_DIR "/../verification/stepped_strip.prm",
                 {"Laminate/Plies=" + plies,
                  "Laminate/Layers=" + layers,
                  "Laminate/Reference surface=" + reference,
                  "Materials=strip, soft",
                  "Material soft/Type=isotropic",
                  "Material soft/E=0.1",
                  "Material soft/nu=0",
                  "Loads/Edge moments=",
                  "Loads/Edge forces=alpha_1 max: 0 0 0.001"},
                 [&](const ShellEquations &equations,
                     const StepReport &,
                     const State &state) {
                   for (const Node &node : equations.mesh.nodes)
                     if (node.alpha[0] > 1.99)
                       result = state.displacement(node.dof(2, 0));
                 });
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string strip = "strip: 0.005 @ 0, strip: 0.005 @ 0";
  const double      alone = deflection(strip, "1, 1", "middle");
  // F l^3/(3 E I)
  check_range(
    "strip", alone / (0.001 * 8 / 3 / (1.5e6 * 1e-6 / 12)), 0.99, 1.01);
  for (const std::string reference : {"inner", "middle", "outer", "ply 1"})
    for (const std::string part : {"from 0 to 1", "from 0.5 to 1"})
      check_small("with a layer that ends, reference " + reference,
                  deflection("soft: 0.01 @ 0 " + part + ", " + strip,
                             "1, 1, 1",
                             reference) -
                    alone,
                  1e-3,
                  alone);
}
