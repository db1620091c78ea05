// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/loads.h>
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
          // the mean of the outermost faces, and half the differences over the
          // layers
          for (unsigned int i = 0; i < 3; ++i)
            {
              velocity(node.dof(i, 0)) =
                (of_faces.front()[i] + of_faces.back()[i]) / 2;
              for (unsigned int part = 1; part < node.n_parts(); ++part)
                velocity(node.dof(i, part)) =
                  (of_faces[part][i] - of_faces[part - 1][i]) / 2;
            }
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


  void
  start_motion(const ShellEquations       &equations,
               const std::vector<Formula> &initial_velocity,
               const std::string          &section,
               const LoadsOfStepInTime    &first,
               State                      &state)
  {
    const ShellMesh &mesh     = equations.mesh;
    LA::Vector       velocity = mesh.owned_vector();
    if (state.velocity.size() > 0)
      velocity = owned_part(state.velocity);
    bool is_finite = true;
    if (!initial_velocity.empty())
      is_finite = set_velocities(mesh, initial_velocity, state, velocity);
    // a formula may have no value on one rank alone
    if (Utilities::MPI::logical_or(!is_finite, mesh.communicator))
      {
        std::string text;
        for (const Formula &formula : initial_velocity)
          text += (text.empty() ? "" : "; ") + formula.get_text();
        throw InputError(section + "/Initial velocity",
                         text,
                         "it must be finite at all nodes");
      }
    mesh.constraints.distribute(velocity);

    // otherwise the velocities of supports that move would change between twice
    // their velocity and none
    const MotionOfSupports motion(equations, state, first);
    for (const PrescribedDisplacement &p : mesh.prescribed)
      if (mesh.locally_owned.is_element(p.dof))
        velocity(p.dof) = motion.at_start(p.dof);
    velocity.compress(VectorOperation::insert);
    state.velocity = mesh.ghosted_vector();
    state.velocity = velocity;
  }
} // namespace Biface
