// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/greatest_deviation.h>

namespace Biface
{
  using namespace dealii;

  void
  GreatestDeviation::add(const double    deviation,
                         const double    curvature,
                         const Point<3> &x,
                         const Point<2> &alpha)
  {
    worst = std::min(worst,
                     {{-std::abs(deviation) * curvature,
                       x[0],
                       x[1],
                       x[2],
                       deviation,
                       alpha[0],
                       alpha[1]}});
  }


  void
  GreatestDeviation::check(const ReferenceSurface &surface,
                           const MPI_Comm          communicator) const
  {
    // the same place on all ranks, whatever the partition
    const auto by_rank = Utilities::MPI::all_gather(communicator, worst);
    const auto [part, x, y, z, deviation, alpha_1, alpha_2] =
      *std::min_element(by_rank.begin(), by_rank.end());
    if (-part <= allowed)
      return;
    const auto in_unit = [&surface](const unsigned int a, const double alpha) {
      // without round-off
      return coordinate_to_string(alpha / surface.coordinate_unit(a), 1e3);
    };
    const double size = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const auto   without_round_off = [size](const double coordinate) {
      return coordinate_to_string(coordinate, size);
    };
    const std::string place  = surface.has_chart()
                                 ? "alpha_1 = " + in_unit(0, alpha_1) +
                                    ", alpha_2 = " + in_unit(1, alpha_2)
                                 : "x, y, z = (" + without_round_off(x) + ", " +
                                    without_round_off(y) + ", " +
                                    without_round_off(z) + ")";
    const double      radius = std::abs(deviation / part);
    throw InputError(
      "the section 'Surface/Imperfection' describes a deviation of " +
      number_to_string(deviation) + " at " + place +
      ", but it must be at most " + number_to_string(allowed) +
      " of the smaller radius of curvature there, which is " +
      number_to_string(radius) + ".");
  }
} // namespace Biface
