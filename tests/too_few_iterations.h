// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_too_few_iterations_h
#define biface_tests_too_few_iterations_h

#include <string>
#include <vector>

/** Settings of a coarse tire whose contact, in the second stage, needs more
 * iterations of the linear solver than its inflation: with 55 at most, Newton's
 * systems are solved but not those of derivatives. A third stage goes on, a
 * fourth one starts from the inflated tire. */
inline std::vector<std::string>
too_few_iterations(const unsigned int max_iterations)
{
  return {"Mesh/Intervals alpha_1=-120:120:14",
          "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
          "Contact/Multiplier mass=lumped",
          "Contact/Regularization=1e3",
          "Output/Write VTU=false",
          "Newton/Residual tolerance=1e-11",
          "Linear solver/Type=iterative",
          "Linear solver/Coarsest unknowns=500",
          "Linear solver/Maximum iterations=" + std::to_string(max_iterations),
          "Number of stages=4",
          "Stage 1/Pressure=0.005",
          "Stage 2/Pressure=0.15",
          "Stage 2/Travel=10",
          "Stage 2/Steps=2",
          "Stage 3/Contact=true",
          "Stage 3/Travel=12",
          "Stage 3/Steps=1",
          "Stage 4/Start from=1",
          "Stage 4/Pressure=0.008",
          "Stage 4/Steps=1",
          "Sensitivities/Entries=Material cord/E_L; Material cord/G_LT",
          "Sensitivities/Outputs=strain_energy, max_fiber_tension",
          "Sensitivities/Stages=1, 2, 3, 4"};
}

#endif
