// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/axle_moment.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** e_y x a vector, in the frame of a node. */
    Tensor<1, 3>
    turned(const Node &node, const Tensor<1, 3> &in_frame)
    {
      const Tensor<1, 3> axle({0., 1., 0.});
      return node.surface.to_frame(
        cross_product_3d(axle, node.surface.from_frame(in_frame)));
    }
  } // namespace


  AxleMoment
  axle_moment(const ShellEquations &equations,
              const State          &state,
              const Loads          &loads)
  {
    const ShellMesh &mesh = equations.mesh;
    AxleMoment       result;
    result.gradient = mesh.owned_vector();

    LoadRates unit;
    unit.angular_velocity        = 1;
    double                moment = 0, per_angular_velocity = 0;
    ForceTerm::CellForces forces;

    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        const auto  V    = mesh.cell_values(state.displacement, cell);
        MixedElement::NodalVector per_unit;
        forces.clear();
        for (const ForceTerm *term : equations.get_terms())
          if (term->source() == ForceTerm::Source::foundation &&
              term->acts_on(c, state, loads))
            {
              const ForceTerm::CellState at{c, cell, V, state, loads};
              term->add(at, forces);
              if (loads.rolling)
                term->add_load_derivative(at, unit, per_unit);
            }
        const MixedElement::NodalVector force = forces.force + forces.load;
        if (force.norm_square() + per_unit.norm_square() == 0)
          continue;

        // the rotation, and the transpose of its derivative times the forces
        MixedElement::NodalVector rotation, gradient;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Node  &node = mesh.nodes[cell.nodes[v]];
            const double sign = cell.sign_of_outer_face(v);
            // all forces act on the outer face of the node
            Tensor<1, 3> f;
            for (unsigned int i = 0; i < 3; ++i)
              f[i] = force[MixedElement::dof(v, i, MixedElement::mean)];
            MixedElement::add_force(-turned(node, f), v, sign, gradient);
            const Tensor<1, 3> r =
              turned(node,
                     node.surface.to_frame(Tensor<1, 3>(mesh.deformed_position(
                       state.displacement, node, Resultants::outer))));
            for (unsigned int i = 0; i < 3; ++i)
              rotation[MixedElement::dof(v, i, MixedElement::mean)] = r[i];
          }
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
            gradient[j] -= forces.tangent[i][j] * rotation[i];
        moment += rotation * force;
        per_angular_velocity += rotation * per_unit;
        mesh.add_nodal_forces(cell, gradient, result.gradient);
      }

    result.gradient.compress(VectorOperation::add);
    mesh.condense(result.gradient);
    result.gradient *= -1;
    result.value = -Utilities::MPI::sum(moment, mesh.communicator);
    result.per_angular_velocity =
      -Utilities::MPI::sum(per_angular_velocity, mesh.communicator);
    return result;
  }
} // namespace Biface
