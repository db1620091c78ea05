// SPDX-License-Identifier: LGPL-2.1-or-later

// A stage that starts from prestress goes on with all loads, and constant
// forces take up what is out of balance: nothing moves unless the loads change,
// dead loads act as if only their change were given, and follower pressure
// keeps its stiffness.

#include "../model/forces.h"
#include "../restart.h"

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string inflated =
    DATA_DIR "/../verification/inflated_cylinder.prm";
  const std::string pulled = DATA_DIR "/../verification/pulled_cylinder.prm";

  // length 10, width 1, E h = 1000, pulled by 115.5 per width: with the
  // stretch 1 + g, E h (g + g^2/2) (1 + g) = 115.5, so that g = 0.1
  const std::string strip = R"(
subsection Surface
  set Type = plane
end
subsection Mesh
  set Intervals alpha_1  = 0:10:4
  set Intervals alpha_2  = 0:1:1
  set Closed in alpha_2  = false
end
set Materials = strip
subsection Material strip
  set Type = isotropic
  set E    = 1e4
  set nu   = 0
end
subsection Laminate
  set Plies             = strip: 0.1 @ 0
  set Reference surface = middle
end
set Named points = end: 10 0
subsection Supports
  set alpha_1 min = fixed
end
subsection Loads
  set Edge forces = alpha_1 max: 115.5 0 0
end
set Number of stages = 2
subsection Stage 1
  set Load factor = 1
end
subsection Stage 2
  set Start from prestress = true
end
)";


  /** What a run has written. */
  struct Written
  {
    /** What the start of the second stage prints. */
    std::string unbalance;
    /** The last displacement of the named point along x. */
    double u_x = 0;
    /** Its change in the last step. */
    double du_x = 0;
    /** The values of the last step, as text. */
    std::string pressure, load_factor, iterations;
    /** The sum of the forces on the shell in the last step, and the line
     * `prestress`, relative to the maximum force. */
    double imbalance = 0, prestress = 0;

    Written(const std::string &file, const std::vector<std::string> &settings)
    {
      const std::string directory = "prestress_results";
      std::filesystem::remove_all(directory);
      const Ended ended =
        run(with({file}, settings), directory, MPI_COMM_WORLD);
      if (ended.code != 0)
        {
          std::cout << "FAILED: " << ended.err << std::endl;
          return;
        }

      const auto begin = ended.out.find("from prestress: ");
      if (begin != std::string::npos)
        unbalance = ended.out.substr(
          begin + 16, ended.out.find(" is out", begin) - begin - 16);

      const auto column = [](const auto &table, const std::string &name) {
        return std::find(table[0].begin(), table[0].end(), name) -
               table[0].begin();
      };
      const auto history = read_table(directory + "/history.csv");
      pressure           = history.back()[column(history, "pressure")];
      load_factor        = history.back()[column(history, "load_factor")];
      iterations         = history.back()[column(history, "iterations")];

      // three lines per point and step
      const auto probes = read_table(directory + "/probes.csv");
      const auto c      = column(probes, "u_x");
      u_x               = std::stod(probes.back()[c]);
      du_x              = u_x - std::stod(probes[probes.size() - 4][c]);

      const auto            forces = read_table(directory + "/forces.csv");
      std::array<double, 6> sum{};
      double                largest = 0;
      for (const auto &row : forces)
        if (row[0] == history.back()[0])
          for (unsigned int i = 0; i < 6; ++i)
            {
              const double f = std::stod(row[3 + i]);
              sum[i] += f;
              largest = std::max(largest, std::abs(f));
              if (row[2] == "prestress")
                prestress = std::max(prestress, std::abs(f));
            }
      for (const double s : sum)
        imbalance = std::max(imbalance, std::abs(s) / largest);
      prestress /= largest;
    }
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // with the pressure p = 20 the stretch is 1 + g and N_0 = p R/(1 + g); in the
  // second stage E h (g + g^2/2) (1 + g) + N_0 g = 5 R
  std::cout << "dead pressure, 20 to 25" << std::endl;
  {
    const double R = 100, Eh = 1e4, g_0 = 0.159704853;
    const double N_0 = 20 * R / (1 + g_0);
    double       g   = 0;
    for (unsigned int i = 0; i < 20; ++i)
      g -= (Eh * (g + g * g / 2) * (1 + g) + N_0 * g - 5 * R) /
           (Eh * (1 + 3 * g + 1.5 * g * g) + N_0);
    const Written more(inflated,
                       {"Formulation=paper",
                        "Stage 2/Strain theory=nonlinear",
                        "Stage 2/Pressure=25"});
    check_small("  displacement", more.u_x - g * R, 1e-5, g * R);
    std::cout << "  pressure in history.csv: " << more.pressure << std::endl;
    // 1 - 1/(1 + g_0) of the force, half on each face, while the load is on one
    std::cout << "  out of balance: " << more.unbalance << std::endl;
    check_small("  balance of forces", more.imbalance, 1e-8);
    check_true("  some of them balance the shape", more.prestress > 1e-3);
  }

  std::cout << "the same pressure" << std::endl;
  for (const std::string kind : {"dead", "follower"})
    for (const std::string pressure : {"20", "unchanged"})
      {
        const Written same(inflated,
                           {"Loads/Pressure type=" + kind,
                            "Stage 2/Strain theory=nonlinear",
                            "Stage 2/Pressure=" + pressure});
        std::cout << "  " << kind << ", " << pressure << ": pressure "
                  << same.pressure << ", iterations " << same.iterations
                  << std::endl;
        check_small("  displacement", same.u_x, 1e-9);
        check_small("  balance of forces", same.imbalance, 1e-8);
      }

  // inflation stretches it by 1e-4 only: reset or not, the displacement under
  // the line forces is the same
  std::cout << "follower pressure, pulled" << std::endl;
  {
    const std::string follower = "Loads/Pressure type=follower";
    const Written     reset(pulled, {follower});
    const Written     whole(pulled,
                        {follower, "Stage 2/Start from prestress=false"});
    const Written     dead(pulled, {});
    check_small(
      "  as without the reset", reset.u_x - whole.du_x, 1e-3, whole.du_x);
    check_true("  unlike dead pressure",
               std::abs(reset.u_x / dead.u_x - 1) > 0.05);
    check_small("  balance of forces", reset.imbalance, 1e-8);
  }

  std::cout << "strip" << std::endl;
  for (const std::string theory : {"linear", "nonlinear"})
    {
      const Written pulled_strip(write_prm("strip.prm", strip),
                                 {"Stage 1/Strain theory=" + theory});
      // in nonlinear theory 1 - 1/(1 + g)
      std::cout << "  " << theory << ": " << pulled_strip.unbalance
                << ", load factor " << pulled_strip.load_factor << std::endl;
      check_small("  displacement", pulled_strip.u_x, 1e-9);
      check_small("  balance of forces", pulled_strip.imbalance, 1e-8);
      if (theory == "linear")
        check_small("  force of the prestress", pulled_strip.prestress, 1e-8);
    }

  // the rings hold the stretched membrane
  const Written membrane(PRM_DIR "/prestressed_membrane.prm", {no_vtu});
  std::cout << "membrane: " << membrane.unbalance << std::endl;
}
