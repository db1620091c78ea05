// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <biface/base/errors.h>
#include <biface/input/coordinate.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/intervals.h>

#include <boost/math/tools/roots.hpp>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int max_cells = 1000000;

    /** @return whether start and end are known: if they depend on `end`, only
     * if this is given. */
    bool
    parse_interval(const std::string           &entry,
                   const std::string           &text,
                   const std::optional<double> &end,
                   Interval                    &interval,
                   bool                        &smooth)
    {
      const std::string form = "each interval must have the form "
                               "start:end:cells, start:end:cells:ratio or "
                               "start:end:cells:smooth";

      const std::vector<std::string> parts =
        Utilities::split_string_list(text, ':');
      if (parts.size() < 3 || parts.size() > 4)
        throw InputError(entry, text, form);

      interval.text = text;
      const Coordinate from(entry, parts[0], text, form);
      const Coordinate to(entry, parts[1], text, form);
      const bool       known = end || !(from.uses_end() || to.uses_end());
      if (known)
        {
          interval.start = from.value(end.value_or(0));
          interval.end   = to.value(end.value_or(0));
          if (!(interval.end > interval.start))
            throw InputError(
              entry,
              text,
              "the end of an interval must be greater than its start");
        }

      const double n = parse_number(entry, parts[2], form);
      if (!(n >= 1 && n <= max_cells && n == std::floor(n)))
        throw InputError(entry,
                         text,
                         "an interval must have a whole number of cells from "
                         "1 to " +
                           std::to_string(max_cells));
      interval.n_cells = static_cast<unsigned int>(n);

      smooth = (parts.size() == 4 && parts[3] == "smooth");
      if (parts.size() == 4 && !smooth)
        {
          interval.ratio = parse_number(entry, parts[3], form);
          if (!(interval.ratio >= 0.01 && interval.ratio <= 100))
            throw InputError(entry,
                             text,
                             "the ratio of neighboring cells must lie "
                             "between 0.01 and 100");
          constexpr double longest = 1e10;
          // by logarithms, since the power may exceed all numbers
          if (std::abs(std::log(interval.ratio)) * (n - 1) > std::log(longest))
            throw InputError(entry,
                             text,
                             "the longest cell of an interval must not "
                             "exceed 1e10 times the shortest");
        }
      return known;
    }


    /**
     * The ratio q for which cells of the lengths l q, l q^2, ..., l q^n fill
     * the given length.
     */
    double
    smooth_ratio(const double length, const unsigned int n, const double l)
    {
      const auto excess = [&](const double log_q) {
        double sum = 0;
        for (unsigned int k = 1; k <= n; ++k)
          sum += std::exp(k * log_q);
        // the solver needs finite numbers
        return std::min(sum, 1e200) - length / l;
      };
      // the sum lies between q and n q^n for q >= 1, and below n q otherwise
      const double bound = std::log(length / l);
      const double lower = std::min(bound - std::log(n), 0.) - 1;
      const double upper = std::max(bound, 0.) + 1;

      std::uintmax_t max_iterations = 200;
      const auto     bracket        = boost::math::tools::toms748_solve(
        excess,
        lower,
        upper,
        boost::math::tools::eps_tolerance<double>(52),
        max_iterations);
      return std::exp((bracket.first + bracket.second) / 2);
    }


    void
    resolve_smooth(const std::string       &entry,
                   const std::vector<bool> &smooth,
                   std::vector<Interval>   &intervals)
    {
      for (unsigned int i = 0; i < intervals.size(); ++i)
        if (smooth[i])
          {
            Interval    &interval = intervals[i];
            const double length   = interval.end - interval.start;
            // from the cells on the left if these are given; from those on the
            // right the ratio is that of the other direction
            if (i > 0 && !smooth[i - 1])
              interval.ratio = smooth_ratio(
                length,
                interval.n_cells,
                intervals[i - 1].cell_length(intervals[i - 1].n_cells - 1));
            else if (i + 1 < intervals.size() && !smooth[i + 1])
              interval.ratio =
                1 / smooth_ratio(length,
                                 interval.n_cells,
                                 intervals[i + 1].cell_length(0));
            else
              throw InputError(entry,
                               interval.text,
                               "'smooth' needs an adjoining interval whose "
                               "cells are given");
          }
    }
  } // namespace


  double
  Interval::cell_length(const unsigned int i) const
  {
    // the sum of a geometric series is the whole length
    const double sum =
      (ratio == 1 ? n_cells : (std::pow(ratio, n_cells) - 1) / (ratio - 1));
    return (end - start) / sum * std::pow(ratio, i);
  }


  std::vector<double>
  IntervalList::lines(const double unit) const
  {
    Assert(!intervals.empty(), ExcMessage("The coordinates depend on 'end'."));
    std::vector<double> lines(1, intervals.front().start * unit);
    for (const Interval &interval : intervals)
      {
        double line = interval.start;
        for (unsigned int i = 0; i + 1 < interval.n_cells; ++i)
          {
            if (interval.ratio == 1)
              line = interval.start + (interval.end - interval.start) *
                                        (i + 1.) / interval.n_cells;
            else
              line += interval.cell_length(i);
            lines.push_back(line * unit);
          }
        // exactly, so that the next interval starts at the same line
        lines.push_back(interval.end * unit);
      }
    return lines;
  }


  namespace
  {
    IntervalList
    parse(const std::string           &entry,
          const std::string           &text,
          const std::optional<double> &end)
    {
      IntervalList           list;
      std::vector<Interval> &intervals = list.intervals;
      list.entry                       = entry;
      list.text                        = text;
      unsigned int      n_cells        = 0;
      std::vector<bool> is_smooth;
      bool              known = true;
      for (const std::string &item : split_list(entry, text))
        {
          bool smooth = false;
          intervals.emplace_back();
          if (!parse_interval(entry, item, end, intervals.back(), smooth))
            known = false;
          is_smooth.push_back(smooth);
          n_cells += intervals.back().n_cells;
          if (n_cells > max_cells)
            throw InputError(entry,
                             text,
                             "it must have at most " +
                               std::to_string(max_cells) + " cells in total");
        }
      if (intervals.empty())
        throw InputError(entry, text, "it must contain at least one interval");
      // lengths that depend on 'end' are checked when the surface is known
      if (!known)
        {
          intervals.clear();
          return list;
        }

      for (unsigned int i = 1; i < intervals.size(); ++i)
        if (intervals[i].start != intervals[i - 1].end)
          throw InputError(
            entry,
            text,
            "each interval must start at the end of the previous "
            "one: '" +
              intervals[i].text +
              (intervals[i].start < intervals[i - 1].end
                 ? "' overlaps '"
                 : "' leaves a gap after '") +
              intervals[i - 1].text + "'");
      resolve_smooth(entry, is_smooth, intervals);

      const std::vector<double> lines = list.lines();
      for (unsigned int i = 1; i < lines.size(); ++i)
        if (!(lines[i] - lines[i - 1] > 1e-9 * (lines.back() - lines.front())))
          throw InputError(
            entry,
            text,
            "each cell must be longer than 1e-9 of the total length");
      return list;
    }
  } // namespace


  IntervalList
  parse_intervals(const std::string &entry, const std::string &text)
  {
    return parse(entry, text, {});
  }


  IntervalList
  IntervalList::on(const double end) const
  {
    return parse(entry, text, end);
  }
} // namespace Biface
