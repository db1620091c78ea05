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
  GreatestDeviation::add(const double                 deviation,
                         const std::array<double, 2> &curvature,
                         const Point<2>              &alpha)
  {
    const double k = std::max(std::abs(curvature[0]), std::abs(curvature[1]));
    worst          = std::min(
      worst, {{-std::abs(deviation) * k, alpha[0], alpha[1], deviation}});
  }


  void
  GreatestDeviation::check(const ReferenceSurface &surface,
                           const MPI_Comm          communicator) const
  {
    // the same place on all ranks, whatever the partition
    const auto by_rank = Utilities::MPI::all_gather(communicator, worst);
    const auto [part, alpha_1, alpha_2, deviation] =
      *std::min_element(by_rank.begin(), by_rank.end());
    if (-part <= allowed)
      return;
    const auto in_unit = [&](const unsigned int a, const double alpha) {
      // without round-off
      return coordinate_to_string(alpha / surface.coordinate_unit(a), 1e3);
    };
    const double radius = std::abs(deviation / part);
    throw InputError(
      "the section 'Surface/Imperfection' describes a deviation of " +
      number_to_string(deviation) + " at alpha_1 = " + in_unit(0, alpha_1) +
      ", alpha_2 = " + in_unit(1, alpha_2) + ", but it must be at most " +
      number_to_string(allowed) +
      " of the smaller radius of curvature there, which is " +
      number_to_string(radius) + ".");
  }
} // namespace Biface
