// SPDX-License-Identifier: LGPL-2.1-or-later

// A free plate with damping c moves as a point on a dashpot does by the
// implicit Euler method, and all work of its load is dissipated; a roof that
// snaps through under its load with damping ends where its path does.

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

namespace
{
  std::vector<Row>
  rows(const std::string              &directory,
       const std::string              &table,
       const std::string              &file,
       const std::vector<std::string> &settings)
  {
    const Ended ended = run(with({file}, settings), directory, MPI_COMM_SELF);
    std::cout << directory << ": " << ended.code << '\n' << ended.err;
    return read_csv(directory + "/" + table);
  }


  double
  number(const Row &row, const std::string &column)
  {
    return std::strtod(row.at(column).c_str(), nullptr);
  }


  void
  check_plate(const std::string &name, const std::vector<std::string> &settings)
  {
    const double f = 0.01, c = 0.002, area = 100 * 50;
    const auto   probes =
      rows(name, "probes.csv", DATA_DIR "/free_plate.prm", settings);
    // steps of a quarter, with a quarter of the load each
    double u = 0, work = 0;
    for (unsigned int step = 1; step <= 4; ++step)
      {
        const double velocity = f * step / 4 / c;
        u += velocity / 4;
        // the load grows in the step
        work += f * area * (step - 0.5) / 4 * velocity / 4;
        for (const Row &row : probes)
          if (row.at("step") == std::to_string(step) &&
              row.at("face") == "outer")
            check_small("displacement", number(row, "u_z") / u - 1, 1e-9);
      }
    const Row last = read_csv(name + "/history.csv").back();
    check_small("work of the load", number(last, "load_work") / work - 1, 1e-6);
    check_small(
      "what damping dissipates", number(last, "damping_work") / work - 1, 1e-9);
    for (const Row &row : read_csv(name + "/forces.csv"))
      if (row.at("body") == "loads")
        check_small("load and dashpots", number(row, "F_z"), 1e-9, f * area);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_plate("plate", {});
  // its load acts in the middle, so that layers would bend with their thickness
  check_plate("plate_of_layers",
              {"Laminate/Layers=1, 1", "Material rubber/nu=0"});
  check_plate("linear_plate", {"Stage 1/Strain theory=linear"});

  const std::string roof    = DATA_DIR "/../verification/hinged_roof.prm";
  const std::string lines_1 = "Mesh/Intervals alpha_1=0:254:4";
  const std::string lines_2 = "Mesh/Intervals alpha_2=0:5.729577951308232:4";
  // a stage after it starts with the dashpots of the one before
  rows("two_stages",
       "history.csv",
       DATA_DIR "/free_plate.prm",
       {"Number of stages=2", "Stage 2/Damping=0.002", "Stage 2/Steps=2"});
  const Row two_stages = read_csv("two_stages/history.csv").back();
  check_small(
    "work of the load in two stages",
    number(two_stages, "load_work") / number(two_stages, "damping_work") - 1,
    1e-9);

  const Row path = rows("path", "history.csv", roof, {lines_1, lines_2}).back();
  const Row snap = rows("snap",
                        "history.csv",
                        roof,
                        {lines_1,
                         lines_2,
                         "Number of stages=2",
                         "Stage 1/Control=load",
                         "Stage 1/Steps=20",
                         "Stage 1/Damping=1e-5",
                         "Stage 2/Name=rest"})
                     .back();
  check_small("strain energy after the snap",
              number(snap, "strain_energy") / number(path, "strain_energy") - 1,
              1e-6);

  // a support that does not move does no work
  const auto moved = rows("moved",
                          "history.csv",
                          roof,
                          {lines_1,
                           lines_2,
                           "Supports/Point supports=center: x middle = -30",
                           "Loads/Point forces=",
                           "Number of stages=2",
                           "Stage 1/Control=load",
                           "Stage 1/Load factor=1",
                           "Stage 1/Steps=20",
                           "Stage 1/Damping=1e-5",
                           "Stage 2/Name=rest"});
  check_small("work of a support at rest",
              number(moved.back(), "load_work") /
                  number(moved.at(moved.size() - 2), "load_work") -
                1,
              1e-6);
}
