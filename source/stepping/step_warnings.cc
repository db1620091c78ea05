// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <biface/input/parameter_tools.h>
#include <biface/solver/active_set_iteration.h>
#include <biface/stepping/step_warnings.h>

namespace Biface
{
  using namespace dealii;

  void
  StepWarnings::end_step(const StageRun &run, StepReport &report)
  {
    warn_of_pierced_nodes(run, report.loads);
    warn_of_fast_wheel(run, report);
  }


  void
  StepWarnings::warn_of_pierced_nodes(const StageRun &run, const Loads &loads)
  {
    if (warned_of_pierced_nodes || !run.stage.contact)
      return;
    const ActiveSet pierced =
      run.contact.ground().pierced_nodes(run.state, loads);
    const bool any = std::any_of(
      pierced.begin(), pierced.end(), [](const char node) { return node; });
    if (!Utilities::MPI::logical_or(any, run.contact.mesh.communicator))
      return;
    out << "  Warning: the foundation penetrates supported nodes, which "
           "cannot come into contact: "
        << name_nodes(run.contact.mesh, pierced) << std::endl;
    warned_of_pierced_nodes = true;
  }


  void
  StepWarnings::warn_of_fast_wheel(const StageRun   &run,
                                   const StepReport &report)
  {
    const auto &strips = run.contact.mesh.strips;
    if (warned_of_fast_wheel || report.n_negative_pivots.value_or(0) == 0 ||
        !report.loads.rolling || report.loads.rolling->angular_velocity == 0 ||
        std::none_of(strips.begin(), strips.end(), [](const Strip &strip) {
          return strip.laminate.mass_moments()[0][0] > 0;
        }))
      return;
    const std::vector<double> &lines = run.contact.mesh.grid.lines[1];
    double                     angle = 0;
    for (std::size_t i = 1; i < lines.size(); ++i)
      angle = std::max(angle, lines[i] - lines[i - 1]);
    out << "  Warning: the tangent has negative pivots at the angular velocity "
        << number_to_string(report.loads.rolling->angular_velocity)
        << ". Either it is above the critical velocity at which standing "
           "waves form, or the cells, of up to "
        << number_to_string(std::round(angle * 180 / numbers::PI))
        << " degrees around the axle, are too large to resolve the inertia: "
           "compare with cells of half the angle."
        << std::endl;
    warned_of_fast_wheel = true;
  }
} // namespace Biface
