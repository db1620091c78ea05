// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/surface/half_wave_series.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** More waves than any mesh can resolve. */
    constexpr unsigned int most_waves = 1000;


    unsigned int
    number_of_waves(const double number, const std::string &place)
    {
      if (number < 0 || number > most_waves || number != std::floor(number))
        throw InputError(place + " is " + number_to_string(number) +
                         ", but it must be a whole number from 0 to " +
                         std::to_string(most_waves) + ".");
      return static_cast<unsigned int>(number);
    }


    std::string
    term_text(const HalfWaveSeries::Term &term)
    {
      return "k = " + std::to_string(term.k) +
             ", l = " + std::to_string(term.l);
    }
  } // namespace


  HalfWaveSeries::HalfWaveSeries(const std::string &text,
                                 const std::string &name)
  {
    std::set<std::pair<unsigned int, unsigned int>> given;
    for (const auto &row :
         parse_rows(text,
                    name,
                    "each line must contain four numbers, 'k, l, A, B'",
                    4,
                    4))
      {
        const Term term{number_of_waves(row[0], name + ": the number k"),
                        number_of_waves(row[1], name + ": the number l"),
                        row[2],
                        row[3]};
        if (!given.emplace(term.k, term.l).second)
          throw InputError(name + ": the term " + term_text(term) +
                           " must not be given twice.");
        if (term.l == 0 && term.B != 0)
          throw InputError(name + ": B of the term " + term_text(term) +
                           " is " + number_to_string(term.B) +
                           ", but it must be 0, since it is the factor of "
                           "sin(0).");
        terms.push_back(term);
        n_waves = {
          {std::max(n_waves[0], term.k + 1), std::max(n_waves[1], term.l + 1)}};
      }
    if (terms.empty())
      throw InputError(name + ": there must be at least one term, 'k, l, A, "
                              "B'.");
  }


  double
  HalfWaveSeries::value(const double s, const double phi) const
  {
    std::vector<double> along(n_waves[0]), cosine(n_waves[1]), sine(n_waves[1]);
    for (unsigned int k = 0; k < along.size(); ++k)
      along[k] = std::cos(k * numbers::PI * s);
    for (unsigned int l = 0; l < cosine.size(); ++l)
      {
        cosine[l] = std::cos(l * phi);
        sine[l]   = std::sin(l * phi);
      }
    double sum = 0;
    for (const Term &term : terms)
      sum += along[term.k] * (term.A * cosine[term.l] + term.B * sine[term.l]);
    return sum;
  }


  void
  SectorOfShell::check(const HalfWaveSeries &series,
                       const std::string    &name) const
  {
    constexpr double round_off = 1e-9;
    const auto       refuse    = [&](const HalfWaveSeries::Term &term,
                            const std::string          &why) {
      throw InputError(name + ": the term " + term_text(term) + " " + why +
                       "; leave it out, or model the whole shell.");
    };
    for (const HalfWaveSeries::Term &term : series.get_terms())
      {
        const double size = std::hypot(term.A, term.B);
        if (size == 0)
          continue;
        // at a plane of symmetry the slope across it vanishes
        for (const double s : planes[0])
          if (std::abs(std::sin(term.k * numbers::PI * s)) > round_off)
            refuse(term,
                   "is not symmetric about the edge of alpha_1 with the "
                   "support 'symmetry'");
        for (const double phi : planes[1])
          if (std::abs(term.A * std::sin(term.l * phi) -
                       term.B * std::cos(term.l * phi)) > round_off * size &&
              term.l > 0)
            refuse(term,
                   "is not symmetric about the edge of alpha_2 with the "
                   "support 'symmetry'");
        if (std::abs(std::sin(term.l * period / 2)) > round_off)
          refuse(term,
                 "does not repeat after " +
                   coordinate_to_string(period * 180 / numbers::PI, 360) +
                   " degrees, but the edges of alpha_2 are cyclic");
      }
  }
} // namespace Biface
