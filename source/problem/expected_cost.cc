// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/expected_cost.h>
#include <biface/surface/quadrilateral_mesh.h>

#include <sys/resource.h>
#include <unistd.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr double gibibyte = 1024. * 1024. * 1024.;


    /** More than fit into a whole number, if need be. */
    double
    n_nodes_of(const ChartGrid &grid)
    {
      return static_cast<double>(grid.lines[0].size()) * grid.lines[1].size();
    }


    /** The ranks on the machine of this one. */
    unsigned int
    ranks_on_machine(const MPI_Comm communicator)
    {
      // ranks of other machines have other memory
      MPI_Comm machine;
      MPI_Comm_split_type(
        communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
      const unsigned int n = Utilities::MPI::n_mpi_processes(machine);
      MPI_Comm_free(&machine);
      return n;
    }


    /** The first number in a file; infinite if there is none. */
    double
    number_in(const std::string &file)
    {
      // a control group without limit has a word there
      double number = 0;
      return std::ifstream(file) >> number
               ? number
               : std::numeric_limits<double>::infinity();
    }


    /** The bytes that this rank can have: its share of the machine or of its
     * control group, or what its limits leave. */
    double
    memory_of_rank(const unsigned int n_ranks)
    {
      const double page = sysconf(_SC_PAGESIZE);
      double       shared =
        std::min({sysconf(_SC_PHYS_PAGES) * page,
                  number_in("/sys/fs/cgroup/memory.max"),
                  number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
      double result = shared / n_ranks;
      rlimit limit;
      if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        // libraries have a part of it
        result = std::min(
          result, limit.rlim_cur - page * number_in("/proc/self/statm"));
      return result;
    }
  } // namespace


  double
  expected_iterations(const Parameters &parameters, const Stage &stage)
  {
    // of runs of the files in prm/; in a wheel that rolls, stresses that relax
    // couple all nodes of a circle
    constexpr double of_step = 5, relaxing = 10, heat_rounds = 3, adaptive = 3,
                     of_derivative = 0.5;

    double     result = of_step;
    const bool rolls  = stage.rolls(LoadLevel());
    if (rolls && std::any_of(parameters.materials.begin(),
                             parameters.materials.end(),
                             [](const MaterialParameters &material) {
                               return material.relaxes();
                             }))
      result *= relaxing;
    if (rolls && parameters.heat.temperatures ==
                   RollingHeat::Parameters::Temperatures::coupled)
      result *= heat_rounds;
    if (stage.control == ControlKind::arc_length)
      result *= adaptive;
    // two perturbed runs each
    return result + 2 * of_derivative * parameters.sensitivities.changes.size();
  }


  namespace
  {
    /** The iterations that take as long as the modes, the buckling loads and
     * the response at the end of a stage. */
    double
    iterations_at_end(const Stage &stage)
    {
      constexpr double of_mode = 0.5, of_frequency = 4;
      const double     n = stage.n_modes + stage.n_buckling;
      return (n > 0 ? 1 + of_mode * n : 0.) +
             of_frequency * stage.frequencies.size();
    }
  } // namespace


  ExpectedCost::ExpectedCost(const Parameters &parameters,
                             const ChartGrid  &grid,
                             const MPI_Comm    communicator)
  {
    // doc/performance.md: bytes of a node of two faces, with factors of a
    // symmetric tangent in single precision or a multigrid, and with others;
    // of a copy of the mesh; of a rank
    constexpr double symmetric = 32e3, unsymmetric = 55e3, mesh = 5e3,
                     rank = 0.17 * gibibyte;
    // factors grow faster than the unknowns of a node
    constexpr double growth_with_layers = 1.6;
    // seconds of an iteration
    constexpr double of_ten_thousand = 0.07, growth = 1.15,
                     both_triangles = 1.8;

    const unsigned int n_ranks  = Utilities::MPI::n_mpi_processes(communicator);
    const double       n_nodes  = grid.has_lines()
                                    ? n_nodes_of(grid)
                                    : parameters.surface.mesh.mesh->nodes.size();
    const double       per_node = 3. * (parameters.laminate.n_layers() + 1);
    const double       n_copies =
      (grid.distribution == MeshDistribution::shared ? n_ranks : 1);
    bool is_symmetric =
      parameters.contact.condition.mortar_matrix == MortarMatrix::lumped &&
      parameters.pressure.kind == PressureKind::dead;
    for (const Stage &stage : parameters.stages)
      is_symmetric =
        is_symmetric &&
        !(stage.contact && !parameters.friction_in(stage).is_zero());
    const bool is_small =
      is_symmetric || parameters.linear_solver.is_iterative();
    const double of_node = (is_small ? symmetric : unsymmetric) *
                           std::pow(per_node / 6, growth_with_layers);
    memory = n_ranks * rank + n_nodes * (mesh * (n_copies - 1) + of_node);

    double n_iterations = 0;
    for (unsigned int s = 0; s <= parameters.last_stage(); ++s)
      {
        const Stage &stage = parameters.stages[s];
        n_steps += stage.n_steps;
        n_iterations += stage.n_steps * expected_iterations(parameters, stage) +
                        iterations_at_end(stage);
      }
    seconds =
      n_iterations * of_ten_thousand * (is_small ? 1. : both_triangles) *
      std::pow(n_nodes * per_node / 1e4, growth) / std::pow(n_ranks, 0.7);
  }


  std::string
  ExpectedCost::text() const
  {
    char number[32];
    std::snprintf(number, sizeof(number), "%.2g", memory / gibibyte);
    return std::string("about ") + number + " GiB of memory and a time of " +
           (seconds < 60     ? "seconds"
            : seconds < 3600 ? "minutes"
                             : "hours") +
           " for " + number_to_string(n_steps) +
           (n_steps == 1 ? " step" : " steps");
  }


  void
  check_memory(const Parameters &parameters,
               const ChartGrid  &grid,
               const MPI_Comm    communicator)
  {
    // some runs take less than expected
    constexpr double margin = 0.7;

    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const ExpectedCost expected(parameters, grid, communicator);
    // the same decision on all ranks, also on different machines
    const double available =
      n_ranks * Utilities::MPI::min(
                  memory_of_rank(ranks_on_machine(communicator)), communicator);
    if (margin * expected.memory <= available)
      return;
    char message[256];
    std::snprintf(message,
                  sizeof(message),
                  " nodes, which need about %.3g GiB of memory, but there are "
                  "only %.3g; take fewer cells or layers, or more memory.",
                  expected.memory / gibibyte,
                  std::max(0., available / gibibyte));
    throw InputError("the section 'Mesh' describes " +
                     number_to_string(n_nodes_of(grid)) + message);
  }
} // namespace Biface
