// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <biface/contact/tangential_law.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/equations/tangent_matrix.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/solver/fixed_contact_tangent.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The loads of the tangent: a body on which the shell rolls with friction
     * acts with its own derivatives; the others hold the nodes in contact. */
    Loads
    with_bodies_that_stay(const Loads &loads)
    {
      return FixedContactTangent::rolls_with_friction(loads)
               ? loads
               : FixedContactTangent::without_bodies(loads);
    }


    /** The forces on the nodes that turn with the shell: those of the shell and
     * of loads that follow it. */
    LA::Vector
    forces_that_turn(const ShellEquations &equations,
                     const State          &state,
                     const Loads          &loads)
    {
      const NodalForces forces   = equations.nodal_forces(state, loads);
      LA::Vector        constant = equations.mesh.owned_vector();
      for (const ForceTerm *term : equations.get_terms())
        term->add_dead_forces({loads.pressure, loads.factors, 0}, constant);
      equations.internal_forces().add_constant_forces(state, constant);
      LA::Vector result = forces[ForceTerm::Source::shell];
      result += forces[ForceTerm::Source::loads];
      result -= constant;
      return result;
    }


    /** The same state, in linear theory with the tangent that has its stresses:
     * that of the equations has those at the start of the stage. */
    State
    with_stresses_in_tangent(const State &state)
    {
      State result = state;
      if (state.linearization_point)
        {
          auto start = std::make_shared<State>(*state.linearization_point);
          start->resultants          = state.resultants;
          result.linearization_point = start;
        }
      return result;
    }
  } // namespace


  FixedContactTangent::FixedContactTangent(ShellEquations           &equations,
                                           const ContactInteraction &contact,
                                           TimerOutput              &timer)
    : equations(equations), contact(contact), timer(timer)
  {}


  FixedContactTangent::~FixedContactTangent() = default;


  bool
  FixedContactTangent::rolls_with_friction(const Loads &loads)
  {
    return std::any_of(
      loads.bodies.begin(), loads.bodies.end(), [](const auto &body) {
        return body.second->laws.tangential().depends_on_velocity();
      });
  }


  void
  FixedContactTangent::add_stiffness_of(const ContactPair &pair,
                                        const State       &given,
                                        const Loads       &loads,
                                        TangentMatrix     &stiffness_of_contact)
  {
    State state = given;
    for (const auto &[number, body] : loads.bodies)
      body->laws.tangential().stick_all(state.contacts[number]);
    const ShellMesh &mesh    = pair.mesh;
    LA::Vector       nothing = mesh.owned_vector();
    for (const unsigned int c : mesh.walls)
      {
        const Cell               &cell = mesh.cells[c];
        MixedElement::NodalMatrix matrix{};
        bool                      any = false;
        for (unsigned int i = 0; i < pair.points.on_cell().size(); ++i)
          {
            const auto        &point = pair.points.on_cell()[i];
            const unsigned int n     = pair.points.number(cell, i);
            if (!pair.state_of(state).active[n])
              continue;
            any = true;
            const Tensor<2, 3> stiffness =
              pair.traction(state, loads, n).stiffness;
            const double part = pair.points.area(cell, i) / 2;
            for (unsigned int r = 0; r < 4; ++r)
              for (unsigned int s = 0; s < 4; ++s)
                {
                  // lumped also where the multipliers are not
                  const double weight =
                    part * point.position[r] * point.position[s];
                  if (weight == 0)
                    continue;
                  const auto &row    = mesh.nodes[cell.nodes[r]].surface.frame,
                             &column = mesh.nodes[cell.nodes[s]].surface.frame;
                  Tensor<2, 3> in_frame;
                  // the symmetric part: friction does not make a held node
                  // unsymmetric
                  for (unsigned int i = 0; i < 3; ++i)
                    for (unsigned int j = 0; j < 3; ++j)
                      in_frame[i][j] =
                        weight * (row[i] * (stiffness * column[j]) +
                                  column[j] * (stiffness * row[i]));
                  MixedElement::add_stiffness(in_frame,
                                              r,
                                              cell.sign_of_face(r, pair.face),
                                              s,
                                              cell.sign_of_face(s, pair.face),
                                              matrix);
                }
          }
        if (any)
          stiffness_of_contact.add(
            c, matrix, MixedElement::NodalVector(), nothing);
      }
  }


  const LA::SparseMatrix &
  FixedContactTangent::stiffness_of_contact(const State &state,
                                            const Loads &loads)
  {
    if (!of_contact)
      of_contact =
        std::make_unique<TangentMatrix>(contact.mesh, contact.mesh.constraints);
    of_contact->clear();
    for (const auto &pair : contact.pairs)
      add_stiffness_of(*pair, state, loads, *of_contact);
    of_contact->compress();
    return of_contact->get();
  }


  std::pair<State, Loads>
  FixedContactTangent::of_tangent(const State &state, const Loads &loads)
  {
    Loads now = with_bodies_that_stay(loads);
    // with the loads at the end, as the stresses
    now.linearized_at.reset();
    return {with_stresses_in_tangent(state), now};
  }


  void
  FixedContactTangent::assemble(const State      &state,
                                const Loads      &loads,
                                LA::SparseMatrix &K)
  {
    TimerOutput::Scope scope(timer, "Assembly");
    const auto [of_stresses, now] = of_tangent(state, loads);
    equations.assemble(of_stresses, now);
    K.copy_from(equations.tangent());
  }


  void
  FixedContactTangent::add_contact_stiffness(const State      &state,
                                             const Loads      &loads,
                                             LA::SparseMatrix &K)
  {
    if (with_bodies_that_stay(loads).bodies.size() == loads.bodies.size())
      return;
    K.add(1., stiffness_of_contact(state, loads));
  }


  std::vector<RigidMotion>
  FixedContactTangent::free_motions(const State &state, const Loads &loads)
  {
    if (loads.rolling)
      return {};
    return free_rigid_motions(
      equations.mesh,
      equations.internal_forces().in_shape_of_tangent(state).displacement,
      loads.bodies.empty() ? nullptr : &stiffness_of_contact(state, loads));
  }


  std::vector<RigidMotion>
  FixedContactTangent::neutral_motions(const State            &state,
                                       const Loads            &loads,
                                       const LA::SparseMatrix &K)
  {
    // part of the resistance that is computed for a rotation, to which
    // interpolation in a curved shell contributes
    constexpr double negligible = 0.1;

    const ShellMesh          &mesh = equations.mesh;
    std::vector<RigidMotion>  neutral;
    std::optional<LA::Vector> turning;
    for (const RigidMotion &motion : free_motions(state, loads))
      {
        if (motion.rotation.norm() > 0)
          {
            if (!turning)
              turning = forces_that_turn(equations, state, loads);
            LA::Vector exact = turned(mesh, motion.rotation, *turning);
            mesh.condense(exact);
            LA::Vector computed(exact);
            K.vmult(computed, motion.displacement);
            if (exact.l2_norm() > negligible * computed.l2_norm())
              continue;
          }
        neutral.push_back(motion);
      }
    return neutral;
  }


  Loads
  FixedContactTangent::without_bodies(const Loads &loads)
  {
    Loads alone = loads;
    alone.bodies.clear();
    return alone;
  }


  bool
  FixedContactTangent::is_symmetric(const Loads            &loads,
                                    const LA::SparseMatrix &K) const
  {
    return equations.is_symmetric(with_bodies_that_stay(loads), K);
  }


  bool
  FixedContactTangent::is_symmetric_but_for_loads(const Loads &loads) const
  {
    return equations.is_symmetric_but_for_loads(with_bodies_that_stay(loads));
  }


  std::vector<LA::Vector>
  normalized_shapes(const ShellMesh &mesh, const std::vector<LA::Vector> &parts)
  {
    std::vector<LA::Vector> owned(parts), shapes;
    for (LA::Vector &part : owned)
      {
        mesh.constraints.distribute(part);
        shapes.push_back(mesh.ghosted_vector());
        shapes.back() = part;
      }
    double largest = 0;
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int face = 0; face < 2; ++face)
          {
            double square = 0;
            for (const LA::Vector &shape : shapes)
              square += mesh.displacement(shape, node, face).norm_square();
            largest = std::max(largest, std::sqrt(square));
          }
    largest = Utilities::MPI::max(largest, mesh.communicator);
    // one factor for both parts, between which it keeps the phase
    for (unsigned int i = 0; i < parts.size(); ++i)
      {
        owned[i] /= largest;
        shapes[i] = owned[i];
      }
    return shapes;
  }
} // namespace Biface
