// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::string
    to_text(const Point<3> &x)
    {
      return "(" + number_to_string(x[0]) + ", " + number_to_string(x[1]) +
             ", " + number_to_string(x[2]) + ")";
    }


    /** The numbers of a text, line by line. */
    class MeshText
    {
    public:
      MeshText(const std::string &text, const std::string &name)
        : name(name), rest(text.c_str())
      {}

      /** Go to the next line that is not empty. @return whether there is one.
       */
      bool
      next_line()
      {
        while (*rest != '\0')
          {
            ++number;
            const char *end = rest;
            while (*end != '\0' && *end != '\n')
              ++end;
            line.assign(rest, end);
            rest = (*end == '\0' ? end : end + 1);
            line = Utilities::trim(line);
            if (!line.empty())
              {
                position = line.c_str();
                return true;
              }
          }
        return false;
      }

      /** Go to the next line, which must exist. */
      void
      require_line(const std::string &meaning)
      {
        if (!next_line())
          throw InputError("the mesh '" + name + "' ends where " + meaning +
                           " should follow; it is incomplete.");
      }

      const std::string &
      get_line() const
      {
        return line;
      }

      /** The next number of the line. */
      double
      number_of(const std::string &meaning)
      {
        char        *end   = nullptr;
        const double value = std::strtod(position, &end);
        if (end == position || !std::isfinite(value) ||
            (*end != '\0' && *end != ' ' && *end != '\t'))
          refuse(meaning);
        position = end;
        return value;
      }

      /** The next number of the line, a whole one that is not negative. */
      std::size_t
      index_of(const std::string &meaning)
      {
        const double value = number_of(meaning);
        if (!(value >= 0 && value < 1e15 && value == std::floor(value)))
          refuse(meaning);
        return static_cast<std::size_t>(value);
      }

      /** Pass over numbers of the line. */
      void
      skip(const unsigned int n, const std::string &meaning)
      {
        for (unsigned int i = 0; i < n; ++i)
          number_of(meaning);
      }

      /** Throw InputError: the line must contain something else. */
      [[noreturn]] void
      refuse(const std::string &meaning) const
      {
        throw InputError(name + ", line " + std::to_string(number),
                         line,
                         "it must contain " + meaning);
      }

    private:
      const std::string name;
      const char       *rest;
      std::string       line;
      const char       *position = nullptr;
      std::size_t       number   = 0;
    };


    /** The kinds of elements of Gmsh that can occur in the mesh of a shell.
     * @param n_nodes all of them, of which the corners come first. */
    struct ElementKind
    {
      unsigned int dimension, n_corners, n_nodes;
    };

    /** The kind of a number; none for solids and others. */
    const std::map<std::size_t, ElementKind> kinds_of_elements{
      {15, {0, 1, 1}},
      {1, {1, 2, 2}},
      {8, {1, 2, 3}},
      {26, {1, 2, 4}},
      {2, {2, 3, 3}},
      {9, {2, 3, 6}},
      {21, {2, 3, 10}},
      {3, {2, 4, 4}},
      {16, {2, 4, 8}},
      {10, {2, 4, 9}},
      {36, {2, 4, 16}}};


    /** The contents of a file before anything is checked that needs more than
     * a line. */
    struct RawMesh
    {
      std::vector<Point<3>>                         nodes;
      std::vector<std::size_t>                      node_numbers;
      std::unordered_map<std::size_t, unsigned int> node_of_number;

      struct Element
      {
        std::size_t               number;
        std::vector<unsigned int> corners;
        /** The physical groups of the element. */
        std::vector<long> groups;
      };
      /** By dimension. */
      std::array<std::vector<Element>, 3> elements;

      /** The names of groups by dimension and number. */
      std::map<std::pair<unsigned int, long>, std::string> names;
    };


    class GmshReader
    {
    public:
      GmshReader(const std::string &text, const std::string &name)
        : name(name), text(text, name)
      {}

      RawMesh
      read()
      {
        bool has_format = false;
        while (text.next_line())
          {
            const std::string section = text.get_line();
            if (section[0] != '$')
              text.refuse("the start of a section of Gmsh, such as '$Nodes'");
            if (section == "$MeshFormat")
              {
                read_format();
                has_format = true;
              }
            else if (!has_format)
              text.refuse("'$MeshFormat', with which a mesh of Gmsh starts");
            else if (section == "$PhysicalNames")
              read_names();
            else if (section == "$Entities")
              read_entities();
            else if (section == "$Nodes")
              read_nodes();
            else if (section == "$Elements")
              read_elements();
            const std::string end = "$End" + section.substr(1);
            do
              text.require_line("'" + end + "'");
            while (text.get_line() != end);
          }
        if (!has_format)
          throw InputError("the mesh '" + name +
                           "' is not one of Gmsh: it must start with "
                           "'$MeshFormat'.");
        return raw;
      }

    private:
      void
      read_format()
      {
        text.require_line("the version of the format");
        const std::string meaning = "version, kind and size of numbers";
        version                   = text.number_of(meaning);
        const std::size_t kind    = text.index_of(meaning);
        if (kind != 0)
          throw InputError(
            name + " is a binary mesh, but it must be ASCII: save it with "
                   "'Mesh.Binary = 0'.");
        if (!(version >= 2 && version < 3) && version != 4.1)
          text.refuse("the version 2.2 or 4.1 of the format of Gmsh (in Gmsh: "
                      "'Mesh.MshFileVersion = 4.1')");
      }

      void
      read_names()
      {
        const std::string meaning =
          "dimension, number and quoted name of a physical group";
        text.require_line("the number of physical groups");
        const std::size_t n = text.index_of("the number of physical groups");
        for (std::size_t i = 0; i < n; ++i)
          {
            text.require_line(meaning);
            const std::size_t dimension = text.index_of(meaning);
            const std::size_t number    = text.index_of(meaning);
            const std::string line      = text.get_line();
            const auto        first = line.find('"'), last = line.rfind('"');
            if (last == first || last == first + 1)
              text.refuse(meaning);
            raw.names[{dimension, number}] =
              line.substr(first + 1, last - first - 1);
          }
      }

      void
      read_entities()
      {
        const std::string meaning = "the numbers of points, curves, surfaces "
                                    "and volumes";
        text.require_line(meaning);
        std::array<std::size_t, 4> n;
        for (std::size_t &value : n)
          value = text.index_of(meaning);
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (std::size_t i = 0; i < n[dimension]; ++i)
            {
              const std::string of_entity =
                "number, box and physical groups of an entity";
              text.require_line(of_entity);
              const std::size_t number = text.index_of(of_entity);
              text.skip(dimension == 0 ? 3 : 6, of_entity);
              auto             &groups = groups_of_entity[{dimension, number}];
              const std::size_t n_groups = text.index_of(of_entity);
              for (std::size_t k = 0; k < n_groups; ++k)
                groups.push_back(
                  std::abs(static_cast<long>(text.number_of(of_entity))));
            }
      }

      void
      add_node(const std::size_t number, const Point<3> &x)
      {
        if (!raw.node_of_number.emplace(number, raw.nodes.size()).second)
          text.refuse("another node number: this one has occurred before");
        raw.nodes.push_back(x);
        raw.node_numbers.push_back(number);
      }

      void
      read_nodes()
      {
        const std::string of_block = "numbers of a block of nodes",
                          meaning  = "the coordinates of a node";
        const auto position        = [&]() {
          Point<3> x;
          for (unsigned int d = 0; d < 3; ++d)
            x[d] = text.number_of(meaning);
          return x;
        };
        text.require_line("the number of nodes");
        if (version < 3)
          {
            const std::size_t n = text.index_of("the number of nodes");
            for (std::size_t i = 0; i < n; ++i)
              {
                text.require_line(meaning);
                const std::size_t number = text.index_of(meaning);
                add_node(number, position());
              }
            return;
          }
        const std::size_t n_blocks = text.index_of(of_block);
        for (std::size_t b = 0; b < n_blocks; ++b)
          {
            text.require_line(of_block);
            text.skip(3, of_block);
            const std::size_t        n = text.index_of(of_block);
            std::vector<std::size_t> numbers;
            for (std::size_t i = 0; i < n; ++i)
              {
                text.require_line("the number of a node");
                numbers.push_back(text.index_of("the number of a node"));
              }
            for (const std::size_t number : numbers)
              {
                text.require_line(meaning);
                add_node(number, position());
              }
          }
      }

      void
      add_element(const std::size_t        number,
                  const std::size_t        type,
                  const std::vector<long> &groups)
      {
        const std::string meaning = "the nodes of an element";
        const auto        kind    = kinds_of_elements.find(type);
        if (kind == kinds_of_elements.end())
          throw InputError(
            name + ": the element " + std::to_string(number) + " is of type " +
            std::to_string(type) +
            " of Gmsh, but the mesh of a shell consists of quadrilaterals, and "
            "of lines and points that have names: save the surfaces alone.");
        RawMesh::Element element{number, {}, groups};
        for (unsigned int i = 0; i < kind->second.n_nodes; ++i)
          {
            const auto node = raw.node_of_number.find(text.index_of(meaning));
            if (node == raw.node_of_number.end())
              text.refuse(meaning + ", which must be among those of '$Nodes' "
                                    "before it");
            if (i < kind->second.n_corners)
              element.corners.push_back(node->second);
          }
        raw.elements[kind->second.dimension].push_back(element);
      }

      void
      read_elements()
      {
        const std::string of_block = "numbers of a block of elements",
                          meaning  = "number and nodes of an element";
        text.require_line("the number of elements");
        if (version < 3)
          {
            const std::size_t n = text.index_of("the number of elements");
            for (std::size_t i = 0; i < n; ++i)
              {
                text.require_line(meaning);
                const std::size_t number = text.index_of(meaning);
                const std::size_t type   = text.index_of(meaning);
                const std::size_t n_tags = text.index_of(meaning);
                // the first tag is the physical group, 0 for none; an element
                // in several groups is listed several times
                std::vector<long> groups;
                for (std::size_t k = 0; k < n_tags; ++k)
                  {
                    const double tag = text.number_of(meaning);
                    if (k == 0 && tag != 0)
                      groups.push_back(std::abs(static_cast<long>(tag)));
                  }
                add_element(number, type, groups);
              }
            return;
          }
        const std::size_t n_blocks = text.index_of(of_block);
        for (std::size_t b = 0; b < n_blocks; ++b)
          {
            text.require_line(of_block);
            const std::size_t dimension = text.index_of(of_block);
            const std::size_t entity    = text.index_of(of_block);
            const std::size_t type      = text.index_of(of_block);
            const std::size_t n         = text.index_of(of_block);
            const auto groups = groups_of_entity.find({dimension, entity});
            for (std::size_t i = 0; i < n; ++i)
              {
                text.require_line(meaning);
                const std::size_t number = text.index_of(meaning);
                add_element(number,
                            type,
                            groups == groups_of_entity.end()
                              ? std::vector<long>()
                              : groups->second);
              }
          }
      }

      const std::string name;
      MeshText          text;
      double            version = 0;
      RawMesh           raw;
      /** The physical groups of an entity by its dimension and number. */
      std::map<std::pair<std::size_t, std::size_t>, std::vector<long>>
        groups_of_entity;
    };


    QuadrilateralMesh::Side
    sorted(const unsigned int a, const unsigned int b)
    {
      return {{std::min(a, b), std::max(a, b)}};
    }


    /** Turns what a file contains into a mesh, and checks it. */
    class MeshBuilder
    {
    public:
      MeshBuilder(const RawMesh &raw, const std::string &name)
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
        check_places();
        set_normals();
        check_folds(fold_angle);
        collect_groups();
        return mesh;
      }

    private:
      [[noreturn]] void
      refuse(const std::string &sentence) const
      {
        throw InputError(name + ": " + sentence);
      }

      std::string
      cell_in_words(const unsigned int cell) const
      {
        return "the cell " + std::to_string(mesh.cell_numbers[cell]) + " at " +
               to_text(mesh.center(cell));
      }

      std::string
      node_in_words(const unsigned int node) const
      {
        return "the node " + std::to_string(mesh.node_numbers[node]) + " at " +
               to_text(mesh.nodes[node]);
      }

      void
      collect_cells()
      {
        std::map<std::size_t, unsigned int> known;
        for (const RawMesh::Element &element : raw.elements[2])
          {
            if (element.corners.size() == 3)
              refuse(
                "the cell " + std::to_string(element.number) + " at " +
                to_text(raw.nodes[element.corners[0]]) +
                " is a triangle, but all cells must be quadrilaterals; Gmsh "
                "makes them by 'Recombine Surface' with "
                "'Mesh.SubdivisionAlgorithm = 1'.");
            // in version 2.2 a cell occurs once for each of its groups
            const auto entry = known.emplace(element.number, mesh.cells.size());
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
                refuse(cell_in_words(c) +
                       " is degenerate or not convex at the corner at " +
                       to_text(mesh.nodes[mesh.cells[c][v]]) +
                       ", but all corners must be convex.");
          }
      }

      void
      find_sides()
      {
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            {
              const auto side = side_of(c, f);
              auto      &of   = cells_of_side[sorted(side[0], side[1])];
              of.push_back({c, f});
              if (of.size() > 2)
                refuse(cell_in_words(c) + " shares a side with the cells " +
                       std::to_string(mesh.cell_numbers[of[0].cell]) + " and " +
                       std::to_string(mesh.cell_numbers[of[1].cell]) +
                       ", but at most two cells may meet at a side: joints of "
                       "several shells are not possible.");
            }
      }

      /** The nodes of a side in the direction in which it runs around the cell
       * counterclockwise. */
      QuadrilateralMesh::Side
      side_of(const unsigned int cell, const unsigned int face) const
      {
        const auto        &c = mesh.cells[cell];
        const unsigned int a =
                             c[GeometryInfo<2>::face_to_cell_vertices(face, 0)],
                           b =
                             c[GeometryInfo<2>::face_to_cell_vertices(face, 1)];
        // sides 1 and 2 run with their coordinate, sides 0 and 3 against it
        return face == 1 || face == 2 ? QuadrilateralMesh::Side{{a, b}}
                                      : QuadrilateralMesh::Side{{b, a}};
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
                    const auto side = side_of(c, f);
                    for (const auto &other :
                         cells_of_side.at(sorted(side[0], side[1])))
                      {
                        if (other.cell == c)
                          continue;
                        const bool same = (side_of(other.cell, other.face) ==
                                           sorted_against(side));
                        const int  wanted =
                          same ? orientation[c] : -orientation[c];
                        int &of = orientation[other.cell];
                        if (of == 0)
                          {
                            of = wanted;
                            to_visit.push_back(other.cell);
                          }
                        else if (of != wanted)
                          refuse(cell_in_words(other.cell) +
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

      /** The side in the other direction. */
      static QuadrilateralMesh::Side
      sorted_against(const QuadrilateralMesh::Side &side)
      {
        return {{side[1], side[0]}};
      }

      void
      find_free_sides()
      {
        // the numbers of sides have changed with the orientation
        std::map<QuadrilateralMesh::Side, unsigned int> n_cells;
        for (const auto &side : cells_of_side)
          n_cells[side.first] = side.second.size();
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int f = 0; f < 4; ++f)
            {
              const auto side = side_of(c, f);
              if (n_cells.at(sorted(side[0], side[1])) == 1)
                mesh.free_sides.push_back({c, f});
            }
      }

      /** Refuse two nodes of free sides at one place, where the mesh would come
       * apart. */
      void
      check_places() const
      {
        std::set<unsigned int> ends;
        for (const auto &side : mesh.free_sides)
          for (const unsigned int node : side_of(side.cell, side.face))
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
              refuse(cell_in_words(one) + " and the cell " +
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
          for (const RawMesh::Element &element : raw.elements[dimension])
            for (const long number : element.groups)
              {
                std::vector<unsigned int> nodes;
                for (const unsigned int corner : element.corners)
                  nodes.push_back(new_number[corner]);
                const bool inside =
                  std::find(nodes.begin(),
                            nodes.end(),
                            numbers::invalid_unsigned_int) == nodes.end();
                if (!inside || (dimension == 1 && cells_of_side.count(sorted(
                                                    nodes[0], nodes[1])) == 0))
                  refuse("the element " + std::to_string(element.number) +
                         " of the group '" + name_of({dimension, number}) +
                         "' is not a part of any cell, but it must be " +
                         (dimension == 0 ? "a node" : "a side") + " of one.");
                Group &group = groups[{dimension, number}];
                group.nodes.insert(
                  group.nodes.end(), nodes.begin(), nodes.end());
                if (dimension == 1)
                  group.sides.push_back(sorted(nodes[0], nodes[1]));
              }

        std::map<std::string, unsigned int> dimension_of_name;
        for (auto &[key, group] : groups)
          {
            group.name = name_of(key);
            if (!dimension_of_name.emplace(group.name, key.first).second)
              refuse("two groups have the name '" + group.name +
                     "', but names must be unique.");
            std::sort(group.nodes.begin(), group.nodes.end());
            group.nodes.erase(
              std::unique(group.nodes.begin(), group.nodes.end()),
              group.nodes.end());
            mesh.groups.push_back(group);
          }
      }

      std::string
      name_of(const std::pair<unsigned int, long> &key) const
      {
        const auto found = raw.names.find(key);
        return found == raw.names.end() ? std::to_string(key.second)
                                        : found->second;
      }

      using Group = QuadrilateralMesh::Group;

      const RawMesh    &raw;
      const std::string name;
      QuadrilateralMesh mesh;
      /** The number of each node of the file in the mesh; invalid for those of
       * no cell. */
      std::vector<unsigned int> new_number;
      std::map<QuadrilateralMesh::Side,
               std::vector<QuadrilateralMesh::FreeSide>>
                                                     cells_of_side;
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


  unsigned int
  QuadrilateralMesh::find_group(const std::string &entry,
                                const std::string &text,
                                const std::string &name,
                                const bool         lines) const
  {
    std::string names;
    for (unsigned int i = 0; i < groups.size(); ++i)
      {
        const Group &group = groups[i];
        if (lines ? group.sides.empty() : group.nodes.empty())
          continue;
        if (group.name == name)
          return i;
        names += (names.empty() ? "'" : ", '") + group.name + "'";
      }
    throw InputError(
      entry,
      text,
      std::string("the mesh has no group of ") +
        (lines ? "lines" : "lines or points") + " '" + name + "'; " +
        (names.empty() ? "it has none at all" : "its groups are " + names));
  }


  QuadrilateralMesh
  parse_gmsh(const std::string &text,
             const std::string &file_name,
             const double       fold_angle)
  {
    const RawMesh raw = GmshReader(text, file_name).read();
    return MeshBuilder(raw, "the mesh '" + file_name + "'").build(fold_angle);
  }
} // namespace Biface
