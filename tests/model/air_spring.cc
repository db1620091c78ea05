// SPDX-License-Identifier: LGPL-2.1-or-later

// The air spring of air_spring.prm has the effective area of a membrane without
// stiffness, that of the circle through the middle of the lobe; the forces on
// plate and piston balance; and the work of the plate is what the wall stores
// and the gas takes up, C (V_2^(1-n) - V_1^(1-n))/(n - 1), less that of the
// ambient pressure.

#include <cmath>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/step_report.h>

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


  Reading
  read(const ShellEquations &equations,
       const Cavity         &cavity,
       const StepReport     &report,
       const State          &state)
  {
    Reading result{30 * report.level.factors[0],
                   0,
                   0,
                   report.loads->pressure,
                   equations.internal_forces().strain_energy(state),
                   cavity.volume(state)};
    for (const auto &item : report.forces_of_bodies)
      if (item.body == "alpha_1 max")
        result.force = item.force[1];
      else if (item.body == "alpha_1 min" || item.body == "piston")
        result.of_piston_side += item.force[1];
    return result;
  }
} // namespace


namespace
{
  /** The last step of a run. */
  Reading
  end_of(const std::string &file, const std::vector<Override> &entries)
  {
    Analysis     analysis(file, entries);
    const Cavity cavity(
      analysis.simulation.get_equations().mesh, {{}, 0.}, Resultants::inner);
    Reading result{};
    analysis.simulation.run([&](const StepReport &report, const State &state) {
      result = read(analysis.simulation.get_equations(), cavity, report, state);
    });
    return result;
  }


  void
  test_reciprocity()
  {
    const std::string file = PRM_DIR "/bellows.prm";
    const auto        at   = [&](const double pressure, const double height) {
      return end_of(file,
                    {"Number of stages=2",
                     "Stage 1/Pressure=" + std::to_string(pressure),
                     "Stage 2/Gas=open",
                     "Stage 2/Load factor=" + std::to_string(height / 20),
                     "Stage 2/Steps=1"});
    };
    const double p = 0.01, h = 0.2, out = 5;
    // away from where the plates begin to touch
    const double by_pressure =
      (at(0.5 + p, out).force - at(0.5 - p, out).force) / (2 * p);
    const double by_height =
      (at(0.5, out + h).volume - at(0.5, out - h).volume) / (2 * h);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      check_small("force by pressure is volume by height",
                  by_pressure + by_height,
                  1e-3,
                  by_height);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double ambient = 0.101325, exponent = 1.4, sector = 2. / 360;

  std::vector<Reading>        path;
  const std::vector<Override> entries{"Number of stages=2"};
  Analysis                    analysis(PRM_DIR "/air_spring.prm", entries);
  const Cavity                cavity(
    analysis.simulation.get_equations().mesh, {{}, 0.}, Resultants::inner);
  const auto result =
    analysis.simulation.run([&](const StepReport &report, const State &state) {
      const Reading point =
        read(analysis.simulation.get_equations(), cavity, report, state);
      if (report.instant.stage == 1 || report.instant.fraction == 1)
        path.push_back(point);
    });
  test_reciprocity();
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
