// SPDX-License-Identifier: LGPL-2.1-or-later

// In a stretched strip whose plies have Poisson's ratio 0, plies-NNNN.csv
// contains the stress E*eps of each ply, its failure index and its tension
// along the fibers; the index of a material without strengths is empty, and a
// message says so.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <limits>
#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::stringstream                out;
  std::ostringstream               err;
  Biface::run_program(
    {DATA_DIR "/strip_of_two_materials.prm"}, MPI_COMM_WORLD, out, err);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  std::cout << err.str();
  std::string line;
  while (std::getline(out, line))
    if (line.find("strengths") != std::string::npos)
      std::cout << line << std::endl;

  // the strain is 0.01, the stress 10 in ply 1, 1 in ply 2, 0.1 in ply 3
  const double      stress[3]    = {10, 1, 0.1};
  const double      thickness[3] = {0.2, 0.1, 0.3};
  const double      begin[3]     = {-0.3, -0.1, 0};
  const std::string material[3]  = {"fiber", "fiber", "bare"};
  const std::string point[2]     = {"end", "middle"};

  const auto rows  = read_csv("results/plies-0001.csv");
  bool       order = rows.size() == 18, empty = true;
  double     heights = 0, strains = 0, stresses = 0, others = 0, tension = 0,
         indices = 0;
  unsigned int n = 0;
  for (const auto &row : rows)
    {
      const unsigned int p = (n / 3) % 3, i = n % 3;
      order = order && row.at("name") == point[n / 9] &&
              row.at("ply") == std::to_string(p + 1) &&
              row.at("material") == material[p];
      ++n;

      const auto add =
        [&](double &deviation, const std::string &column, const double value) {
          // an empty cell where there must be a number is as bad as can be
          deviation = std::max(
            deviation,
            row.at(column).empty()
              ? std::numeric_limits<double>::max()
              : std::abs(Utilities::string_to_double(row.at(column)) - value));
        };
      add(heights, "fraction", i / 2.);
      add(heights, "angle", p == 1 ? 90 : 0);
      add(heights, "height", begin[p] + i / 2. * thickness[p]);
      add(strains, "e_11", 0.01);
      add(strains, p == 1 ? "e_T" : "e_L", 0.01);
      add(stresses, "s_11", stress[p]);
      add(stresses, p == 1 ? "s_T" : "s_L", stress[p]);
      for (const std::string name : {"e_22",
                                     "e_33",
                                     "g_23",
                                     "g_13",
                                     "g_12",
                                     "s_22",
                                     "s_33",
                                     "t_23",
                                     "t_13",
                                     "t_12",
                                     "g_LT",
                                     "t_LT",
                                     "e_N",
                                     "s_N",
                                     "g_TN",
                                     "g_LN",
                                     "t_TN",
                                     "t_LN"})
        add(others, name, 0);
      add(tension, "fiber_tension", p == 1 ? 0 : thickness[p] * stress[p]);
      for (const std::string name : {"maximum_stress_index", "tsai_wu_index"})
        if (p == 2)
          empty = empty && row.at(name).empty();
        else
          add(indices, name, 0.25);
    }
  check_true("three plies at three heights of two points", order);
  check_small("heights", heights, 1e-12);
  check_small("strains", strains, 1e-12);
  check_small("stresses", stresses, 1e-9);
  check_small("no other strains and stresses", others, 1e-9);
  check_small("tension along the fibers", tension, 1e-9);
  check_small("failure indices", indices, 1e-11);
  check_true("none without strengths", empty);
}
