// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/mesh_text.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::string
    in_parentheses(const Point<3> &x)
    {
      return "(" + vector_to_string(x) + ")";
    }


    /** Turns what a file contains into a mesh, and checks it. */
    class MeshBuilder
    {
    public:
      MeshBuilder(const MeshText &raw, const std::string &name)
        : raw(raw), name(name)
      {}

      QuadrilateralMesh
      build(const double fold_angle)
      {
        collect_cells();
        collect_nodes();
        check_shapes();
        find_sides();
        orient();
        order_vertices();
        find_free_sides();
        check_fans();
        check_places();
        set_normals();
        check_folds(fold_angle);
        collect_groups();
        return mesh;
      }

    private:
      using Group = QuadrilateralMesh::Group;
      using Side  = QuadrilateralMesh::Side;

      /** The key of a side in @p cells_of_side. */
      Side
      key_of_side(const unsigned int cell, const unsigned int face) const
      {
        return QuadrilateralMesh::without_direction(mesh.side(cell, face));
      }

      [[noreturn]] void
      refuse(const std::string &sentence) const
      {
        throw InputError(name + ": " + sentence);
      }

      std::string
      node_in_words(const unsigned int node) const
      {
        return "the node " + std::to_string(mesh.node_numbers[node]) + " at " +
               in_parentheses(mesh.nodes[node]);
      }

      void
      collect_cells()
      {
        std::map<std::array<unsigned int, 4>, unsigned int> known;
        for (const MeshText::Element &element : raw.elements[2])
          {
            if (element.corners.size() == 3)
              refuse(
                "the cell " + std::to_string(element.number) + " at " +
                in_parentheses(raw.nodes[element.corners[0]]) +
                " is a triangle, but all cells must be quadrilaterals; Gmsh "
                "makes them by 'Recombine Surface' with "
                "'Mesh.SubdivisionAlgorithm = 1'.");
            // in version 2.2 a cell occurs once for each of its groups
            std::array<unsigned int, 4> corners;
            std::copy(
              element.corners.begin(), element.corners.end(), corners.begin());
            std::sort(corners.begin(), corners.end());
            const auto entry = known.emplace(corners, mesh.cells.size());
            if (entry.second)
              {
                const auto &c = element.corners;
                mesh.cells.push_back({{c[0], c[1], c[3], c[2]}});
                mesh.cell_numbers.push_back(element.number);
              }
            for (const long group : element.groups)
              groups[{2, group}].cells.push_back(entry.first->second);
          }
        if (mesh.cells.empty())
          refuse(
            "there are no quadrilaterals, of which the mesh must consist.");
      }

      void
      collect_nodes()
      {
        new_number.assign(raw.nodes.size(), numbers::invalid_unsigned_int);
        for (auto &cell : mesh.cells)
          for (unsigned int &node : cell)
            {
              unsigned int &number = new_number[node];
              if (number == numbers::invalid_unsigned_int)
                {
                  number = mesh.nodes.size();
                  mesh.nodes.push_back(raw.nodes[node]);
                  mesh.node_numbers.push_back(raw.node_numbers[node]);
                }
              node = number;
            }
      }

      /** The normal of a cell at one of its vertices, with the length of the
       * area between the sides. */
      Tensor<1, 3>
      normal_at(const unsigned int cell, const unsigned int v) const
      {
        const auto        &c      = mesh.cells[cell];
        const Tensor<1, 3> along  = mesh.nodes[c[v | 1]] - mesh.nodes[c[v & 2]];
        const Tensor<1, 3> across = mesh.nodes[c[v | 2]] - mesh.nodes[c[v & 1]];
        return cross_product_3d(along, across);
      }

      /** The normal of a cell at its center. */
      Tensor<1, 3>
      normal_of(const unsigned int cell) const
      {
        const auto &c = mesh.cells[cell];
        return cross_product_3d(mesh.nodes[c[3]] - mesh.nodes[c[0]],
                                mesh.nodes[c[2]] - mesh.nodes[c[1]]);
      }

      void
      check_shapes() const
      {
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          {
            double size = 0;
            for (const unsigned int a : mesh.cells[c])
              for (const unsigned int b : mesh.cells[c])
                size = std::max(size, mesh.nodes[a].distance(mesh.nodes[b]));
            const Tensor<1, 3> normal = normal_of(c);
            for (unsigned int v = 0; v < 4; ++v)
              // as a part of the area of a square of this size
              if (!(normal_at(c, v) * normal >
                    1e-4 * size * size * normal.norm()))
                refuse(mesh.cell_in_words(c) +
                       " is degenerate or not convex at the corner at " +
                       in_parentheses(mesh.nodes[mesh.cells[c][v]]) +
                       ", but all corners must be convex.");
          }
      }

      void
      find_sides()
      {
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            {
              auto &of = cells_of_side[key_of_side(c, f)];
              of.push_back({c, f});
              if (of.size() > 2)
                refuse(mesh.cell_in_words(c) +
                       " shares a side with the cells " +
                       std::to_string(mesh.cell_numbers[of[0].cell]) + " and " +
                       std::to_string(mesh.cell_numbers[of[1].cell]) +
                       ", but at most two cells may meet at a side: joints of "
                       "several shells are not possible.");
            }
      }

      /** Give all cells of a connected part the orientation of its first one.
       */
      void
      orient()
      {
        std::vector<int> orientation(mesh.cells.size());
        for (unsigned int first = 0; first < mesh.cells.size(); ++first)
          {
            if (orientation[first] != 0)
              continue;
            orientation[first] = 1;
            std::vector<unsigned int> to_visit{first};
            while (!to_visit.empty())
              {
                const unsigned int c = to_visit.back();
                to_visit.pop_back();
                for (unsigned int f = 0; f < 4; ++f)
                  {
                    const Side side = mesh.side(c, f);
                    for (const auto &other :
                         cells_of_side.at(key_of_side(c, f)))
                      {
                        if (other.cell == c)
                          continue;
                        // it runs in opposite directions around both
                        const bool same = (mesh.side(other.cell, other.face) ==
                                           Side{{side[1], side[0]}});
                        const int  wanted =
                          same ? orientation[c] : -orientation[c];
                        int &of = orientation[other.cell];
                        if (of == 0)
                          {
                            of = wanted;
                            to_visit.push_back(other.cell);
                          }
                        else if (of != wanted)
                          refuse(mesh.cell_in_words(other.cell) +
                                 " closes a band with one side only, like that "
                                 "of Moebius, but the surface must have two.");
                      }
                  }
              }
          }
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          if (orientation[c] < 0)
            std::swap(mesh.cells[c][1], mesh.cells[c][2]);
      }

      /** Let opposite sides of all cells run in the same direction, which
       * deal.II wants. */
      void
      order_vertices()
      {
        std::vector<CellData<2>> cells(mesh.cells.size());
        for (unsigned int c = 0; c < cells.size(); ++c)
          std::copy(mesh.cells[c].begin(),
                    mesh.cells[c].end(),
                    cells[c].vertices.begin());
        GridTools::consistently_order_cells(cells);
        for (unsigned int c = 0; c < cells.size(); ++c)
          std::copy(cells[c].vertices.begin(),
                    cells[c].vertices.end(),
                    mesh.cells[c].begin());
      }

      void
      find_free_sides()
      {
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            // by nodes: the numbers of sides have changed with the orientation
            if (cells_of_side.at(key_of_side(c, f)).size() == 1)
              mesh.free_sides.push_back({c, f});
      }

      /** Refuse nodes at which parts of the shell meet that have no side in
       * common. */
      void
      check_fans() const
      {
        std::vector<unsigned int> n_cells(mesh.nodes.size()),
          n_sides(mesh.nodes.size());
        for (const auto &cell : mesh.cells)
          for (const unsigned int node : cell)
            ++n_cells[node];
        for (const auto &side : cells_of_side)
          for (const unsigned int node : side.first)
            ++n_sides[node];
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (n_sides[n] > n_cells[n] + 1)
            refuse(node_in_words(n) +
                   " joins parts of the shell that have no side in common, but "
                   "the cells around a node must be neighbors.");
      }

      /** Refuse two nodes of free sides at one place, where the mesh would come
       * apart. */
      void
      check_places() const
      {
        std::set<unsigned int> ends;
        for (const auto &side : mesh.free_sides)
          for (const unsigned int node : mesh.side(side.cell, side.face))
            ends.insert(node);
        std::vector<unsigned int> sorted_nodes(ends.begin(), ends.end());
        double                    size = 0;
        for (const Point<3> &x : mesh.nodes)
          size = std::max(size, x.distance(mesh.nodes[0]));
        const double tolerance = 1e-7 * size;
        std::sort(sorted_nodes.begin(),
                  sorted_nodes.end(),
                  [&](const unsigned int a, const unsigned int b) {
                    return mesh.nodes[a][0] < mesh.nodes[b][0];
                  });
        for (auto a = sorted_nodes.begin(); a != sorted_nodes.end(); ++a)
          for (auto b = a + 1;
               b != sorted_nodes.end() &&
               mesh.nodes[*b][0] - mesh.nodes[*a][0] <= tolerance;
               ++b)
            if (mesh.nodes[*a].distance(mesh.nodes[*b]) <= tolerance)
              refuse(node_in_words(*a) + " and the node " +
                     std::to_string(mesh.node_numbers[*b]) +
                     " are at the same place, where the shell would come "
                     "apart; merge them (Gmsh: 'Coherence Mesh').");
      }

      void
      set_normals()
      {
        mesh.normals.resize(mesh.nodes.size());
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < 4; ++v)
            {
              const auto        &cell = mesh.cells[c];
              const Tensor<1, 3> along =
                mesh.nodes[cell[v ^ 1]] - mesh.nodes[cell[v]];
              const Tensor<1, 3> across =
                mesh.nodes[cell[v ^ 2]] - mesh.nodes[cell[v]];
              const double       angle  = std::acos(std::min(
                1.,
                std::max(-1.,
                         along * across / (along.norm() * across.norm()))));
              const Tensor<1, 3> normal = normal_at(c, v);
              mesh.normals[cell[v]] += angle / normal.norm() * normal;
            }
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          {
            if (!(mesh.normals[n].norm() > 1e-3))
              refuse(node_in_words(n) +
                     " has no normal: the cells around it are folded onto each "
                     "other.");
            mesh.normals[n] /= mesh.normals[n].norm();
          }
      }

      void
      check_folds(const double fold_angle) const
      {
        for (const auto &side : cells_of_side)
          {
            if (side.second.size() < 2)
              continue;
            const unsigned int one = side.second[0].cell,
                               two = side.second[1].cell;
            Tensor<1, 3> a = normal_of(one), b = normal_of(two);
            const double angle =
              std::atan2(cross_product_3d(a, b).norm(), a * b) * 180 /
              numbers::PI;
            if (angle > fold_angle)
              refuse(mesh.cell_in_words(one) + " and the cell " +
                     std::to_string(mesh.cell_numbers[two]) +
                     " meet at an angle of " +
                     number_to_string(std::round(10 * angle) / 10) +
                     " degrees, but it must be at most 'Surface/Mesh/Fold "
                     "angle', " +
                     number_to_string(fold_angle) +
                     ": folds are not possible; on a smooth surface, use "
                     "smaller cells or a larger angle.");
          }
      }

      void
      collect_groups()
      {
        for (unsigned int dimension = 0; dimension < 2; ++dimension)
          for (const MeshText::Element &element : raw.elements[dimension])
            for (const long number : element.groups)
              {
                std::vector<unsigned int> nodes;
                for (const unsigned int corner : element.corners)
                  nodes.push_back(new_number[corner]);
                const bool inside =
                  std::find(nodes.begin(),
                            nodes.end(),
                            numbers::invalid_unsigned_int) == nodes.end();
                const Side side = QuadrilateralMesh::without_direction(
                  {{nodes.front(), nodes.back()}});
                if (!inside ||
                    (dimension == 1 && cells_of_side.count(side) == 0))
                  refuse("the element " + std::to_string(element.number) +
                         " of the group '" + name_of({dimension, number}) +
                         "' is not a part of any cell, but it must be " +
                         (dimension == 0 ? "a node" : "a side") + " of one.");
                Group &group = groups[{dimension, number}];
                group.nodes.insert(
                  group.nodes.end(), nodes.begin(), nodes.end());
                if (dimension == 1)
                  group.sides.push_back(side);
              }

        std::set<std::pair<unsigned int, std::string>> names;
        for (auto &[key, group] : groups)
          {
            group.name = name_of(key);
            if (!names.emplace(key.first, group.name).second)
              refuse("two groups have the name '" + group.name +
                     "', but names must be unique.");
            std::sort(group.nodes.begin(), group.nodes.end());
            group.nodes.erase(
              std::unique(group.nodes.begin(), group.nodes.end()),
              group.nodes.end());
            std::sort(group.sides.begin(), group.sides.end());
            group.sides.erase(
              std::unique(group.sides.begin(), group.sides.end()),
              group.sides.end());
            mesh.groups.push_back(group);
          }
        for (const auto &[set_name, nodes] : raw.node_sets)
          mesh.groups.push_back(group_of_nodes(set_name, nodes));
      }

      /** The group of a set of nodes, with the free sides between them. */
      Group
      group_of_nodes(const std::string               &set_name,
                     const std::vector<unsigned int> &nodes) const
      {
        std::set<unsigned int> of_cells;
        for (const unsigned int node : nodes)
          if (new_number[node] != numbers::invalid_unsigned_int)
            of_cells.insert(new_number[node]);
        Group group;
        group.name = set_name;
        group.nodes.assign(of_cells.begin(), of_cells.end());
        for (const auto &free_side : mesh.free_sides)
          {
            const Side side = mesh.side(free_side.cell, free_side.face);
            if (of_cells.count(side[0]) > 0 && of_cells.count(side[1]) > 0)
              group.sides.push_back(QuadrilateralMesh::without_direction(side));
          }
        return group;
      }

      std::string
      name_of(const std::pair<unsigned int, long> &key) const
      {
        const auto found = raw.names.find(key);
        return found == raw.names.end() ? std::to_string(key.second)
                                        : found->second;
      }

      const MeshText   &raw;
      const std::string name;
      QuadrilateralMesh mesh;
      /** The number of each node of the file in the mesh; invalid for those of
       * no cell. */
      std::vector<unsigned int>                                new_number;
      std::map<Side, std::vector<QuadrilateralMesh::FreeSide>> cells_of_side;
      std::map<std::pair<unsigned int, long>, Group>           groups;
    };
  } // namespace


  Point<3>
  QuadrilateralMesh::center(const unsigned int cell) const
  {
    Point<3> x;
    for (const unsigned int node : cells[cell])
      x += nodes[node] / 4;
    return x;
  }


  std::string
  QuadrilateralMesh::cell_in_words(const unsigned int cell) const
  {
    return "the cell " + std::to_string(cell_numbers[cell]) + " at " +
           in_parentheses(center(cell));
  }


  QuadrilateralMesh::Side
  QuadrilateralMesh::side(const unsigned int cell,
                          const unsigned int face) const
  {
    const auto end = [&](const unsigned int i) {
      return cells[cell][GeometryInfo<2>::face_to_cell_vertices(face, i)];
    };
    // sides 1 and 2 run with their coordinate, sides 0 and 3 against it
    return face == 1 || face == 2 ? Side{{end(0), end(1)}}
                                  : Side{{end(1), end(0)}};
  }


  QuadrilateralMesh
  parse_mesh(const std::string &text,
             const std::string &file_name,
             const double       fold_angle)
  {
    const std::string name  = "the mesh '" + file_name + "'";
    const auto        first = text.find_first_not_of(" \t\n");
    if (first == std::string::npos ||
        (text[first] != '$' && text[first] != '*'))
      throw InputError(name +
                       " is neither one of Gmsh, which starts with "
                       "'$MeshFormat', nor one of Abaqus or CalculiX, which "
                       "starts with a line of '*'.");
    const MeshText raw = (text[first] == '$' ? read_gmsh(text, file_name)
                                             : read_abaqus(text, file_name));
    return MeshBuilder(raw, name).build(fold_angle);
  }
} // namespace Biface
