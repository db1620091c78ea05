// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>

#include <cmath>
#include <limits>

#include <biface/model/equations/symmetry.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A pseudorandom number between -1 and 1. */
    double
    scattered(const double seed)
    {
      const double value = std::sin(12.9898 * seed + 1) * 43758.5453;
      return 2 * (value - std::floor(value)) - 1;
    }
  } // namespace


  LA::Vector
  arbitrary_displacements(const ShellMesh &mesh, const unsigned int seed)
  {
    // the numbers follow from those of the nodes, so that they are the same on
    // any number of ranks
    LA::Vector v = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int d = 0; d < node.dofs.size(); ++d)
          v(node.dofs[d]) =
            scattered(static_cast<double>(node.dofs.size()) * node.number + d +
                      std::sqrt(2.) * seed);
    v.compress(VectorOperation::insert);
    mesh.constraints.set_zero(v);
    return v;
  }


  double
  roundoff(const ShellMesh        &mesh,
           const LA::SparseMatrix &K,
           const LA::Vector       &x)
  {
    LA::Vector ghosted = mesh.ghosted_vector();
    ghosted            = x;

    const Epetra_CrsMatrix &epetra       = K.trilinos_matrix();
    const Epetra_Vector     x_of_columns = at_columns(K, ghosted);
    double                  sum          = 0;
    for (int row = 0; row < epetra.NumMyRows(); ++row)
      sum += absolute_product(K, row, x_of_columns) *
             std::abs(ghosted(epetra.GRID(row)));
    return std::numeric_limits<double>::epsilon() *
           Utilities::MPI::sum(sum, mesh.communicator);
  }


  bool
  is_symmetric(const ShellMesh &mesh, const LA::SparseMatrix &K)
  {
    // an unsymmetric matrix has y.K x = x.K y for two arbitrary vectors only by
    // chance
    const LA::Vector x = arbitrary_displacements(mesh, 0);
    const LA::Vector y = arbitrary_displacements(mesh, 7);
    LA::Vector       product(x);
    K.vmult(product, x);
    double difference = y * product;
    K.vmult(product, y);
    difference -= x * product;
    return std::abs(difference) <=
           10 * (roundoff(mesh, K, x) + roundoff(mesh, K, y));
  }
} // namespace Biface
