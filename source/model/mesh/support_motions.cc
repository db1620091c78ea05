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
#include <limits>
#include <map>
#include <set>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
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


    /** The symmetric edges on which a point lies, on all ranks. */
    std::vector<unsigned int>
    symmetric_edges_of_point(const std::string &name,
                             const Edges       &symmetric,
                             const MeshNodes   &mesh)
    {
      std::array<unsigned int, 4> on{};
      for (unsigned int p = 0; p < mesh.points.size(); ++p)
        if (mesh.points[p].name == name &&
            mesh.nodes_of_points[p] != numbers::invalid_unsigned_int)
          {
            const Node &node = mesh.nodes[mesh.nodes_of_points[p]];
            for (unsigned int edge = 0; edge < 4; ++edge)
              on[edge] =
                (symmetric[edge] &&
                 mesh.grid.on_edge(node.grid_index, static_cast<Edge>(edge)));
          }
      std::vector<unsigned int> edges;
      for (unsigned int edge = 0; edge < 4; ++edge)
        if (Utilities::MPI::max(on[edge], mesh.communicator) > 0)
          edges.push_back(edge);
      return edges;
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


    /** The sum of the squares of the prescribed displacements. */
    double
    square_of_all(const std::vector<Row> &rows, const MPI_Comm communicator)
    {
      return sum_over(rows, communicator, [](const Row &row) {
        return row.value * row.value;
      });
    }


    /** Motions of a rigid body: the components of the translation of a center,
     * and of a rotation about it. */
    using RigidMotions = std::vector<std::array<double, 6>>;


    double
    displacement(const Row &row, const std::array<double, 6> &motion)
    {
      double sum = 0;
      for (unsigned int i = 0; i < 6; ++i)
        sum += row.derivatives[i] * motion[i];
      return sum;
    }


    /** The sum of given motions with the least norm that has the prescribed
     * displacements.
     * @param fits whether it has them. */
    std::array<double, 6>
    rigid_motion(const std::vector<Row> &rows,
                 const RigidMotions     &motions,
                 const MPI_Comm          communicator,
                 bool                   &fits)
    {
      // what the displacements leave open is found by a small part of the
      // identity, whose effect the repetitions remove
      constexpr double       open = 1e-6, tolerance = 1e-6;
      constexpr unsigned int repetitions = 4;

      const unsigned int    n = motions.size();
      std::array<double, 6> result{};
      FullMatrix<double>    products(n, n);
      Vector<double>        right(n), solution(n);
      for (const Row &row : rows)
        for (unsigned int i = 0; i < n; ++i)
          {
            const double along = displacement(row, motions[i]);
            right(i) += along * row.value;
            for (unsigned int j = 0; j < n; ++j)
              products(i, j) += along * displacement(row, motions[j]);
          }
      Utilities::MPI::sum(right, communicator, right);
      Utilities::MPI::sum(products, communicator, products);
      double largest = 0;
      for (unsigned int i = 0; i < n; ++i)
        largest = std::max(largest, products(i, i));
      // as for differences of the faces, which no translation changes
      fits = false;
      if (largest == 0)
        return result;
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
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = 0; k < 6; ++k)
          result[k] += solution(i) * motions[i][k];

      const double error = sum_over(rows, communicator, [&](const Row &row) {
        const double missing = row.value - displacement(row, result);
        return missing * missing;
      });
      fits =
        (error <= tolerance * tolerance * square_of_all(rows, communicator));
      return result;
    }


    Tensor<1, 3>
    translation(const std::array<double, 6> &motion)
    {
      return Tensor<1, 3>({motion[0], motion[1], motion[2]});
    }


    Tensor<1, 3>
    rotation(const std::array<double, 6> &motion)
    {
      return Tensor<1, 3>({motion[3], motion[4], motion[5]});
    }


    /** The planes of symmetry and the axis by which the whole structure
     * follows from the part that is modeled. */
    struct Images
    {
      std::vector<Tensor<1, 3>> normals;
      /** Zero without cyclic edges. */
      Tensor<1, 3> axis;
    };


    /** The unit vector across an edge of a grid, the same on all ranks. */
    Tensor<1, 3>
    normal_of_edge(const unsigned int edge, const MeshNodes &mesh)
    {
      Tensor<1, 3> sum;
      double       n = 0;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned &&
            mesh.grid.on_edge(node.grid_index, static_cast<Edge>(edge)))
          {
            sum += node.surface.frame[edge / 2];
            ++n;
          }
      sum = Utilities::MPI::sum(sum, mesh.communicator);
      return sum / std::max(sum.norm(), std::numeric_limits<double>::min());
    }


    /** The translations, or the rotations, by which the modeled part and its
     * images move as one body: translations in all planes of symmetry,
     * rotations about their common normal; both along an axis.
     * @param first 0 for translations, 3 for rotations. */
    RigidMotions
    motions_of_whole(const Images &images, const unsigned int first)
    {
      constexpr double parallel = 1e-6;

      std::vector<Tensor<1, 3>> vectors;
      const auto add_unit = [&vectors](const Tensor<1, 3> &vector) {
        vectors.push_back(vector / vector.norm());
      };
      const auto &normals = images.normals;
      // a plane of symmetry across the first one
      const auto other = std::find_if(
        normals.begin(), normals.end(), [&](const Tensor<1, 3> &normal) {
          return cross_product_3d(normals[0], normal).norm() > parallel;
        });
      if (images.axis.norm() > 0)
        add_unit(images.axis);
      else if (normals.empty())
        for (unsigned int d = 0; d < 3; ++d)
          {
            Tensor<1, 3> unit;
            unit[d] = 1;
            add_unit(unit);
          }
      else if (other != normals.end())
        {
          if (first == 0)
            add_unit(cross_product_3d(normals[0], *other));
        }
      else if (first == 3)
        add_unit(normals[0]);
      else
        {
          Tensor<1, 3> across;
          // not parallel to the normal
          unsigned int d = 0;
          for (unsigned int i = 1; i < 3; ++i)
            if (std::abs(normals[0][i]) < std::abs(normals[0][d]))
              d = i;
          across[d] = 1;
          add_unit(cross_product_3d(normals[0], across));
          add_unit(cross_product_3d(normals[0], vectors[0]));
        }
      RigidMotions motions;
      for (const Tensor<1, 3> &vector : vectors)
        {
          std::array<double, 6> motion{};
          for (unsigned int i = 0; i < 3; ++i)
            motion[first + i] = vector[i];
          motions.push_back(motion);
        }
      return motions;
    }


    /** Find the kind and the amount of a motion. */
    void
    classify(const std::vector<Row> &rows,
             const Images           &images,
             const double            length,
             const double            largest,
             const MPI_Comm          communicator,
             SupportMotion          &motion)
    {
      constexpr double round_off = 1e-6;

      RigidMotions motions = motions_of_whole(images, 0);
      bool         fits    = false;
      auto         found   = rigid_motion(rows, motions, communicator, fits);
      if (fits)
        {
          motion.kind      = SupportMotion::Kind::translation;
          motion.amount    = translation(found).norm();
          motion.direction = translation(found) / motion.amount;
          return;
        }
      for (const auto &rotation : motions_of_whole(images, 3))
        motions.push_back(rotation);
      found = rigid_motion(rows, motions, communicator, fits);
      // neither a screw nor a translation that is a bit oblique
      const Tensor<1, 3>    turn = rotation(found);
      std::array<double, 6> part = found;
      std::fill(part.begin() + 3, part.end(), 0.);
      const double of_translation =
        sum_over(rows, communicator, [&](const Row &row) {
          return displacement(row, part) * displacement(row, part);
        });
      if (fits && of_translation < square_of_all(rows, communicator) / 4 &&
          std::abs(translation(found) * turn) <= round_off * turn.norm_square())
        {
          motion.kind   = SupportMotion::Kind::rotation;
          motion.amount = turn.norm() / length;
        }
      else
        {
          motion.kind   = SupportMotion::Kind::other;
          motion.amount = largest;
        }
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


  std::optional<SupportMotion>
  common_motion(const std::vector<SupportMotion> &motions,
                const unsigned int                factor)
  {
    constexpr double roundoff = 1e-6;

    std::optional<SupportMotion> first;
    for (const SupportMotion &motion : motions)
      {
        if (motion.factor != factor)
          continue;
        if (!first)
          first = motion;
        else if (motion.kind != first->kind ||
                 motion.multiple != first->multiple ||
                 (motion.direction - first->direction).norm() > roundoff ||
                 std::abs(motion.amount - first->amount) >
                   roundoff * std::abs(first->amount))
          return {};
      }
    return first;
  }


  std::vector<SupportMotion>
  find_support_motions(const Supports       &supports,
                       const MeshNodes      &mesh,
                       const SupportedNodes &supported)
  {
    // the same on all ranks
    std::vector<SupportMotion> candidates;
    std::vector<Images>        images_of_candidates;
    Edges                      symmetric{};
    for (unsigned int edge = 0; edge < 4; ++edge)
      symmetric[edge] = supports.is_symmetric(edge);
    unsigned int body = 0;
    // in the order of the bodies
    const auto add = [&](const std::vector<SupportCondition> &conditions,
                         const double                         multiple,
                         const Images                        &images) {
      const MovedComponents moved = moved_components(conditions);
      for (const auto &[factor, components] : moved)
        {
          std::string name = supported.bodies[body];
          if (moved.size() > 1)
            for (const std::string &component : components)
              name += ' ' + component;
          candidates.push_back({name, body, factor, multiple});
          images_of_candidates.push_back(images);
        }
      ++body;
    };
    for (const PointSupport &item : supports.points)
      {
        // a point has one image or more in each plane that it lies in
        Images images;
        double multiple = 1;
        if (mesh.grid.has_lines())
          for (const unsigned int edge :
               symmetric_edges_of_point(item.point, symmetric, mesh))
            {
              multiple *= 2;
              images.normals.push_back(normal_of_edge(edge, mesh));
            }
        add(item.conditions, multiple, images);
      }
    for (unsigned int edge = 0; edge < 4; ++edge)
      if (!supports.edges[edge].empty())
        {
          const double multiple =
            multiple_of_edge(edge, supports, symmetric, mesh);
          Images             images;
          const unsigned int across = 1 - edge / 2;
          if (multiple != 1)
            {
              if (supports.is_cyclic() && across == 1)
                images.axis = mesh.get_surface().axis();
              else
                for (const unsigned int end : {2 * across, 2 * across + 1})
                  if (symmetric[end])
                    images.normals.push_back(normal_of_edge(end, mesh));
            }
          add(supports.edges[edge], multiple, images);
        }
    for (const EdgeSupport &item : supports.named_edges)
      add(item.conditions, 1, Images());

    std::vector<SupportMotion> result;
    std::set<std::string>      columns;
    for (unsigned int k = 0; k < candidates.size(); ++k)
      {
        SupportMotion &motion = candidates[k];
        const Images  &images = images_of_candidates[k];
        const double   length = mesh.size();
        Point<3>       center = middle_of(motion, mesh, supported);
        // the axis passes through the origin
        if (images.axis.norm() > 0)
          center = Point<3>((center * images.axis) * images.axis /
                            images.axis.norm_square());
        const std::vector<Row> rows =
          rows_of(motion, mesh, supported, center, length);
        double largest = 0;
        for (const Row &row : rows)
          largest = std::max(largest, std::abs(row.value));
        largest = Utilities::MPI::max(largest, mesh.communicator);
        // a formula may vanish at all nodes
        if (largest == 0)
          continue;
        const std::string column = with_underscores(motion.name);
        if (!columns.insert(column).second)
          throw InputError("two supports that move are '" + motion.name +
                           "' in the column '" + column +
                           "_force'; give a point in one item of the list "
                           "'Supports/Point supports', and different names to "
                           "edges.");
        classify(rows, images, length, largest, mesh.communicator, motion);
        result.push_back(motion);
      }
    return result;
  }
} // namespace Biface
