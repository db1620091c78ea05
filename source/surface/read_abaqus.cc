// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/read_file.h>
#include <biface/surface/mesh_text.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::string
    in_capitals(std::string text)
    {
      for (char &c : text)
        c = std::toupper(static_cast<unsigned char>(c));
      return text;
    }


    /** Reads the lines of keywords and data one after the other. */
    class AbaqusReader
    {
    public:
      AbaqusReader(const std::string &text, const std::string &name)
        : name(name), lines(text)
      {}

      MeshText
      read()
      {
        while (next_line())
          if (line[0] == '*')
            read_keyword();
          else if (keyword == "NODE")
            read_node();
          else if (keyword == "ELEMENT")
            read_element();
          else if (keyword == "NSET" || keyword == "ELSET")
            read_set();
        // data of other keywords have nothing to do with the mesh
        finish();
        return result;
      }

    private:
      /** Go to the next line that is neither empty nor a comment. */
      bool
      next_line()
      {
        std::string physical;
        while (std::getline(lines, physical))
          {
            ++number;
            line = Utilities::trim(physical);
            if (!line.empty() && line.compare(0, 2, "**") != 0)
              return true;
          }
        return false;
      }

      [[noreturn]] void
      refuse(const std::string &meaning) const
      {
        throw InputError(name + ", line " + std::to_string(number),
                         line,
                         "it must contain " + meaning);
      }

      /** The value of a parameter of the keyword; empty if there is none. */
      std::string
      parameter(const std::string &wanted) const
      {
        for (const std::string &cell : parameters)
          {
            const auto equals = cell.find('=');
            if (in_capitals(Utilities::trim(cell.substr(0, equals))) == wanted)
              return equals == std::string::npos
                       ? wanted
                       : Utilities::trim(cell.substr(equals + 1));
          }
        return {};
      }

      bool
      is_curvilinear() const
      {
        const std::string system = in_capitals(parameter("SYSTEM"));
        return !system.empty() && system != "R";
      }

      void
      read_keyword()
      {
        if (!rest.empty())
          refuse(
            "the other nodes of an element, whose line ended with a comma");
        parameters = split_cells(line.substr(1), ',');
        keyword    = in_capitals(parameters[0]);
        parameters.erase(parameters.begin());
        set      = in_capitals(parameter(keyword));
        generate = !parameter("GENERATE").empty();
        if (keyword == "INCLUDE")
          refuse("the mesh itself: an included file is not read");
        if (keyword == "PART" && ++n_parts > 1)
          refuse("one part only: write each to a file of its own");
        if (keyword == "SYSTEM" || (keyword == "NODE" && is_curvilinear()))
          refuse("Cartesian coordinates: other systems are not possible");
        if ((keyword == "NSET" || keyword == "ELSET") && set.empty())
          refuse("the name of a set");
        // SOLID SECTION is that of trusses, too
        if (keyword.size() > 8 &&
            keyword.compare(keyword.size() - 8, 8, " SECTION") == 0)
          sets_of_sections.insert(in_capitals(parameter("ELSET")));
        if (keyword == "NODE")
          set = in_capitals(parameter("NSET"));
        if (keyword == "ELEMENT")
          {
            set             = in_capitals(parameter("ELSET"));
            const auto type = in_capitals(parameter("TYPE"));
            // the lines of Gmsh
            is_line = (type == "T2D2" || type == "T3D2");
            // by the number of nodes in the name: S4R5 has four
            const std::string shells[] = {"S", "M3D", "CPS", "CPE", "STRI"};
            n_nodes                    = 0;
            for (const std::string &shell : shells)
              if (type.compare(0, shell.size(), shell) == 0 &&
                  type.size() > shell.size() &&
                  std::isdigit(static_cast<unsigned char>(type[shell.size()])))
                n_nodes = type[shell.size()] - '0';
            if (is_line)
              n_nodes = 2;
            else if (n_nodes != 3 && n_nodes != 4 && n_nodes != 6 &&
                     n_nodes != 8 && n_nodes != 9)
              refuse("a type of shells, such as S4R or S3: others are not "
                     "possible");
          }
      }

      double
      number_in(const std::string &cell, const std::string &meaning) const
      {
        char        *end   = nullptr;
        const double value = std::strtod(cell.c_str(), &end);
        if (cell.empty() || *end != '\0' || !std::isfinite(value))
          refuse(meaning);
        return value;
      }

      std::size_t
      index_in(const std::string &cell, const std::string &meaning) const
      {
        const double value = number_in(cell, meaning);
        if (!(value >= 0 && value < 1e15 && value == std::floor(value)))
          refuse(meaning);
        return static_cast<std::size_t>(value);
      }

      void
      read_node()
      {
        const std::string meaning = "number and coordinates of a node";
        const auto        cells   = split_cells(line, ',');
        if (cells.size() < 2)
          refuse(meaning);
        const std::size_t node = index_in(cells[0], meaning);
        Point<3>          x;
        for (unsigned int d = 0; d < 3 && d + 1 < cells.size(); ++d)
          x[d] = cells[d + 1].empty() ? 0. : number_in(cells[d + 1], meaning);
        if (!result.node_of_number.emplace(node, result.nodes.size()).second)
          refuse("another node number: this one has occurred before");
        result.nodes.push_back(x);
        result.node_numbers.push_back(node);
        if (!set.empty())
          node_sets[set].push_back(node);
      }

      void
      read_element()
      {
        const std::string meaning = "number and nodes of an element";
        for (const std::string &cell : split_cells(line, ','))
          if (!cell.empty())
            rest.push_back(index_in(cell, meaning));
        if (rest.size() < n_nodes + 1)
          {
            if (line.back() != ',')
              refuse(meaning);
            return;
          }
        if (rest.size() > n_nodes + 1)
          refuse(meaning);
        MeshText::Element element{rest[0], {}, {}};
        auto             &all = result.elements[is_line ? 1 : 2];
        if (!elements.emplace(rest[0], ElementAt{is_line ? 1U : 2U, all.size()})
               .second)
          refuse("another element number: this one has occurred before");
        // the corners come first
        const unsigned int n_corners =
          (n_nodes % 3 == 0 && n_nodes < 9 ? 3 : std::min(n_nodes, 4U));
        for (unsigned int i = 0; i < n_corners; ++i)
          {
            const auto node = result.node_of_number.find(rest[1 + i]);
            if (node == result.node_of_number.end())
              refuse("nodes that have been given before");
            element.corners.push_back(node->second);
          }
        if (!set.empty())
          element_sets[set].push_back(rest[0]);
        all.push_back(element);
        rest.clear();
      }

      void
      read_set()
      {
        const std::string meaning = "numbers or names of a set";
        auto             &sets = (keyword == "NSET" ? node_sets : element_sets);
        auto             &items = sets[set];
        const auto        cells = split_cells(line, ',');
        if (generate)
          {
            if (cells.size() < 2)
              refuse("first and last number of a set, and the step");
            const std::size_t first = index_in(cells[0], meaning),
                              last  = index_in(cells[1], meaning),
                              step  = cells.size() > 2 && !cells[2].empty()
                                        ? index_in(cells[2], meaning)
                                        : 1;
            if (step == 0 || last < first || (last - first) / step > 100000000)
              refuse("first and last number of a set, and the step");
            for (std::size_t i = first; i <= last; i += step)
              items.push_back(i);
            return;
          }
        for (const std::string &cell : cells)
          {
            if (cell.empty())
              continue;
            if (std::isdigit(static_cast<unsigned char>(cell[0])))
              {
                items.push_back(index_in(cell, meaning));
                continue;
              }
            const auto other = sets.find(in_capitals(cell));
            if (other == sets.end())
              refuse("numbers, or names of sets that have been given before");
            // a set may be added to itself, whose numbers would move meanwhile
            const std::vector<std::size_t> copy = other->second;
            items.insert(items.end(), copy.begin(), copy.end());
          }
      }

      /** Turn the sets of numbers into those of the mesh. Numbers of other
       * elements and nodes, such as those of a coarser part, are left out. */
      void
      finish()
      {
        for (const auto &[set_name, numbers] : node_sets)
          {
            auto &nodes = result.node_sets[set_name];
            for (const std::size_t node : numbers)
              {
                const auto known = result.node_of_number.find(node);
                if (known == result.node_of_number.end())
                  throw InputError("the mesh '" + name + "': the set '" +
                                   set_name + "' has the node " +
                                   std::to_string(node) +
                                   ", which does not exist.");
                nodes.push_back(known->second);
              }
          }
        long group = 0;
        for (const auto &[set_name, numbers] : element_sets)
          {
            // its sides and its cells are two groups of the same number
            ++group;
            for (const std::size_t element : numbers)
              {
                const auto known = elements.find(element);
                if (known == elements.end())
                  throw InputError("the mesh '" + name + "': the set '" +
                                   set_name + "' has the element " +
                                   std::to_string(element) +
                                   ", which does not exist.");
                const auto [dimension, position] = known->second;
                if (dimension == 1 && sets_of_sections.count(set_name) > 0)
                  throw InputError("the mesh '" + name + "': the set '" +
                                   set_name +
                                   "' has trusses with a section, but only "
                                   "shells are possible.");
                result.names[{dimension, group}] = set_name;
                result.elements[dimension][position].groups.push_back(group);
              }
          }
      }

      const std::string        name;
      std::istringstream       lines;
      std::string              line;
      std::size_t              number = 0;
      std::string              keyword;
      std::vector<std::string> parameters;
      /** The name of the set of the keyword. */
      std::string  set;
      bool         generate = false, is_line = false;
      unsigned int n_parts = 0, n_nodes = 0;
      /** What is read of an element so far. */
      std::vector<std::size_t> rest;

      MeshText result;
      /** The dimension of an element, and its position among those of it. */
      struct ElementAt
      {
        unsigned int dimension;
        std::size_t  position;
      };
      std::map<std::size_t, ElementAt>                elements;
      std::set<std::string>                           sets_of_sections;
      std::map<std::string, std::vector<std::size_t>> node_sets, element_sets;
    };
  } // namespace


  MeshText
  read_abaqus(const std::string &text, const std::string &name)
  {
    return AbaqusReader(text, name).read();
  }
} // namespace Biface
