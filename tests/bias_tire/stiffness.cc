// SPDX-License-Identifier: LGPL-2.1-or-later

// The table of stiffnesses of the bias tire, pressed by 20 mm without friction
// and then glued to the plane, agrees with those of the independent
// program of doc/bias_tire.md within 0.1 %, each from the same loaded state.

#include <map>

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto reports = run_bias_tire({"Contact/Multiplier mass=lumped",
                                      "Contact/Tangential regularization=1e4",
                                      "Number of stages=5",
                                      "Stage 2/Steps=2",
                                      "Stage 3/Name=lateral",
                                      "Stage 3/Contact=true",
                                      "Stage 3/Glued=true",
                                      "Stage 3/Slide=0, 0.02, 0",
                                      "Stage 3/Steps=2",
                                      "Stage 4/Name=longitudinal",
                                      "Stage 4/Start from=2",
                                      "Stage 4/Contact=true",
                                      "Stage 4/Glued=true",
                                      "Stage 4/Slide=0, 0, 0.01",
                                      "Stage 5/Name=turn",
                                      "Stage 5/Start from=2",
                                      "Stage 5/Contact=true",
                                      "Stage 5/Glued=true",
                                      "Stage 5/Turn=0.01"});
  // the last step of each stage
  std::map<std::string, StepStiffness> last;
  for (const StepReport &report : reports)
    if (report.stiffness.count("foundation") > 0)
      last[report.stage] = report.stiffness.at("foundation");

  const StepStiffness &lateral = last.at("lateral");
  check_small(
    "loaded: force", lateral.loaded.force[0] + 1929.45, 1e-5, 1929.45);
  check_small("loaded: approach", lateral.level.travel - 20, 1e-12, 20);
  check_small("loaded: pressure", lateral.level.pressure - 0.15, 1e-12);
  for (const auto &[kind, stiffness] :
       {std::make_pair("secant", lateral.secant),
        std::make_pair("tangent", lateral.tangent)})
    {
      const std::string name = std::string("lateral, ") + kind;
      check_small(name, stiffness.along() - 145.24, 1e-3, 145.24);
      check_small(
        name + ": longitudinal force", stiffness.force[2] + 12.87, 1e-3, 12.87);
    }
  const Stiffness longitudinal = last.at("longitudinal").secant;
  check_small("longitudinal", longitudinal.along() - 1049.6, 1e-3, 1049.6);
  check_small(
    "longitudinal: lateral force", longitudinal.force[1] + 12.87, 1e-3, 12.87);
  check_small("turn", last.at("turn").secant.along() - 58655, 1e-3, 58655);
}
