// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <biface/model/mesh/constraints.h>
#include <biface/model/mesh/mesh_nodes.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/support_motions.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Edges = std::array<bool, 4>;

    /** By factor, the components that a support moves. */
    using MovedComponents = std::map<unsigned int, std::set<std::string>>;

    MovedComponents
    moved_components(const std::vector<SupportCondition> &conditions)
    {
      MovedComponents result;
      for (const SupportCondition &condition : conditions)
        if (condition.value != 0 || condition.formula)
          result[condition.factor].insert(
            component_names()[static_cast<unsigned int>(condition.component)]);
      return result;
    }


    /** How often an edge of a grid occurs in the whole structure. */
    double
    multiple_of_edge(const unsigned int edge,
                     const Supports    &supports,
                     const Edges       &symmetric,
                     const MeshNodes   &mesh)
    {
      // the edges that end it
      const unsigned int across = 1 - edge / 2;
      const bool         first  = symmetric[2 * across],
                 second         = symmetric[2 * across + 1];
      const auto  &lines        = mesh.grid.lines[across];
      const double period       = mesh.get_surface().get_periodicity()[across];
      if (period > 0 && ((first && second) || supports.is_cyclic()))
        return period / (lines.back() - lines.front());
      // between two parallel planes of symmetry the structure has no end
      return first != second ? 2. : 1.;
    }


    double
    multiple_of_point(const std::string &name,
                      const Edges       &symmetric,
                      const MeshNodes   &mesh)
    {
      double result = 1;
      for (unsigned int p = 0; p < mesh.points.size(); ++p)
        if (mesh.points[p].name == name &&
            mesh.nodes_of_points[p] != numbers::invalid_unsigned_int)
          {
            const Node &node = mesh.nodes[mesh.nodes_of_points[p]];
            result           = 1;
            for (unsigned int edge = 0; edge < 4; ++edge)
              if (symmetric[edge] &&
                  mesh.grid.on_edge(node.grid_index, static_cast<Edge>(edge)))
                result *= 2;
          }
      return Utilities::MPI::max(result, mesh.communicator);
    }


    /** A prescribed displacement: the derivatives of the displacement by three
     * components of a translation and three of a rotation. */
    struct Row
    {
      std::array<double, 6> derivatives;
      double                value;
    };


    /** The rows of a motion on this rank, with the rotation about a center in
     * units of a length. */
    std::vector<Row>
    rows_of(const SupportMotion  &motion,
            const MeshNodes      &mesh,
            const SupportedNodes &supported,
            const Point<3>       &center,
            const double          length)
    {
      std::vector<Row> rows;
      for (const SupportedNodes::Item &item : supported.items)
        if (mesh.nodes[item.nodes[0]].locally_owned)
          for (const SupportEquation &equation : item.equations)
            if (equation.body == motion.body &&
                equation.factor == motion.factor)
              {
                Row          row{{}, equation.values[motion.factor]};
                unsigned int begin = 0;
                double       size  = 0;
                for (const unsigned int n : item.nodes)
                  {
                    const Node        &node    = mesh.nodes[n];
                    const unsigned int n_faces = node.n_parts();
                    Tensor<1, 3>       sum;
                    for (unsigned int face = 0; face < n_faces; ++face)
                      {
                        Tensor<1, 3> along;
                        for (unsigned int i = 0; i < 3; ++i)
                          along[i] =
                            equation.coefficients[begin + n_faces * i + face];
                        along = node.surface.from_frame(along);
                        size += along.norm();
                        const Tensor<1, 3> lever =
                          (node.surface.position +
                           node.height(face) * node.surface.frame[2] - center) /
                          length;
                        const Tensor<1, 3> turn =
                          cross_product_3d(lever, along);
                        for (unsigned int i = 0; i < 3; ++i)
                          {
                            row.derivatives[i] += along[i];
                            row.derivatives[3 + i] += turn[i];
                          }
                      }
                    begin += 3 * n_faces;
                  }
                // of a face that moves by the value
                for (double &derivative : row.derivatives)
                  derivative /= size;
                row.value /= size;
                rows.push_back(row);
              }
      return rows;
    }


    /** The sum of a number over all rows of all ranks. */
    template <typename Function>
    double
    sum_over(const std::vector<Row> &rows,
             const MPI_Comm          communicator,
             const Function         &function)
    {
      double sum = 0;
      for (const Row &row : rows)
        sum += function(row);
      return Utilities::MPI::sum(sum, communicator);
    }


    /** The motion of a rigid body with the least norm that has the prescribed
     * displacements.
     * @param n 3 for a translation, 6 with a rotation.
     * @param fits whether it has them. */
    Vector<double>
    rigid_motion(const std::vector<Row> &rows,
                 const unsigned int      n,
                 const MPI_Comm          communicator,
                 bool                   &fits)
    {
      // what the displacements leave open is found by a small part of the
      // identity, whose effect the repetitions remove
      constexpr double       open = 1e-6, tolerance = 1e-6;
      constexpr unsigned int repetitions = 4;

      FullMatrix<double> products(n, n);
      Vector<double>     right(n), solution(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          right(i) = sum_over(rows, communicator, [&](const Row &row) {
            return row.derivatives[i] * row.value;
          });
          for (unsigned int j = 0; j < n; ++j)
            products(i, j) = sum_over(rows, communicator, [&](const Row &row) {
              return row.derivatives[i] * row.derivatives[j];
            });
        }
      double largest = 0;
      for (unsigned int i = 0; i < n; ++i)
        largest = std::max(largest, products(i, i));
      // differences of the faces, which no translation changes
      if (largest == 0)
        {
          fits = false;
          return solution;
        }
      FullMatrix<double> inverse(products);
      for (unsigned int i = 0; i < n; ++i)
        inverse(i, i) += open * largest;
      inverse.gauss_jordan();
      for (unsigned int k = 0; k < repetitions; ++k)
        {
          Vector<double> left(n), change(n);
          products.vmult(left, solution);
          left.sadd(-1, 1, right);
          inverse.vmult(change, left);
          solution += change;
        }

      const double error = sum_over(rows, communicator, [&](const Row &row) {
        double missing = row.value;
        for (unsigned int i = 0; i < n; ++i)
          missing -= row.derivatives[i] * solution(i);
        return missing * missing;
      });
      const double all   = sum_over(rows, communicator, [](const Row &row) {
        return row.value * row.value;
      });
      fits               = (error <= tolerance * tolerance * all);
      return solution;
    }


    double
    norm(const Vector<double> &values, const unsigned int begin)
    {
      double square = 0;
      for (unsigned int i = begin; i < begin + 3; ++i)
        square += values(i) * values(i);
      return std::sqrt(square);
    }


    /** The middle of the nodes of a support. */
    Point<3>
    middle_of(const SupportMotion  &motion,
              const MeshNodes      &mesh,
              const SupportedNodes &supported)
    {
      Tensor<1, 3> sum;
      double       n = 0;
      for (const SupportedNodes::Item &item : supported.items)
        if (mesh.nodes[item.nodes[0]].locally_owned &&
            std::any_of(item.equations.begin(),
                        item.equations.end(),
                        [&](const SupportEquation &equation) {
                          return equation.body == motion.body;
                        }))
          {
            sum += mesh.nodes[item.nodes[0]].surface.position;
            ++n;
          }
      sum = Utilities::MPI::sum(sum, mesh.communicator);
      n   = Utilities::MPI::sum(n, mesh.communicator);
      return Point<3>(sum / std::max(n, 1.));
    }
  } // namespace


  std::vector<SupportMotion>
  find_support_motions(const Supports       &supports,
                       const MeshNodes      &mesh,
                       const SupportedNodes &supported)
  {
    // the same on all ranks
    std::vector<SupportMotion> candidates;
    Edges                      symmetric{};
    for (unsigned int edge = 0; edge < 4; ++edge)
      symmetric[edge] = supports.is_symmetric(edge);
    unsigned int body = 0;
    // in the order of the bodies
    const auto add = [&](const std::vector<SupportCondition> &conditions,
                         const double                         multiple) {
      const MovedComponents moved = moved_components(conditions);
      for (const auto &[factor, components] : moved)
        {
          std::string name = supported.bodies[body];
          if (moved.size() > 1)
            for (const std::string &component : components)
              name += ' ' + component;
          candidates.push_back({name, body, factor, multiple});
        }
      ++body;
    };
    for (const PointSupport &item : supports.points)
      add(item.conditions,
          mesh.grid.has_lines() ? multiple_of_point(item.point, symmetric, mesh)
                                : 1.);
    for (unsigned int edge = 0; edge < 4; ++edge)
      if (!supports.edges[edge].empty())
        add(supports.edges[edge],
            multiple_of_edge(edge, supports, symmetric, mesh));
    for (const EdgeSupport &item : supports.named_edges)
      add(item.conditions, 1);

    std::vector<SupportMotion> result;
    for (SupportMotion &motion : candidates)
      {
        const double           length = mesh.size();
        const std::vector<Row> rows   = rows_of(
          motion, mesh, supported, middle_of(motion, mesh, supported), length);
        double largest = 0;
        for (const Row &row : rows)
          largest = std::max(largest, std::abs(row.value));
        largest = Utilities::MPI::max(largest, mesh.communicator);
        // a formula may vanish at all nodes
        if (largest == 0)
          continue;
        bool           fits  = false;
        Vector<double> found = rigid_motion(rows, 3, mesh.communicator, fits);
        if (fits)
          {
            motion.kind   = SupportMotion::Kind::translation;
            motion.amount = norm(found, 0);
          }
        else
          {
            found         = rigid_motion(rows, 6, mesh.communicator, fits);
            motion.kind   = (fits ? SupportMotion::Kind::rotation
                                  : SupportMotion::Kind::other);
            motion.amount = (fits ? norm(found, 3) / length : largest);
          }
        result.push_back(motion);
      }
    return result;
  }
} // namespace Biface
