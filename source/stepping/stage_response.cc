// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <set>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_loads.h>
#include <biface/stepping/stage_response.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    parse_excitations(const std::string &entry, const std::string &text)
    {
      std::vector<std::string> result;
      for (const std::string &item : split_list(entry, text, ',', 100))
        {
          std::string words;
          for (const std::string &word : split_words(item))
            words += (words.empty() ? "" : " ") + word;
          result.push_back(words);
        }
      return result;
    }


    std::vector<double>
    parse_frequencies(const std::string &entry, const std::string &text)
    {
      if (split_words(text).empty())
        return {};
      return parse_values(entry,
                          text,
                          "it must be a list of frequencies, in which "
                          "'first:last:number' stands for so many",
                          100000);
    }
  } // namespace


  std::optional<std::pair<std::string, unsigned int>>
  StageResponse::motion(const std::string &excitation, const StageLoads &loads)
  {
    const std::size_t blank = excitation.rfind(' ');
    if (blank == std::string::npos || blank + 2 != excitation.size())
      return {};
    const std::size_t direction =
      std::string("xyz").find(excitation[blank + 1]);
    const std::string body = excitation.substr(0, blank);
    if (direction == std::string::npos ||
        (body != "ground" && body != "supports" &&
         std::find(loads.bodies.begin(), loads.bodies.end(), body) ==
           loads.bodies.end()))
      return {};
    return std::make_pair(body, static_cast<unsigned int>(direction));
  }


  bool
  StageResponse::is_excited_by(const std::string &name) const
  {
    return std::find(excitations.begin(), excitations.end(), name) !=
           excitations.end();
  }


  void
  StageResponse::complete(StageLoads &loads) const
  {
    for (const std::string &name : excitations)
      {
        if (motion(name, loads) || name == "pressure" || name == "load factor")
          continue;
        // the factor of the longest name that includes these loads, or the
        // common one
        std::optional<double> factor  = loads.common_factor;
        std::size_t           longest = 0;
        bool                  has_own = false;
        for (const auto &[other, of_other] : loads.own_factors)
          {
            has_own = has_own || other == name;
            if (name.rfind(other + " ", 0) == 0 && other.size() > longest)
              {
                longest = other.size();
                factor  = of_other;
              }
          }
        if (!has_own)
          loads.own_factors.emplace_back(name, factor);
      }
  }


  void
  StageResponse::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(
      prm,
      "Frequency response",
      "",
      frequencies,
      parse_frequencies,
      "Frequencies at which the steady response of the loaded shell to "
      "'Excitations' is computed at the end of the stage: a list of numbers, in "
      "which 'first:last:number' stands for so many equidistant ones: "
      "'5:300:296'. Each takes the time of a few factorizations. Losses are "
      "those of 'Loss factor', here and of the materials, of 'Relaxation "
      "times', 'Mass damping' and 'Stiffness damping'. See 'Modes' for the "
      "nodes in contact. All plies need a 'Density'.",
      Unit("1/time") | RestartChange::within_stage);
    add_parsed(
      prm,
      "Excitations",
      "",
      excitations,
      parse_excitations,
      "What shakes the shell in 'Frequency response', each with the amplitude "
      "1 and on its own: a list of motions of 'ground', of 'supports', all of "
      "them together, or of one of 'Bodies', followed by x, y or z, and of "
      "loads, 'pressure', 'load factor' or one of 'Load factors': 'ground z, "
      "supports x, load factor'.",
      RestartChange::within_stage);
    prm.add_parameter("Loss factor",
                      loss_factor,
                      "Part of the whole stiffness that is imaginary in "
                      "'Frequency response', with that of prestress and "
                      "contact: structural damping. It adds to the losses of "
                      "the materials.",
                      Patterns::Double(),
                      Unit::none() | RestartChange::within_stage);
  }


  void
  StageResponse::check(const std::string &section) const
  {
    check_not_negative(section + "/Loss factor", loss_factor);
    check_at_most(section + "/Loss factor", loss_factor, 2);
    for (const double frequency : frequencies)
      check_not_negative(section + "/Frequency response", frequency);
    if (!vibrates())
      {
        if (!excitations.empty())
          throw InputError(section + "/Excitations",
                           excitations[0],
                           "it needs a 'Frequency response'");
        if (loss_factor > 0)
          throw InputError(section + "/Loss factor",
                           number_to_string(loss_factor),
                           "it needs a 'Frequency response'");
        return;
      }
    if (excitations.empty())
      throw InputError(section + "/Excitations",
                       "",
                       "it must not be empty with a 'Frequency response': "
                       "'ground z' or 'load factor', for example");
    std::set<std::string> names;
    for (const std::string &name : excitations)
      if (!names.insert(name).second)
        throw InputError(section + "/Excitations", name, "it is named twice");
  }
} // namespace Biface
