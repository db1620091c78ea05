// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_bias_tire_h
#define biface_tests_bias_tire_h

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"

/** Run the shipped bias tire with some entries changed.
 * @return the reports of all steps. */
inline std::vector<Biface::StepReport>
run_bias_tire(const std::vector<Biface::Override> &overrides,
              const Observer                      &observer = {})
{
  return run_analysis(PRM_DIR "/bias_tire.prm", overrides, observer);
}


/** Three stages after the contact of 20 mm, each of which moves the ground a
 * little with the nodes glued to it: `fore-aft`, `lateral` and `torsion`. */
inline std::vector<Biface::Override>
glued_motions()
{
  return {"Number of stages=5",
          "Stage 3/Name=fore-aft",
          "Stage 3/Start from=2",
          "Stage 3/Contact=true",
          "Stage 3/Glued=true",
          "Stage 3/Slide=0, 0, 0.02",
          "Stage 4/Name=lateral",
          "Stage 4/Start from=2",
          "Stage 4/Contact=true",
          "Stage 4/Glued=true",
          "Stage 4/Slide=0, 0.02, 0",
          "Stage 5/Name=torsion",
          "Stage 5/Start from=2",
          "Stage 5/Contact=true",
          "Stage 5/Glued=true",
          "Stage 5/Turn=0.02"};
}


/** The secant stiffnesses of the last step of each stage, by its name. */
inline std::map<std::string, double>
secant_stiffnesses(const std::vector<Biface::StepReport> &reports)
{
  std::map<std::string, double> stiffnesses;
  for (const Biface::StepReport &report : reports)
    if (report.stiffness.count("foundation") > 0)
      stiffnesses[report.stage] =
        report.stiffness.at("foundation").secant.along();
  return stiffnesses;
}


/** The way after which a part 1 - 1/e of the change of a force has happened.
 * @param forces at equal distances over a way.
 * @param end the force in the limit. */
inline double
relaxation_length(const std::vector<double> &forces,
                  const double               end,
                  const double               way)
{
  const double rest = std::exp(-1.);
  const double step = way / (forces.size() - 1);
  const auto   left = [&](const unsigned int i) {
    return (end - forces[i]) / (end - forces[0]);
  };
  unsigned int i = 1;
  while (i + 1 < forces.size() && left(i) > rest)
    ++i;
  return step * (i - 1 + (left(i - 1) - rest) / (left(i - 1) - left(i)));
}

#endif
