// SPDX-License-Identifier: LGPL-2.1-or-later

// A study of which no sample succeeds ends with exit code 2, and with 0 if one
// does.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string values : {"-1, -2", "-1, 3000"})
    {
      std::ofstream("study.prm")
        << "subsection Study\n"
           "  set Base file = " DATA_DIR
           "/../stepping/displacement_control.prm\n"
           "  set Variables = E: Material roof/E\n"
           "  set Values = E: "
        << values << "\n  set Outputs = load_factor\nend\n";
      const Ended ended =
        run({"--study", "study.prm"}, "study", MPI_COMM_WORLD);
      std::cout << "E = " << values << ": " << ended.code << std::endl
                << ended.err;
    }
}
