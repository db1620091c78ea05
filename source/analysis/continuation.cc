// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <biface/analysis/continuation.h>
#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_loads.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Entries = std::vector<std::pair<std::string, std::string>>;

    /** Full names and values of all entries, in their order. */
    Entries
    entries_of(const std::string &text)
    {
      Entries            entries;
      std::istringstream lines(text);
      std::string        line, path;
      while (std::getline(lines, line))
        {
          line = Utilities::trim(line.substr(0, line.find('#')));
          if (line.rfind("subsection ", 0) == 0)
            path += Utilities::trim(line.substr(11)) + "/";
          else if (line == "end" && !path.empty())
            path.erase(path.find_last_of('/', path.size() - 2) + 1);
          else if (line.rfind("set ", 0) == 0)
            {
              const auto equals = line.find('=');
              entries.emplace_back(
                path + Utilities::trim(line.substr(4, equals - 4)),
                Utilities::trim(line.substr(equals + 1)));
            }
        }
      return entries;
    }


    /** The words and numbers of a value, ignoring insignificant blanks. */
    std::vector<std::string>
    words_of(const std::string &value)
    {
      return split_words(
        std::regex_replace(value, std::regex("[,;:@=]"), " $& "));
    }


    bool
    same_word(const std::string &a, const std::string &b)
    {
      if (a == b)
        return true;
      // 1e3 and 1000 are the same number
      char        *end_a = nullptr, *end_b = nullptr;
      const double x = std::strtod(a.c_str(), &end_a);
      const double y = std::strtod(b.c_str(), &end_b);
      return !a.empty() && !b.empty() && *end_a == 0 && *end_b == 0 && x == y;
    }


    bool
    same_value(const std::string &a, const std::string &b)
    {
      const auto x = words_of(a), y = words_of(b);
      return std::equal(x.begin(), x.end(), y.begin(), y.end(), same_word);
    }


    /** The run that is continued. */
    struct EarlierRun
    {
      const Progress &progress;
      /** Whether it has started the tire test. */
      bool in_tire_test;
      /** Whether it carries derivatives along. */
      bool has_derivatives;
    };


    /** Whether an entry may still change when a run is continued. */
    bool
    may_change(const EntryAttributes &entry, const EarlierRun &run)
    {
      const RestartChange change = entry.get_restart_change();
      switch (change)
        {
          case RestartChange::never:
            return false;
          case RestartChange::always:
            return true;
          case RestartChange::before_tire_test:
            return !run.in_tire_test;
          default:
            break;
        }
      Assert(entry.get_stage() > 0, ExcInternalError());
      const unsigned int stage = entry.get_stage() - 1;
      if (stage != run.progress.stage)
        return stage > run.progress.stage;
      // a restart does not know the settings of the perturbed runs
      return !run.progress.stage_begun ||
             (change == RestartChange::within_stage && !run.has_derivatives);
    }


    /** The names in an entry 'Load factors'. */
    std::set<std::string>
    names_in(const std::string &entry, const std::string &value)
    {
      std::set<std::string> names;
      for (const auto &factor : parse_load_factors(entry, value))
        names.insert(factor.first);
      return names;
    }


    /** Refuse other names in the entry 'Load factors' of a stage that has
     * begun: where its loads are on their way is only known for those. */
    void
    check_named_loads(const Progress                           &progress,
                      const std::map<std::string, std::string> &before,
                      const std::string                        &entry,
                      const std::string                        &now)
    {
      const auto old = before.find(entry);
      if (!progress.stage_begun || old == before.end() ||
          entry !=
            "Stage " + std::to_string(progress.stage + 1) + "/Load factors" ||
          names_in(entry, old->second) == names_in(entry, now))
        return;
      throw InputError(entry,
                       now,
                       "the run to be continued is in this stage with '" +
                         old->second +
                         "', so that only the numbers may change");
    }


    std::string
    in_quotes(const std::string &text)
    {
      return "'" + (text.size() <= 200 ? text : text.substr(0, 197) + "...") +
             "'";
    }
  } // namespace


  void
  check_continuation(const std::string       &before,
                     const std::string       &now,
                     const AttributesByEntry &attributes,
                     const PairsByEntry      &files_before,
                     const PairsByEntry      &files_now,
                     const Progress          &progress)
  {
    std::map<std::string, std::string> values;
    for (const auto &entry : entries_of(before))
      values.insert(entry);
    // what perturbed runs went through cannot be changed afterward
    const auto derivatives = values.find("Sensitivities/Entries");
    const bool with_derivatives =
      derivatives != values.end() && !derivatives->second.empty();
    // the stages of a tire test follow those of the file
    const bool in_tire_test =
      values.count("Number of stages") > 0 &&
      progress.stage >= std::stoul(values["Number of stages"]);
    const EarlierRun run{progress, in_tire_test, with_derivatives};
    for (const auto &entry : entries_of(now))
      {
        const auto old = values.find(entry.first);
        if (entry.first == "Number of stages" && in_tire_test &&
            entry.second != old->second)
          throw InputError(entry.first,
                           entry.second,
                           "the run to be continued has started its tire test "
                           "after stage " +
                             old->second);
        if (entry.first == "Number of stages" && !in_tire_test &&
            std::stoul(entry.second) <= progress.stage)
          throw InputError(entry.first,
                           entry.second,
                           "the run to be continued has reached stage " +
                             std::to_string(progress.stage + 1));
        check_named_loads(progress, values, entry.first, entry.second);
        if (may_change(attributes.at(entry.first), run))
          continue;
        if (old == values.end())
          throw InputError("the entry " + in_quotes(entry.first) + " is " +
                           in_quotes(entry.second) +
                           ", but the run to be continued had no such entry.");
        if (!same_value(entry.second, old->second))
          throw InputError("the entry " + in_quotes(entry.first) + " is " +
                           in_quotes(entry.second) +
                           ", but the run to be continued had " +
                           in_quotes(old->second) + ".");
      }

    for (const auto &file : files_now)
      {
        // what they contain counts, not the text of the entry alone
        const auto old = files_before.find(file.first);
        if (old == files_before.end() || old->second != file.second)
          throw InputError("the file of the entry " + in_quotes(file.first) +
                           " differs from that of the run to be continued.");
      }
    for (const auto &file : files_before)
      if (files_now.count(file.first) == 0)
        throw InputError("the entry " + in_quotes(file.first) +
                         " names no file, but the run to be continued had "
                         "one.");
  }
} // namespace Biface
