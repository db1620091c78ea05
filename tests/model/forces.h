// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_forces_h
#define biface_tests_model_forces_h

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

/** Force and moment about the origin. */
using Resultant = std::array<double, 6>;

/** The forces on the shell at the end of a run, by the body, and their sum
 * divided by the largest entry. */
struct Forces
{
  std::map<std::string, Resultant> of;
  double                           imbalance = 0;
  Biface::StepReport               report;

  /** Run a parameter file with some entries changed. */
  Forces(const std::string                   &file,
         const std::vector<Biface::Override> &overrides)
  {
    run_analysis(file,
                 overrides,
                 [&](const Biface::ShellEquations &,
                     const Biface::StepReport &report,
                     const Biface::State &) {
                   this->report = report;
                   for (const auto &item : report.forces_of_bodies)
                     for (unsigned int i = 0; i < 3; ++i)
                       {
                         of[item.body][i]     = item.force[i];
                         of[item.body][3 + i] = item.moment[i];
                       }
                 });
    Resultant sum{};
    double    largest = 0;
    for (const auto &body : of)
      for (unsigned int i = 0; i < 6; ++i)
        {
          sum[i] += body.second[i];
          largest = std::max(largest, std::abs(body.second[i]));
        }
    for (const double s : sum)
      imbalance = std::max(imbalance, std::abs(s) / largest);
  }
};


/** The greatest difference of two resultants, relative to the greatest entry of
 * the second. */
inline double
difference(const Resultant &a, const Resultant &b)
{
  double apart = 0, largest = 0;
  for (unsigned int i = 0; i < 6; ++i)
    {
      apart   = std::max(apart, std::abs(a[i] - b[i]));
      largest = std::max(largest, std::abs(b[i]));
    }
  return apart / largest;
}


/** Write a parameter file on the first rank. */
inline std::string
write_prm(const std::string &name, const std::string &text)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::ofstream(name) << text;
  MPI_Barrier(MPI_COMM_WORLD);
  return name;
}

#endif
