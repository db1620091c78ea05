// SPDX-License-Identifier: LGPL-2.1-or-later

// What is allowed but probably unintended is said at the start, by --check,
// too: loads that no stage applies, symmetry where angle plies have none,
// cyclic sectors that do not divide the turn, a ground that would pass a
// supported edge, meridians whose outward side faces the axis, and points of a
// file that were taken as one, or are a kink.

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
          line.rfind("The edges", 0) == 0 || line.rfind("Outward", 0) == 0 ||
          line.rfind("Warning", 0) == 0)
        std::cout << "  " << line << std::endl;
      else if (line.find("contour.csv: ") != std::string::npos)
        std::cout << "  " << line.substr(line.find("contour.csv: "))
                  << std::endl;
  }


  /** A meridian through points, with further settings. */
  void
  say_of(const std::string              &what,
         const std::string              &points,
         const std::vector<std::string> &settings = {})
  {
    std::ofstream("contour.csv") << points;
    std::vector<std::string> all{"Surface/Meridian=spline",
                                 "Surface/Spline/File=contour.csv",
                                 "Mesh/Intervals alpha_1=0:end:4"};
    all.insert(all.end(), settings.begin(), settings.end());
    say(what, all);
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

  const std::vector<std::string> downward{"Surface/Meridian=straight line",
                                          "Surface/Straight line/Start=60, 80",
                                          "Surface/Straight line/End=60, 0",
                                          "Mesh/Intervals alpha_1=0:end:4"};
  say("a cylinder from top to bottom", downward);
  auto upward = downward;
  upward[1]   = "Surface/Straight line/Start=60, -80";
  say("from bottom to top", upward);
  upward[1] = "Surface/Straight line/Start=20, 0";
  say("an annulus", upward);
  say_of("a contour from top to bottom", "60, 80\n60, 40\n60, 0\n");
  say_of("mostly upward", "60, 10\n70, 0\n80, 10\n80, 60\n");
  say_of("a point almost repeated",
         "60, 0\n66, 20\n60, 40\n60.1, 40.1\n50, 60\n46, 80\n");
  const std::string kink = "100, 0\n100, 25\n100, 50\n100, 75\n100, 100\n"
                           "80, 120\n60, 140\n40, 160\n";
  say_of("a kink", kink);
  say_of("a corner", kink, {"Surface/Spline/Corner radius=10"});
  for (const std::string travel : {"74", "76"})
    say("a travel of " + travel + " on a section of 75",
        {"Mesh/Intervals alpha_2=-5:5:2",
         "Supports/alpha_1 min=fixed",
         "Stage 1/Contact=true",
         "Stage 1/Travel=" + travel});
  return 0;
}
