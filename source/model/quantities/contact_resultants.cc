// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>

#include <biface/model/contact/bristle_lines.h>
#include <biface/model/contact/contact_forces.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/quantities/axle.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A motion of the face, the work of the forces of a body on which is the
     * resultant. */
    struct Motion
    {
      /** The motion of a point at the given position. */
      std::function<Tensor<1, 3>(const Tensor<1, 3> &)> at;
      /** The transposed derivative of the motion times a force; null if the
       * motion is a translation. */
      std::function<Tensor<1, 3>(const Tensor<1, 3> &)> transposed_derivative;
      /** The change of the motion at a position by each of the loads; empty if
       * it does not depend on them. */
      std::vector<std::function<Tensor<1, 3>(const Tensor<1, 3> &)>> change;
    };


    LinearizedResultant
    work_of_contact(const ContactPair            &pair,
                    const State                  &state,
                    const Loads                  &loads,
                    const std::vector<LoadRates> &rates,
                    const Motion                 &motion)
    {
      const ShellMesh    &mesh = pair.mesh;
      const ContactForces of_pair(pair);
      // over a step in the shape halfway, in which internal forces have no
      // moment
      const double part     = (state.step ? 0.5 : 1);
      const auto   position = [&](const Node &node) {
        Tensor<1, 3> x(
          mesh.deformed_position(state.displacement, node, pair.face));
        if (state.step)
          x = (x + Tensor<1, 3>(mesh.deformed_position(
                     state.step->start.displacement, node, pair.face))) /
              2;
        return x;
      };
      LinearizedResultant result;
      result.gradient = mesh.owned_vector();

      // the value, its magnitude, then the derivatives by the loads
      std::vector<double>                    sums(2 + rates.size());
      ForceTerm::CellForces                  forces;
      std::vector<MixedElement::NodalVector> per_load(rates.size());
      for (const unsigned int c : mesh.walls)
        {
          const Cell &cell = mesh.cells[c];
          const auto  V    = mesh.cell_values(state.displacement, cell);
          forces.clear();
          for (MixedElement::NodalVector &vector : per_load)
            vector = 0;
          if (!of_pair.acts_on(c, state, loads))
            continue;
          const ForceTerm::CellState at{c, cell, V, state, loads};
          if (state.step)
            of_pair.add_over_step(at, at, forces);
          else
            of_pair.add(at, forces);
          for (unsigned int i = 0; i < rates.size(); ++i)
            of_pair.add_load_derivative(at, rates[i], per_load[i]);

          const MixedElement::NodalVector force = forces.force + forces.load;
          MixedElement::NodalVector       moved, gradient;
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Node &node = mesh.nodes[cell.nodes[v]];
              // all forces act on the face of the node
              Tensor<1, 3> f;
              for (unsigned int i = 0; i < 3; ++i)
                f[i] = force[MixedElement::dof(v, i, MixedElement::mean)];
              if (motion.transposed_derivative)
                MixedElement::add_force(
                  part * node.surface.to_frame(motion.transposed_derivative(
                           node.surface.from_frame(f))),
                  v,
                  cell.sign_of_face(v, pair.face),
                  gradient);
              const Tensor<1, 3> x = position(node);
              for (unsigned int i = 0; i < motion.change.size(); ++i)
                sums[2 + i] += f * node.surface.to_frame(motion.change[i](x));
              const Tensor<1, 3> r = node.surface.to_frame(motion.at(x));
              for (unsigned int i = 0; i < 3; ++i)
                moved[MixedElement::dof(v, i, MixedElement::mean)] = r[i];
              sums[1] += std::abs(f * r);
            }
          // with the tangent of the iteration, so that the equation of a
          // control converges quadratically with the others
          for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
            for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
              gradient[j] -= forces.tangent[i][j] * moved[i];
          sums[0] += moved * force;
          for (unsigned int i = 0; i < rates.size(); ++i)
            sums[2 + i] += moved * per_load[i];
          mesh.add_nodal_forces(cell, gradient, result.gradient);
        }

      std::vector<double> per_rate(rates.size());
      const BristleLines  bristles = pair.bristle_lines(state, loads);
      sums[0] += bristles.add_work(motion.at,
                                   motion.transposed_derivative,
                                   rates,
                                   result.gradient,
                                   per_rate);
      for (unsigned int i = 0; i < rates.size(); ++i)
        sums[2 + i] += per_rate[i];
      if (bristles.exist())
        for (unsigned int i = 0; i < motion.change.size(); ++i)
          {
            LA::Vector          unused = mesh.owned_vector();
            std::vector<double> none;
            sums[2 + i] +=
              bristles.add_work(motion.change[i], nullptr, {}, unused, none);
          }
      result.gradient.compress(VectorOperation::add);
      mesh.condense(result.gradient);
      Utilities::MPI::sum(sums, mesh.communicator, sums);
      result.value     = sums[0];
      result.magnitude = sums[1];
      result.per_load.assign(sums.begin() + 2, sums.end());
      return result;
    }
  } // namespace


  LinearizedResultant
  ground_force(const ContactPair            &ground,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates)
  {
    const Tensor<1, 3> outward = -loads.ground()->direction();
    return work_of_contact(
      ground,
      state,
      loads,
      rates,
      {[&](const Tensor<1, 3> &) { return outward; }, nullptr, {}});
  }


  LinearizedResultant
  axle_moment(const ContactInteraction     &contact,
              const State                  &state,
              const Loads                  &loads,
              const std::vector<LoadRates> &rates)
  {
    // M = -sum f.(e_y x x), section 10 of doc/theory.md
    const Tensor<1, 3> axle({0., 1., 0.});
    Tensor<1, 3>       place = displacement_of_axle(contact.mesh, loads);
    double             part  = 1;
    if (state.step)
      {
        part  = 0.5;
        place = (place + displacement_of_axle(contact.mesh,
                                              state.step->loads_at_start)) /
                2;
      }
    Motion turn;
    turn.at = [&](const Tensor<1, 3> &x) {
      return cross_product_3d(x - place, axle);
    };
    turn.transposed_derivative = [&](const Tensor<1, 3> &f) {
      return cross_product_3d(axle, f);
    };
    for (const LoadRates &of_loads : rates)
      turn.change.push_back(
        [moved = part *
                 cross_product_3d(
                   axle, displacement_of_axle(contact.mesh, of_loads.factors))](
          const Tensor<1, 3> &) { return moved; });
    LinearizedResultant result;
    result.gradient = contact.mesh.owned_vector();
    result.per_load.resize(rates.size());
    for (const ContactPair *pair : contact.present(loads))
      result += work_of_contact(*pair, state, loads, rates, turn);
    return result;
  }


  LinearizedResultant
  power_of_body(const ContactPair            &pair,
                const State                  &state,
                const Loads                  &loads,
                const LoadRates              &motion,
                const std::vector<LoadRates> &rates)
  {
    // the balance of powers of section 6 of doc/theory.md, "A body found by a
    // force", without its spring
    const RigidBody   &body = pair.body(loads)->body;
    const Tensor<1, 3> spin = motion.angular_velocity_of(body);
    Motion             velocity;
    velocity.at = [&](const Tensor<1, 3> &x) {
      return motion.velocity_of(body, Point<3>(x));
    };
    velocity.transposed_derivative = [&](const Tensor<1, 3> &f) {
      return cross_product_3d(f, spin);
    };
    for (const LoadRates &of_loads : rates)
      velocity.change.push_back([&](const Tensor<1, 3> &x) {
        return motion.change_of_velocity(body, Point<3>(x), of_loads);
      });
    return work_of_contact(pair, state, loads, rates, velocity);
  }
} // namespace Biface
