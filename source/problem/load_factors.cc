// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/mesh/supports.h>
#include <biface/problem/parameters.h>

namespace Biface
{
  namespace
  {
    /** A load, or a prescribed displacement. */
    struct Item
    {
      /** The names in 'Load factors' that include it, from the most general one
       * to its own. */
      std::vector<std::string> names;
      /** The position of its factor. */
      unsigned int *factor;
    };


    /** All items with a factor. */
    std::vector<Item>
    items_of(DeadLoads                   &loads,
             Supports                    &supports,
             std::vector<BodyParameters> &bodies)
    {
      std::vector<Item> items;
      // by the name of their place
      std::map<std::string, unsigned int> numbers;
      const auto add_force = [&](const std::string &kind,
                                 const std::string &point_or_edge,
                                 unsigned int      &factor) {
        std::string place = kind;
        for (const std::string &word : split_words(point_or_edge))
          place += " " + word;
        // several loads at a place are told apart by their order in the file
        const unsigned int number = ++numbers[place];
        items.push_back(
          {{kind, place, place + " " + std::to_string(number)}, &factor});
      };
      for (PointForce &item : loads.point_forces)
        add_force("point forces", item.point, item.force.factor);
      for (EdgeForce &item : loads.edge_forces)
        add_force("edge forces", item.edge, item.force.factor);
      for (EdgeMoment &item : loads.edge_moments)
        add_force("edge moments", item.edge, item.factor);
      for (const auto face : {Resultants::inner, Resultants::outer})
        if (!loads.tractions[face].components.empty())
          items.push_back(
            {{face == Resultants::inner ? "inner traction" : "outer traction"},
             &loads.tractions[face].factor});
      if (loads.area_force.norm() > 0)
        items.push_back({{"area force"}, &loads.factor_of_area_force});

      const auto add_support = [&](const std::string             &point_or_edge,
                                   std::vector<SupportCondition> &conditions) {
        std::string place = "supports";
        for (const std::string &word : split_words(point_or_edge))
          place += " " + word;
        for (SupportCondition &condition : conditions)
          if (condition.is_prescribed)
            items.push_back({{"supports",
                              place,
                              place + " " +
                                component_names()[static_cast<unsigned int>(
                                  condition.component)]},
                             &condition.factor});
      };
      for (unsigned int edge = 0; edge < supports.edges.size(); ++edge)
        add_support(edge_names[edge], supports.edges[edge]);
      for (EdgeSupport &edge : supports.named_edges)
        add_support(edge.edge, edge.conditions);
      for (PointSupport &point : supports.points)
        add_support(point.point, point.conditions);

      for (BodyParameters &body : bodies)
        for (BodyMotion &motion : body.motions)
          items.push_back({{"bodies",
                            "bodies " + body.name,
                            "bodies " + body.name + " " + motion.name},
                           &motion.factor});
      return items;
    }


    /** The names of all items in words, or of those of one kind. */
    std::string
    in_words(const std::vector<Item> &items, const std::string &kind = "")
    {
      constexpr unsigned int limit = 20;

      std::vector<std::string> names;
      for (const Item &item : items)
        if (kind.empty() || item.names.front() == kind)
          for (const std::string &name : item.names)
            if (std::find(names.begin(), names.end(), name) == names.end())
              names.push_back(name);
      std::string text;
      for (unsigned int i = 0; i < names.size() && i < limit; ++i)
        text += (i == 0 ? "'" : ", '") + names[i] + "'";
      return text + (names.size() > limit ? ", ..." : "");
    }
  } // namespace


  std::vector<MotionByForce>
  Parameters::motions_by_force(
    const unsigned int i, const std::vector<std::string> &of_supports) const
  {
    const Stage      &stage = stages[i];
    const std::string entry =
      "Stage " + std::to_string(i + 1) + "/Forces on bodies";
    // the motions of the bodies that are there
    std::vector<MotionByForce> there, result;
    std::string                known;
    for (const BodyParameters &body : bodies)
      if (std::find(stage.bodies.begin(), stage.bodies.end(), body.name) !=
          stage.bodies.end())
        for (const BodyMotion &motion : body.motions)
          {
            there.push_back({body.name, motion, 0});
            there.back().motion.suspension = body.suspensions.of(motion.name);
            known += (known.empty() ? "'" : ", '") + there.back().name() + "'";
          }
    for (const std::string &name : of_supports)
      {
        BodyMotion motion;
        motion.name       = name;
        motion.suspension = supports.suspensions.of(name);
        there.push_back({"", motion, 0});
        known += (known.empty() ? "'" : ", '") + name + "'";
      }
    for (const auto &[name, force] : stage.forces_on_bodies)
      {
        const auto found =
          std::find_if(there.begin(),
                       there.end(),
                       [&, &wanted = name](const MotionByForce &motion) {
                         return motion.name() == wanted;
                       });
        if (found == there.end())
          throw InputError(entry,
                           name,
                           known.empty()
                             ? "no body of the stage has 'Motions', and no "
                               "support a prescribed displacement"
                             : "it must be a motion of a body of the stage, or "
                               "supports with a prescribed displacement: one "
                               "of " +
                                 known);
        if (!found->moves_supports() && found->motion.amplitude() == 0)
          throw InputError(entry, name, "this motion must not be zero");
        result.push_back(*found);
        result.back().force = force;
        for (const auto &own_factor : stage.own_factors)
          if (own_factor.first == found->name_of_factor())
            throw InputError("Stage " + std::to_string(i + 1) + "/Load factors",
                             own_factor.first,
                             "it must not be named, since 'Forces on bodies' "
                             "finds it");
      }
    return result;
  }


  void
  Parameters::check_suspensions_of_supports() const
  {
    const auto includes = [](const std::string &general,
                             const std::string &name) {
      return (name + " ").rfind(general + " ", 0) == 0;
    };
    for (const SuspensionParameters::Item &item : supports.suspensions.items())
      {
        const std::string &name  = item.name;
        const std::string  entry = "Supports/" + item.entry;
        if (std::none_of(stages.begin(), stages.end(), [&](const Stage &stage) {
              return stage.has_force(name);
            }))
          throw InputError(entry,
                           name,
                           "it must be a name in 'Forces on bodies' of a "
                           "stage, which finds the motion");
        // the same supports under another name would go without it
        for (unsigned int i = 0; i < stages.size(); ++i)
          for (const auto &[other, force] : stages[i].forces_on_bodies)
            if (!stages[i].has_force(name) &&
                (includes(name, other) || includes(other, name)))
              throw InputError(
                "Stage " + std::to_string(i + 1) + "/Forces on bodies",
                other,
                "it must have the name in '" + entry + "', '" + name + "'");
      }
  }


  void
  Parameters::assign_load_factors()
  {
    const std::vector<Item> items = items_of(loads, supports, bodies);
    const auto              entry = [](const unsigned int stage) {
      return "Stage " + std::to_string(stage + 1) + "/Load factors";
    };

    std::set<std::string>    known, motions;
    std::vector<std::string> of_supports;
    for (const Item &item : items)
      {
        for (const std::string &name : item.names)
          if (known.insert(name).second && item.names.front() == "supports")
            of_supports.push_back(name);
        // body 'a b' with the motion 'c', and body 'a' with 'b c'
        if (item.names.front() == "bodies" &&
            !motions.insert(item.names.back()).second)
          throw InputError("Bodies",
                           item.names.back().substr(7),
                           "two motions have this name, made of those of body "
                           "and motion; rename one");
      }

    supports.suspensions.check(
      "Supports",
      [&of_supports](const std::string &name) {
        return std::find(of_supports.begin(), of_supports.end(), name) !=
               of_supports.end();
      },
      of_supports.empty() ? "no support has a prescribed displacement"
                          : "it must be one of " + in_words(items, "supports"));

    // the positions of the factors, the same in every order of the stages
    std::map<std::string, unsigned int> positions;
    for (unsigned int i = 0; i < stages.size(); ++i)
      for (const auto &factor : stages[i].own_factors)
        {
          const std::string &name    = factor.first;
          const std::string  section = "Stage " + std::to_string(i + 1);
          if (known.count(name) == 0)
            throw InputError(
              stages[i].histories.has(name)   ? section + "/Load history"
              : stages[i].is_excited_by(name) ? section + "/Excitations"
                                              : entry(i),
              name,
              items.empty()
                ? "there are no loads, except the pressure, no "
                  "prescribed displacements and no motions of bodies"
                : std::string("it must be ") +
                    (stages[i].histories.has(name)
                       ? "'pressure', 'travel', 'turn', 'load factor' or "
                     : stages[i].is_excited_by(name)
                       ? "a motion such as 'ground z', 'pressure', 'load "
                         "factor' or "
                       : "") +
                    "one of " + in_words(items));
          positions[name] = 0;
        }
    check_suspensions_of_supports();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        stages[i].motions_by_force = motions_by_force(i, of_supports);
        for (const MotionByForce &motion : stages[i].motions_by_force)
          positions[motion.name_of_factor()] = 0;
      }
    // 0 is the common factor; names are in alphabetic order
    unsigned int last = 0;
    for (auto &position : positions)
      position.second = ++last;

    std::vector<std::vector<std::string>> names(1 + last);
    for (const Item &item : items)
      {
        std::vector<std::string> given;
        *item.factor = 0;
        for (const std::string &name : item.names)
          {
            const auto position = positions.find(name);
            if (position == positions.end())
              continue;
            given.push_back(name);
            *item.factor = position->second;
            // the same name for a point 'a b' and for component b of a point
            // 'a'
            if (!names[position->second].empty() &&
                names[position->second] != given)
              for (unsigned int i = 0; i < stages.size(); ++i)
                for (const auto &factor : stages[i].own_factors)
                  if (factor.first == name)
                    throw InputError(
                      entry(i),
                      name,
                      "several points or bodies have a load, support or "
                      "motion of this name; rename one");
            names[position->second] = given;
          }
      }
    for (Stage &stage : stages)
      {
        stage.set_factors(names);
        for (MotionByForce &motion : stage.motions_by_force)
          {
            // the control finds this factor, which no stage prescribes
            motion.motion.factor = positions.at(motion.name_of_factor());
            stage.factors[motion.motion.factor].reset();
          }
      }
  }
} // namespace Biface
