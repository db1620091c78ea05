// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cmath>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/forces/inertia_of_wheel.h>
#include <biface/model/mesh/displacements_of_faces.h>
#include <biface/model/quantities/axle.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/axle_moment_in_time.h>
#include <biface/model/time/inertia.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const Tensor<1, 3> axle({0., 1., 0.});


    /** The motion of all nodes in a rotation about the axle with a unit
     * angular velocity.
     * @param displacement readable at all nodes of this rank.
     * @param place of the axle. */
    LA::Vector
    rotation(const ShellMesh    &mesh,
             const LA::Vector   &displacement,
             const Tensor<1, 3> &place)
    {
      LA::Vector result = mesh.owned_vector();
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          {
            std::vector<Tensor<1, 3>> of_faces;
            for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
              of_faces.push_back(node.surface.to_frame(
                cross_product_3d(axle,
                                 Tensor<1, 3>(mesh.position_of_any_face(
                                                displacement, node, face) -
                                              Point<3>(place)))));
            set_displacements_of_faces(node, of_faces, result);
          }
      result.compress(VectorOperation::insert);
      LA::Vector with_ghosts = mesh.ghosted_vector();
      with_ghosts            = result;
      return with_ghosts;
    }


    /** The sum of nodal forces over all ranks. */
    Tensor<1, 3>
    sum_of(const ShellMesh &mesh, const LA::Vector &forces)
    {
      Tensor<1, 3> sum;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
            sum += node.surface.from_frame(
              mesh.force_on_any_face(forces, node, face));
      for (unsigned int i = 0; i < 3; ++i)
        sum[i] = Utilities::MPI::sum(sum[i], mesh.communicator);
      return sum;
    }


    /** Add the derivative of the work of nodal forces in a rotation by the
     * displacements, times a factor. */
    void
    add_change_of_rotation(const ShellMesh  &mesh,
                           const LA::Vector &forces,
                           const double      factor,
                           LA::Vector       &gradient)
    {
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
            {
              // f.(e x dx) = dx.(f x e)
              const Tensor<1, 3> force = node.surface.from_frame(
                mesh.force_on_any_face(forces, node, face));
              const Tensor<1, 3> change =
                factor * node.surface.to_frame(cross_product_3d(force, axle));
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int part = 0; part < node.n_parts(); ++part)
                  gradient(node.dof(i, part)) +=
                    Node::sign_of_part(face, part) * change[i];
            }
    }


    /** The moment that forces of inertia need. */
    LinearizedResultant
    moment_of_inertia_forces(const ShellMesh              &mesh,
                             const State                  &state,
                             const Loads                  &loads,
                             const std::vector<LoadRates> &rates)
    {
      const StepInTime                      &step = *state.step;
      const Inertia                          of_shell(mesh);
      const InertiaOfWheel                   of_wheel(mesh);
      const std::array<const ForceTerm *, 2> terms{{&of_shell, &of_wheel}};

      // in the shape halfway, in which internal forces have no moment
      LA::Vector halfway = owned_part(state.displacement);
      halfway.sadd(0.5, 0.5, owned_part(step.start.displacement));
      LA::Vector middle = mesh.ghosted_vector();
      middle            = halfway;
      const LA::Vector turn =
        rotation(mesh,
                 middle,
                 (displacement_of_axle(mesh, step.loads_at_start) +
                  displacement_of_axle(mesh, loads)) /
                   2);

      LinearizedResultant result;
      result.gradient             = mesh.owned_vector();
      LA::Vector            nodal = mesh.owned_vector();
      std::vector<double>   sums(2 + rates.size());
      ForceTerm::CellForces forces;
      for (const unsigned int c : mesh.layers)
        {
          const Cell &cell = mesh.cells[c];
          const auto  V    = mesh.cell_values(state.displacement, cell),
                     V_0   = mesh.cell_values(step.start.displacement, cell);
          const ForceTerm::CellState start{
            c, cell, V_0, step.start, step.loads_at_start},
            end{c, cell, V, state, loads};
          forces.clear();
          std::vector<MixedElement::NodalVector> per_load(rates.size());
          for (const ForceTerm *term : terms)
            if (term->acts_on(c, state, loads))
              {
                term->add_over_step(start, end, forces);
                for (unsigned int i = 0; i < rates.size(); ++i)
                  term->add_load_derivative_over_step(
                    start, end, rates[i], per_load[i]);
              }
          const auto                      moved = mesh.cell_values(turn, cell);
          const MixedElement::NodalVector force = forces.force + forces.load;
          MixedElement::NodalVector       gradient;
          for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
            {
              sums[0] -= moved[i] * force[i];
              sums[1] += std::abs(moved[i] * force[i]);
              for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
                gradient[j] += forces.tangent[i][j] * moved[i];
            }
          for (unsigned int i = 0; i < rates.size(); ++i)
            sums[2 + i] -= moved * per_load[i];
          mesh.add_nodal_forces(cell, gradient, result.gradient);
          mesh.add_nodal_forces(cell, force, nodal);
        }
      nodal.compress(VectorOperation::add);
      add_change_of_rotation(mesh, nodal, -0.5, result.gradient);
      // the place of the axle moves, too
      const Tensor<1, 3>  resultant = sum_of(mesh, nodal);
      std::vector<double> by_place;
      for (const LoadRates &of_loads : rates)
        by_place.push_back(
          cross_product_3d(axle, displacement_of_axle(mesh, of_loads.factors)) *
          resultant / 2);
      result.gradient.compress(VectorOperation::add);
      mesh.condense(result.gradient);
      Utilities::MPI::sum(sums, mesh.communicator, sums);
      result.value     = sums[0];
      result.magnitude = sums[1];
      result.per_load.assign(sums.begin() + 2, sums.end());
      for (unsigned int i = 0; i < rates.size(); ++i)
        result.per_load[i] += by_place[i];
      return result;
    }
  } // namespace


  LinearizedResultant
  axle_moment_in_time(const ContactInteraction     &contact,
                      const State                  &state,
                      const Loads                  &loads,
                      const std::vector<LoadRates> &rates)
  {
    const StepInTime   &step = *state.step;
    LinearizedResultant result =
      moment_of_inertia_forces(contact.mesh, state, loads, rates);
    result += axle_moment(contact, state, loads, rates);
    const double of_rim =
      step.moment_of_inertia * step.spin(loads).acceleration;
    result.value += of_rim;
    result.magnitude += std::abs(of_rim);
    for (unsigned int i = 0; i < rates.size(); ++i)
      result.per_load[i] +=
        step.moment_of_inertia * rates[i].angular_velocity / step.duration;
    return result;
  }
} // namespace Biface
