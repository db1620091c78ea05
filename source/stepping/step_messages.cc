// SPDX-License-Identifier: LGPL-2.1-or-later

#include <iomanip>
#include <sstream>

#include <biface/input/parameter_tools.h>
#include <biface/stepping/step_messages.h>
#include <biface/stepping/wheel_motion.h>

namespace Biface
{
  using namespace dealii;

  void
  print(const StageRun                  &run,
        const ShellEquations::Unbalance &unbalance,
        ConditionalOStream              &out)
  {
    // without loads, prestress is in balance with supports alone
    const bool   loaded = unbalance.loads > 0;
    const double whole  = (loaded ? unbalance.loads : unbalance.with_supports);
    double       part   = (whole > 0 ? unbalance.forces / whole : 0.);
    // round-off
    if (part < 1e-10)
      part = 0;
    std::ostringstream number;
    number << std::setprecision(3) << part;
    out << "Start of " << run.stage.name << " from prestress: " << number.str()
        << (loaded ? " of the loads" : " of the forces of the supports")
        << " is out of balance in the undeformed shape" << std::endl;
  }


  void
  announce(const StageRun       &run,
           const Control::Trial &trial,
           ConditionalOStream   &out)
  {
    const LoadLevel first = trial.level(trial.mu);
    out << "Step " << run.progress.n_steps + 1 << ", " << run.stage.name
        << ": ";
    if (run.stage.inertia)
      out << "time " << first.time << ", ";
    out << "pressure ";
    if (run.stage.sealed)
      out << run.progress.reached.pressure << " at its start";
    else
      out << first.pressure;
    out << ", load factor " << first.factors[0];
    for (unsigned int i = 1; i < first.factors.size(); ++i)
      out << ", that of " << run.stage.names_of_factors[i].back() << ' '
          << first.factors[i];
    if (run.stage.contact)
      {
        out << ", approach " << first.travel;
        if (first.slide.norm() > 0)
          out << ", slide " << vector_to_string(first.slide);
        if (first.turn != 0)
          out << ", turn " << first.turn;
      }
    out << describe_wheel_motion(first, run.rolls);
    out << (trial.equations ? " at its start" : "") << std::endl;
  }
} // namespace Biface
