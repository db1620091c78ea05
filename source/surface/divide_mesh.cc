// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/close_pairs.h>
#include <biface/surface/divide_mesh.h>
#include <biface/surface/known_surface.h>
#include <biface/surface/mesh_options.h>
#include <biface/surface/mesh_text.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Side = std::array<unsigned int, 2>;

    class MeshPreparation
    {
    public:
      MeshPreparation(MeshText          &mesh,
                      const MeshOptions &options,
                      const std::string &name)
        : mesh(mesh), options(options), name(name)
      {}

      /** @return remarks. */
      std::vector<std::string>
      prepare()
      {
        unite_close_nodes();
        remove_repeated_corners();
        measure();
        check_number_of_cells();
        move_to_surface();
        for (unsigned int i = 0; i < options.n_refinements; ++i)
          divide();
        std::vector<std::string> remarks;
        for (const std::string &set : ambiguous_sets)
          remarks.push_back(
            "The set of nodes '" + set +
            "' is an edge: 'Refine' has given it the new nodes on the ends and "
            "folds of the shell, but not those across the cells between them. "
            "If it is a part of the shell, use cells that are half as long in "
            "the file.");
        return remarks;
      }

    private:
      /** A cell at a side, and whether the side runs around it from the node
       * with the lower number. */
      struct CellAtSide
      {
        unsigned int cell;
        bool         is_forward;
      };

      [[noreturn]] void
      refuse(const std::string &entry,
             const std::string &value,
             const std::string &sentence) const
      {
        throw InputError(
          "Surface/Mesh/" + entry, value, name + ": " + sentence);
      }

      std::string
      node_in_words(const unsigned int node) const
      {
        return "the node " + std::to_string(mesh.node_numbers[node]) + " at (" +
               vector_to_string(mesh.nodes[node]) + ")";
      }

      /** Let elements have the first node of each group of close ones. */
      void
      unite_close_nodes()
      {
        const double distance = options.merge_distance;
        if (!(distance > 0))
          return;
        std::vector<unsigned int> first(mesh.nodes.size());
        std::iota(first.begin(), first.end(), 0);
        const auto root = [&first](unsigned int i) {
          while (first[i] != i)
            i = first[i] = first[first[i]];
          return i;
        };
        for_close_pairs(mesh.nodes,
                        first,
                        distance,
                        [&](const unsigned int a, const unsigned int b) {
                          const unsigned int i = root(a), j = root(b);
                          first[std::max(i, j)] = std::min(i, j);
                        });
        for (auto &elements : mesh.elements)
          for (MeshText::Element &element : elements)
            {
              std::vector<unsigned int> united;
              for (const unsigned int corner : element.corners)
                united.push_back(root(corner));
              for (unsigned int i = 0; i < united.size(); ++i)
                for (unsigned int j = 0; j < i; ++j)
                  if (united[i] == united[j] &&
                      element.corners[i] != element.corners[j])
                    refuse("Merge distance",
                           number_to_string(distance),
                           "the element " + std::to_string(element.number) +
                             " would lose a corner at (" +
                             vector_to_string(mesh.nodes[element.corners[i]]) +
                             "); the distance must be smaller than its sides");
              element.corners = united;
            }
        for (auto &set : mesh.node_sets)
          {
            std::set<unsigned int> united;
            for (const unsigned int node : set.second)
              united.insert(root(node));
            set.second.assign(united.begin(), united.end());
          }
      }

      /** Cells of four nodes with one of them twice in a row are triangles. */
      void
      remove_repeated_corners()
      {
        for (MeshText::Element &cell : mesh.elements[2])
          {
            std::vector<unsigned int> corners;
            for (unsigned int i = 0; i < cell.corners.size(); ++i)
              if (cell.corners[i] !=
                  cell.corners[(i + 1) % cell.corners.size()])
                corners.push_back(cell.corners[i]);
            if (corners.size() == 3)
              cell.corners = corners;
          }
      }

      /** The size of the mesh, and the shortest side at each node. */
      void
      measure()
      {
        shortest_side.assign(mesh.nodes.size(),
                             std::numeric_limits<double>::infinity());
        Point<3> lowest, highest;
        for (unsigned int d = 0; d < 3; ++d)
          {
            lowest[d]  = std::numeric_limits<double>::infinity();
            highest[d] = -lowest[d];
          }
        for (const MeshText::Element &cell : mesh.elements[2])
          for (unsigned int i = 0; i < cell.corners.size(); ++i)
            {
              const unsigned int a = cell.corners[i],
                                 b =
                                   cell.corners[(i + 1) % cell.corners.size()];
              const double length = mesh.nodes[a].distance(mesh.nodes[b]);
              for (const unsigned int node : {a, b})
                shortest_side[node] = std::min(shortest_side[node], length);
              for (unsigned int d = 0; d < 3; ++d)
                {
                  lowest[d]  = std::min(lowest[d], mesh.nodes[a][d]);
                  highest[d] = std::max(highest[d], mesh.nodes[a][d]);
                }
            }
        size = mesh.elements[2].empty() ? 0. : lowest.distance(highest);
      }

      void
      check_number_of_cells() const
      {
        constexpr double most = 4e6;
        double           n    = 0;
        for (const MeshText::Element &cell : mesh.elements[2])
          n += cell.corners.size() * std::pow(4., options.n_refinements - 1.);
        if (options.n_refinements > 0 && n > most)
          refuse("Refine",
                 std::to_string(options.n_refinements),
                 "there would be " + number_to_string(n) +
                   " cells, but at most 4 million are possible");
      }

      void
      move_to_surface()
      {
        if (!options.surface)
          return;
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          // those of cells
          if (std::isfinite(shortest_side[n]))
            {
              const auto closest =
                options.surface->closest_point(mesh.nodes[n], size);
              const double distance =
                closest ? closest->distance(mesh.nodes[n])
                        : std::numeric_limits<double>::infinity();
              if (!(distance <= 0.1 * shortest_side[n]))
                throw InputError(
                  name + ": " + node_in_words(n) + " is " +
                  (closest ? number_to_string(distance) + " away from"
                           : std::string("not near")) +
                  " the surface of 'Surface/Mesh/Geometry', but the nodes of "
                  "the file must be on it within a tenth of the sides of their "
                  "cells, in the same unit of length.");
              mesh.nodes[n] = *closest;
            }
      }

      unsigned int
      add_node(const Point<3> &x)
      {
        mesh.nodes.push_back(x);
        mesh.node_numbers.push_back(++last_number);
        return mesh.nodes.size() - 1;
      }

      /** A place that has been found for a new node. */
      Point<3>
      place_of(const std::optional<Point<3>> &place, const Point<3> &near) const
      {
        if (!place)
          throw InputError(
            name +
            ": no point of the surface of 'Surface/Mesh/Geometry' is "
            "found for the new node of 'Refine' near (" +
            vector_to_string(near) +
            "): a formula must be smooth around it, without a condition that "
            "changes there, and a STEP file must not have an end or a hole "
            "there.");
        return *place;
      }

      static Side
      sorted_side(const unsigned int a, const unsigned int b)
      {
        return {{std::min(a, b), std::max(a, b)}};
      }

      /** Find the cells of all sides, each cell once. */
      void
      find_sides()
      {
        cells_of_side.clear();
        std::set<std::vector<unsigned int>> known;
        for (unsigned int c = 0; c < mesh.elements[2].size(); ++c)
          {
            const auto               &corners = mesh.elements[2][c].corners;
            std::vector<unsigned int> sorted  = corners;
            std::sort(sorted.begin(), sorted.end());
            if (known.insert(sorted).second)
              for (unsigned int i = 0; i < corners.size(); ++i)
                {
                  const unsigned int a = corners[i],
                                     b = corners[(i + 1) % corners.size()];
                  cells_of_side[sorted_side(a, b)].push_back({c, a < b});
                }
          }
      }

      /** The direction of the normal of a cell, with the length of its area,
       * more or less. */
      Tensor<1, 3>
      normal_of(const MeshText::Element &cell) const
      {
        const auto &c = cell.corners;
        return cross_product_3d(mesh.nodes[c[2]] - mesh.nodes[c[0]],
                                mesh.nodes[c.back()] - mesh.nodes[c[1]]);
      }

      /** Whether the surface ends or has a fold at a side of these cells. */
      bool
      is_edge(const std::vector<CellAtSide> &cells) const
      {
        if (cells.size() != 2)
          return true;
        const Tensor<1, 3> a = normal_of(mesh.elements[2][cells[0].cell]),
                           b =
                             (cells[0].is_forward == cells[1].is_forward ? -1.
                                                                         : 1.) *
                             normal_of(mesh.elements[2][cells[1].cell]);
        return std::atan2(cross_product_3d(a, b).norm(), a * b) >
               options.fold_angle * numbers::PI / 180;
      }

      /** The node in the middle of a side. */
      unsigned int
      middle_of(const unsigned int a, const unsigned int b)
      {
        const Side side  = sorted_side(a, b);
        const auto known = middles.find(side);
        if (known != middles.end())
          return known->second;
        const Point<3> from = mesh.nodes[side[0]], to = mesh.nodes[side[1]];
        Point<3>       middle = from + (to - from) / 2;
        if (options.surface)
          {
            const auto cells = cells_of_side.find(side);
            middle =
              (cells != cells_of_side.end() && is_edge(cells->second)
                 ? place_of(options.surface->middle_of_edge(from, to, size),
                            middle)
                 : place_of(
                     options.surface->point_between(middle, {from, to}, size),
                     middle));
          }
        return middles[side] = add_node(middle);
      }

      /** The node in the middle of a cell. In version 2.2 of Gmsh's format, a
       * cell occurs once for each of its groups. */
      unsigned int
      center_of(const std::vector<unsigned int> &corners)
      {
        std::vector<unsigned int> sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        const auto known = centers.find(sorted);
        if (known != centers.end())
          return known->second;
        Point<3>              mean;
        std::vector<Point<3>> around;
        for (const unsigned int corner : corners)
          {
            around.push_back(mesh.nodes[corner]);
            mean += mesh.nodes[corner] / static_cast<double>(corners.size());
          }
        if (options.surface)
          mean =
            place_of(options.surface->point_between(mean, around, size), mean);
        return centers[sorted] = add_node(mean);
      }

      void
      divide()
      {
        find_sides();
        middles.clear();
        centers.clear();
        last_number = 0;
        for (const std::size_t number : mesh.node_numbers)
          last_number = std::max(last_number, number);

        std::array<std::vector<MeshText::Element>, 3> parts;
        parts[0]       = mesh.elements[0];
        const auto add = [&parts](const MeshText::Element         &whole,
                                  const std::vector<unsigned int> &corners) {
          parts[corners.size() == 2 ? 1 : 2].push_back(
            {whole.number, corners, whole.groups});
        };
        for (const MeshText::Element &cell : mesh.elements[2])
          {
            const unsigned int n      = cell.corners.size();
            const unsigned int center = center_of(cell.corners);
            for (unsigned int i = 0; i < n; ++i)
              add(cell,
                  {cell.corners[i],
                   middle_of(cell.corners[i], cell.corners[(i + 1) % n]),
                   center,
                   middle_of(cell.corners[(i + n - 1) % n], cell.corners[i])});
          }
        for (const MeshText::Element &line : mesh.elements[1])
          {
            const unsigned int middle =
              middle_of(line.corners[0], line.corners[1]);
            add(line, {line.corners[0], middle});
            add(line, {middle, line.corners[1]});
          }
        extend_sets();
        mesh.elements = parts;
      }

      /** Give the new nodes to the sets of nodes. */
      void
      extend_sets()
      {
        if (mesh.node_sets.empty())
          return;
        for (auto &named : mesh.node_sets)
          {
            std::vector<unsigned int>   &nodes = named.second;
            const std::set<unsigned int> set(nodes.begin(), nodes.end());
            const auto for_each_side = [&](const auto &visit) {
              for (const auto &[side, cells] : cells_of_side)
                if (set.count(side[0]) > 0 && set.count(side[1]) > 0)
                  visit(side, cells);
            };
            // the nodes of edges, between which a side may cross the shell
            std::set<unsigned int> on_edges;
            for_each_side(
              [&](const Side &side, const std::vector<CellAtSide> &cells) {
                if (is_edge(cells))
                  on_edges.insert(side.begin(), side.end());
              });
            const auto is_inner =
              [&](const std::vector<unsigned int> &corners) {
                bool all = true, any = false;
                for (const unsigned int corner : corners)
                  {
                    all = all && set.count(corner) > 0;
                    any = any || on_edges.count(corner) == 0;
                  }
                return all && any;
              };
            bool is_ambiguous = false;
            for_each_side(
              [&](const Side &side, const std::vector<CellAtSide> &cells) {
                if (is_edge(cells) || on_edges.count(side[0]) == 0 ||
                    on_edges.count(side[1]) == 0 ||
                    std::any_of(
                      cells.begin(), cells.end(), [&](const CellAtSide &at) {
                        return is_inner(mesh.elements[2][at.cell].corners);
                      }))
                  nodes.push_back(middles.at(side));
                else
                  // the triangle in the corner of an edge has such a side
                  is_ambiguous =
                    is_ambiguous ||
                    std::none_of(
                      cells.begin(), cells.end(), [&](const CellAtSide &at) {
                        return mesh.elements[2][at.cell].corners.size() == 3;
                      });
              });
            for (const auto &[corners, center] : centers)
              if (is_inner(corners))
                nodes.push_back(center);
            if (is_ambiguous)
              ambiguous_sets.insert(named.first);
          }
      }

      MeshText          &mesh;
      const MeshOptions &options;
      const std::string  name;
      double             size = 0;
      /** By the node; infinite where there is no cell. */
      std::vector<double>                     shortest_side;
      std::map<Side, std::vector<CellAtSide>> cells_of_side;
      /** The new nodes by the sides and the sorted corners of cells. */
      std::map<Side, unsigned int>                      middles;
      std::map<std::vector<unsigned int>, unsigned int> centers;
      std::size_t                                       last_number = 0;
      /** Sets of nodes that may be an edge or a part of the shell. */
      std::set<std::string> ambiguous_sets;
    };
  } // namespace


  std::vector<std::string>
  prepare_mesh(MeshText          &mesh,
               const MeshOptions &options,
               const std::string &name)
  {
    return MeshPreparation(mesh, options, name).prepare();
  }
} // namespace Biface
