// SPDX-License-Identifier: LGPL-2.1-or-later

// A braided tube under pressure whose ends are held pulls at them as a net of
// its cords does that carries the pressure around the axis: with 2 pi r^2 p
// cot^2 of the cord angle, without the thrust on end plates (Chou and
// Hannaford, IEEE Trans. Robot. Autom. 12 (1996), 90-102).

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/model/quantities/forces_on_shell.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double radius = 10, pressure = 0.3, sectors = 36;
  const double     angle = 25 * dealii::numbers::PI / 180;
  const double expected = 2 * dealii::numbers::PI * radius * radius * pressure /
                          std::pow(std::tan(angle), 2);
  double     computed = 0;
  const auto reports  = run_analysis(DATA_DIR "/braided_tube.prm", {});
  for (const ForceOnShell &force : reports.back().forces_of_bodies)
    if (force.body == "alpha_1 max")
      computed = sectors * force.force[1];
  check_small("axial force", computed - expected, 1e-3, expected);
}
