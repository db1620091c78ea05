// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_bias_tire_h
#define biface_tests_bias_tire_h

#include <vector>

#include "../run_analysis.h"

/** Run the shipped bias tire with some entries changed.
 * @return the reports of all steps. */
inline std::vector<Biface::StepReport>
run_bias_tire(const std::vector<Biface::Override> &overrides,
              const Observer                      &observer = {})
{
  return run_analysis(PRM_DIR "/bias_tire.prm", overrides, observer);
}

#endif
