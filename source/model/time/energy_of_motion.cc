// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include <biface/contact/rolling.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_over_step.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/settle_friction.h>
#include <biface/model/equations/mass_matrix.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/inertia_of_wheel.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/energy_of_motion.h>
#include <biface/model/time/inertia.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A vector with the entries of all nodes of this rank. A temporary that is
     * assigned would be moved, without those of ghosts. */
    LA::Vector
    with_ghosts(const ShellMesh &mesh, const LA::Vector &owned)
    {
      LA::Vector result = mesh.ghosted_vector();
      result            = owned;
      return result;
    }


    /** The product @f$\mathbf v\cdot\mathbf M\,\mathbf v@f$ of locally owned
     * entries. */
    double
    mass_product(const ShellMesh &mesh, const LA::Vector &v)
    {
      return inertia(mesh, with_ghosts(mesh, v)) * v;
    }


    /** What Inertia remembers at the end of a step, beside the accelerations of
     * the nodes. */
    enum Remembered : unsigned int
    {
      /** Of the last step. */
      duration,
      /** The strain energy at the start of the stage, and the largest energy of
       * the motion since then. */
      strain_energy_at_start,
      largest_energy,
      n_remembered
    };
  } // namespace


  EnergyOfMotion
  energy_of_motion(const ShellEquations     &equations,
                   const ContactInteraction &contact,
                   const State              &state,
                   const Loads              &loads)
  {
    const ShellMesh &mesh = equations.mesh;
    EnergyOfMotion   result;
    result.strain = equations.strain_energy(state);
    for (const auto &pair : contact.pairs)
      result.contact += contact_energy(*pair, state, loads);
    if (state.step)
      for (const MovingMass &mass : state.step->masses)
        {
          result.of_masses += mass.kinetic_energy(mass.velocity_at_end(loads));
          result.of_springs +=
            mass.energy_of_spring(factor_at(loads.factors, mass.factor));
        }
    if (state.velocity.size() == 0)
      return result;

    LA::Vector momentum = inertia(mesh, state.velocity);
    result.kinetic      = momentum * owned_part(state.velocity) / 2;
    if (loads.rolling)
      {
        const InertiaOfWheel of_wheel(mesh);
        const double         angular_velocity = loads.rolling->angular_velocity;
        result.centrifugal = of_wheel.potential(state, angular_velocity);
        LA::Vector flow    = mesh.owned_vector();
        of_wheel.add_momentum(state, angular_velocity, flow);
        flow.compress(VectorOperation::add);
        momentum += flow;
      }
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
          {
            // by faces, whose positions are the lever arms
            const Tensor<1, 3> of_face = node.surface.from_frame(
              mesh.force_on_any_face(momentum, node, face));
            result.momentum += of_face;
            result.angular_momentum += cross_product_3d(
              mesh.position_of_any_face(state.displacement, node, face),
              of_face);
          }
    for (Tensor<1, 3> *sum : {&result.momentum, &result.angular_momentum})
      for (unsigned int i = 0; i < 3; ++i)
        (*sum)[i] = Utilities::MPI::sum((*sum)[i], mesh.communicator);
    return result;
  }


  namespace
  {
    /** Replace the work of bodies and supports that move with their masses on
     * the shell by that of the forces on them, and add what their dampers
     * dissipate. */
    void
    add_work_of_masses(const ContactInteraction &contact,
                       const State              &state,
                       const Loads              &loads,
                       Work                     &work)
    {
      for (const MovingMass &mass : state.step->masses)
        {
          LoadRates rate;
          rate.factors.assign(loads.factors.size(), 0.);
          rate.factors[mass.factor] = 1;
          // supports are part of the work of the loads already
          double on_shell = 0;
          for (const ContactPair *pair : contact.present(loads))
            on_shell += power_of_body(*pair, state, loads, rate).value *
                        mass.change(loads) / mass.amplitude;
          work.ground -= on_shell;
          work.loads +=
            on_shell + mass.resistance(loads).value * mass.change(loads);
          work.damping += mass.dissipated(loads);
        }
    }
  } // namespace


  namespace
  {
    /** The work of the bristles of a wheel on its shape: they hold it to a
     * ground that moves. */
    double
    work_of_bristles(const ContactPair &contact,
                     const State       &state,
                     const Loads       &loads,
                     const LA::Vector  &change)
    {
      LA::Vector forces = contact.mesh.owned_vector();
      contact.bristle_lines(state, loads).add_forces(forces);
      forces.compress(VectorOperation::add);
      return forces * change;
    }
  } // namespace


  Work
  work_in_time(const ShellEquations     &equations,
               const ContactInteraction &contact,
               const State              &state,
               const Loads              &loads,
               const NodalForces        &forces,
               const EnergyOfMotion     &after)
  {
    const ShellMesh  &mesh   = equations.mesh;
    const StepInTime &step   = *state.step;
    LA::Vector        change = owned_part(state.displacement);
    change -= owned_part(step.start.displacement);

    EnergyOfMotion before =
      energy_of_motion(equations, contact, step.start, step.loads_at_start);
    for (const MovingMass &mass : step.masses)
      {
        before.of_masses += mass.kinetic_energy(mass.velocity);
        before.of_springs += mass.energy_of_spring(
          factor_at(step.loads_at_start.factors, mass.factor));
      }

    double on_shell = forces[ForceTerm::Source::ground] * change;
    for (const auto &pair : contact.pairs)
      if (const auto found = forces.of_bodies.find(pair->name);
          found != forces.of_bodies.end())
        on_shell += found->second * change;
    const double of_inertia = forces.of_bodies.at(Inertia::body) * change;
    Work         result;
    // supports exert what is missing
    result.loads =
      (mesh.prescribes_displacements()
         ? -(forces[ForceTerm::Source::shell] * change) - of_inertia - on_shell
         : forces[ForceTerm::Source::loads] * change);
    // what the axle does, which makes the potential another one
    result.loads += after.centrifugal - before.centrifugal;
    for (const auto &pair : contact.pairs)
      {
        result.ground += work_of_body_over_step(*pair, state, loads) +
                         work_of_bristles(*pair, state, loads, change);
        result.friction += friction_work_over_step(*pair, state, loads);
      }

    const double mass_damping = step.damping.of_mass / step.duration *
                                mass_product(mesh, change),
                 of_strains = equations.dissipated_energy(state),
                 parts      = step.weight_of_end() - 0.5,
                 numerical  = parts > 0
                                ? of_strains * step.damping.numerical / 2 / parts
                                : 0.;
    result.damping          = mass_damping + of_strains - numerical;
    result.numerical        = numerical;

    // what goes into the springs of contact and does not come out
    const double lost =
      result.ground - on_shell - (after.contact - before.contact);
    result.contact = lost - result.friction;
    add_work_of_masses(contact, state, loads, result);
    result.unbalanced = after.sum() - before.sum() - result.loads -
                        result.ground + result.damping + result.numerical +
                        lost;
    return result;
  }


  namespace
  {
    /** The energy of the motion at the end of a step: the kinetic one, and the
     * change of the strain energy since the start of the stage. */
    double
    energy_at_end(const ShellEquations      &equations,
                  const State               &state,
                  const Loads               &loads,
                  const std::vector<double> &remembered)
    {
      double of_masses = 0;
      for (const MovingMass &mass : state.step->masses)
        of_masses += mass.kinetic_energy(mass.velocity_at_end(loads));
      return of_masses +
             mass_product(equations.mesh, state.step->velocity(state)) / 2 +
             std::abs(equations.strain_energy(state) -
                      remembered[strain_energy_at_start]);
    }


    /** What Inertia remembers of the steps before; empty for none. */
    std::vector<double>
    remembered_before(const State &state)
    {
      const auto found = state.step->start.terms.find(Inertia::body);
      return found == state.step->start.terms.end() ? std::vector<double>()
                                                    : found->second.numbers;
    }
  } // namespace


  ErrorInTime
  error_in_time(const ShellEquations &equations,
                const State          &state,
                const Loads          &loads)
  {
    const ShellMesh          &mesh = equations.mesh;
    const StepInTime         &step = *state.step;
    const std::vector<double> last = remembered_before(state);
    if (last.empty())
      return {};
    // what round-off and the iteration leave is no motion
    constexpr double negligible = 1e-9;
    const double     now        = energy_at_end(equations, state, loads, last);
    ErrorInTime      result;
    result.from_rest  = last[largest_energy] <= negligible * now;
    LA::Vector change = step.acceleration(state), before = mesh.owned_vector();
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      if (mesh.nodes[n].locally_owned)
        for (unsigned int i = 0; i < mesh.nodes[n].dofs.size(); ++i)
          before(mesh.nodes[n].dofs[i]) =
            step.start.terms.at(Inertia::body).at_nodes(n, i);
    before.compress(VectorOperation::insert);
    change -= before;

    // the velocity that has the largest energy of the motion, with that of the
    // end of this step
    const double energy = std::max(last[largest_energy], now);
    const double dt = step.duration, between = (dt + last[duration]) / 2;
    double       square = mass_product(mesh, change);
    for (const MovingMass &mass : step.masses)
      {
        const double of_mass =
          mass.acceleration(loads) - mass.last_acceleration;
        square += mass.mass * of_mass * of_mass;
      }
    if (energy > 0)
      result.value = dt * dt / 12 / between * std::sqrt(square / (2 * energy));
    return result;
  }


  void
  remember_motion(const ShellEquations &equations,
                  const Loads          &loads,
                  State                &state)
  {
    const ShellMesh  &mesh = equations.mesh;
    const StepInTime &step = *state.step;
    TermState        &term = state.terms[Inertia::body];
    if (term.numbers.empty())
      {
        term.numbers.resize(n_remembered);
        term.numbers[strain_energy_at_start] =
          equations.strain_energy(step.start);
      }
    term.numbers[duration] = step.duration;
    term.numbers[largest_energy] =
      std::max(term.numbers[largest_energy],
               energy_at_end(equations, state, loads, term.numbers));
    for (const MovingMass &mass : step.masses)
      MovingMass::set_motion(
        state,
        mass.factor,
        {mass.velocity_at_end(loads), mass.acceleration(loads)});

    const LA::Vector acceleration = with_ghosts(mesh, step.acceleration(state));
    term.at_nodes.reinit(mesh.nodes.size(), mesh.n_dofs_per_node());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      for (unsigned int i = 0; i < mesh.nodes[n].dofs.size(); ++i)
        term.at_nodes(n, i) = acceleration(mesh.nodes[n].dofs[i]);
  }
} // namespace Biface
