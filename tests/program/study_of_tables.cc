// SPDX-License-Identifier: LGPL-2.1-or-later

// A study whose base file names a table continues with the same table, and is
// refused when the numbers of the table have changed.

#include "../restart.h"

using namespace dealii;

namespace
{
  void
  write_table(const std::string &last_line)
  {
    std::ofstream("thickness.csv") << "alpha_1,t\n0,0.1\n" << last_line << '\n';
  }


  void
  study(const std::vector<std::string> &more)
  {
    std::vector<std::string> words{"--study"};
    words.insert(words.end(), more.begin(), more.end());
    words.emplace_back("tables.prm");
    const Ended ended = run(words, "study", MPI_COMM_WORLD);
    std::cout << ended.code << ' ' << said(ended) << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all("study");

  std::ofstream("tables.prm")
    << "subsection Study\n"
    << "set Base file = " << DATA_DIR << "/thinning_strip.prm\n"
    << "set Settings = Laminate/Tables=t: "
    << std::filesystem::current_path().string() << "/thickness.csv; "
    << "Laminate/Plies=bare: t @ 0\n"
    << "set Variables = Material bare/E\nset Sampling = list\n"
    << "set Values = Material bare/E: 1e4, 2e4\n"
    << "set Outputs = strain_energy\nend\n";
  write_table("10,0.2");
  study({});
  study({"--restart"});
  write_table("10,0.3");
  study({"--restart"});
}
