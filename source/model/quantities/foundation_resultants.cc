// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <functional>

#include <biface/model/contact/contact_forces.h>
#include <biface/model/quantities/foundation_resultants.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A motion of the face, the work of the forces of the foundation on
     * which is the resultant. */
    struct Motion
    {
      /** The motion of a point at the given position. */
      std::function<Tensor<1, 3>(const Tensor<1, 3> &)> at;
      /** The transposed derivative of the motion times a force; null if the
       * motion is a translation. */
      std::function<Tensor<1, 3>(const Tensor<1, 3> &)> transposed_derivative;
    };


    FoundationResultant
    work_of_foundation(const ContactPair            &ground,
                       const State                  &state,
                       const Loads                  &loads,
                       const std::vector<LoadRates> &rates,
                       const Motion                 &motion)
    {
      const ShellMesh    &mesh = ground.mesh;
      const ContactForces of_ground(ground);
      FoundationResultant result;
      result.gradient = mesh.owned_vector();

      // the value, then the derivatives by the loads
      std::vector<double>                    sums(1 + rates.size());
      ForceTerm::CellForces                  forces;
      std::vector<MixedElement::NodalVector> per_load(rates.size());
      for (const unsigned int c : mesh.walls)
        {
          const Cell &cell = mesh.cells[c];
          const auto  V    = mesh.cell_values(state.displacement, cell);
          forces.clear();
          for (MixedElement::NodalVector &vector : per_load)
            vector = 0;
          if (!of_ground.acts_on(c, state, loads))
            continue;
          const ForceTerm::CellState at{c, cell, V, state, loads};
          of_ground.add(at, forces);
          for (unsigned int i = 0; i < rates.size(); ++i)
            of_ground.add_load_derivative(at, rates[i], per_load[i]);

          const MixedElement::NodalVector force = forces.force + forces.load;
          MixedElement::NodalVector       moved, gradient;
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Node &node = mesh.nodes[cell.nodes[v]];
              if (motion.transposed_derivative)
                {
                  // all forces act on the face of the node
                  Tensor<1, 3> f;
                  for (unsigned int i = 0; i < 3; ++i)
                    f[i] = force[MixedElement::dof(v, i, MixedElement::mean)];
                  MixedElement::add_force(
                    node.surface.to_frame(
                      motion.transposed_derivative(node.surface.from_frame(f))),
                    v,
                    cell.sign_of_face(v, ground.face),
                    gradient);
                }
              const Tensor<1, 3> r = node.surface.to_frame(
                motion.at(Tensor<1, 3>(ground.position(state, node))));
              for (unsigned int i = 0; i < 3; ++i)
                moved[MixedElement::dof(v, i, MixedElement::mean)] = r[i];
            }
          for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
            for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
              gradient[j] -= forces.tangent[i][j] * moved[i];
          sums[0] += moved * force;
          for (unsigned int i = 0; i < rates.size(); ++i)
            sums[1 + i] += moved * per_load[i];
          mesh.add_nodal_forces(cell, gradient, result.gradient);
        }

      if (ground.has_bristles(loads))
        {
          std::vector<double> per_rate(rates.size());
          sums[0] += ground.bristle_lines(state, loads)
                       .add_work(motion.at,
                                 motion.transposed_derivative,
                                 rates,
                                 result.gradient,
                                 per_rate);
          for (unsigned int i = 0; i < rates.size(); ++i)
            sums[1 + i] += per_rate[i];
        }
      result.gradient.compress(VectorOperation::add);
      mesh.condense(result.gradient);
      Utilities::MPI::sum(sums, mesh.communicator, sums);
      result.value = sums[0];
      result.per_load.assign(sums.begin() + 1, sums.end());
      return result;
    }
  } // namespace


  FoundationResultant
  foundation_force(const ContactPair            &ground,
                   const State                  &state,
                   const Loads                  &loads,
                   const std::vector<LoadRates> &rates)
  {
    const Tensor<1, 3> outward = -loads.ground()->direction();
    return work_of_foundation(
      ground,
      state,
      loads,
      rates,
      {[&](const Tensor<1, 3> &) { return outward; }, nullptr});
  }


  FoundationResultant
  axle_moment(const ContactPair            &ground,
              const State                  &state,
              const Loads                  &loads,
              const std::vector<LoadRates> &rates)
  {
    const Tensor<1, 3> axle({0., 1., 0.});
    return work_of_foundation(
      ground,
      state,
      loads,
      rates,
      {[&](const Tensor<1, 3> &x) { return cross_product_3d(x, axle); },
       [&](const Tensor<1, 3> &f) { return cross_product_3d(axle, f); }});
  }
} // namespace Biface
