// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>
#include <vector>

#include <biface/contact/tangential_law.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/velocity_matrix.h>
#include <biface/model/forces/inertia_of_wheel.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    void
    add_friction(const ContactPair         &pair,
                 const State               &state,
                 const Loads               &loads,
                 const Cell                &cell,
                 MixedElement::NodalMatrix &C)
    {
      for (unsigned int v = 0; v < 4; ++v)
        {
          const unsigned int node = cell.nodes[v];
          if (!pair.state_of(state).active[node])
            continue;
          // friction in rolling needs lumped multipliers, by which a traction
          // acts on its own node alone
          const auto        &frame = pair.mesh.nodes[node].surface.frame;
          const Tensor<2, 3> per_velocity =
            pair.traction(state, loads, node).per_velocity;
          Tensor<2, 3> in_frame;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              in_frame[i][j] = -cell.geometry.weight / 4 *
                               (frame[i] * (per_velocity * frame[j]));
          const double sign = cell.sign_of_face(v, pair.face);
          MixedElement::add_stiffness(in_frame, v, sign, v, sign, C);
        }
    }
  } // namespace


  VelocityMatrix::VelocityMatrix(const ContactInteraction        &contact,
                                 const State                     &state,
                                 const Loads                     &loads,
                                 const AffineConstraints<double> &constraints)
    : mesh(contact.mesh), matrix(mesh, constraints)
  {
    Assert(loads.rolling, ExcNotInitialized());
    const double angular_velocity = loads.rolling->angular_velocity;

    const InertiaOfWheel inertia(mesh);
    const auto           pairs   = contact.present(loads);
    LA::Vector           nothing = mesh.owned_vector();
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell               &cell = mesh.cells[c];
        MixedElement::NodalMatrix velocity_matrix{};
        if (cell.is_layer)
          inertia.add_gyroscopic(cell, angular_velocity, velocity_matrix);
        // mass belongs to the layers, contact to the wall
        if (cell.is_wall)
          for (const ContactPair *pair : pairs)
            add_friction(*pair, state, loads, cell, velocity_matrix);
        matrix.add(c, velocity_matrix, MixedElement::NodalVector(), nothing);
      }
    matrix.compress();
  }


  void
  VelocityMatrix::vmult(LA::Vector &product, const LA::Vector &v) const
  {
    matrix.get().vmult(product, v);
    mesh.constraints.set_zero(product);
  }


  void
  VelocityMatrix::Tvmult(LA::Vector &product, const LA::Vector &v) const
  {
    matrix.get().Tvmult(product, v);
    mesh.constraints.set_zero(product);
  }


  std::unique_ptr<const VelocityMatrix>
  make_velocity_matrix(const ContactInteraction &contact,
                       const State              &state,
                       const Loads              &loads)
  {
    return loads.rolling ? std::make_unique<const VelocityMatrix>(
                             contact, state, loads, contact.mesh.constraints)
                         : nullptr;
  }
} // namespace Biface
