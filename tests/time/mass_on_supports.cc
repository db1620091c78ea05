// SPDX-License-Identifier: LGPL-2.1-or-later

// A mass that the end of a light strip carries, on a spring, vibrates with
// atan(pi f dt)/(pi dt), f = sqrt((E A/L + k)/m)/(2 pi); a force in resonance
// with it, and a damper, keep the balance of energy, and the work of the force
// is its integral over the way. A table of the force over the time is the same
// as its formula.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <cmath>

#include "motion.h"

using namespace dealii;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double stiffness = 100. * 20 * 2 / 100 + 10, mass = 1e-3,
               omega = std::sqrt(stiffness / mass), dt = 2e-3;
  const std::vector<std::string> strip{DATA_DIR "/strip_with_mass.prm",
                                       "Number of stages=2",
                                       "Stage 2/Inertia=true",
                                       "Stage 2/Forces on bodies=supports: 0",
                                       "Stage 2/Duration=0.1",
                                       "Stage 2/Time step=2e-3",
                                       "Stage 2/Time error=0"};

  const Motion free     = move(strip, "free", MPI_COMM_SELF);
  const double measured = 2 * std::atan(omega * dt / 2);
  const double start    = number(free.history[0], "alpha_1_max_displacement");
  check_small("deflection", start * stiffness / 5e-3 - 1, 1e-5);
  double deviation = 0;
  for (unsigned int i = 1; i < free.history.size(); ++i)
    deviation =
      std::max(deviation,
               std::abs(number(free.history[i], "alpha_1_max_displacement") -
                        start * std::cos(measured * i)));
  check_small("vibration", deviation, 1e-4, start);
  check_balance(free, 1e-11);

  std::vector<std::string> forced = strip;
  for (const std::string setting :
       {"Stage 1/Forces on bodies=supports: 0",
        "Supports/Dampers=supports: 5e-3",
        "Stage 2/Load history=supports: 1e-3*sin(223.6*t)"})
    forced.push_back(setting);
  const Motion resonant = move(forced, "forced", MPI_COMM_SELF);
  check_balance(resonant, 1e-11);
  double work = 0, before = 0;
  for (unsigned int i = 1; i < resonant.history.size(); ++i)
    {
      const double u = number(resonant.history[i], "alpha_1_max_displacement");
      work += 1e-3 * std::sin(223.6 * (i - 0.5) * dt) * (u - before);
      before = u;
    }
  const Row &end = resonant.history.back();
  check_small("work of the force", number(end, "load_work") - work, 1e-8, work);
  std::vector<std::string> tables = strip, formulas = strip;
  tables.push_back("Stage 2/Load history=supports: 1e-3*push");
  tables.emplace_back("Stage 2/History tables=push: " DATA_DIR "/push.csv");
  formulas.emplace_back(
    "Stage 2/Load history=supports: 1e-3*(t < 0.02 ? 100*t : t < 0.06 ? 4 - "
    "100*t : t < 0.08 ? 100*t - 8 : 0)");
  check_small("table and formula",
              number(move(tables, "table", MPI_COMM_SELF).history.back(),
                     "alpha_1_max_displacement") -
                number(move(formulas, "formula", MPI_COMM_SELF).history.back(),
                       "alpha_1_max_displacement"),
              1e-10,
              start);
  check_small("what is left of it",
              number(end, "load_work") - number(end, "damping_work") -
                resonant.energy.back(),
              1e-9,
              work);
}
