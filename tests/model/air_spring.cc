// SPDX-License-Identifier: LGPL-2.1-or-later

// The air spring of air_spring.prm has the effective area of a membrane without
// stiffness, that of the circle through the middle of the lobe; the forces on
// plate and piston balance; and the work of the plate is what the wall stores
// and the gas takes up, C (V_2^(1-n) - V_1^(1-n))/(n - 1), less that of the
// ambient pressure.

#include <cmath>

#include <biface/model/quantities/forces_on_shell.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** What a step says about the sector of two degrees. */
  struct Reading
  {
    double height, force, of_piston_side, pressure, energy, volume;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double ambient = 0.101325, exponent = 1.4, sector = 2. / 360;

  std::vector<Reading>        path;
  const std::vector<Override> entries{"Number of stages=2"};
  Analysis                    analysis(PRM_DIR "/air_spring.prm", entries);
  const Parameters            parameters =
    parameters_of(PRM_DIR "/air_spring.prm", entries);
  const Cavity cavity(
    analysis.simulation.get_equations().mesh, {{}, 0.}, Resultants::inner);
  const auto result =
    analysis.simulation.run([&](const StepReport &report, const State &state) {
      const ShellEquations &equations = analysis.simulation.get_equations();
      Reading               point{30 * report.level.factors[0],
                    0,
                    0,
                    report.loads.pressure,
                    equations.internal_forces().strain_energy(state),
                    cavity.volume(state)};
      for (const auto &item :
           forces_on_shell(equations, state, *report.forces, {}))
        if (item.body == "alpha_1 max")
          point.force = item.force[1];
        else if (item.body == "alpha_1 min" || item.body == "piston")
          point.of_piston_side += item.force[1];
      if (report.instant.stage == 1 || report.instant.fraction == 1)
        path.push_back(point);
    });
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_true("success", result.success);

  const Reading &first = path.front(), &last = path.back();
  const double   area = sector * numbers::PI * 65 * 65;
  check_small("effective area of the membrane",
              -first.force / first.pressure - area,
              5e-3,
              area);
  check_small("balance", first.force + first.of_piston_side, 1e-3, first.force);

  double of_plate = 0;
  for (unsigned int i = 1; i < path.size(); ++i)
    of_plate += (path[i].force + path[i - 1].force) / 2 *
                (path[i].height - path[i - 1].height);
  const double content =
    (first.pressure + ambient) * std::pow(first.volume, exponent);
  const double of_gas = content / (exponent - 1) *
                          (std::pow(last.volume, 1 - exponent) -
                           std::pow(first.volume, 1 - exponent)) +
                        ambient * (last.volume - first.volume);
  check_small("work of the plate",
              of_plate - (last.energy - first.energy + of_gas),
              2e-3,
              of_plate);
}
