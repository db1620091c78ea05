// SPDX-License-Identifier: LGPL-2.1-or-later

// Without contact, the table at the end of a run lists the loads and the
// displacements of named points as in probes.csv, and no line shows figures of
// a contact zone; last is the critical point that the step has passed.

#include "../read_csv.h"
#include "../restart.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended = run(with(coarse_tire,
                               {no_vtu,
                                "Stage 2/Contact=false",
                                "Stage 2/Travel=0",
                                "Named points=crown: 0 0, clamp: -120 0"}),
                          "results",
                          MPI_COMM_WORLD);
  std::cout << ended.code << '\n' << ended.err;

  std::vector<std::string> table;
  bool                     no_figures = true;
  std::istringstream       lines(ended.out);
  std::string              line;
  while (std::getline(lines, line))
    {
      if (line.rfind("step ", 0) == 0 || !table.empty())
        table.push_back(line);
      if (line.rfind("  step ", 0) == 0)
        no_figures = no_figures && line.find("contact") == std::string::npos &&
                     line.find("approach") == std::string::npos;
    }
  check_true("no figures of a contact zone", no_figures);
  std::cout << table.at(0) << '\n';

  double deviation = 0;
  for (const Row &row : read_csv("results/probes.csv"))
    if (row.at("face") == "middle")
      {
        std::istringstream cells(table.at(std::stoi(row.at("step"))));
        double             step, pressure, crown, clamp;
        cells >> step >> pressure >> crown >> clamp;
        deviation =
          std::max(deviation,
                   std::abs((row.at("name") == "crown" ? crown : clamp) -
                            std::stod(row.at("u_x"))));
      }
  // six digits are printed
  check_small("displacements", deviation, 1e-5);
}
