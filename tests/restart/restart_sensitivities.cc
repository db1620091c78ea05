// SPDX-License-Identifier: LGPL-2.1-or-later

// A run with derivatives that is stopped and continued on another number of
// ranks has those of an uninterrupted run: in a stage whose start depends on
// the entries, with friction, whose history does, with stresses that relax, and
// in a stage that starts from an earlier one.

#include "../restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string entries =
    "Sensitivities/Entries=p: Stage 1/Pressure, Stage 2/Pressure; "
    "Material cord/E_L; Laminate/Plies[2]; Surface/Circular arc/Radius";
  const auto tire = with(soft_tire,
                         {no_vtu,
                          "Contact/Multiplier mass=lumped",
                          "Newton/Residual tolerance=1e-11",
                          "Stage 2/Travel=10",
                          "Stage 2/Steps=2",
                          "Sensitivities/Outputs=force, loaded_radius"});
  const auto slid = with(tire,
                         {"Number of stages=3",
                          "Stage 3/Contact=true",
                          "Stage 3/Slide=0, 2, 0",
                          "Stage 3/Steps=2"});
  check_restart("pressed", with(tire, {entries}), 3);
  const auto branched =
    with(slid, {entries, "Stage 3/Start from=1", "Stage 3/Travel=8"});
  check_restart("branched", branched, 4);

  // the current stage keeps its loads, and entries their differences, which are
  // smaller with friction
  if (is_root())
    for (const std::vector<std::string> &changed :
         {std::vector<std::string>{"Stage 3/Steps=3"},
          {"Number of stages=4", "Stage 4/Contact=true", "Stage 4/Friction=1"}})
      {
        const Ended ended =
          restart(with(branched, changed), "cut", MPI_COMM_SELF);
        std::cout << "changed: " << ended.code << '\n' << said(ended);
      }

  check_restart("relaxation",
                with(slid,
                     {"Material cord/Relaxation times=1, 20",
                      "Material cord/Relaxation moduli=0.2, 0.3",
                      "Stage 1/Duration=0.5",
                      "Stage 2/Duration=2",
                      "Stage 3/Duration=3",
                      "Sensitivities/Entries=Stage 1/Duration; Stage "
                      "2/Duration; Stage 3/Duration"}),
                5);
  check_restart("friction",
                with(slid,
                     {entries + "; Contact/Friction",
                      "Contact/Friction=0.5",
                      "Contact/Regularization=1e2",
                      "Contact/Tangential regularization=1e2"}),
                5);
}
