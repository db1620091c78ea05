// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/displacements_of_faces.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/masses_of_stage.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/start_motion.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Set the velocities of the owned nodes to those of formulas.
     * @return whether they are all finite, on this rank. */
    bool
    set_velocities(const ShellMesh            &mesh,
                   const std::vector<Formula> &formulas,
                   const State                &state,
                   LA::Vector                 &velocity)
    {
      bool is_finite = true;
      for (const Node &node : mesh.nodes)
        {
          if (!node.locally_owned)
            continue;
          std::vector<Tensor<1, 3>> of_faces;
          for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
            {
              const Point<3> x =
                mesh.position_of_any_face(state.displacement, node, face);
              Tensor<1, 3> v;
              for (unsigned int i = 0; i < 3; ++i)
                v[i] = formulas[i].unchecked({x[0], x[1], x[2]});
              is_finite = is_finite && std::isfinite(v.norm());
              of_faces.push_back(node.surface.to_frame(v));
            }
          set_displacements_of_faces(node, of_faces, velocity);
        }
      velocity.compress(VectorOperation::insert);
      return is_finite;
    }
  } // namespace


  MotionOfSupports::MotionOfSupports(const ShellEquations    &equations,
                                     const State             &state,
                                     const LoadsOfStepInTime &loads)
    : at_start(equations.mesh.owned_vector())
    , at_end(equations.mesh.owned_vector())
    , mean(equations.mesh.owned_vector())
  {
    State      placed = state;
    const auto place  = [&](const Loads &at) {
      equations.move_supports(placed, at);
      return owned_part(placed.displacement);
    };
    const LA::Vector u_0 = place(loads.before), u_m = place(loads.middle),
                     u_1 = place(loads.after);
    // of the parabola through the three places
    at_start.add(-3, u_0, 4, u_m);
    at_start.add(-1, u_1);
    at_end.add(1, u_0, -4, u_m);
    at_end.add(3, u_1);
    mean.add(-1, u_0, 1, u_1);
    for (LA::Vector *velocity : {&at_start, &at_end, &mean})
      *velocity /= loads.duration;
  }


  namespace
  {
    /** The velocity with which supports start, as the nodes that they hold. */
    double
    velocity_of_supports(const ShellMesh  &mesh,
                         const MovingMass &mass,
                         const LA::Vector &of_supports)
    {
      std::vector<double> sums(2);
      for (const PrescribedDisplacement &p : mesh.prescribed)
        if (mesh.locally_owned.is_element(p.dof))
          {
            const double per_factor = p.values[mass.factor];
            sums[0] += per_factor * of_supports(p.dof);
            sums[1] += per_factor * per_factor;
          }
      Utilities::MPI::sum(sums, mesh.communicator, sums);
      return sums[0] / sums[1] * mass.amplitude;
    }


    /** Set the velocities at which the masses of a stage start. */
    std::vector<MovingMass>
    start_masses(const Stage             &stage,
                 const ShellMesh         &mesh,
                 const LA::Vector        &of_supports,
                 const LoadsOfStepInTime &first,
                 State                   &state)
    {
      std::vector<MovingMass> masses =
        masses_of_stage(stage, mesh, state, first.before, first.duration);
      MovingMass::bring_to_rest(state);
      for (unsigned int i = 0; i < masses.size(); ++i)
        {
          const MotionByForce &item = stage.motions_by_force[i];
          MovingMass          &mass = masses[i];
          if (item.moves_supports())
            mass.velocity = velocity_of_supports(mesh, mass, of_supports);
          for (const auto &[name, velocity] : stage.velocities_of_bodies)
            if (name == item.name())
              mass.velocity = velocity;
          MovingMass::set_motion(state, mass.factor, {mass.velocity, 0});
        }
      return masses;
    }
  } // namespace


  void
  start_motion(const ShellEquations    &equations,
               const Stage             &stage,
               const std::string       &section,
               const LoadsOfStepInTime &first,
               State                   &state)
  {
    const ShellMesh &mesh     = equations.mesh;
    LA::Vector       velocity = mesh.owned_vector();
    if (state.velocity.size() > 0)
      velocity = owned_part(state.velocity);
    bool is_finite = true;
    if (!stage.initial_velocity.empty())
      is_finite = set_velocities(mesh, stage.initial_velocity, state, velocity);
    // a formula may have no value on one rank alone
    if (Utilities::MPI::logical_or(!is_finite, mesh.communicator))
      {
        std::string text;
        for (const Formula &formula : stage.initial_velocity)
          text += (text.empty() ? "" : "; ") + formula.get_text();
        throw InputError(section + "/Initial velocity",
                         text,
                         "it must be finite at all nodes");
      }
    LA::Vector of_supports(velocity);
    mesh.constraints.distribute(velocity);
    of_supports -= velocity;
    const std::vector<MovingMass> masses =
      start_masses(stage, mesh, of_supports, first, state);

    // otherwise the velocities of supports that move would change between twice
    // their velocity and none
    const MotionOfSupports motion(equations, state, first);
    for (const PrescribedDisplacement &p : mesh.prescribed)
      if (mesh.locally_owned.is_element(p.dof))
        velocity(p.dof) =
          motion.at_start(p.dof) + velocity_by_masses(p, masses);
    velocity.compress(VectorOperation::insert);
    state.velocity = mesh.ghosted_vector();
    state.velocity = velocity;
  }
} // namespace Biface
