// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/close_pairs.h>
#include <biface/surface/divide_mesh.h>
#include <biface/surface/known_surface.h>
#include <biface/surface/mesh_options.h>
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
      MeshBuilder(const MeshText    &raw,
                  const std::string &name,
                  const MeshOptions &options)
        : raw(raw), name(name), options(options)
      {}

      QuadrilateralMesh
      build()
      {
        collect_cells();
        collect_nodes();
        check_shapes();
        find_sides();
        collect_groups();
        set_joints();
        check_overlaps();
        orient();
        check_connected();
        check_places();
        split_nodes();
        order_vertices();
        find_free_sides();
        complete_folds();
        find_corners();
        set_normals();
        if (options.n_refinements > 0 && !options.surface)
          remark_facets();
        return mesh;
      }

    private:
      using CellSide = QuadrilateralMesh::CellSide;
      using Fold     = QuadrilateralMesh::Fold;
      using Group    = QuadrilateralMesh::Group;
      using Side     = QuadrilateralMesh::Side;

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
              refuse("the cell " + std::to_string(element.number) + " at " +
                     in_parentheses(raw.nodes[element.corners[0]]) +
                     " is a triangle, but all cells must be quadrilaterals: "
                     "'Surface/Mesh/Refine = 1' divides all cells into some.");
            // in version 2.2 a cell occurs once for each of its groups
            std::array<unsigned int, 4> corners;
            std::copy(
              element.corners.begin(), element.corners.end(), corners.begin());
            std::sort(corners.begin(), corners.end());
            const auto entry = known.emplace(corners, mesh.cells.size());
            if (!entry.second && !raw.repeats_cells)
              refuse("the cells " +
                     std::to_string(mesh.cell_numbers[entry.first->second]) +
                     " and " + std::to_string(element.number) + " at (" +
                     vector_to_string(raw.nodes[element.corners[0]]) +
                     ") have the same nodes, but cells must not lie on each "
                     "other.");
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
        cells_of_side.clear();
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            cells_of_side[key_of_side(c, f)].push_back({c, f});
      }

      /** Whether a side runs around two cells in opposite directions, as it
       * does if they have the same orientation. */
      bool
      run_oppositely(const CellSide &one, const CellSide &two) const
      {
        return mesh.side(one.cell, one.face) != mesh.side(two.cell, two.face);
      }

      /** The angle in degrees by which the surface turns from one cell to
       * another beyond their common side. */
      double
      angle_between(const CellSide &one, const CellSide &two) const
      {
        const Tensor<1, 3> a = normal_of(one.cell),
                           b = (run_oppositely(one, two) ? 1. : -1.) *
                               normal_of(two.cell);
        return std::atan2(cross_product_3d(a, b).norm(), a * b) * 180 /
               numbers::PI;
      }

      /** The sides of a group of lines, or those of several cells between the
       * nodes of a set. */
      std::vector<Side>
      sides_of_group(const unsigned int group) const
      {
        std::vector<Side> sides = mesh.groups[group].sides;
        const auto        set   = sets_of_nodes.find(group);
        if (set != sets_of_nodes.end())
          for (const auto &[side, of] : cells_of_side)
            if (of.size() > 1 && set->second.count(side[0]) > 0 &&
                set->second.count(side[1]) > 0)
              sides.push_back(side);
        return sides;
      }

      /** Note the sides of the groups with a joint that the user has chosen. */
      void
      set_joints()
      {
        for (const JointOfGroup &joint : options.joints)
          {
            std::vector<Side> sides;
            for (unsigned int g = 0; g < mesh.groups.size(); ++g)
              if (mesh.groups[g].name == joint.group)
                {
                  const std::vector<Side> here = sides_of_group(g);
                  sides.insert(sides.end(), here.begin(), here.end());
                }
            if (sides.empty())
              throw InputError("Surface/Mesh/Joints",
                               joint.text,
                               name + " has no lines '" + joint.group +
                                 "' between cells");
            for (const Side &side : sides)
              {
                const auto &of = cells_of_side.at(side);
                if (of.size() < 2)
                  throw InputError("Surface/Mesh/Joints",
                                   joint.text,
                                   mesh.cell_in_words(of[0].cell) +
                                     " meets no other one there");
                joint_of_side[side] = joint.stiffness;
              }
          }
      }

      /** Whether two cells at a side have their directors in common. A joint
       * separates two cells that go on smoothly, but of more cells only those
       * that do not. */
      bool
      is_smooth(const Side     &side,
                const CellSide &one,
                const CellSide &two) const
      {
        return angle_between(one, two) <= options.fold_angle &&
               (cells_of_side.at(side).size() > 2 ||
                joint_of_side.count(side) == 0);
      }

      /** Refuse cells that lie on each other on the same side of a line. */
      void
      check_overlaps() const
      {
        for (const auto &[side, of] : cells_of_side)
          for (unsigned int i = 0; i < of.size(); ++i)
            for (unsigned int j = 0; j < i; ++j)
              if (const double angle = angle_between(of[j], of[i]); angle > 175)
                refuse(mesh.cell_in_words(of[j].cell) + " and the cell " +
                       std::to_string(mesh.cell_numbers[of[i].cell]) +
                       " lie on each other beside a common side, but parts of "
                       "the shell may meet at 175 degrees at most.");
      }

      /** Give all cells of a connected part the orientation of its first one.
       * Where three or more cells meet, only those that go on smoothly are
       * connected. */
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
                    const Side     key = key_of_side(c, f);
                    const auto    &all = cells_of_side.at(key);
                    const CellSide own{c, f};
                    for (const CellSide &other : all)
                      {
                        if (other.cell == c ||
                            (all.size() > 2 && !is_smooth(key, own, other)))
                          continue;
                        const int wanted = run_oppositely(own, other)
                                             ? orientation[c]
                                             : -orientation[c];
                        int      &of     = orientation[other.cell];
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
        // the numbers of sides have changed
        find_sides();
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

      /** Find the sides of single cells, those of folds apart, and the cells of
       * the sides in their final order. */
      void
      find_free_sides()
      {
        find_sides();
        std::set<Side> of_folds;
        for (const RawFold &fold : raw_folds)
          for (const RawFold::Part &part : fold.cells)
            of_folds.insert(QuadrilateralMesh::without_direction(part.side));
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            {
              const Side key = key_of_side(c, f);
              if (cells_of_side.at(key).size() == 1 && of_folds.count(key) == 0)
                mesh.free_sides.push_back({c, f});
            }
        for (const auto &[group, nodes] : sets_of_nodes)
          add_free_sides(mesh.groups[group], nodes);
      }

      /** Sort the cells around each node into parts that are connected by sides
       * at the node.
       * @param connected whether two cells at a side are.
       * @return the number of the part of each vertex, from 0 in the order of
       * the cells. */
      template <typename Predicate>
      std::vector<std::array<unsigned int, 4>>
      parts_around_nodes(const Predicate &connected) const
      {
        // unite the vertices of cells
        std::vector<unsigned int> first(4 * mesh.cells.size());
        std::iota(first.begin(), first.end(), 0);
        const auto root = [&first](unsigned int i) {
          while (first[i] != i)
            i = first[i] = first[first[i]];
          return i;
        };
        const auto vertex = [this](const unsigned int cell,
                                   const unsigned int node) {
          const auto &c = mesh.cells[cell];
          return 4 * cell + (std::find(c.begin(), c.end(), node) - c.begin());
        };
        for (const auto &[side, of] : cells_of_side)
          for (unsigned int i = 0; i < of.size(); ++i)
            for (unsigned int j = 0; j < i; ++j)
              if (connected(side, of[j], of[i]))
                for (const unsigned int node : side)
                  {
                    const unsigned int a  = root(vertex(of[i].cell, node)),
                                       b  = root(vertex(of[j].cell, node));
                    first[std::max(a, b)] = std::min(a, b);
                  }

        std::vector<std::array<unsigned int, 4>> parts(mesh.cells.size());
        std::vector<std::vector<unsigned int>>   roots(mesh.nodes.size());
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < 4; ++v)
            {
              auto              &known = roots[mesh.cells[c][v]];
              const unsigned int own   = root(4 * c + v);
              const auto found = std::find(known.begin(), known.end(), own);
              parts[c][v]      = found - known.begin();
              if (found == known.end())
                known.push_back(own);
            }
        return parts;
      }

      /** Refuse nodes at which parts of the shell meet that have no side in
       * common. */
      void
      check_connected() const
      {
        const auto parts = parts_around_nodes(
          [](const Side &, const CellSide &, const CellSide &) {
            return true;
          });
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < 4; ++v)
            if (parts[c][v] > 0)
              refuse(node_in_words(mesh.cells[c][v]) +
                     " joins parts of the shell that have no side in common, "
                     "but the cells around a node must be neighbors.");
      }

      /** Refuse two nodes of free sides at one place, where the mesh would come
       * apart. */
      void
      check_places() const
      {
        std::set<unsigned int> ends;
        for (const auto &side : cells_of_side)
          if (side.second.size() == 1)
            ends.insert(side.first.begin(), side.first.end());
        double size = 0;
        for (const Point<3> &x : mesh.nodes)
          size = std::max(size, x.distance(mesh.nodes[0]));
        for_close_pairs(
          mesh.nodes,
          {ends.begin(), ends.end()},
          1e-7 * size,
          [&](const unsigned int a, const unsigned int b) {
            refuse(node_in_words(a) + " and the node " +
                   std::to_string(mesh.node_numbers[b]) +
                   " are at the same place, where the shell would come "
                   "apart; merge them (Gmsh: 'Coherence Mesh').");
          });
      }

      /** Give each smooth part of the surface nodes of its own, and find the
       * sides at which several parts meet. */
      void
      split_nodes()
      {
        const auto parts = parts_around_nodes(
          [this](const Side &side, const CellSide &one, const CellSide &two) {
            return is_smooth(side, one, two);
          });
        const unsigned int n_nodes = mesh.nodes.size();
        copies.resize(n_nodes);
        for (unsigned int n = 0; n < n_nodes; ++n)
          copies[n].push_back(n);
        std::vector<std::array<unsigned int, 4>> of_file = mesh.cells;
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < 4; ++v)
            {
              const unsigned int n = of_file[c][v];
              // parts are in the order of cells
              if (parts[c][v] == copies[n].size())
                {
                  copies[n].push_back(mesh.nodes.size());
                  const Point<3> position = mesh.nodes[n];
                  mesh.nodes.push_back(position);
                  const std::size_t number = mesh.node_numbers[n];
                  mesh.node_numbers.push_back(number);
                }
            }

        // sides by the nodes of the file, which groups have
        std::vector<std::set<unsigned int>> nodes_of_groups(mesh.groups.size());
        std::map<Side, std::vector<unsigned int>> groups_of_side;
        for (unsigned int g = 0; g < mesh.groups.size(); ++g)
          {
            Group &group = mesh.groups[g];
            if (group.sides.empty())
              // a point holds one part, which holds the others
              nodes_of_groups[g].insert(group.nodes.begin(), group.nodes.end());
            for (const Side &side : group.sides)
              groups_of_side[side].push_back(g);
            group.sides.clear();
          }
        for (const auto &[side, of] : cells_of_side)
          {
            RawFold fold;
            bool    several = false;
            for (const CellSide &at : of)
              {
                const Side directed = mesh.side(at.cell, at.face);
                Side       own;
                for (unsigned int k = 0; k < 2; ++k)
                  {
                    const auto        &c = of_file[at.cell];
                    const unsigned int v =
                      std::find(c.begin(), c.end(), directed[k]) - c.begin();
                    own[k] = copies[directed[k]][parts[at.cell][v]];
                  }
                const Side key   = QuadrilateralMesh::without_direction(own);
                const auto named = groups_of_side.find(side);
                // supports and loads act on the first part
                if (named != groups_of_side.end() && fold.cells.empty())
                  for (const unsigned int g : named->second)
                    {
                      nodes_of_groups[g].insert(own.begin(), own.end());
                      mesh.groups[g].sides.push_back(key);
                    }
                fold.cells.push_back({at.cell, own});
                several =
                  several || key != QuadrilateralMesh::without_direction(
                                      fold.cells[0].side);
              }
            if (several)
              {
                const auto joint = joint_of_side.find(side);
                fold.stiffness   = (joint == joint_of_side.end()
                                      ? std::numeric_limits<double>::infinity()
                                      : joint->second);
                raw_folds.push_back(fold);
              }
          }
        for (unsigned int g = 0; g < mesh.groups.size(); ++g)
          {
            Group &group = mesh.groups[g];
            group.nodes.assign(nodes_of_groups[g].begin(),
                               nodes_of_groups[g].end());
            std::sort(group.sides.begin(), group.sides.end());
          }
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < 4; ++v)
            mesh.cells[c][v] = copies[of_file[c][v]][parts[c][v]];
        for (const auto &joint : copies)
          if (joint.size() > 1)
            mesh.joints.push_back(joint);
      }

      /** Set the folds, whose cells have their final order now. */
      void
      complete_folds()
      {
        for (const RawFold &raw_fold : raw_folds)
          {
            Fold fold;
            fold.stiffness = raw_fold.stiffness;
            // the directions into the cells, and their normals
            std::vector<Tensor<1, 3>> inward, normals;
            for (const RawFold::Part &part : raw_fold.cells)
              {
                fold.cells.push_back(
                  {part.cell, side_at(part.cell, part.side[0], 0)});
                const Tensor<1, 3> along =
                  mesh.nodes[part.side[1]] - mesh.nodes[part.side[0]];
                inward.push_back(cross_product_3d(normal_of(part.cell), along));
                normals.push_back(cross_product_3d(along, inward.back()));
                normals.back() /= normals.back().norm();
                inward.back() /= inward.back().norm();
              }
            for (unsigned int face = 0; face < 2; ++face)
              for (unsigned int i = 0; i < fold.cells.size(); ++i)
                {
                  // the first cell from there around the side
                  unsigned int next  = i;
                  double       least = 2 * numbers::PI;
                  for (unsigned int j = 0; j < fold.cells.size(); ++j)
                    {
                      if (j == i)
                        continue;
                      double angle = std::atan2((face == 0 ? -1. : 1.) *
                                                  (inward[j] * normals[i]),
                                                inward[j] * inward[i]);
                      if (angle < 0)
                        angle += 2 * numbers::PI;
                      if (angle < least)
                        {
                          least = angle;
                          next  = j;
                        }
                    }
                  const Side &one = raw_fold.cells[i].side,
                             &two = raw_fold.cells[next].side;
                  unsigned int &beyond =
                    beyond_fold[face][fold.cells[i].cell][fold.cells[i].face];
                  beyond = numbers::invalid_unsigned_int;
                  // nodes at the same places, in the opposite direction
                  if (mesh.nodes[one[0]] != mesh.nodes[two[1]])
                    {
                      fold.is_closed[face] = false;
                      continue;
                    }
                  beyond = fold.cells[next].cell;
                  if (i < next && one != Side{{two[1], two[0]}})
                    fold.wedges[face].push_back({{i, next}});
                }
            mesh.folds.push_back(fold);
          }
      }

      /** The number of the side of a cell that begins, or ends, at a node. */
      unsigned int
      side_at(const unsigned int cell,
              const unsigned int node,
              const unsigned int end) const
      {
        // one of four
        for (unsigned int f = 0; f < 3; ++f)
          if (mesh.side(cell, f)[end] == node)
            return f;
        return 3;
      }

      /** Walk counterclockwise around a node, over the faces that bound one
       * wedge after the other.
       * @return the nodes of the parts; empty where the walk comes to an end.
       */
      std::vector<unsigned int>
      walk_around(const unsigned int first_cell,
                  const unsigned int first_node,
                  const unsigned int face) const
      {
        std::vector<unsigned int> parts{first_node};
        unsigned int              cell = first_cell, node = first_node;
        do
          {
            const unsigned int f    = side_at(cell, node, 1);
            const auto         fold = beyond_fold[face].find(cell);
            const auto        &of   = cells_of_side.at(key_of_side(cell, f));
            unsigned int       next = numbers::invalid_unsigned_int;
            if (fold != beyond_fold[face].end() && fold->second.count(f) > 0)
              next = fold->second.at(f);
            else if (of.size() == 2)
              next = (of[0].cell == cell ? of[1].cell : of[0].cell);
            if (next == numbers::invalid_unsigned_int)
              return {};
            // the node of its part at the same place
            for (const unsigned int n : mesh.cells[next])
              if (mesh.nodes[n] == mesh.nodes[first_node])
                node = n;
            cell = next;
            if (node != parts.back())
              parts.push_back(node);
        } while (cell != first_cell);
        if (parts.size() > 1 && parts.back() == first_node)
          parts.pop_back();
        return parts;
      }

      /** Find the corners that three parts or more enclose. */
      void
      find_corners()
      {
        std::set<unsigned int> of_joints;
        for (const auto &joint : mesh.joints)
          of_joints.insert(joint.begin(), joint.end());
        for (unsigned int face = 0; face < 2; ++face)
          {
            std::set<std::set<unsigned int>> known;
            for (unsigned int c = 0; c < mesh.cells.size(); ++c)
              for (const unsigned int n : mesh.cells[c])
                {
                  if (of_joints.count(n) == 0)
                    continue;
                  const auto                   parts = walk_around(c, n, face);
                  const std::set<unsigned int> sorted(parts.begin(),
                                                      parts.end());
                  if (sorted.size() >= 3 && sorted.size() == parts.size() &&
                      known.insert(sorted).second)
                    mesh.corners[face].push_back(parts);
                }
          }
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
              // a cell counts as much as several that share its angle
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
        if (options.surface)
          use_known_normals();
      }

      void
      remark_facets()
      {
        constexpr double remarkable = 1;
        double           largest    = 0;
        for (const auto &[side, of] : cells_of_side)
          if (of.size() == 2)
            largest = std::max(largest, angle_between(of[0], of[1]));
        if (largest > remarkable)
          mesh.remarks.push_back(
            "Warning: the cells of 'Surface/Mesh/File' turn by up to " +
            number_to_string(std::round(10 * largest) / 10) +
            " degrees from one to the next, and 'Refine' makes facets of them, "
            "whose results may be off by a third. Give the curved surface in "
            "'Geometry', or a finer mesh.");
      }

      void
      use_known_normals()
      {
        double size = 0;
        for (const Point<3> &x : mesh.nodes)
          size = std::max(size, x.distance(mesh.nodes[0]));
        const double least = std::cos(options.fold_angle * numbers::PI / 180);
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          {
            const Tensor<1, 3> known =
              options.surface->normal(mesh.nodes[n], mesh.normals[n], size);
            // at a fold, the surface may know that of another part
            if (known * mesh.normals[n] >= least)
              mesh.normals[n] = known;
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
                // a node of no cell has got no number
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
          {
            // which of their sides are free is not known yet
            auto &own = sets_of_nodes[mesh.groups.size()];
            for (const unsigned int node : nodes)
              if (new_number[node] != numbers::invalid_unsigned_int)
                own.insert(new_number[node]);
            mesh.groups.emplace_back();
            mesh.groups.back().name = set_name;
          }
      }

      /** Make a group of a set of nodes, with the free sides and those of folds
       * between them, and the nodes of the parts at free sides; elsewhere with
       * the node of the first part. */
      void
      add_free_sides(Group &group, const std::set<unsigned int> &set_of_nodes)
      {
        std::map<unsigned int, unsigned int> original;
        // at a fold each part of the shell has its own copy of a node
        for (const unsigned int node : set_of_nodes)
          for (const unsigned int copy : copies[node])
            original[copy] = node;
        std::set<unsigned int> all, on_sides;
        for (const CellSide &free_side : mesh.free_sides)
          {
            const Side side = mesh.side(free_side.cell, free_side.face);
            if (original.count(side[0]) == 0 || original.count(side[1]) == 0)
              continue;
            group.sides.push_back(QuadrilateralMesh::without_direction(side));
            for (const unsigned int copy : side)
              {
                all.insert(copy);
                on_sides.insert(original.at(copy));
              }
          }
        for (const RawFold &fold : raw_folds)
          {
            const Side side =
              QuadrilateralMesh::without_direction(fold.cells[0].side);
            if (original.count(side[0]) > 0 && original.count(side[1]) > 0)
              group.sides.push_back(side);
          }
        for (const unsigned int node : set_of_nodes)
          if (on_sides.count(node) == 0)
            all.insert(node);
        group.nodes.assign(all.begin(), all.end());
      }

      std::string
      name_of(const std::pair<unsigned int, long> &key) const
      {
        const auto found = raw.names.find(key);
        return found == raw.names.end() ? std::to_string(key.second)
                                        : found->second;
      }

      /** A fold before the vertices of its cells are in their final order. */
      struct RawFold
      {
        /** A cell, and its side in the direction in which it runs around the
         * cell counterclockwise. */
        struct Part
        {
          unsigned int cell;
          Side         side;
        };
        std::vector<Part> cells;
        double            stiffness;
      };

      const MeshText      &raw;
      const std::string    name;
      const MeshOptions   &options;
      QuadrilateralMesh    mesh;
      std::vector<RawFold> raw_folds;
      /** By the face, the cell and the number of its side at a fold: the cell
       * with which it bounds a wedge there, an invalid number if there is
       * none. */
      std::array<std::map<unsigned int, std::map<unsigned int, unsigned int>>,
                 2>
        beyond_fold;
      /** The stiffness of joints that the user has chosen, by the nodes of the
       * file. */
      std::map<Side, double> joint_of_side;
      /** The nodes of each part at each node of the file, itself first. */
      std::vector<std::vector<unsigned int>> copies;
      /** The nodes of sets of nodes, by the group. */
      std::map<unsigned int, std::set<unsigned int>> sets_of_nodes;
      /** The number of each node of the file in the mesh; invalid for those of
       * no cell. */
      std::vector<unsigned int>                      new_number;
      std::map<Side, std::vector<CellSide>>          cells_of_side;
      std::map<std::pair<unsigned int, long>, Group> groups;
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
             const MeshOptions &options)
  {
    const std::string name  = "the mesh '" + file_name + "'";
    const auto        first = text.find_first_not_of(" \t\n");
    if (first == std::string::npos ||
        (text[first] != '$' && text[first] != '*'))
      throw InputError(name +
                       " is neither one of Gmsh, which starts with "
                       "'$MeshFormat', nor one of Abaqus or CalculiX, which "
                       "starts with a line of '*'.");
    MeshText raw = (text[first] == '$' ? read_gmsh(text, file_name)
                                       : read_abaqus(text, file_name));
    const std::vector<std::string> remarks = prepare_mesh(raw, options, name);
    QuadrilateralMesh mesh = MeshBuilder(raw, name, options).build();
    mesh.remarks.insert(mesh.remarks.begin(), remarks.begin(), remarks.end());
    return mesh;
  }
} // namespace Biface
