// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that was stopped in any kind of stage, and is continued on another
// number of ranks, ends with the history of one that was not.

#include "restart.h"

#include "../tests.h"

using namespace dealii;

namespace
{
  bool
  is_root()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }


  /** Run on the first rank alone, or on all of them. */
  template <typename Function>
  int
  on(const bool all, const Function &function)
  {
    int code = 0;
    if (all)
      code = function(MPI_COMM_WORLD).code;
    else if (is_root())
      code = function(MPI_COMM_SELF).code;
    MPI_Barrier(MPI_COMM_WORLD);
    return code;
  }


  /** Stop before a step, first on one rank, then on all; continue on the
   * others. */
  void
  check(const std::string              &name,
        const std::vector<std::string> &words,
        const unsigned int              step)
  {
    const std::string whole = "whole", cut = "cut";
    const std::string stop_at = "Step " + std::to_string(step) + ",";
    on(false, [&](const MPI_Comm communicator) {
      std::filesystem::remove_all(whole);
      return run(words, whole, communicator);
    });
    for (const bool all_ranks : {false, true})
      {
        if (is_root())
          std::filesystem::remove_all(cut);
        MPI_Barrier(MPI_COMM_WORLD);
        const int stopped = on(all_ranks, [&](const MPI_Comm communicator) {
          return run(words, cut, communicator, stop_at);
        });
        const unsigned int n_before = read_table(cut + "/history.csv").size();
        MPI_Barrier(MPI_COMM_WORLD);
        const int continued = on(!all_ranks, [&](const MPI_Comm communicator) {
          return restart(words, cut, communicator);
        });
        if (!is_root())
          continue;
        std::cout << name
                  << (all_ranks ? ", 2 ranks, then 1" : ", 1 rank, then 2")
                  << ": " << stopped << ", " << n_before - 1 << " steps, "
                  << continued << '\n';
        check_small("  history", difference("history.csv", whole, cut), 1e-9);
        if (std::filesystem::exists(whole + "/probes.csv"))
          check_small("  probes", difference("probes.csv", whole, cut), 1e-9);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string verification = DATA_DIR "/../verification/";
  const std::string no_vtu       = "Output/Write VTU=false";

  // a foundation that is less stiff than the default: round-off in clearances
  // is smaller in the forces, and ranks agree in more digits
  const auto tire = with(coarse_tire, {"Contact/Regularization=1e3"});
  check("loads", tire, 4);
  check("a mesh that no rank holds whole",
        with(tire, {"Mesh/Distribution=distributed", no_vtu}),
        3);
  check("loads in steps that are cut",
        with(tire, {"Newton/Maximum iterations=4", "Stage 2/Steps=1", no_vtu}),
        4);
  check("loads in steps that adapt",
        {"--set",
         "Mesh/Intervals alpha_1=0:10:8",
         "--set",
         "Stage 1/Adaptive steps=true",
         "--set",
         "Step control/Greatest growth=4",
         verification + "cantilever_end_shear.prm"},
        5);
  check("force on the foundation",
        with(tire,
             {"Stage 2/Control=foundation force",
              "Stage 2/Travel=0",
              "Stage 2/Force=1500",
              no_vtu}),
        4);
  check("displacement", {DATA_DIR "/../program/displacement_control.prm"}, 6);
  check("arc length",
        {"--set",
         "Mesh/Intervals alpha_1=0:254:4",
         "--set",
         "Mesh/Intervals alpha_2=0:5.729577951308232:4",
         PRM_DIR "/snap_through_roof.prm"},
        20);
  const std::vector<std::string> membrane{"--set",
                                          "Stage 2/Steps=3",
                                          "--set",
                                          no_vtu,
                                          PRM_DIR "/prestressed_membrane.prm"};
  check("begin from prestress", membrane, 2);
  check("linear theory", membrane, 4);
  check("after both", membrane, 6);
}
