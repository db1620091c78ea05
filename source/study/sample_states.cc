// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/study/sample_states.h>

namespace Biface
{
  namespace
  {
    /** Whether two grids have the same lines, up to their scale. */
    bool
    same(const ChartGrid &a, const ChartGrid &b)
    {
      return a.lines == b.lines && a.closed == b.closed;
    }
  } // namespace


  void
  SampleStates::add(std::unique_ptr<const Sample> sample)
  {
    // a few megabytes each on the meshes of tires
    constexpr std::size_t limit = 30;
    if (samples.size() == limit)
      samples.pop_front();
    samples.push_back(std::move(sample));
  }


  const SampleStates::Sample *
  SampleStates::nearest(const std::vector<double> &values,
                        const ChartGrid           &grid,
                        const std::vector<double> &scales) const
  {
    const Sample *result   = nullptr;
    double        smallest = std::numeric_limits<double>::infinity();
    for (const auto &sample : samples)
      {
        if (!same(sample->grid, grid))
          continue;
        double distance = 0;
        for (unsigned int i = 0; i < values.size(); ++i)
          // variables have different units
          distance += std::pow((sample->values[i] - values[i]) / scales[i], 2);
        // the last one of several
        if (distance <= smallest)
          {
            smallest = distance;
            result   = sample.get();
          }
      }
    return result;
  }
} // namespace Biface
