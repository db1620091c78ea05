// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <biface/model/mesh/rigid_motions.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_motions = 6;

    using Combination = std::array<double, n_motions>;

    const std::array<std::string, n_motions> names{{"translation along x",
                                                    "translation along y",
                                                    "translation along z",
                                                    "rotation about x",
                                                    "rotation about y",
                                                    "rotation about z"}};


    /** Displacement of a point by a motion about the origin, for a body of unit
     * size. */
    Tensor<1, 3>
    displacement(const unsigned int motion, const Tensor<1, 3> &x)
    {
      Tensor<1, 3> axis;
      axis[motion % 3] = 1;
      return motion < 3 ? axis : cross_product_3d(axis, x);
    }


    Point<3>
    mean_of_nodes(const ShellMesh &mesh)
    {
      Tensor<1, 3> sum;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          sum += node.surface.position;
      return Point<3>(Utilities::MPI::sum(sum, mesh.communicator) /
                      static_cast<double>(mesh.n_nodes()));
    }


    /** The value of an unknown of a node for a motion, see
     * MixedElement::dof(). */
    double
    nodal_value(const ShellMesh   &mesh,
                const Node        &node,
                const Point<3>    &center,
                const unsigned int motion,
                const unsigned int dof)
    {
      const auto &heights = node.face_heights;
      const auto &frame   = node.surface.frame;

      // a motion is linear in the position, but for the translation
      if (dof % 2 == MixedElement::half_difference)
        return motion < 3 ? 0.
                          : displacement(motion,
                                         (heights[Resultants::outer] -
                                          heights[Resultants::inner]) /
                                           (2 * mesh.size()) * frame[2]) *
                              frame[dof / 2];
      const Tensor<1, 3> x =
        (node.surface.position - center +
         (heights[Resultants::outer] + heights[Resultants::inner]) / 2 *
           frame[2]) /
        mesh.size();
      return displacement(motion, x) * frame[dof / 2];
    }


    /** The matrix of the sum of squares of the violations of the supports by a
     * combination of motions. */
    LAPACKFullMatrix<double>
    violation_matrix(const ShellMesh &mesh)
    {
      const Point<3> center = mean_of_nodes(mesh);

      // the node of an unknown, and its position there
      std::unordered_map<types::global_dof_index,
                         std::pair<unsigned int, unsigned int>>
        place;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        for (unsigned int d = 0; d < 6; ++d)
          place[mesh.nodes[n].dofs[d]] = {n, d};

      std::vector<double> squares(n_motions * n_motions);
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          for (unsigned int d = 0; d < 6; ++d)
            {
              if (!mesh.constraints.is_constrained(node.dofs[d]))
                continue;

              Combination violation;
              for (unsigned int m = 0; m < n_motions; ++m)
                {
                  violation[m] = nodal_value(mesh, node, center, m, d);
                  for (const auto &entry :
                       *mesh.constraints.get_constraint_entries(node.dofs[d]))
                    {
                      const auto &[other, i] = place.at(entry.first);
                      violation[m] -=
                        entry.second *
                        nodal_value(mesh, mesh.nodes[other], center, m, i);
                    }
                }
              // a support of the director counts by its rotation, however thin
              // the shell
              const double scale =
                (d % 2 == MixedElement::half_difference
                   ? 2 * mesh.size() /
                       (node.face_heights[Resultants::outer] -
                        node.face_heights[Resultants::inner])
                   : 1.);
              for (unsigned int i = 0; i < n_motions; ++i)
                for (unsigned int j = 0; j < n_motions; ++j)
                  squares[n_motions * i + j] +=
                    scale * violation[i] * scale * violation[j];
            }
      Utilities::MPI::sum(squares, mesh.communicator, squares);

      LAPACKFullMatrix<double> matrix(n_motions, n_motions);
      for (unsigned int i = 0; i < n_motions; ++i)
        for (unsigned int j = 0; j < n_motions; ++j)
          matrix(i, j) = squares[n_motions * i + j];
      return matrix;
    }


    /** Eliminate, so that single motions appear if there are any. */
    void
    reduce(std::vector<Combination> &rows)
    {
      for (unsigned int row = 0; row < rows.size(); ++row)
        {
          // the largest remaining entry among those not yet used as pivots
          unsigned int pivot_row = row, pivot = 0;
          double       maximum = 0;
          for (unsigned int r = row; r < rows.size(); ++r)
            for (unsigned int m = 0; m < n_motions; ++m)
              if (std::abs(rows[r][m]) > maximum)
                {
                  maximum   = std::abs(rows[r][m]);
                  pivot_row = r;
                  pivot     = m;
                }
          std::swap(rows[row], rows[pivot_row]);
          const double scale = rows[row][pivot];
          for (double &entry : rows[row])
            entry /= scale;
          for (unsigned int r = 0; r < rows.size(); ++r)
            if (r != row)
              {
                const double factor = rows[r][pivot];
                for (unsigned int m = 0; m < n_motions; ++m)
                  rows[r][m] -= factor * rows[row][m];
              }
        }
    }
  } // namespace


  std::vector<std::string>
  free_rigid_motions(const ShellMesh &mesh)
  {
    // squares of violations, of the order of the number of supported nodes
    const double tolerance = 1e-10;

    LAPACKFullMatrix<double> matrix = violation_matrix(mesh);
    Vector<double>           eigenvalues;
    FullMatrix<double>       eigenvectors;
    matrix.compute_eigenvalues_symmetric(
      -1., tolerance, 1e-14, eigenvalues, eigenvectors);

    std::vector<Combination> rows(eigenvalues.size());
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int m = 0; m < n_motions; ++m)
        rows[i][m] = eigenvectors(m, i);
    reduce(rows);

    std::vector<std::string> motions;
    for (const Combination &row : rows)
      {
        std::string name;
        for (unsigned int m = 0; m < n_motions; ++m)
          if (std::abs(row[m]) > 1e-4)
            name += (name.empty() ? "" : " with ") + names[m];
        motions.push_back(name);
      }
    std::sort(motions.begin(), motions.end());
    return motions;
  }


  std::vector<std::vector<double>>
  rigid_motions(const ShellMesh &mesh)
  {
    const Point<3>                   center = mean_of_nodes(mesh);
    std::vector<std::vector<double>> motions(
      n_motions, std::vector<double>(mesh.locally_owned.n_elements()));
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int d = 0; d < 6; ++d)
          {
            const auto i = mesh.locally_owned.index_within_set(node.dofs[d]);
            for (unsigned int m = 0; m < n_motions; ++m)
              motions[m][i] = nodal_value(mesh, node, center, m, d);
          }
    return motions;
  }
} // namespace Biface
