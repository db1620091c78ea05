// SPDX-License-Identifier: LGPL-2.1-or-later

// Interval lists give the specified grid lines: equal, graded by a ratio, or
// continuing the cell sizes of their neighbor, between numbers or formulas of
// the end of the surface.

#include <deal.II/base/numbers.h>

#include <biface/surface/intervals.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  compare(const std::string         &what,
          const std::vector<double> &lines,
          const std::vector<double> &expected)
  {
    check_true(what + ", number of lines", lines.size() == expected.size());
    double deviation = 0;
    for (unsigned int i = 0; i < std::min(lines.size(), expected.size()); ++i)
      deviation = std::hypot(deviation, std::abs(lines[i] - expected[i]));
    check_small(what, deviation, 1e-12);
  }
} // namespace


int
main()
{
  compare("equal",
          parse_intervals("entry", "-1:3:4").lines(0.5),
          {-0.5, 0, 0.5, 1, 1.5});
  compare("graded", parse_intervals("entry", "0:7:3:2").lines(1), {0, 1, 3, 7});
  compare("graded the other way",
          parse_intervals("entry", "0:7:3:0.5").lines(1),
          {0, 4, 6, 7});
  compare("adjoining",
          parse_intervals("entry", "0:2:2, 2:9:3:2").lines(1),
          {0, 1, 2, 3, 5, 9});
  // 2 + 4 + 8 = 14: the ratio 2 continues cells of length 1
  compare("smooth on the right",
          parse_intervals("entry", "0:1:1, 1:15:3:smooth").lines(1),
          {0, 1, 3, 7, 15});
  compare("smooth on the left",
          parse_intervals("entry", "-14:0:3:smooth, 0:3:2:2").lines(1),
          {-14, -6, -2, 0, 1, 3});
  compare("smooth and shrinking",
          parse_intervals("entry", "0:8:1, 8:15:3:smooth").lines(1),
          {0, 8, 12, 14, 15});
  compare("smooth and equal",
          parse_intervals("entry", "0:2:1, 2:6:2:smooth").lines(1),
          {0, 2, 4, 6});

  compare("up to the end",
          parse_intervals("entry",
                          "-end:-0.5*end:1, -0.5*end:0.5*end:2, "
                          "0.5*end:end:2:smooth")
            .on(14)
            .lines(1),
          parse_intervals("entry", "-14:-7:1, -7:7:2, 7:14:2:smooth").lines(1));

  // the bias tire: 18 cells of 5/3 degrees, then (5/3) q^k, k = 1, ..., 11,
  // fill 165 degrees to each side
  const double degree = numbers::PI / 180;
  const auto   tire =
    parse_intervals("entry", "-180:-15:11:smooth, -15:15:18, 15:180:11:smooth")
      .lines(degree);
  check_true("the tire has 41 lines", tire.size() == 41);
  const double q = (tire[31] - tire[30]) / (tire[30] - tire[29]);
  check_small("ratio of the tire", q - 1.3471, 5e-5);
  double sum = 0, kink = 0, asymmetry = 0;
  for (unsigned int k = 1; k <= 11; ++k)
    {
      sum += 5. / 3 * std::pow(q, k);
      kink = std::hypot(kink,
                        std::abs((tire[29 + k] - tire[28 + k]) / degree -
                                 5. / 3 * std::pow(q, k)));
    }
  for (unsigned int i = 0; i < 41; ++i)
    asymmetry = std::hypot(asymmetry, std::abs(tire[i] + tire[40 - i]));
  check_small("sum of the growing cells, degrees", sum - 165, 1e-10);
  check_small("their lengths are geometric, degrees", kink, 1e-10);
  check_small("both sides are alike", asymmetry, 1e-13);
  check_small(
    "a full turn", tire.back() - tire.front() - 2 * numbers::PI, 1e-14);
}
