// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include <biface/model/mesh/coarse_spaces.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A node as far as interpolation needs it. */
    struct Site
    {
      SurfacePoint surface;
      /** The point in the middle between the inner and the outer face. */
      Point<3> middle;
      double   half_thickness;
      /** Half the thickness of each layer. */
      const double *of_layers;
    };


    /** Half the thickness, the height of the middle, and half the thickness of
     * each layer on each line of the first coordinate. */
    std::vector<std::vector<double>>
    thickness_of_lines(const ShellMesh &mesh)
    {
      // each rank knows the lines of its nodes
      const unsigned int  n     = mesh.grid.n_nodes(0);
      const unsigned int  width = 3 + mesh.n_layers();
      std::vector<double> sums(width * n);
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          {
            double *sum = &sums[width * node.grid_index[0]];
            sum[0] += 1;
            sum[1] += (node.face_heights[Resultants::outer] -
                       node.face_heights[Resultants::inner]) /
                      2;
            sum[2] += (node.face_heights[Resultants::outer] +
                       node.face_heights[Resultants::inner]) /
                      2;
            for (unsigned int k = 0; k < mesh.n_layers(); ++k)
              sum[3 + k] += node.half_thickness[k];
          }
      Utilities::MPI::sum(sums, mesh.communicator, sums);

      std::vector<std::vector<double>> lines(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = 1; k < width; ++k)
          lines[i].push_back(sums[width * i + k] / sums[width * i]);
      return lines;
    }


    /** A mesh of some of the lines of the given one. */
    class Level
    {
    public:
      /** With all lines, and the unknowns of the mesh. */
      Level(const ShellMesh &mesh)
        : mesh(mesh)
        , thickness(thickness_of_lines(mesh))
        , along(short_coordinate(mesh.get_surface(), mesh.grid))
        , grid(mesh.grid)
        , numbers(mesh.n_dofs_per_node() * grid.n_nodes(0) * grid.n_nodes(1),
                  numbers::invalid_dof_index)
        , locally_owned(mesh.locally_owned)
      {
        find_nodes();
        for (const auto &[node, index] : owned)
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            if (!mesh.constraints.is_constrained(node->dofs[d]))
              number(index, d) = node->dofs[d];

        number_rows([&](const Node &node, const GridIndex &) {
          for (const auto dof : node.dofs)
            nodes.rows.push_back(mesh.locally_owned.index_within_set(dof));
        });
      }


      /** With the lines of @p grid, and unknowns numbered anew. */
      Level(const Level &finer, const ChartGrid &grid)
        : mesh(finer.mesh)
        , thickness(finer.thickness)
        , along(finer.along)
        , grid(grid)
        , numbers(mesh.n_dofs_per_node() * grid.n_nodes(0) * grid.n_nodes(1))
      {
        find_nodes();
        types::global_dof_index n_owned = 0;
        for (const auto &[node, index] : owned)
          for (const auto dof : node->dofs)
            n_owned += !mesh.constraints.is_constrained(dof);
        locally_owned = Utilities::MPI::create_ascending_partitioning(
          mesh.communicator,
          n_owned)[Utilities::MPI::this_mpi_process(mesh.communicator)];

        // shifted by one, so that zero is none and a sum collects them
        const types::global_dof_index first =
          n_owned > 0 ? locally_owned.nth_index_in_set(0) : 0;
        int next = 0;
        number_rows([&](const Node &node, const GridIndex &index) {
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            if (!mesh.constraints.is_constrained(node.dofs[d]))
              {
                nodes.rows.push_back(next);
                number(index, d) = first + next + 1;
                ++next;
              }
        });
        Utilities::MPI::sum(numbers, mesh.communicator, numbers);
        add_images();
        for (auto &number : numbers)
          number = (number > 0 ? number - 1 : numbers::invalid_dof_index);
      }


      /** The interpolation from another one to this one. */
      LA::SparseMatrix
      interpolation_from(const Level &coarse) const
      {
        DynamicSparsityPattern pattern(
          locally_owned.size(), coarse.locally_owned.size(), locally_owned);
        for_each_weight(coarse,
                        [&](const types::global_dof_index row,
                            const types::global_dof_index column,
                            const double) { pattern.add(row, column); });
        LA::SparseMatrix matrix;
        matrix.reinit(
          locally_owned, coarse.locally_owned, pattern, mesh.communicator);
        for_each_weight(
          coarse,
          [&](const types::global_dof_index row,
              const types::global_dof_index column,
              const double weight) { matrix.add(row, column, weight); });
        matrix.compress(VectorOperation::add);
        return matrix;
      }


      types::global_dof_index
      n_unknowns() const
      {
        return locally_owned.size();
      }


      const ShellMesh &mesh;
      /** See thickness_of_lines(). */
      const std::vector<std::vector<double>> thickness;
      /** See short_coordinate(). */
      const unsigned int along;
      const ChartGrid    grid;
      GridLineNodes      nodes;

    private:
      types::global_dof_index &
      number(const GridIndex &node, const unsigned int d)
      {
        return numbers[mesh.n_dofs_per_node() * grid.node_number(node) + d];
      }

      types::global_dof_index
      number(const GridIndex &node, const unsigned int d) const
      {
        return numbers[mesh.n_dofs_per_node() * grid.node_number(node) + d];
      }


      /** The index of a node of the mesh if it is one of this level. */
      std::optional<GridIndex>
      index_of(const Node &node) const
      {
        GridIndex index;
        for (unsigned int a = 0; a < 2; ++a)
          {
            const auto line = std::lower_bound(
              grid.lines[a].begin(), grid.lines[a].end(), node.alpha[a]);
            if (line == grid.lines[a].end() || *line != node.alpha[a])
              return {};
            index[a] = std::distance(grid.lines[a].begin(), line);
          }
        return index;
      }


      void
      find_nodes()
      {
        for (const Node &node : mesh.nodes)
          if (node.locally_owned)
            if (const auto index = index_of(node))
              owned.emplace_back(&node, *index);
        std::sort(
          owned.begin(), owned.end(), [&](const auto &a, const auto &b) {
            return std::make_pair(a.second[1 - along], a.second[along]) <
                   std::make_pair(b.second[1 - along], b.second[along]);
          });
      }


      /** Fill @p nodes.
       * @param add_rows adds the rows of a node. */
      template <typename Action>
      void
      number_rows(const Action &add_rows)
      {
        for (unsigned int n = 0; n < owned.size(); ++n)
          {
            const GridIndex &index = owned[n].second;
            if (n == 0 || owned[n - 1].second[1 - along] != index[1 - along] ||
                owned[n - 1].second[along] + 1 != index[along])
              nodes.line_begin.push_back(n);
            add_rows(*owned[n].first, index);
            nodes.begin.push_back(nodes.rows.size());
          }
        nodes.line_begin.push_back(owned.size());
      }


      /** Unknowns that equal others, as across cyclic edges, have the number of
       * these. */
      void
      add_images()
      {
        std::unordered_map<types::global_dof_index,
                           std::pair<const Node *, unsigned int>>
          place;
        for (const Node &node : mesh.nodes)
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            place[node.dofs[d]] = {&node, d};

        // only entries of 1 make an unknown the image of another: those of
        // cyclic edges, which are the same unknown on all levels
        std::vector<types::global_dof_index> images(numbers.size());
        for (const auto &[node, index] : owned)
          for (unsigned int d = 0; d < mesh.n_dofs_per_node(); ++d)
            {
              const auto *entries =
                mesh.constraints.get_constraint_entries(node->dofs[d]);
              if (entries == nullptr || entries->size() != 1 ||
                  entries->front().second != 1)
                continue;
              const auto other = place.find(entries->front().first);
              if (other == place.end())
                continue;
              const auto &[original, i] = other->second;
              if (const auto there = index_of(*original))
                images[mesh.n_dofs_per_node() * grid.node_number(index) + d] =
                  number(*there, i);
            }
        Utilities::MPI::sum(images, mesh.communicator, images);
        for (std::size_t i = 0; i < numbers.size(); ++i)
          numbers[i] += images[i];
      }


      /** @param line of the finest mesh, see thickness_of_lines(). */
      Site
      site(const SurfacePoint &surface, const unsigned int line) const
      {
        return {surface,
                surface.position + thickness[line][1] * surface.frame[2],
                thickness[line][0],
                &thickness[line][2]};
      }


      Site
      site(const Point<2> &alpha) const
      {
        const auto        &lines = mesh.grid.lines[0];
        const unsigned int line =
          std::distance(lines.begin(),
                        std::lower_bound(lines.begin(), lines.end(), alpha[0]));
        return site(mesh.get_surface().evaluate(alpha), line);
      }


      /** Call @p action with the row, the column and the value of each entry of
       * the interpolation from another level. */
      template <typename Action>
      void
      for_each_weight(const Level &coarse, const Action &action) const
      {
        const unsigned int n_parts = mesh.n_layers() + 1;
        std::unordered_map<types::global_cell_index, Site> sites;
        const auto site_of = [&](const GridIndex &index) -> const Site & {
          const auto key   = coarse.grid.node_number(index);
          const auto found = sites.find(key);
          if (found != sites.end())
            return found->second;
          return sites.emplace(key, site(coarse.grid.alpha(index)))
            .first->second;
        };

        for (const auto &[node, node_index] : owned)
          {
            // vectors are interpolated, not their components in frames that
            // turn
            const Point<2>  &alpha = node->alpha;
            const GridIndex &index = node_index;
            const Site       here  = site(node->surface, node->grid_index[0]);

            // the lines on both sides, and the weight of the second one
            std::array<unsigned int, 2> low;
            std::array<double, 2>       weight;
            for (unsigned int a = 0; a < 2; ++a)
              {
                const auto &lines = coarse.grid.lines[a];
                const auto  next  = std::upper_bound(
                  lines.begin(), std::prev(lines.end()), alpha[a]);
                low[a] = std::distance(lines.begin(), next) - 1;
                weight[a] =
                  (alpha[a] - *std::prev(next)) / (*next - *std::prev(next));
              }

            for (unsigned int v = 0; v < 4; ++v)
              {
                const double w = (v & 1 ? weight[0] : 1 - weight[0]) *
                                 (v >> 1 ? weight[1] : 1 - weight[1]);
                if (w == 0)
                  continue;
                const GridIndex other = coarse.grid.node_of_cell(low, v);
                const Site     &there = site_of(other);
                const auto &e = here.surface.frame, &f = there.surface.frame;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    const auto number_of = [&](const unsigned int part) {
                      return coarse.number(other, n_parts * c + part);
                    };
                    const auto add = [&](const unsigned int  part,
                                         const unsigned int  column_part,
                                         const Tensor<1, 3> &value) {
                      const auto column = number_of(column_part);
                      if (column == numbers::invalid_dof_index)
                        return;
                      for (unsigned int k = 0; k < 3; ++k)
                        {
                          const auto row = number(index, n_parts * k + part);
                          if (row != numbers::invalid_dof_index)
                            action(row, column, w * (e[k] * value));
                        }
                    };
                    add(0, 0, f[c]);
                    for (unsigned int part = 1; part < n_parts; ++part)
                      {
                        // a half difference turns with the director, so that it
                        // grows with the thickness of its layer
                        const double half  = here.of_layers[part - 1],
                                     other = there.of_layers[part - 1];
                        if (half > 0 && other > 0)
                          add(part, part, half / other * f[c]);
                        // the rotation of the wall
                        if (w < 1 && other > 0)
                          add(0,
                              part,
                              cross_product_3d(cross_product_3d(f[2], f[c]),
                                               here.middle - there.middle) /
                                (2 * there.half_thickness));
                      }
                  }
              }
          }
      }


      /** The numbers of the unknowns, node by node, in the order of
       * Node::dofs. */
      std::vector<types::global_dof_index> numbers;
      IndexSet                             locally_owned;
      /** The locally owned nodes with their indices, line by line. */
      std::vector<std::pair<const Node *, GridIndex>> owned;
    };
  } // namespace


  NestedSpaces
  make_nested_spaces(const ShellMesh              &mesh,
                     const types::global_dof_index max_unknowns)
  {
    auto         finer = std::make_unique<Level>(mesh);
    NestedSpaces spaces{finer->nodes, {}};
    while (finer->n_unknowns() > max_unknowns)
      {
        const ChartGrid grid = finer->grid.coarsened({});
        if (grid.lines == finer->grid.lines)
          break;
        auto coarse = std::make_unique<Level>(*finer, grid);
        spaces.coarse.push_back(
          {coarse->nodes, finer->interpolation_from(*coarse)});
        finer = std::move(coarse);
      }
    return spaces;
  }
} // namespace Biface
