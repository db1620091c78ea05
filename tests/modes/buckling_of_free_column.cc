// SPDX-License-Identifier: LGPL-2.1-or-later

// A hinged column that nothing holds sideways buckles at the loads of Euler,
// pi^2 E I/L^2 and four times as much in bending of the strip, and a quarter of
// that with its other moment of inertia in its plane, whatever its free motion.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <fstream>

#include <biface/stepping/buckling.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string column = "subsection Surface\n  set Type = plane\nend\n"
                             "subsection Mesh\n"
                             "  set Intervals alpha_1 = 0:100:20\n"
                             "  set Intervals alpha_2 = 0:10:1\n"
                             "  set Closed in alpha_2 = false\nend\n"
                             "subsection Material cord\n"
                             "  set Type = isotropic\n"
                             "  set E    = 1000\n  set nu   = 0\nend\n"
                             "subsection Laminate\n  set Plies = cord: 2 @ 0\n"
                             "  set Reference surface = middle\nend\n"
                             "subsection Supports\n"
                             "  set alpha_1 min = v_1 middle; v_3 middle\n"
                             "  set alpha_1 max = v_3 middle\nend\n"
                             "subsection Loads\n  set Edge forces = alpha_1 "
                             "max: -1 0 0 local middle\nend\n"
                             "subsection Stage 1\n  set Load factor = 0.1\n"
                             "  set Buckling    = 3\nend\n";
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  if (is_root)
    std::ofstream("column.prm") << column;
  MPI_Barrier(MPI_COMM_WORLD);

  for (const char *solver : {"direct", "iterative"})
    {
      const auto reports = run_analysis(
        "column.prm", {std::string("Linear solver/Type=") + solver});
      if (!is_root)
        continue;
      const double euler = numbers::PI * numbers::PI * 1000 / (100 * 100);
      const double I = 10 * 8 / 12., I_in_plane = 2 * 1000 / 12.;
      const double exact[3] = {
        euler * I, 4 * euler * I, euler * I_in_plane / 4};
      const auto &buckling = reports.back().buckling;
      check_true("three loads", buckling && buckling->loads.size() == 3);
      // forces of 1 per length on a width of 10
      for (unsigned int i = 0; buckling && i < buckling->loads.size(); ++i)
        check_small("load " + std::to_string(i + 1),
                    buckling->loads[i].level.factors[0] * 10 - exact[i],
                    0.012,
                    exact[i]);
    }
}
