// SPDX-License-Identifier: LGPL-2.1-or-later

// What is allowed but probably unintended is said at the start, by --check,
// too: loads that no stage applies, symmetry where angle plies have none, and
// cyclic sectors that do not divide the turn.

#include "../restart.h"

namespace
{
  const std::string sector =
    "subsection Mesh\n"
    "  set Intervals alpha_1 = -120:120:4\n"
    "  set Intervals alpha_2 = -5:5:1\n"
    "  set Closed in alpha_2 = false\n"
    "end\n"
    "subsection Material cord\n"
    "  set Type = transversely isotropic\n"
    "  set E = 5\n  set E_L = 500\n  set E_T = 7\n  set G_LT = 2\n  set G_TT = 2\n"
    "end\n"
    "set Named points = equator: 0 -5\n";


  /** The sentences between what is printed first and last. */
  void
  say(const std::string &what, const std::vector<std::string> &settings)
  {
    std::ofstream("warnings.prm") << sector;
    std::vector<std::string> words{"--check", "warnings.prm"};
    for (const std::string &setting : settings)
      {
        words.push_back("--set");
        words.push_back(setting);
      }
    const Ended ended = run(words, "results", MPI_COMM_SELF);
    std::cout << what << ": exit code " << ended.code << ended.err << std::endl;
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind("No stage", 0) == 0 || line.rfind("Both edges", 0) == 0 ||
          line.rfind("The edges", 0) == 0)
        std::cout << "  " << line << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  say("an edge moment", {"Loads/Edge moments=alpha_1 min: 1 dead"});
  say("not applied",
      {"Loads/Edge moments=alpha_1 min: 1 dead", "Stage 1/Load factor=0"});
  say("applied",
      {"Loads/Edge moments=alpha_1 min: 1 dead", "Stage 1/Load factor=1"});
  say("all dead loads",
      {"Loads/Point forces=equator: 1 0 0",
       "Loads/Edge forces=alpha_1 min: 1 0 0",
       "Loads/Inner traction=1; 0; 0",
       "Loads/Outer traction=1; 0; 0",
       "Loads/Area force=1, 0, 0"});
  say("a displacement of a support", {"Supports/alpha_1 min=v_1 both = 1"});
  say("a displacement of a point",
      {"Supports/Point supports=equator: v_1 both = 1"});
  say("a kind of pressure",
      {"Loads/Pressure type=dead", "Loads/Pressure distribution=x"});
  say("pressure of a stage",
      {"Loads/Pressure type=dead", "Stage 1/Pressure=1"});

  const std::vector<std::string> symmetry{"Supports/alpha_2 min=symmetry",
                                          "Supports/alpha_2 max=v_2 both"};
  const auto                     with = [&](const std::string &setting) {
    auto settings = symmetry;
    settings.push_back(setting);
    return settings;
  };
  say("a sector with angle plies", symmetry);
  say("with plies along the lines",
      with("Laminate/Plies=cord: 1 @ 0, cord: 1 @ -90"));
  say("of an isotropic material", with("Material cord/Type=isotropic"));
  say("with a free edge", with("Supports/alpha_2 max=free"));

  const std::vector<std::string> cyclic{"Supports/alpha_2 min=cyclic",
                                        "Supports/alpha_2 max=cyclic",
                                        "Supports/Point supports=equator: v_1 "
                                        "both"};
  say("a cyclic sector of 10 degrees", cyclic);
  auto uneven = cyclic;
  uneven.push_back("Mesh/Intervals alpha_2=-5:20:1");
  say("of 25 degrees", uneven);
  uneven[2] = "Stage 1/Contact=false";
  say("with nothing at points", uneven);
  return 0;
}
