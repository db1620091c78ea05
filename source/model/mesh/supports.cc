// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::array<double, 2> inner_only{{1, 0}};
    const std::array<double, 2> outer_only{{0, 1}};
    const std::array<double, 2> middle{{0.5, 0.5}};
    const std::array<double, 2> difference{{-1, 1}};


    std::string
    join(const std::vector<std::string> &words)
    {
      std::string text;
      for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
      return text;
    }
  } // namespace


  void
  Supports::add_parameters(EntryDeclarations &prm)
  {
    for (unsigned int edge = 0; edge < 4; ++edge)
      add_parsed(
        prm,
        edge_names[edge],
        "free",
        edges[edge],
        [this, edge](const std::string &entry, const std::string &text) {
          // no condition of one edge, but a coupling of both
          cyclic[edge] = (edge / 2 == 1 && text == "cyclic");
          return cyclic[edge] ? std::vector<SupportCondition>()
                              : parse_support(entry, text, edge / 2);
        },
        "Support of the edge " + edge_names[edge] +
          ": 'free', 'fixed', 'hinged' (the middle surface), 'hinged inner', "
          "'hinged outer', 'symmetry' (no displacement normal to the edge), " +
          (edge / 2 == 1
             ? "'cyclic' (both edges of alpha_2: the same displacements in the "
               "frames of both, for shells that repeat along alpha_2), "
             : "") +
          "or a list, separated by semicolons, of 'COMPONENT FACE' or "
          "'COMPONENT FACE = value'. COMPONENT is one of v_1, v_2, v_3 (in "
          "the frame of the coordinate lines), x, y, z, and, for a surface of "
          "revolution, radial, axial (along y), circumferential (along "
          "alpha_2), in the undeformed shell; FACE is one of inner, outer, "
          "both (and those between layers), middle, difference (outer minus "
          "inner). A value is a number, or a formula of the undeformed "
          "position x, y, z of the face and of alpha_1, alpha_2: 'axial both = "
          "-0.01*x' tilts an edge by 0.01 radians. Values are multiplied by "
          "the load factor of the stage, see 'Load factors'. A closed "
          "coordinate has no edges; leave them 'free'.",
        Unit("length"));
    add_parsed(prm,
               "Edge supports",
               "",
               named_edges,
               parse_edge_supports,
               "Supports of the edges of a surface of type 'mesh', its groups "
               "of lines: a comma-separated list of 'name: support', with "
               "supports as for edges, but 'symmetry x', 'symmetry y' or "
               "'symmetry z' for an edge in a plane of symmetry normal to this "
               "direction, to which the shell is normal.",
               Unit("length"));
    add_parsed(prm,
               "Point supports",
               "",
               points,
               parse_point_supports,
               "Supports of named points: a comma-separated list of 'name: "
               "support', with supports as for edges.");
    suspensions.add_parameters(
      prm,
      "names in 'Forces on bodies', such as 'supports' "
      "or 'supports alpha_1 min', for one support with "
      "its images in planes of symmetry at its ends, "
      "as its force in history.csv");
  }


  std::vector<SupportCondition>
  parse_support(const std::string &entry,
                const std::string &text,
                const unsigned int across)
  {
    const auto all_components = [](const std::array<double, 2> &c) {
      return std::vector<SupportCondition>{
        {Component::v_1, c, 0}, {Component::v_2, c, 0}, {Component::v_3, c, 0}};
    };
    // two conditions, one on each outermost face; faces between layers are held
    // along with the outer one
    const auto both = [](std::vector<SupportCondition> conditions) {
      const unsigned int n = conditions.size();
      for (unsigned int i = 0; i < n; ++i)
        {
          conditions[i].holds_all_faces = true;
          conditions.push_back(conditions[i]);
          conditions[i].coefficients     = inner_only;
          conditions.back().coefficients = outer_only;
        }
      return conditions;
    };

    if (text == "free")
      return {};
    if (text == "fixed")
      return both(all_components(inner_only));
    if (text == "hinged")
      return all_components(middle);
    if (text == "hinged inner")
      return all_components(inner_only);
    if (text == "hinged outer")
      return all_components(outer_only);
    // only an edge has a direction across
    if (text == "symmetry" && across < 3)
      return both({{static_cast<Component>(across), inner_only, 0}});

    const std::string form =
      std::string("it must be 'free', 'fixed', 'hinged', 'hinged inner', "
                  "'hinged outer'") +
      (across < 3 ? ", 'symmetry'" : "") + (across == 1 ? ", 'cyclic'" : "") +
      ", or a list like 'v_1 both; axial middle = 0.5' (components: " +
      join(component_names()) +
      "; faces: inner, outer, both, middle, difference)";

    std::vector<SupportCondition> conditions;
    for (const std::string &item : split_list(entry, text, ';'))
      {
        const auto                     equals = item.find('=');
        const std::vector<std::string> words =
          split_words(item.substr(0, equals));
        const std::string value_text =
          (equals == std::string::npos
             ? "0"
             : dealii::Utilities::trim(item.substr(equals + 1)));
        double                 value = 0;
        std::optional<Formula> formula;
        if (value_text.empty())
          throw InputError(entry, text, form);
        if (Patterns::Double().match(value_text))
          value = parse_number(entry, value_text, form);
        else
          formula = parse_position_formula(entry, value_text);
        if (words.size() != 2)
          throw InputError(entry, text, form);
        const auto &names = component_names();
        const auto  name  = std::find(names.begin(), names.end(), words[0]);
        if (name == names.end())
          throw InputError(entry, text, form);

        SupportCondition condition{static_cast<Component>(name - names.begin()),
                                   inner_only,
                                   value,
                                   equals != std::string::npos};
        condition.formula = formula;
        const std::map<std::string, std::array<double, 2>> faces{
          {"inner", inner_only},
          {"outer", outer_only},
          {"middle", middle},
          {"difference", difference}};
        if (words[1] == "both")
          for (const SupportCondition &c : both({condition}))
            conditions.push_back(c);
        else if (faces.count(words[1]))
          {
            condition.coefficients = faces.at(words[1]);
            conditions.push_back(condition);
          }
        else
          throw InputError(entry, text, form);
      }
    if (conditions.empty())
      throw InputError(entry, text, form);
    return conditions;
  }


  namespace
  {
    /** The name and the support of an item of a list. */
    std::pair<std::string, std::string>
    split_support(const std::string &entry, const std::string &item)
    {
      return split_named(
        entry, item, "each support must have the form 'name: support'");
    }
  } // namespace


  std::vector<EdgeSupport>
  parse_edge_supports(const std::string &entry, const std::string &text)
  {
    const std::vector<std::string> planes{
      "symmetry x", "symmetry y", "symmetry z"};
    std::vector<EdgeSupport> supports;
    for (const std::string &item : split_list(entry, text))
      {
        const auto  named = split_support(entry, item);
        EdgeSupport support{named.first, item, {}, {}};
        const auto  plane =
          std::find(planes.begin(), planes.end(), named.second);
        if (plane != planes.end())
          {
            support.symmetry = plane - planes.begin();
            support.conditions =
              parse_support(entry, named.second.substr(9) + " both", 3);
          }
        else if (named.second == "symmetry")
          throw InputError(entry,
                           item,
                           "the direction normal to the plane of symmetry is "
                           "needed: 'symmetry x', 'symmetry y' or 'symmetry "
                           "z'");
        else
          support.conditions = parse_support(entry, named.second, 3);
        supports.push_back(support);
      }
    return supports;
  }


  std::vector<PointSupport>
  parse_point_supports(const std::string &entry, const std::string &text)
  {
    std::vector<PointSupport> supports;
    for (const std::string &item : split_list(entry, text))
      {
        const auto named = split_support(entry, item);
        supports.push_back(
          {named.first, parse_support(entry, named.second, 3)});
      }
    return supports;
  }


  bool
  Supports::is_symmetric(const unsigned int edge) const
  {
    if (edges[edge].size() != 2)
      return false;
    std::array<bool, 2> held{{false, false}};
    for (const SupportCondition &condition : edges[edge])
      for (unsigned int face = 0; face < 2; ++face)
        if ((condition.component == static_cast<Component>(edge / 2) ||
             (edge / 2 == 1 &&
              condition.component == Component::circumferential)) &&
            condition.value == 0 && !condition.formula &&
            condition.coefficients[face] == 1 &&
            condition.coefficients[1 - face] == 0)
          held[face] = true;
    return held[0] && held[1];
  }


  void
  Supports::check() const
  {
    for (unsigned int edge = 2; edge < 4; ++edge)
      if (cyclic[edge] && !cyclic[5 - edge])
        throw InputError(
          "Supports/" + edge_names[edge],
          "cyclic",
          "then the other edge of alpha_2 must be 'cyclic', too");
  }
} // namespace Biface
