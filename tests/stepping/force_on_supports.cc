// SPDX-License-Identifier: LGPL-2.1-or-later

// A force on the rim of a tire, the supports of its beads, that presses it on
// the ground moves it by what has this force as its reaction where it is
// prescribed, also from before the ground touches, with a sealed gas and in the
// half of a tire between planes of symmetry.

#include <deal.II/base/mpi.h>

#include <array>
#include <sstream>

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

namespace
{
  /** The displacement and the force of both edges at the end of a run. */
  std::array<double, 2>
  press(const std::string              &directory,
        const std::vector<std::string> &settings,
        const std::string              &how)
  {
    std::vector<std::string> all{
      "Laminate/Plies=cord: 1.2 @ 0, cord: 1.2 @ 90, cord: 1.2 @ 90, "
      "cord: 1.2 @ 0",
      "Formulation=standard",
      "Loads/Pressure type=follower",
      "Contact/Multiplier mass=lumped",
      "Contact/Regularization=1",
      "Supports/alpha_1 min=x both = 2; y both; z both",
      "Supports/alpha_1 max=x both = 2; y both; z both",
      "Stage 2/Travel=unchanged",
      no_vtu};
    all.insert(all.end(), settings.begin(), settings.end());
    all.push_back(how);
    const Ended ended = run(with(coarse_tire, all), directory, MPI_COMM_WORLD);
    if (!is_root())
      return {};
    if (ended.code != 0)
      std::cout << said(ended);
    const Row end = read_csv(directory + "/history.csv").back();
    return {{std::stod(end.at("alpha_1_min_displacement")),
             std::stod(end.at("alpha_1_min_force")) +
               std::stod(end.at("alpha_1_max_force"))}};
  }


  void
  check(const std::string &name, const std::vector<std::string> &settings)
  {
    const auto given = press("given", settings, "Stage 2/Load factor=4.5");
    if (is_root())
      std::cout << name << '\n';
    double value = given[1];
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    std::ostringstream text;
    text.precision(14);
    text << "Stage 2/Forces on bodies=supports: " << value;
    const auto found = press("found", settings, text.str());
    if (!is_root())
      return;
    check_small("  displacement", found[0] / given[0] - 1, 1e-7);
    check_small("  force", found[1] / given[1] - 1, 1e-9);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // what a prestress exerts at supports is a part of their force
  const Ended stretched = run(with({DATA_DIR "/strip_with_mass.prm"},
                                   {"Number of stages=2",
                                    "Supports/Springs=",
                                    "Stage 1/Forces on bodies=",
                                    "Stage 1/Load factor=1",
                                    "Stage 2/Start from prestress=true",
                                    "Stage 2/Forces on bodies=supports: 20"}),
                              "prestressed",
                              MPI_COMM_WORLD);
  if (is_root())
    {
      std::cout << "start from prestress\n" << said(stretched);
      const Row end = read_csv("prestressed/history.csv").back();
      check_small(
        "  force", std::stod(end.at("alpha_1_max_force")) / 20 - 1, 1e-6);
      check_true("  goes back",
                 std::stod(end.at("alpha_1_max_displacement")) < 0);
    }
  // beads of their own, which nothing holds before the ground touches
  const Ended apart =
    run(with(coarse_tire,
             {"Formulation=standard",
              "Loads/Pressure type=follower",
              "Contact/Multiplier mass=lumped",
              "Supports/alpha_1 min=x both = 1; y both; z both",
              "Supports/alpha_1 max=x both = 1; y both; z both",
              "Stage 2/Travel=unchanged",
              "Stage 2/Forces on bodies=supports alpha_1 min: 200, supports "
              "alpha_1 max: 200",
              no_vtu}),
        "apart",
        MPI_COMM_WORLD);
  if (is_root())
    check_true("two beads by two forces are told to be one",
               apart.code == 2 &&
                 apart.err.find("does not depend on the loads") !=
                   std::string::npos);

  check("frictionless", {});
  check("sealed gas",
        {"Stage 2/Gas=sealed",
         "Stage 2/Pressure=unchanged",
         "Gas/Ambient pressure=0.1"});
  check("half",
        {"Mesh/Closed in alpha_2=false",
         "Mesh/Intervals alpha_2=0:20:3, 20:180:4:smooth",
         "Supports/alpha_2 min=symmetry",
         "Supports/alpha_2 max=symmetry"});
}
