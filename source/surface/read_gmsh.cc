// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include <biface/base/errors.h>
#include <biface/surface/mesh_text.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The numbers of a text, line by line. */
    class GmshText
    {
    public:
      GmshText(const std::string &text, const std::string &name)
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


    class GmshReader
    {
    public:
      GmshReader(const std::string &text, const std::string &name)
        : name(name), text(text, name)
      {}

      MeshText
      read()
      {
        bool has_format = false;
        while (text.next_line())
          {
            const std::string section = text.get_line();
            bool              is_read = true;
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
            else if (section == "$PartitionedEntities")
              throw InputError("the mesh '" + name +
                               "' is partitioned, but it must be whole: the "
                               "program distributes it itself.");
            else if (section == "$ParametricNodes")
              throw InputError("the mesh '" + name +
                               "' has parametric nodes, but must be saved "
                               "with 'Mesh.SaveParametric = 0'.");
            else
              // results, views and so on are passed over
              is_read = false;
            const std::string end = "$End" + section.substr(1);
            do
              {
                text.require_line("'" + end + "'");
                if (is_read && text.get_line() != end)
                  text.refuse("'" + end +
                              "': there are more lines than the counts before "
                              "them say");
            } while (text.get_line() != end);
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
              Utilities::trim(line.substr(first + 1, last - first - 1));
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
        // from version 4 on, a block has all numbers before the coordinates
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
        MeshText::Element element{number, {}, groups};
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
        raw.repeats_cells = (version < 3);
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
      GmshText          text;
      double            version = 0;
      MeshText          raw;
      /** The physical groups of an entity by its dimension and number. */
      std::map<std::pair<std::size_t, std::size_t>, std::vector<long>>
        groups_of_entity;
    };
  } // namespace


  MeshText
  read_gmsh(const std::string &text, const std::string &name)
  {
    return GmshReader(text, name).read();
  }
} // namespace Biface
