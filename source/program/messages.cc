// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdio>

#include <biface/base/version.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/rigid_motions.h>
#include <biface/program/messages.h>

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
        << " cells, " << mesh.n_unknowns() << " unknowns\n"
        << "BLAS: " << blas << '\n';
    if (blas.find("openblas") == std::string::npos &&
        blas.find("mkl") == std::string::npos)
      out << "  (not OpenBLAS: linear solves may take several times as long; "
             "on Debian, install libopenblas0-pthread)\n";

    const std::vector<std::string> motions = free_rigid_motions(mesh);
    if (!motions.empty())
      {
        out << "The supports leave rigid motions free: ";
        for (unsigned int i = 0; i < motions.size(); ++i)
          out << (i > 0 ? ", " : "") << motions[i];
        out << ". Loads or contact alone must hold them.\n";
      }
    out << std::endl;
  }


  void
  print_memory(const MPI_Comm communicator, ConditionalOStream &out)
  {
    Utilities::System::MemoryStats stats{};
    Utilities::System::get_memory_stats(stats);
    const double kilobytes =
      Utilities::MPI::sum(static_cast<double>(stats.VmHWM), communicator);
    char line[64];
    std::snprintf(
      line, sizeof(line), "Peak memory: %.3f GiB", kilobytes / (1024 * 1024));
    out << line << "\n\n";
  }


  void
  print_load_deflection(const std::vector<LoadDeflection> &curve,
                        ConditionalOStream                &out)
  {
    out << "\n  approach        force   nodes         area  greatest "
           "pressure\n";
    for (const LoadDeflection &step : curve)
      {
        char line[128];
        std::snprintf(line,
                      sizeof(line),
                      "%10.4g %12.6g %7u %12.6g %18.4g\n",
                      step.approach,
                      step.contact.force,
                      step.contact.n_nodes,
                      step.contact.area,
                      step.contact.max_pressure);
        out << line;
      }
    out << std::flush;
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


  void
  print_coarse_solver_time(const double seconds, ConditionalOStream &out)
  {
    char line[96];
    std::snprintf(line,
                  sizeof(line),
                  "Factorizations and solutions on coarser meshes: %.3g s\n",
                  seconds);
    out << line;
  }


  std::string
  failure_paragraph(const LoadSteppingResult &result)
  {
    const auto loads = [&](const LoadLevel &point) {
      return "pressure " + number_to_string(point.pressure) + ", load factor " +
             number_to_string(point.factor) +
             (result.in_contact ? ", approach " + number_to_string(point.travel)
                                : "");
    };
    std::string text = explain(result.cause, result.in_contact) +
                       " The last state kept is that of " +
                       loads(result.reached);
    if (result.cause != FailureCause::too_many_steps)
      text += "; the smallest step beyond it began with " + loads(result.tried);
    std::string lines;
    for (const std::string &line :
         Utilities::break_text_into_lines(text + '.', 78))
      lines += "  " + line + '\n';
    return lines;
  }
} // namespace Biface
