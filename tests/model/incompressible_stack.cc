// SPDX-License-Identifier: LGPL-2.1-or-later

// Stacks of nearly incompressible layers do not lock: a simply supported strip
// has the deflection of Timoshenko's beam within 3 % on 8 and 1.5 % on 16 cells
// per quarter wave, whatever Poisson's ratio is.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "../run_analysis.h"
#include "../tests.h"

using namespace Biface;

namespace
{
  /** The deflection in the middle over that of the beam with the shear factor
   * 5/6. */
  double
  deflection(const unsigned int n_layers,
             const double       nu,
             const unsigned int n_cells)
  {
    const double h = 0.5, a = 10, E = 100;
    std::string  layers = "1";
    for (unsigned int k = 1; k < n_layers; ++k)
      layers += ", 1";
    double result = 0;
    run_analysis(SOURCE_DIR "/../verification/pagano_0_10.prm",
                 {"Mesh/Intervals alpha_1=0:5:" + std::to_string(n_cells),
                  "Materials=ply, rubber",
                  "Material rubber/Type=isotropic",
                  "Material rubber/E=" + std::to_string(E),
                  "Material rubber/nu=" + std::to_string(nu),
                  "Laminate/Plies=" + std::to_string(n_layers) +
                    " x (rubber: " + std::to_string(h) + "/" +
                    std::to_string(n_layers) + " @ 0)",
                  "Laminate/Layers=" + layers,
                  "Laminate/Transverse shear=constant strain",
                  "Supports/alpha_1 min=v_3 both"},
                 [&](const ShellEquations &equations,
                     const StepReport &,
                     const State &state) {
                   for (const Node &node : equations.mesh.nodes)
                     if (node.alpha[0] > 4.999)
                       result = state.displacement(node.dof(2, 0));
                 });
    const double k = dealii::numbers::PI / a;
    return result / (12 * (1 - nu * nu) / (E * std::pow(k * k * h, 2) * h) +
                     2 * (1 + nu) * 6 / 5 / (E * h * k * k));
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const unsigned int n_layers : {2, 3, 4})
    for (const double nu : {0.3, 0.49, 0.499})
      {
        std::cout << n_layers << " layers, nu = " << nu << std::endl;
        check_range("8 cells", deflection(n_layers, nu, 8), 0.97, 1.01);
        check_range("16 cells", deflection(n_layers, nu, 16), 0.985, 1.01);
      }
}
