// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdio>

#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/quantities/penetration_between_points.h>
#include <biface/model/state/loads.h>
#include <biface/solver/active_set_iteration.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>
#include <biface/stepping/step_warnings.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  void
  StepWarnings::start_stage(const StageRun &run,
                            const std::optional<unsigned int> & /*before*/)
  {
    const ShellMesh &mesh = run.equations.mesh;
    // energy is kept in a motion away from an unstable equilibrium, too
    const unsigned int n = run.progress.n_negative_pivots.value_or(0);
    if (run.stage.inertia && n > 0)
      out << "  Warning: the equilibrium at the start of " << run.stage.name
          << " is unstable: its tangent has " << n
          << (n == 1 ? " negative pivot" : " negative pivots")
          << ", and a small motion grows" << std::endl;
    if (run.stage.inertia && !warned_of_rigid_motions &&
        mesh.formulation == Formulation::paper &&
        mesh.get_surface().get_periodicity()[1] > 0)
      {
        out << "  Warning: with 'Formulation = paper' rigid motions strain a "
            << "curved shell, so that momenta are kept up to the error of the "
            << "mesh only; 'standard' keeps them" << std::endl;
        warned_of_rigid_motions = true;
      }
  }


  void
  StepWarnings::end_step(const StageRun &run, StepReport &report)
  {
    warn_of_pierced_nodes(run, *report.loads);
    warn_of_large_cells(run, *report.loads);
    warn_of_pull(run, report);
    warn_of_steep_sides(run, report);
    warn_of_stiffness(run, report);
  }


  void
  StepWarnings::warn_of_steep_sides(const StageRun   &run,
                                    const StepReport &report)
  {
    constexpr double steep = numbers::PI / 4;

    // a step that converged at once gives no reason to doubt its solution
    if (report.n_cuts == 0)
      return;
    for (const ContactPair *pair : run.contact.present(*report.loads))
      if (warned_of_steep_sides.count(pair->name) == 0 &&
          largest_angle_of_normals(*pair, run.state, *report.loads) > steep)
        {
          out << "  Warning: the step was halved, and a steep side of "
              << pair->description()
              << " holds nodes; the shell may have several equilibria there, "
              << "of which the steps choose one. Go from soft to rigid contact "
              << "by 'Regularization' of stages, or give a 'Contact/Tread'"
              << std::endl;
          warned_of_steep_sides.insert(pair->name);
        }
  }


  void
  StepWarnings::warn_of_stiffness(const StageRun &run, const StepReport &report)
  {
    const auto found = report.stiffness.find(run.contact.ground().name);
    if (found == report.stiffness.end() || found->second.doubt.empty() ||
        !warned_of_stiffness.insert(run.stage.name).second)
      return;
    out << "  Warning: stiffness.csv has nan in " << run.stage.name
        << ", since " << found->second.doubt
        << ": forces may change in it though the ground is at rest"
        << std::endl;
  }


  void
  StepWarnings::warn_of_pull(const StageRun &run, const StepReport &report)
  {
    // beside the pressures
    constexpr double      remarkable = 1e-3;
    const ContactSummary &contact    = report.contact;
    if (contact.force >= -remarkable * contact.max_pressure * contact.area ||
        !warned_of_pull.insert(run.stage.name).second)
      return;
    out << "  Warning: the ground pulls at the shell, since its middle is "
        << "beyond the points that make contact; its radius is too small for "
        << "the cells" << std::endl;
  }


  void
  StepWarnings::warn_of_large_cells(const StageRun &run, const Loads &loads)
  {
    // of wall and tread
    constexpr double remarkable = 0.05;

    for (const ContactPair *pair : run.contact.present(loads))
      {
        // on the ground the footprint shows whether cells are small
        if (pair == &run.contact.ground() ||
            warned_of_large_cells.count(pair->name) > 0)
          continue;
        // points in contact cannot see what lies between them
        const auto deepest =
          penetration_between_points(*pair, run.state, loads);
        if (deepest.relative <= remarkable)
          continue;
        char depth[48];
        std::snprintf(depth,
                      sizeof(depth),
                      "%.3g, %.2g %% of its thickness,",
                      deepest.depth,
                      100 * deepest.relative);
        out << "  Warning: between "
            << (pair->points.at_nodes() ? "nodes" : "points in cells")
            << ", which alone make contact, the body '" << pair->name
            << "' is in the shell by " << depth
            << " more than at those around; make the cells smaller, its edges "
            << "rounder, or 'Points in cells' more" << std::endl;
        warned_of_large_cells.insert(pair->name);
      }
  }


  void
  StepWarnings::warn_of_pierced_nodes(const StageRun &run, const Loads &loads)
  {
    for (const ContactPair *pair : run.contact.present(loads))
      {
        if (warned_of_pierced_nodes.count(pair->name) > 0)
          continue;
        const ActiveSet pierced = pierced_nodes(*pair, run.state, loads);
        const bool      any     = std::any_of(
          pierced.begin(), pierced.end(), [](const char node) { return node; });
        // the names of nodes are gathered from all ranks, which must go the
        // same way
        if (!Utilities::MPI::logical_or(any, run.contact.mesh.communicator))
          continue;
        out << "  Warning: " << pair->description()
            << " penetrates supported nodes, which cannot come into contact: "
            << name_nodes(run.contact.mesh, pierced) << std::endl;
        warned_of_pierced_nodes.insert(pair->name);
      }
  }
} // namespace Biface
