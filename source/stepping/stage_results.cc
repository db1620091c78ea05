// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_results.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::string> &
    critical_points_names()
    {
      static const std::vector<std::string> names{
        "ignore", "report", "locate", "switch branch"};
      return names;
    }
  } // namespace


  const std::string &
  StageResults::critical_points_name() const
  {
    return critical_points_names()[static_cast<unsigned int>(critical_points)];
  }


  void
  StageResults::add_parameters(EntryDeclarations &prm)
  {
    // nothing is on by default that takes its own time: 'report' reads the
    // pivots that the iteration has
    prm.add_parameter("Modes",
                      n_modes,
                      "Number of natural frequencies and modes of vibration "
                      "of the loaded shell that are computed at the end of "
                      "the stage, the lowest ones. The ground holds the "
                      "nodes in contact along its normal and, with friction, "
                      "sideways; on a wheel that rolls, friction follows from "
                      "the slip velocity, and there are gyroscopic terms. All "
                      "plies need a 'Density'.",
                      Patterns::Integer(0, 1000),
                      RestartChange::within_stage);
    prm.add_parameter("Buckling",
                      n_buckling,
                      "Number of buckling loads that are predicted at the end "
                      "of the stage, the lowest ones: the loads under which "
                      "the tangent is singular if stresses and loads go on "
                      "changing as in the last step of the stage, but the "
                      "shape does not. For the linear buckling load of an "
                      "unloaded shell, a stage of one step with a small part "
                      "of this load, or any load with 'Strain theory = "
                      "linear', where they change as in the whole stage. See "
                      "'Modes' for the nodes in contact.",
                      Patterns::Integer(0, 1000),
                      RestartChange::within_stage);
    add_choice(prm,
               "Critical points",
               critical_points,
               critical_points_names(),
               "What happens where the number of negative pivots of the "
               "tangent changes along the path. 'report': the program says "
               "after the step whether it is a limit point or a bifurcation; "
               "not with friction or a consistent 'Multiplier mass', whose "
               "tangent is not symmetric, and not with a sealed gas or in "
               "linear theory. "
               "'locate': the step ends there, by bisection of the step to "
               "0.1 % of the loads. 'switch branch': likewise, and at a "
               "bifurcation the run continues on the other branch; with "
               "'Control = load' or 'arc length'.",
               RestartChange::within_stage);
    prm.add_parameter("Branch amplitude",
                      branch_amplitude,
                      "The largest displacement in the critical shape with "
                      "which the other branch is sought, as a multiple of the "
                      "thickness. The sign chooses the side. With 'Control = "
                      "load', it doubles until the branch has reached the "
                      "loads of the next step.",
                      Patterns::Double(),
                      Unit::none() | RestartChange::within_stage);
  }


  void
  StageResults::check(const std::string &section) const
  {
    // with an amplitude of 0 the path would not be left
    if (critical_points == CriticalPoints::switch_branch &&
        (!std::isfinite(branch_amplitude) || branch_amplitude == 0))
      throw InputError(section + "/Branch amplitude",
                       number_to_string(branch_amplitude),
                       "it must be finite and not 0");
  }
} // namespace Biface
