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


    /** The middle between the inner and the outer face at a node, and the
     * vectors from the middle of each layer to its outer face. */
    struct Director
    {
      Point<3>                  middle;
      std::vector<Tensor<1, 3>> half;
    };


    /** The director of each node. */
    using Directors = std::vector<Director>;


    Directors
    undeformed_directors(const ShellMesh &mesh)
    {
      Directors directors;
      for (const Node &node : mesh.nodes)
        {
          const auto         &heights = node.face_heights;
          const Tensor<1, 3> &normal  = node.surface.frame[2];
          directors.push_back(
            {node.surface.position +
               (heights[Resultants::outer] + heights[Resultants::inner]) / 2 *
                 normal,
             {}});
          for (const double half : node.half_thickness)
            directors.back().half.push_back(half * normal);
        }
      return directors;
    }


    Directors
    deformed_directors(const ShellMesh &mesh, const LA::Vector &displacement)
    {
      Directors directors;
      for (const Node &node : mesh.nodes)
        {
          const Point<3> outer =
            mesh.deformed_position(displacement, node, Resultants::outer);
          const Tensor<1, 3> half =
            (outer -
             mesh.deformed_position(displacement, node, Resultants::inner)) /
            2;
          directors.push_back({outer - half, {}});
          for (unsigned int k = 0; k < node.n_layers(); ++k)
            directors.back().half.push_back(
              (mesh.position_of_any_face(displacement, node, k + 1) -
               mesh.position_of_any_face(displacement, node, k)) /
              2);
        }
      return directors;
    }


    /** The value of an unknown of a node for a motion. */
    double
    nodal_value(const ShellMesh   &mesh,
                const Node        &node,
                const Director    &director,
                const Point<3>    &center,
                const unsigned int motion,
                const unsigned int dof)
    {
      const Tensor<1, 3> &direction = node.surface.frame[dof / node.n_parts()];
      const unsigned int  part      = dof % node.n_parts();
      // a motion is linear in the position, but for the translation
      if (part > 0)
        return motion < 3
                 ? 0.
                 : displacement(motion, director.half[part - 1] / mesh.size()) *
                     direction;
      return displacement(motion, (director.middle - center) / mesh.size()) *
             direction;
    }


    /** The matrix of the sum of squares of the violations of the supports by a
     * combination of motions, by its rows. */
    std::vector<double>
    violation_matrix(const ShellMesh &mesh, const Directors &directors)
    {
      const Point<3> center = mean_of_nodes(mesh);

      // the node of an unknown, and its position there
      std::unordered_map<types::global_dof_index,
                         std::pair<unsigned int, unsigned int>>
        place;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
          place[mesh.nodes[n].dofs[d]] = {n, d};

      std::vector<double> squares(n_motions * n_motions);
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].locally_owned)
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            {
              const Node &node = mesh.nodes[n];
              if (!mesh.constraints.is_constrained(node.dofs[d]))
                continue;

              // what a motion does to a constrained unknown less what its
              // constraint demands
              Combination violation;
              for (unsigned int m = 0; m < n_motions; ++m)
                {
                  violation[m] =
                    nodal_value(mesh, node, directors[n], center, m, d);
                  for (const auto &entry :
                       *mesh.constraints.get_constraint_entries(node.dofs[d]))
                    {
                      const auto &[other, i] = place.at(entry.first);
                      violation[m] -=
                        entry.second * nodal_value(mesh,
                                                   mesh.nodes[other],
                                                   directors[other],
                                                   center,
                                                   m,
                                                   i);
                    }
                }
              // a support of the director counts by its rotation, however thin
              // the shell
              const unsigned int part = d % node.n_parts();
              if (part > 0 && node.half_thickness[part - 1] == 0)
                continue; // a layer that does not exist
              const double scale =
                (part > 0 ? mesh.size() / node.half_thickness[part - 1] : 1.);
              for (unsigned int i = 0; i < n_motions; ++i)
                for (unsigned int j = 0; j < n_motions; ++j)
                  squares[n_motions * i + j] +=
                    scale * violation[i] * scale * violation[j];
            }
      Utilities::MPI::sum(squares, mesh.communicator, squares);
      return squares;
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


    /** The combinations of motions that a matrix of sums of squares leaves
     * free. */
    std::vector<Combination>
    free_combinations(const std::vector<double> &squares)
    {
      // squares of violations, of the order of the number of supported nodes
      const double tolerance = 1e-10;

      LAPACKFullMatrix<double> matrix(n_motions, n_motions);
      for (unsigned int i = 0; i < n_motions; ++i)
        for (unsigned int j = 0; j < n_motions; ++j)
          matrix(i, j) = squares[n_motions * i + j];
      Vector<double>     eigenvalues;
      FullMatrix<double> eigenvectors;
      matrix.compute_eigenvalues_symmetric(
        -1., tolerance, 1e-14, eigenvalues, eigenvectors);

      std::vector<Combination> rows(eigenvalues.size());
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int m = 0; m < n_motions; ++m)
          rows[i][m] = eigenvectors(m, i);
      reduce(rows);
      return rows;
    }


    std::string
    in_words(const Combination &row)
    {
      std::string name;
      for (unsigned int m = 0; m < n_motions; ++m)
        if (std::abs(row[m]) > 1e-4)
          name += (name.empty() ? "" : " with ") + names[m];
      return name;
    }


    /** The six motions as nodal displacements. */
    std::vector<LA::Vector>
    all_motions(const ShellMesh &mesh, const Directors &directors)
    {
      const Point<3>          center = mean_of_nodes(mesh);
      std::vector<LA::Vector> motions(n_motions, mesh.owned_vector());
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].locally_owned)
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            for (unsigned int m = 0; m < n_motions; ++m)
              motions[m](mesh.nodes[n].dofs[d]) =
                nodal_value(mesh, mesh.nodes[n], directors[n], center, m, d);
      for (LA::Vector &motion : motions)
        motion.compress(VectorOperation::insert);
      return motions;
    }


    /** Add the squares of the forces by which something resists motions. */
    void
    add_resistance(const LA::SparseMatrix        &stiffness,
                   const std::vector<LA::Vector> &motions,
                   std::vector<double>           &squares)
    {
      // part of its largest entry: a resistance this small counts
      constexpr double least = 1e-9, tolerance = 1e-5;

      const double scale = least / tolerance * stiffness.linfty_norm();
      if (scale == 0)
        return;
      std::vector<LA::Vector> forces(motions);
      for (unsigned int m = 0; m < n_motions; ++m)
        stiffness.vmult(forces[m], motions[m]);
      for (unsigned int i = 0; i < n_motions; ++i)
        for (unsigned int j = 0; j < n_motions; ++j)
          squares[n_motions * i + j] +=
            (forces[i] * forces[j]) / (scale * scale);
    }
  } // namespace


  std::vector<std::string>
  free_rigid_motions(const ShellMesh &mesh)
  {
    std::vector<std::string> motions;
    for (const Combination &row :
         free_combinations(violation_matrix(mesh, undeformed_directors(mesh))))
      motions.push_back(in_words(row));
    std::sort(motions.begin(), motions.end());
    return motions;
  }


  std::vector<RigidMotion>
  free_rigid_motions(const ShellMesh        &mesh,
                     const LA::Vector       &displacement,
                     const LA::SparseMatrix *stiffness)
  {
    const Directors         directors = deformed_directors(mesh, displacement);
    std::vector<LA::Vector> motions   = all_motions(mesh, directors);
    for (LA::Vector &motion : motions)
      mesh.constraints.set_zero(motion);
    std::vector<double> squares = violation_matrix(mesh, directors);
    if (stiffness != nullptr)
      add_resistance(*stiffness, motions, squares);

    std::vector<RigidMotion> result;
    for (const Combination &row : free_combinations(squares))
      {
        RigidMotion motion{in_words(row), mesh.owned_vector(), {}};
        for (unsigned int m = 0; m < n_motions; ++m)
          motion.displacement.add(row[m], motions[m]);
        for (unsigned int i = 0; i < 3; ++i)
          motion.rotation[i] = row[3 + i] / mesh.size();
        result.push_back(motion);
      }
    return result;
  }


  LA::Vector
  turned(const ShellMesh    &mesh,
         const Tensor<1, 3> &rotation,
         const LA::Vector   &forces)
  {
    LA::Vector result = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int part = 0; part < node.n_parts(); ++part)
          {
            Tensor<1, 3> force;
            for (unsigned int i = 0; i < 3; ++i)
              force[i] = forces(node.dof(i, part));
            const Tensor<1, 3> moved = node.surface.to_frame(
              cross_product_3d(rotation, node.surface.from_frame(force)));
            for (unsigned int i = 0; i < 3; ++i)
              result(node.dof(i, part)) = moved[i];
          }
    result.compress(VectorOperation::insert);
    return result;
  }


  std::vector<std::vector<double>>
  rigid_motions(const ShellMesh &mesh)
  {
    std::vector<std::vector<double>> motions;
    for (const LA::Vector &motion :
         all_motions(mesh, undeformed_directors(mesh)))
      motions.emplace_back(motion.begin(), motion.end());
    return motions;
  }


  std::string
  in_words(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    return text;
  }
} // namespace Biface
