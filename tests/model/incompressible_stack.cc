// SPDX-License-Identifier: LGPL-2.1-or-later

// Stacks of nearly incompressible layers do not lock, whatever Poisson's ratio
// is: a simply supported strip has the deflection of Timoshenko's beam within
// 3 % on 8 and 1.5 % on 16 cells per quarter wave, a cantilever bent in its
// plane within 4 % on 4 cells over its width, and a free square plate vibrates
// as with a single layer within 1 % on 12 x 12 cells.

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/solver/modal_analysis.h>
#include <biface/stepping/step_report.h>

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


  /** The work of the load on a cantilever of the length 10 and the width 1 in
   * its plane, over that of the beam with the shear factor 5/6. */
  double
  bending_in_plane(const double nu)
  {
    double result = 0;
    for (const StepReport &report :
         run_analysis(SOURCE_DIR "/../verification/pagano_0_10.prm",
                      {"Mesh/Intervals alpha_1=0:10:40",
                       "Mesh/Intervals alpha_2=0:1:4",
                       "Materials=ply, rubber",
                       "Material rubber/Type=isotropic",
                       "Material rubber/E=1000",
                       "Material rubber/nu=" + std::to_string(nu),
                       "Laminate/Plies=2 x (rubber: 0.1 @ 0)",
                       "Laminate/Layers=1, 1",
                       "Laminate/Transverse shear=constant strain",
                       "Supports/alpha_1 min=v_1 both",
                       "Supports/alpha_1 max=free",
                       "Supports/alpha_2 min=free",
                       "Supports/alpha_2 max=free",
                       "Supports/Point supports=support: v_2 both; v_3 both",
                       "Loads/Outer traction=",
                       "Loads/Edge forces=alpha_1 max: 0 -0.01 0"}))
      result = report.work.loads;
    // F = 0.01, E I = 1000 * 0.2/12, G A = E/(2 (1 + nu)) * 0.2
    return result / (1e-4 / 2 *
                     (1000. / 3 / (200. / 12) + 10 * 1.2 * 2 * (1 + nu) / 200));
  }


  /** The lowest frequency of a free square plate. */
  double
  frequency(const std::string &layers, const double nu)
  {
    const auto reports =
      run_analysis(SOURCE_DIR "/../verification/modes_fv52.prm",
                   {"Mesh/Intervals alpha_1=0:10:12",
                    "Mesh/Intervals alpha_2=0:10:12",
                    "Material wall/nu=" + std::to_string(nu),
                    "Laminate/Layers=" + layers,
                    "Laminate/Transverse shear=constant strain"});
    for (const VibrationMode &mode : reports.back().modes->modes)
      if (mode.frequency() > 1)
        return mode.frequency();
    return 0;
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
  for (const double nu : {0.3, 0.49, 0.499})
    {
      std::cout << "nu = " << nu << std::endl;
      check_range("bending in the plane", bending_in_plane(nu), 0.96, 1.01);
      check_range("frequency, two layers over one",
                  frequency("1/2, 1/2", nu) / frequency("one", nu),
                  0.99,
                  1.01);
    }
}
