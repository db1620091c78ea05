// SPDX-License-Identifier: LGPL-2.1-or-later

// Files that a parameter file names are found whatever the name of its folder
// is, also by a restart and by the parameters as written.

#include "../restart.h"

namespace fs = std::filesystem;

namespace
{
  const std::string parameters =
    "subsection Surface\n"
    "  set Meridian = spline\n"
    "  subsection Spline\n"
    "    set File = meridian.csv\n"
    "  end\n"
    "end\n"
    "subsection Mesh\n"
    "  set Intervals alpha_1 = 0:20:2\n"
    "  set Intervals alpha_2 = -180:180:4\n"
    "end\n"
    "set Materials = rubber\n"
    "subsection Material rubber\n"
    "  set E = 5\n"
    "end\n"
    "subsection Laminate\n"
    "  set Tables = t: thickness.csv, a: \"more, %7Bof%7D them.csv\"\n"
    "  set Plies  = rubber: t @ a\n"
    "end\n"
    "subsection Supports\n"
    "  set alpha_1 min = fixed\n"
    "  set alpha_1 max = fixed\n"
    "end\n"
    "subsection Stage 1\n"
    "  set Pressure = 0.01\n"
    "end\n";
}


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string name :
       {"a, b {c}", "#1", "50 % \"done\"", "x: y; (z", " blanks ", "plain"})
    {
      const fs::path folder = name;
      fs::remove_all(folder);
      fs::create_directory(folder);
      std::ofstream(folder / "meridian.csv") << "10, 0\n10, 10\n10, 20\n";
      std::ofstream(folder / "thickness.csv") << "0, 1\n20, 2\n";
      std::ofstream(folder / "more, {of} them.csv") << "0, 0\n20, 0\n";
      const std::string file = (folder / "run.prm").string();
      std::ofstream(file) << parameters;

      std::cout << "in the folder '" << name << "'" << std::endl;
      fs::remove_all("first");
      fs::remove_all("again");
      Ended ended = run({file}, "first", MPI_COMM_SELF);
      check_true("  runs" + ended.err, ended.code == Biface::done);
      ended = run({"--restart", file}, "first", MPI_COMM_SELF);
      check_true("  restarts" + ended.err, ended.code == Biface::done);
      ended = run({"first/parameters.prm"}, "again", MPI_COMM_SELF);
      check_true("  runs as written" + ended.err, ended.code == Biface::done);
    }
  return 0;
}
