// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <biface/analysis/messages.h>
#include <biface/base/version.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/state/loads.h>
#include <biface/problem/expected_cost.h>
#include <biface/stepping/controls/make_control.h>

namespace Biface
{
  using namespace dealii;

  void
  print_header(const Simulation &simulation, ConditionalOStream &out)
  {
    const ShellMesh   &mesh = simulation.get_equations().mesh;
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(mesh.communicator);
    const std::string blas = blas_library();

    out << "biface " << version() << ", " << n_ranks
        << (n_ranks == 1 ? " rank" : " ranks") << ", " << mesh.n_cells()
        << " cells, " << mesh.n_unknowns() << " unknowns\n";
    if (mesh.n_folds() > 0)
      out << "Folds: " << mesh.n_folds()
          << " sides where parts of the shell meet at an angle or at a joint\n";
    out << "BLAS: " << blas << '\n';
    if (blas.find("openblas") == std::string::npos &&
        blas.find("mkl") == std::string::npos)
      out << "  (not OpenBLAS: linear solves may take several times longer; "
             "on Debian, install libopenblas0-pthread)\n";

    const std::vector<std::string> motions = free_rigid_motions(mesh);
    if (!motions.empty())
      {
        out << "The supports do not prevent these rigid motions: ";
        for (unsigned int i = 0; i < motions.size(); ++i)
          out << (i > 0 ? ", " : "") << motions[i];
        out << ". Only loads or contact can prevent them.\n";
      }
    out << std::endl;
  }


  StepCounter::StepCounter(const Parameters &parameters,
                           const Progress   &progress)
  {
    for (unsigned int i = 0; i <= parameters.last_stage(); ++i)
      {
        const Stage &stage = parameters.stages[i];
        steps.of_stages.push_back(stage.n_steps);
        iterations.of_stages.push_back(stage.n_steps *
                                       expected_iterations(parameters, stage));
        // arc length finds the number of its steps on the way
        if (!make_control(stage)->has_equal_steps())
          predictable = false;
      }
    for (Amount *amount : {&steps, &iterations})
      amount->at_begin = amount->done(progress);
  }


  double
  StepCounter::Amount::done(const Progress &progress) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < progress.stage; ++i)
      sum += of_stages[i];
    if (progress.stage_begun)
      sum += of_stages[progress.stage] * progress.control.done;
    return sum;
  }


  double
  StepCounter::Amount::left(const Progress &progress) const
  {
    return std::max(0.,
                    std::accumulate(of_stages.begin(), of_stages.end(), 0.) -
                      done(progress));
  }


  std::string
  StepCounter::line(const StepReport &report, const Progress &progress) const
  {
    const double seconds = timer.wall_time();

    std::string text = "  step " + std::to_string(report.step);
    if (predictable)
      text += " of " + std::to_string(report.step +
                                      static_cast<unsigned int>(
                                        std::lround(steps.left(progress))));
    text += ":";
    char part[256];
    if (report.loads->factors[0] != 0)
      {
        std::snprintf(
          part, sizeof(part), " load factor %.6g,", report.loads->factors[0]);
        text += part;
      }
    if (report.loads->pressure != 0)
      {
        std::snprintf(
          part, sizeof(part), " pressure %.6g,", report.loads->pressure);
        text += part;
      }
    if (report.controlled)
      {
        std::snprintf(part, sizeof(part), " %.6g,", report.controlled->second);
        text += " " + report.controlled->first + part;
      }
    if (report.in_contact)
      {
        std::snprintf(part,
                      sizeof(part),
                      " approach %.6g, force %.6g, contact nodes %u, "
                      "area %.6g, max contact pressure %.4g,",
                      report.level.travel,
                      report.contact.force,
                      report.contact.n_nodes,
                      report.contact.area,
                      report.contact.max_pressure);
        text += part;
      }
    std::snprintf(part,
                  sizeof(part),
                  " %u iterations, %.2f s; %.3g s so far",
                  report.iterations,
                  report.seconds,
                  seconds);
    text += part;
    if (const unsigned int n = report.n_negative_pivots.value_or(0); n > 0)
      text += ", " + std::to_string(n) +
              (n == 1 ? " negative pivot" : " negative pivots");
    // in proportion to the steps since the start of this run: a restart has not
    // spent the time of the others
    const double done = iterations.done(progress) - iterations.at_begin;
    const double left = iterations.left(progress);
    if (predictable && done > 0 && left > 0)
      {
        std::snprintf(
          part, sizeof(part), ", about %.2g s left", seconds * left / done);
        text += part;
      }
    return text;
  }


  void
  print_costs(Simulation &simulation, ConditionalOStream &out)
  {
    simulation.get_timer().print_summary();

    char line[96];
    if (const double seconds = simulation.get_coarse_solver_seconds())
      {
        std::snprintf(
          line,
          sizeof(line),
          "Factorizations and solutions on coarser meshes: %.3g s\n",
          seconds);
        out << line;
      }

    // as reported by Linux
    Utilities::System::MemoryStats stats{};
    Utilities::System::get_memory_stats(stats);
    // the sum of the peaks of all ranks, which need not come at once
    const double kilobytes =
      Utilities::MPI::sum(static_cast<double>(stats.VmHWM),
                          simulation.get_equations().mesh.communicator);
    std::snprintf(
      line, sizeof(line), "Peak memory: %.3f GiB", kilobytes / (1024 * 1024));
    out << line << "\n\n";
  }


  void
  print_files(const std::string              &directory,
              const std::vector<std::string> &files,
              ConditionalOStream             &out)
  {
    out << " in " << directory << ": ";
    for (const std::string &file : files)
      out << file << ", ";
    out << "parameters.prm, run.log" << std::endl;
  }


  std::string
  failure_paragraph(const LoadSteppingResult &result)
  {
    const auto loads = [&](const LoadLevel &point) {
      return "pressure " + number_to_string(point.pressure) + ", load factor " +
             number_to_string(point.factors[0]) +
             (result.in_use.contact
                ? ", approach " + number_to_string(point.travel)
                : "");
    };
    std::string text = explain(result.failure, result.in_use) +
                       " The last converged step is at " +
                       loads(result.reached);
    if (result.failure.cause != FailureCause::too_many_steps)
      text +=
        "; the smallest step tried beyond it started at " + loads(result.tried);
    text += '.';
    if (result.worst)
      text += " In the last converged step " + describe(*result.worst);
    if (const unsigned int n = result.n_negative_pivots.value_or(0); n > 0)
      text += " The last tangent had " + std::to_string(n) +
              (n == 1 ? " negative pivot" : " negative pivots") +
              ": the shell was not stable.";
    std::string lines;
    for (const std::string &line : Utilities::break_text_into_lines(text, 78))
      lines += "  " + line + '\n';
    return lines;
  }
} // namespace Biface
