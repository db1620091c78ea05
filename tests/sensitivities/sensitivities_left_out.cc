// SPDX-License-Identifier: LGPL-2.1-or-later

// Where an iterative solver cannot solve the linear systems of derivatives, the
// run goes on with a warning; derivatives of this stage and of those that start
// from its end are left out, but not those of a stage that starts from an
// earlier end.

#include <deal.II/base/mpi.h>

#include <cmath>

#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>
#include <tests.h>
#include <too_few_iterations.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string warning = "Warning: the derivatives";

  /** The derivatives at the ends of stages, by name of the stage. */
  std::map<std::string, std::vector<std::vector<double>>>
  derivatives(Analysis &analysis)
  {
    std::map<std::string, std::vector<std::vector<double>>> found;
    const bool success = analysis.simulation
                           .run([&](const StepReport &report, const State &) {
                             if (report.sensitivities)
                               found[report.stage] =
                                 report.sensitivities->derivatives;
                           })
                           .success;
    if (!success)
      found.clear();
    return found;
  }


  std::vector<Override>
  settings(const unsigned int max_iterations)
  {
    const auto words = too_few_iterations(max_iterations);
    return {words.begin(), words.end()};
  }
} // namespace


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string tire = PRM_DIR "/bias_tire.prm";
  Analysis   sufficient(tire, settings(300)), too_few(tire, settings(55));
  const auto all  = derivatives(sufficient);
  const auto some = derivatives(too_few);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  std::cout << "stages with derivatives:";
  double error = 0;
  for (const auto &[stage, values] : some)
    {
      std::cout << ' ' << stage << ',';
      for (unsigned int e = 0; e < values.size(); ++e)
        for (unsigned int o = 0; o < values[e].size(); ++o)
          error = std::max(error,
                           std::abs(values[e][o] - all.at(stage)[e][o]) /
                             std::abs(values[e][o]));
    }
  std::cout << " of " << all.size() << std::endl;
  check_small("difference of these to those with more iterations", error, 1e-8);
  for (Analysis *analysis : {&too_few, &sufficient})
    {
      const std::string text       = analysis->screen.str();
      unsigned int      n_warnings = 0;
      for (auto at = text.find(warning); at != std::string::npos;
           at      = text.find(warning, at + 1))
        ++n_warnings;
      std::cout << "warnings: " << n_warnings << std::endl;
    }
}
