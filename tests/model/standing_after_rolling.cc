// SPDX-License-Identifier: LGPL-2.1-or-later

// A wheel that rolled, with friction or without, and has stopped, sticks where
// it is: an unchanged stage with friction leaves its force, and its lateral
// stiffness is that of a wheel that never rolled.

#include <string>

#include "rolling_wheel.h"

using namespace Biface;

namespace
{
  /** @param friction while it rolls. */
  void
  stand_after_rolling(const std::string &friction)
  {
    const auto reports = rolling_reports({"Stage 3/Friction=" + friction,
                                          "Contact/Friction=0.5",
                                          "Stage 2/Friction=0",
                                          "Number of stages=7",
                                          "Stage 3/Control=load",
                                          "Stage 3/Angular velocity=0.0041",
                                          "Stage 4/Contact=true",
                                          "Stage 4/Friction=" + friction,
                                          "Stage 4/Ground velocity=0",
                                          "Stage 4/Angular velocity=0",
                                          "Stage 5/Contact=true",
                                          "Stage 6/Contact=true",
                                          "Stage 6/Slide=0, 0.1, 0",
                                          "Stage 7/Start from=2",
                                          "Stage 7/Contact=true",
                                          "Stage 7/Slide=0, 0.1, 0"});
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    const StepReport &stopped = reports[4], &unchanged = reports[5];
    std::cout << "Friction while rolling: " << friction << std::endl;
    check_small("change of the force",
                unchanged.contact.force - stopped.contact.force,
                1e-7,
                stopped.contact.force);
    check_true("nothing slips", unchanged.contact.n_slipping == 0);
    const double stiffness =
      reports[6].stiffness.at("foundation").secant.along();
    const double not_rolled =
      reports[7].stiffness.at("foundation").secant.along();
    check_small("lateral stiffness beside that without rolling",
                stiffness - not_rolled,
                1e-6,
                not_rolled);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  stand_after_rolling("0.5");
  stand_after_rolling("0");
}
