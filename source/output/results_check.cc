// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/worst_strains.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/output/results_check.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The largest part of the thickness that may penetrate, and of a reaction
     * that may be an error, without a warning. */
    constexpr double remarkable = 0.01;
    /** A part of the sum of all nodal forces below which a resultant is
     * round-off. */
    constexpr double round_off = 1e-6;


    std::string
    in_digits(const double value, const char *format = "%.4g")
    {
      char text[32];
      std::snprintf(text, sizeof(text), format, value);
      return text;
    }


    std::string
    as_percent(const double part)
    {
      return in_digits(100 * part, "%.2g") + " %";
    }


    /** "275.4 or 2 % of the largest reaction". */
    std::string
    beside_reaction(const double force,
                    const double reaction,
                    const double nodal_loads)
    {
      if (reaction < round_off * nodal_loads)
        return in_digits(force) + " or " + as_percent(force / nodal_loads) +
               " of the nodal loads";
      return in_digits(force) + (reaction > 0
                                   ? " or " + as_percent(force / reaction) +
                                       " of the largest reaction"
                                   : ", without any reaction");
    }


    /** The largest angle between the frames at the ends of a side of a cell, in
     * radians. */
    double
    largest_turn(const ShellMesh &mesh)
    {
      const auto cosine_between =
        [&](const Cell &cell, const unsigned int q, const unsigned int r) {
          // the directions of a mesh without lines may turn in the surface
          if (!mesh.grid.has_lines())
            return mesh.nodes[cell.nodes[q]].surface.frame[2] *
                   mesh.nodes[cell.nodes[r]].surface.frame[2];
          // the trace of a rotation is 1 plus twice the cosine of its angle
          return (trace(transpose(cell.geometry.vertices[q].axes) *
                        cell.geometry.vertices[r].axes) -
                  1) /
                 2;
        };
      double cosine = 1;
      for (const Cell &cell : mesh.wall_elements())
        for (unsigned int q = 0; q < 4; ++q)
          for (unsigned int a = 0; a < 2; ++a)
            cosine = std::min(cosine, cosine_between(cell, q, q ^ (1 << a)));
      return std::acos(
        std::max(-1., Utilities::MPI::min(cosine, mesh.communicator)));
    }


    /** A part, or 0 of nothing. */
    double
    part_of(const double part, const double whole)
    {
      return whole > 0 ? part / whole : 0.;
    }
  } // namespace


  ResultsCheck::ResultsCheck(const ShellEquations     &equations,
                             const ContactInteraction &contact)
    : equations(equations), contact(contact)
  {}


  ResultsCheck::Penetration
  ResultsCheck::largest_penetration(const State &state,
                                    const Loads &loads) const
  {
    Penetration          largest;
    const ContactPoints &points = contact.ground().points;
    const PlacedBody    *placed = contact.ground().body(loads);
    for (unsigned int point = 0; placed && point < points.size(); ++point)
      {
        const double thickness =
          points.interpolate(point, [](const Node &node) {
            return node.face_heights[1] - node.face_heights[0];
          });
        // a pressure is the stiffness times the penetration, section 6
        const Penetration here{
          state.ground().pressure(point) /
            placed->laws.condition().penalty_stiffness(),
          contact.ground().tread.height.value_or(thickness)};
        if (here.relative() > largest.relative())
          largest = here;
      }
    const MPI_Comm communicator = equations.mesh.communicator;
    const auto     rank =
      Utilities::MPI::min_max_avg(largest.relative(), communicator).max_index;
    // depth and thickness must be those of the same point
    largest.depth =
      Utilities::MPI::broadcast(communicator, largest.depth, rank);
    largest.thickness =
      Utilities::MPI::broadcast(communicator, largest.thickness, rank);
    return largest;
  }


  std::array<unsigned int, 2>
  ResultsCheck::lines_in_contact(const State &state) const
  {
    const ShellMesh            &mesh = equations.mesh;
    std::array<unsigned int, 2> n_lines{};
    if (!mesh.grid.has_lines())
      return n_lines;
    const ActiveSet in_contact =
      contact.ground().points.nodes_around(state.ground().active);
    for (unsigned int a = 0; a < 2; ++a)
      {
        std::vector<unsigned int> active(mesh.grid.lines[a].size());
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (in_contact[n])
            active[mesh.nodes[n].grid_index[a]] = 1;
        // a line may be in contact on one rank and not on another
        Utilities::MPI::max(active, mesh.communicator, active);
        n_lines[a] = std::count(active.begin(), active.end(), 1U);
      }
    return n_lines;
  }


  ResultsCheck::Balance
  ResultsCheck::balance(const StepReport &report) const
  {
    const ShellMesh &mesh = equations.mesh;
    Balance          result;
    Tensor<1, 3>     force, moment;
    double           largest_force = 0, largest_moment = 0;
    for (const ForceOnShell &item : report.forces_of_bodies)
      {
        const double size = item.force.norm();
        force += item.force;
        moment += item.moment;
        largest_force  = std::max(largest_force, size);
        largest_moment = std::max(largest_moment, item.moment.norm());
        // only supports and bodies react; initial stresses and the error of
        // interpolation are neither loads nor reactions
        if (item.body == "interpolation")
          result.interpolation = size;
        else if (item.body == "loads")
          result.loads = size;
        else if (item.body != "prestress")
          result.largest_reaction = std::max(result.largest_reaction, size);
      }
    // forces that cancel have moments, and the other way around
    largest_force      = std::max(largest_force, largest_moment / mesh.size());
    result.nodal_loads = (*report.forces)[ForceTerm::Source::loads].l1_norm();
    // where nothing reacts, as under loads that cancel, round-off is relative
    // to the loads themselves
    if (largest_force < round_off * result.nodal_loads)
      largest_force = result.nodal_loads;
    largest_moment  = std::max(largest_moment, largest_force * mesh.size());
    result.error    = std::max(part_of(force.norm(), largest_force),
                            part_of(moment.norm(), largest_moment));
    result.internal = (*report.forces)[ForceTerm::Source::shell].l1_norm();
    return result;
  }


  std::vector<std::string>
  ResultsCheck::add(const StepReport &report, const State &state)
  {
    // of a tread
    constexpr double remarkable_compression = 0.3;

    Figures now;
    now.in_contact     = report.in_contact;
    now.pressure       = report.loads->pressure;
    now.force          = report.contact.force;
    now.footprint_area = report.footprint.area;
    now.n_lines        = lines_in_contact(state);
    now.penetration    = largest_penetration(state, *report.loads);
    now.balance        = balance(report);
    last               = now;

    std::vector<std::string> warnings;
    const unsigned int       stage = report.instant.stage;
    const Penetration       &deep  = now.penetration;
    const bool has_tread           = contact.ground().tread.height.has_value();
    if (deep.relative() > (has_tread ? remarkable_compression : remarkable) &&
        warned_of_penetration.insert(stage).second)
      warnings.push_back(
        has_tread
          ? "Warning: the tread is compressed by " + in_digits(deep.depth) +
              ", " + as_percent(deep.relative()) + " of its height of " +
              in_digits(deep.thickness) +
              ", but its stiffness is that of small compressions."
          : "Warning: the shell penetrates the ground by " +
              in_digits(deep.depth) + ", " + as_percent(deep.relative()) +
              " of its thickness of " + in_digits(deep.thickness) +
              "; raise 'Contact/Regularization', which is " +
              in_digits(contact.ground()
                          .body(*report.loads)
                          ->laws.condition()
                          .penalty_stiffness()) +
              ".");
    const Balance &forces = now.balance;
    if (forces.interpolation > remarkable * forces.largest_reaction &&
        forces.interpolation > round_off * forces.internal &&
        warned_of_interpolation.insert(stage).second)
      warnings.push_back(
        "Warning: an error of the interpolation of rigid motions, " +
        beside_reaction(
          forces.interpolation, forces.largest_reaction, forces.nodal_loads) +
        ", is part of the balance of forces (line 'interpolation' of "
        "forces.csv); smaller cells reduce it" +
        (equations.mesh.formulation != Formulation::paper
           ? "."
           : ", and 'Formulation = standard' with cells of 10 degrees or less "
             "has none."));
    if (!checked_cells && equations.mesh.formulation != Formulation::paper)
      {
        constexpr double remarkable_turn = numbers::PI / 6;
        const double     turn            = largest_turn(equations.mesh);
        checked_cells                    = true;
        if (turn > remarkable_turn * (1 + 1e-6))
          warnings.push_back(
            "Warning: cells turn by up to " +
            in_digits(turn * 180 / numbers::PI, "%.3g") +
            " degrees, but except with 'Formulation = paper' they are flat; make "
            "them narrower, 10 degrees or less.");
      }
    const WorstStrains worst =
      worst_strains(equations.mesh, equations.internal_forces(), state);
    if (std::min(worst.compression.value, -worst.shear.value / 3) <
          least_stable_strain &&
        warned_of_strains.insert(stage).second)
      warnings.push_back("Warning: " + describe(worst) +
                         " Such a state is no result of an elastic shell.");
    return warnings;
  }


  std::string
  ResultsCheck::summary() const
  {
    if (!last)
      return {};
    const Figures &at     = *last;
    const Balance &forces = at.balance;
    std::string    text   = "Check: ";
    if (at.in_contact)
      {
        // a membrane would carry the ground by its pressure alone; the rest is
        // the stiffness of the wall
        const double      carried = at.pressure * at.footprint_area;
        const std::string height  = contact.ground().tread.height
                                      ? " of the height of the tread, "
                                      : " of the thickness, ";
        text += "force " + in_digits(at.force) +
                " = pressure times footprint " + in_digits(carried) +
                " + wall " + in_digits(at.force - carried) +
                (contact.mesh.grid.has_lines()
                   ? "; footprint of " + std::to_string(at.n_lines[0]) + " x " +
                       std::to_string(at.n_lines[1]) +
                       " cells along alpha_1 and alpha_2"
                   : "") +
                "\n       penetration " +
                as_percent(at.penetration.relative()) + height;
      }
    else
      text += "loads " + in_digits(forces.loads) + ", largest reaction " +
              in_digits(forces.largest_reaction) + "\n       ";
    return text + "forces and moments balance to " +
           in_digits(forces.error, "%.0e") + ", interpolation " +
           beside_reaction(forces.interpolation,
                           forces.largest_reaction,
                           forces.nodal_loads) +
           "\n";
  }
} // namespace Biface
