// SPDX-License-Identifier: LGPL-2.1-or-later

// An inflated tube, which is stable, has no negative pivots on cells that are
// ten times as long as its wall is thick, with the rubber inside its cords in
// one layer with them or in a layer of its own.

#include <fstream>
#include <iostream>

#include <run_analysis.h>

using namespace Biface;

namespace
{
  const std::string tube =
    "subsection Surface\n"
    "  set Type     = surface of revolution\n"
    "  set Meridian = straight line\n"
    "  subsection Straight line\n"
    "    set Start = 100, -50\n"
    "    set End   = 100, 50\n"
    "  end\nend\n"
    "subsection Mesh\n"
    "  set Intervals alpha_1 = 0:100:5\n"
    "  set Intervals alpha_2 = -10:10:2\n"
    "  set Closed in alpha_2 = false\nend\n"
    "set Materials = cord, rubber\n"
    "subsection Material cord\n"
    "  set Type  = transversely isotropic\n"
    "  set E_L   = 2000\n  set E_T   = 5\n"
    "  set G_LT  = 2\n  set G_TT  = 1.8\n"
    "  set nu_LT = 0.4\n  set nu_TT = 0.4\nend\n"
    "subsection Material rubber\n"
    "  set Type = isotropic\n"
    "  set E    = 5\n  set nu   = 0.4\nend\n"
    "subsection Laminate\n"
    "  set Plies             = rubber: 1 @ 0, cord: 1 @ 90\n"
    "  set Reference surface = middle\nend\n"
    "subsection Supports\n"
    "  set alpha_1 min = fixed\n  set alpha_1 max = fixed\n"
    "  set alpha_2 min = symmetry\n  set alpha_2 max = symmetry\nend\n"
    "set Number of stages = 1\n"
    "subsection Stage 1\n  set Pressure = 0.25\nend\n";
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ofstream("tube.prm") << tube;
  for (const std::string layers : {"one", "1, 1"})
    for (const StepReport &report :
         run_analysis("tube.prm", {"Laminate/Layers=" + layers}))
      std::cout << "Layers = " << layers << ": "
                << report.n_negative_pivots.value_or(99) << " negative pivots"
                << std::endl;
}
