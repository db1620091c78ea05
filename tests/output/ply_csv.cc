// SPDX-License-Identifier: LGPL-2.1-or-later

// In a stretched strip whose plies have Poisson's ratio 0, plies-NNNN.csv
// contains the stress E*eps of each ply, its failure index and its tension
// along the fibers; the index of a material without strengths is empty, and a
// message says so.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <biface/program/program.h>

#include "../tests.h"

using namespace dealii;

namespace
{
  const char *const strip = R"(
subsection Surface
  set Type = plane
end
subsection Mesh
  set Intervals alpha_1  = 0:10:4
  set Intervals alpha_2  = 0:1:1
  set Closed in alpha_2  = false
end
set Materials = fiber, bare
subsection Material fiber
  set Type = orthotropic
  set E_1  = 1000
  set E_2  = 100
  set E_3  = 100
  set G_12 = 50
  set G_13 = 50
  set G_23 = 50
  set X_t  = 40
  set X_c  = 10
  set Y_t  = 4
  set Y_c  = 8
  set S    = 3
end
subsection Material bare
  set Type = isotropic
  set E    = 10
end
subsection Laminate
  set Plies             = fiber: 0.2 @ 0, fiber: 0.1 @ 90, bare: 0.3 @ 0
  set Reference surface = middle
end
set Named points = end: 10 0, middle: 5 1
subsection Supports
  set alpha_1 min = fixed
  set alpha_1 max = v_1 both = 0.1; v_2 both; v_3 both
end
subsection Stage 1
  set Strain theory = linear
  set Load factor   = 1
end
subsection Output
  set Directory        = results
  set Points per ply   = 3
  set Failure criteria = maximum stress, Tsai-Wu
  set Write VTU        = false
end
)";


  /** The rows of a CSV file by the names of its columns. */
  std::vector<std::map<std::string, std::string>>
  read_csv(const std::string &name)
  {
    // also what is after the last comma
    const auto split = [](const std::string &line) {
      std::vector<std::string> cells(1);
      for (const char c : line)
        if (c == ',')
          cells.emplace_back();
        else
          cells.back() += c;
      return cells;
    };

    std::ifstream file(name);
    std::string   line;
    std::getline(file, line);
    const auto names = split(line);

    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(file, line))
      {
        const auto cells = split(line);
        AssertThrow(cells.size() == names.size(),
                    ExcDimensionMismatch(cells.size(), names.size()));
        rows.emplace_back();
        for (unsigned int i = 0; i < cells.size(); ++i)
          rows.back()[names[i]] = cells[i];
      }
    return rows;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  if (is_root)
    std::ofstream("strip.prm") << strip;
  MPI_Barrier(MPI_COMM_WORLD);
  char                program[] = "biface", file[] = "strip.prm";
  std::vector<char *> arguments{program, file, nullptr};
  std::stringstream   out;
  std::ostringstream  err;
  Biface::run_program(2, arguments.data(), MPI_COMM_WORLD, out, err);
  if (!is_root)
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
