// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/element/element_mass.h>
#include <biface/model/equations/mass_matrix.h>
#include <biface/model/mesh/strip.h>

namespace Biface
{
  using namespace dealii;

  MixedElement::NodalMatrix
  cell_mass(const ShellMesh &mesh, const Cell &cell)
  {
    return element_mass(cell.geometry,
                        mesh.strips[cell.strip].laminate.mass_moments());
  }


  LA::Vector
  inertia(const ShellMesh &mesh, const LA::Vector &V)
  {
    LA::Vector result = mesh.owned_vector();
    for (const unsigned int c : mesh.layers)
      {
        const Cell               &cell = mesh.cells[c];
        const auto                v    = mesh.cell_values(V, cell);
        const auto                M    = cell_mass(mesh, cell);
        MixedElement::NodalVector force;
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
            force[i] += M[i][j] * v[j];
        mesh.add_nodal_forces(cell, force, result);
      }
    result.compress(VectorOperation::add);
    return result;
  }


  MassMatrix::MassMatrix(const ShellMesh &mesh)
    : mesh(mesh), matrix(mesh, mesh.constraints)
  {
    LA::Vector nothing = mesh.owned_vector();
    for (const unsigned int c : mesh.layers)
      {
        const Cell &cell = mesh.cells[c];
        matrix.add(
          c, cell_mass(mesh, cell), MixedElement::NodalVector(), nothing);
        // the shape functions add up to 1, so that the moments add up to the
        // mass per area
        for (const auto &row : mesh.strips[cell.strip].laminate.mass_moments())
          for (const double moment : row)
            total_mass += cell.geometry.weight * moment;
      }
    matrix.compress();
    total_mass = Utilities::MPI::sum(total_mass, mesh.communicator);
  }


  void
  MassMatrix::vmult(LA::Vector &product, const LA::Vector &v) const
  {
    matrix.get().vmult(product, v);
    mesh.constraints.set_zero(product);
  }

} // namespace Biface
