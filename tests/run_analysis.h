// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_run_analysis_h
#define biface_tests_run_analysis_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <biface/analysis/simulation.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/step_report.h>

using Observer = std::function<void(const Biface::ShellEquations &,
                                    const Biface::StepReport &,
                                    const Biface::State &)>;

/** The parameters of a file with some entries changed. */
inline Biface::Parameters
parameters_of(const std::string                   &file,
              const std::vector<Biface::Override> &overrides = {})
{
  Biface::Parameters       parameters;
  dealii::ParameterHandler prm;
  Biface::read_parameters(file, overrides, MPI_COMM_WORLD, parameters, prm);
  return parameters;
}

/** A simulation that is ready to run, and what it prints. */
struct Analysis
{
  Analysis(const std::string                   &file,
           const std::vector<Biface::Override> &overrides = {})
    : simulation(parameters_of(file, overrides), MPI_COMM_WORLD, screen)
  {}

  std::ostringstream screen;
  Biface::Simulation simulation;
};

/** Run a parameter file with some entries changed.
 * @return the reports of all steps. */
inline std::vector<Biface::StepReport>
run_analysis(const std::string                   &file,
             const std::vector<Biface::Override> &overrides,
             const Observer                      &observer = {})
{
  Analysis                        analysis(file, overrides);
  std::vector<Biface::StepReport> reports;
  const auto                      result = analysis.simulation.run(
    [&](const Biface::StepReport &report, const Biface::State &state) {
      reports.push_back(report);
      if (observer)
        observer(analysis.simulation.get_equations(), report, state);
    });
  if (!result.success)
    std::cout << "FAILED: " << result.message << std::endl;
  return reports;
}


/** Run a parameter file with some entries changed.
 * @return the strain energy at the end. */
inline double
energy_at_end(const std::string                   &file,
              const std::vector<Biface::Override> &overrides)
{
  double result = 0;
  run_analysis(file,
               overrides,
               [&](const Biface::ShellEquations &equations,
                   const Biface::StepReport &,
                   const Biface::State &state) {
                 result = equations.internal_forces().strain_energy(state);
               });
  return result;
}

#endif
