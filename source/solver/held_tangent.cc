// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/solver/held_tangent.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A number between -1 and 1 that looks random. */
    double
    scattered(const double seed)
    {
      const double value = std::sin(12.9898 * seed + 1) * 43758.5453;
      return 2 * (value - std::floor(value)) - 1;
    }


    bool
    rolls_with_friction(const Loads &loads)
    {
      return loads.rolling && loads.foundation && loads.friction;
    }


    /** The stiffness by which the foundation holds the nodes in contact. */
    void
    add_contact(const ContactInteraction &contact,
                const State              &state,
                const Loads              &loads,
                LA::SparseMatrix         &K)
    {
      const ShellMesh &mesh = contact.mesh;
      TangentMatrix    held(mesh, mesh.constraints);
      LA::Vector       nothing = mesh.owned_vector();
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          const Cell               &cell = mesh.cells[c];
          MixedElement::NodalMatrix matrix{};
          bool                      any = false;
          for (unsigned int v = 0; v < 4; ++v)
            {
              if (!state.active[cell.nodes[v]])
                continue;
              any               = true;
              const auto &frame = mesh.nodes[cell.nodes[v]].surface.frame;
              const Tensor<2, 3> stiffness =
                contact.traction(state, loads, cell.nodes[v]).stiffness;
              Tensor<2, 3> in_frame;
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  in_frame[i][j] = cell.geometry.weight / 8 *
                                   (frame[i] * (stiffness * frame[j]) +
                                    frame[j] * (stiffness * frame[i]));
              const double sign = cell.sign_of_outer_face(v);
              MixedElement::add_stiffness(in_frame, v, sign, v, sign, matrix);
            }
          if (any)
            held.add(c, matrix, MixedElement::NodalVector(), nothing);
        }
      held.compress();
      K.add(1., held.get());
    }
  } // namespace


  HeldTangent::HeldTangent(ShellEquations           &equations,
                           const ContactInteraction &contact,
                           TimerOutput              &timer)
    : equations(equations), contact(contact), timer(timer)
  {}


  void
  HeldTangent::assemble(const State      &state,
                        const Loads      &loads,
                        LA::SparseMatrix &K)
  {
    TimerOutput::Scope scope(timer, "Assembly");
    equations.assemble(
      state, rolls_with_friction(loads) ? loads : without_foundation(loads));
    K.copy_from(equations.tangent());
  }


  void
  HeldTangent::hold(const State      &state,
                    const Loads      &loads,
                    LA::SparseMatrix &K) const
  {
    if (!loads.foundation || rolls_with_friction(loads))
      return;
    State held = state;
    if (loads.friction)
      contact.set_glued(held, true);
    add_contact(contact, held, loads, K);
  }


  Loads
  HeldTangent::without_foundation(const Loads &loads)
  {
    Loads alone = loads;
    alone.foundation.reset();
    alone.friction.reset();
    return alone;
  }


  bool
  HeldTangent::is_symmetric(const LA::SparseMatrix &K) const
  {
    const LA::Vector start = arbitrary_displacements(equations.mesh, 0);
    const LA::Vector other = arbitrary_displacements(equations.mesh, 7);
    LA::Vector       product(start);
    K.vmult(product, start);
    double difference = other * product;
    K.vmult(product, other);
    difference -= start * product;
    return std::abs(difference) <=
           10 * (roundoff(K, start) + roundoff(K, other));
  }


  double
  HeldTangent::roundoff(const LA::SparseMatrix &K, const LA::Vector &x) const
  {
    const ShellMesh &mesh    = equations.mesh;
    LA::Vector       ghosted = mesh.ghosted_vector();
    ghosted                  = x;

    const Epetra_CrsMatrix &epetra       = K.trilinos_matrix();
    const Epetra_Vector     x_of_columns = at_columns(K, ghosted);
    double                  sum          = 0;
    for (int row = 0; row < epetra.NumMyRows(); ++row)
      sum += absolute_product(K, row, x_of_columns) *
             std::abs(ghosted(epetra.GRID(row)));
    return std::numeric_limits<double>::epsilon() *
           Utilities::MPI::sum(sum, mesh.communicator);
  }


  LA::Vector
  arbitrary_displacements(const ShellMesh &mesh, const unsigned int seed)
  {
    LA::Vector v = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int d = 0; d < 6; ++d)
          v(node.dofs[d]) =
            scattered(6. * node.number + d + std::sqrt(2.) * seed);
    v.compress(VectorOperation::insert);
    mesh.constraints.set_zero(v);
    return v;
  }


  std::vector<LA::Vector>
  unit_shapes(const ShellMesh &mesh, const std::vector<LA::Vector> &parts)
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
    for (unsigned int i = 0; i < parts.size(); ++i)
      {
        owned[i] /= largest;
        shapes[i] = owned[i];
      }
    return shapes;
  }
} // namespace Biface
