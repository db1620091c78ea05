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
        steps.push_back(stage.n_steps);
        iterations.push_back(expected_iterations(parameters, stage));
        // arc length finds the number of its steps on the way
        if (!make_control(stage)->has_equal_steps())
          predictable = false;
      }
    last_stage = progress.stage;
    last_done  = done(progress);
  }


  double
  StepCounter::done(const Progress &progress)
  {
    return progress.stage_begun ? progress.control.done : 0.;
  }


  std::string
  StepCounter::line(const StepReport &report, const Progress &progress)
  {
    const double       seconds = timer.wall_time();
    const unsigned int stage   = progress.stage;
    const double       now     = done(progress);
    const double       size    = now - (stage == last_stage ? last_done : 0.);
    last_stage                 = stage;
    last_done                  = now;
    iterations_done += iterations[stage];
    // a step that was halved says how long the others of the stage will be
    double steps_left = (1 - now) * steps[stage];
    if (size > 0)
      steps_left = std::max(steps_left, (1 - now) / size);
    double iterations_left = steps_left * iterations[stage];
    for (unsigned int i = stage + 1; i < steps.size(); ++i)
      {
        steps_left += steps[i];
        iterations_left += steps[i] * iterations[i];
      }

    std::string text = "  step " + std::to_string(report.step);
    if (predictable)
      text += " of " + std::to_string(report.step + static_cast<unsigned int>(
                                                      std::lround(steps_left)));
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
    // in proportion to the steps of this run: a restart has not spent the time
    // of the others
    if (predictable && iterations_left > 0)
      {
        std::snprintf(part,
                      sizeof(part),
                      ", about %.2g s left",
                      seconds * iterations_left / iterations_done);
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
