// SPDX-License-Identifier: LGPL-2.1-or-later

// Cords with a measured curve have its forces at the stretches of its rows,
// with an energy and a modulus that fit; a straight curve is that of cords with
// the same modulus; and a table that is none is refused.

#include <cmath>

#include <biface/base/errors.h>
#include <biface/laminate/cord_law.h>
#include <biface/laminate/force_curve.h>
#include <biface/laminate/material_parameters.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  using Rows = std::vector<dealii::Point<2>>;

  // of nylon, invented
  const Rows nylon{{1, 0}, {1.02, 8}, {1.05, 15}, {1.1, 33}, {1.15, 70}};

  MaterialParameters
  material()
  {
    MaterialParameters result;
    result.name                     = "ply";
    result.type                     = MaterialParameters::Type::cord_and_rubber;
    result.matrix                   = MaterialParameters::Matrix::neo_Hooke;
    result.cord_and_rubber.E_rubber = 6;
    result.cord_and_rubber.cord_diameter = 0.6;
    result.cord_and_rubber.cord_pitch    = 1;
    return result;
  }

  PairsFile
  file(const Rows &rows)
  {
    return {"nylon.csv", rows};
  }

  double
  green(const double stretch)
  {
    return (stretch * stretch - 1) / 2;
  }
} // namespace


int
main()
{
  constexpr double v = 0.25;
  {
    MaterialParameters measured     = material();
    measured.cord_and_rubber.curve  = file(nylon);
    MaterialParameters straight     = material();
    straight.cord_and_rubber.E_cord = measured.cord_and_rubber.cord_modulus();
    const auto   law = measured.laws(v).cords, line = straight.laws(v).cords;
    const double n    = v / measured.cord_and_rubber.cord_area();
    const double rise = ForceCurve(file(nylon)).initial_slope();
    for (const auto &row : nylon)
      {
        const double stretch = row[0], e = green(stretch);
        // the rubber has the rest, and is the same in both
        const double force =
          rise * (stretch - 1) +
          stretch * (law->response(e).stress - line->response(e).stress) / n;
        check_small("force at a row", force - row[1], 1e-12, 70);
      }
    for (const double stretch : {0.97, 0.999, 1.001, 1.013, 1.04, 1.13, 1.3})
      {
        const double e = green(stretch), by = 1e-6;
        const auto above = law->response(e + by), below = law->response(e - by),
                   at = law->response(e);
        check_small("stress",
                    (above.energy - below.energy) / (2 * by) - at.stress,
                    1e-7,
                    std::abs(at.stress));
        check_small("modulus",
                    (above.stress - below.stress) / (2 * by) - at.modulus,
                    1e-7,
                    std::abs(at.modulus));
        check_small("compression",
                    stretch < 1 ? at.stress - line->response(e).stress : 0.,
                    1e-14,
                    std::abs(at.stress));
      }
  }

  {
    MaterialParameters measured = material();
    measured.cord_and_rubber.curve =
      file({{1, 0}, {1.01, 7}, {1.05, 35}, {1.1, 70}});
    MaterialParameters straight = material();
    straight.cord_and_rubber.E_cord =
      700 / straight.cord_and_rubber.cord_area();
    const auto law = measured.laws(v), line = straight.laws(v);
    check_small("initial stiffness",
                (law.stiffness - line.stiffness).norm(),
                1e-12,
                line.stiffness.norm());
    for (const double stretch : {0.9, 1.003, 1.07, 1.2})
      check_small("straight curve",
                  law.cords->response(green(stretch)).stress -
                    line.cords->response(green(stretch)).stress,
                  1e-12,
                  std::abs(line.cords->response(green(stretch)).stress));
  }

  for (const Rows &rows : {Rows{{1, 0}, {1.1, 1}, {1.2, 2}},
                           Rows{{1, 1}, {1.1, 2}, {1.2, 3}, {1.3, 4}},
                           Rows{{1, 0}, {1.1, 2}, {1.2, 1}, {1.3, 4}},
                           Rows{{1, 0}, {1.1, 1}, {1.1, 2}, {1.3, 4}}})
    try
      {
        ForceCurve curve(file(rows));
        std::cout << "FAILED, not refused" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
}
