// SPDX-License-Identifier: LGPL-2.1-or-later

// Of a roof that snaps through, a study has the first maximum of the load, not
// that of the whole path, and over that of the reference: half of it if all
// moduli are half as large.

#include <cmath>

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ofstream("roof.prm")
    << "subsection Study\n"
       "set Base file = " PRM_DIR "/snap_through_roof.prm\n"
       "set Settings = Mesh/Intervals alpha_1=0:254:2; Mesh/Intervals "
       "alpha_2=0:5.729577951308232:4; Stage 1/Critical points=locate; "
       "Output/Write VTU=false\n"
       "set Variables = part: factor of Material ply/E_L, Material ply/E_T, "
       "Material ply/G_LT, Material ply/G_TT\n"
       "set Values = part: 0.5, 1\n"
       "set Reference sample = 2\n"
       "set Outputs = first maximum load_factor, maximum load_factor\n"
       "end\n";
  const Ended ended = run({"--study", "roof.prm"}, "roof", MPI_COMM_WORLD);
  std::cout << ended.code << ended.err << std::endl;

  const auto rows = read_csv("roof/study.csv");
  for (unsigned int i = 0; i < rows.size(); ++i)
    {
      double first = 0, largest = 0;
      bool   falls = false;
      for (const Row &step :
           read_csv("roof/sample-000" + std::to_string(i + 1) + "/history.csv"))
        {
          const double load = std::stod(step.at("load_factor"));
          falls             = falls || load < first;
          if (!falls)
            first = load;
          largest = std::max(largest, load);
        }
      check_small("first maximum",
                  std::stod(rows[i].at("first maximum load_factor")) / first -
                    1,
                  1e-11);
      check_small("maximum",
                  std::stod(rows[i].at("maximum load_factor")) / largest - 1,
                  1e-11);
      check_true("larger later", largest > 1.2 * first);
    }
  check_small(
    "knock-down factor",
    std::stod(rows[0].at("first maximum load_factor / sample 2")) / 0.5 - 1,
    5e-3);
  check_small("of the reference",
              std::stod(rows[1].at("maximum load_factor / sample 2")) - 1,
              1e-14);
}
