// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_sample_states_h
#define biface_study_sample_states_h

#include <deque>
#include <memory>
#include <vector>

#include <biface/stepping/nested_predictor.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  /** The states of samples of a study, from which other samples start. */
  class SampleStates
  {
  public:
    /** The states in the steps of a sample. */
    struct Sample
    {
      /** The values of the design variables. */
      std::vector<double> values;
      ChartGrid           grid;
      NestedPredictor     states;
    };

    /** Add the states of a sample. Those of the first of many samples are
     * forgotten. */
    void
    add(std::unique_ptr<const Sample> sample);

    /** The nearest sample with the same grid; null if there is none.
     * @param scales the differences of values that count as much. */
    const Sample *
    nearest(const std::vector<double> &values,
            const ChartGrid           &grid,
            const std::vector<double> &scales) const;

  private:
    std::deque<std::unique_ptr<const Sample>> samples;
  };
} // namespace Biface

#endif
