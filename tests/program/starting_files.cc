// SPDX-License-Identifier: LGPL-2.1-or-later

// The program writes its examples as they are shipped, with the files that they
// read, and templates for given sizes, which it accepts, also where their
// numbers have many digits; it replaces no file by another.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  void
  attempt(const std::vector<std::string> &words)
  {
    std::ostringstream out, err;
    const int code = Biface::run_program(words, MPI_COMM_WORLD, out, err);
    std::cout << code << ' ' << out.str() << err.str();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                before = std::filesystem::current_path();
  std::filesystem::remove_all("new");
  std::filesystem::create_directory("new");
  std::filesystem::current_path("new");

  attempt({"--example", "gas_bottle"});
  for (const std::string name : {"gas_bottle.prm", "gas_bottle_profile.csv"})
    check_true(name, text_of(name) == text_of(PRM_DIR "/" + name));
  attempt({"--example", "gas_bottle.prm"});
  std::ofstream("gas_bottle_profile.csv") << "another\n";
  attempt({"--example", "gas_bottle"});
  attempt({"--example", "cleat", "--set", "Stage 1/Pressure=1"});

  for (const std::string name : {"tire", "cylinder", "plate", "meridian"})
    {
      attempt({"--template", name});
      std::ostringstream out, err;
      check_true("accepted",
                 Biface::run_program(
                   {"--check", name + ".prm"}, MPI_COMM_WORLD, out, err) == 0 &&
                   err.str().empty());
    }

  // (350/2 - (630/2 - 100))/(100 - 4 1.2) is the cosine of 114.85 degrees
  std::filesystem::remove("tire.prm");
  attempt(
    {"--template", "tire", "--set", "diameter=630", "--set", "width=200"});
  for (const std::string part : {"-114.8451987", "radius = 215"})
    check_true(part, text_of("tire.prm").find(part) != std::string::npos);
  std::filesystem::remove("cylinder.prm");
  attempt(
    {"--template", "cylinder", "--set", "radius=37", "--set", "length=1000/3"});
  {
    std::ostringstream out, err;
    check_true("accepted",
               Biface::run_program(
                 {"--check", "cylinder.prm"}, MPI_COMM_WORLD, out, err) == 0);
  }
  attempt({"--template", "tire", "--set", "rim=10"});
  attempt({"--template", "tire", "--set", "hight=10"});
  attempt({"--template", "car"});
  attempt({"--example", "mounted"});
  std::filesystem::current_path(before);
}
