// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_messages_h
#define biface_program_messages_h

#include <deal.II/base/conditional_ostream.h>

#include <string>
#include <vector>

#include <biface/program/simulation.h>
#include <biface/restart/checkpoint.h>

namespace Biface
{
  /** Version, ranks, size of the mesh, BLAS, and rigid motions left free. */
  void
  print_header(const Simulation &simulation, dealii::ConditionalOStream &out);

  /** The most memory that all ranks had together, as far as Linux tells. */
  void
  print_memory(const MPI_Comm communicator, dealii::ConditionalOStream &out);

  /** Approach and force of all steps with contact. */
  void
  print_load_deflection(const std::vector<LoadDeflection> &curve,
                        dealii::ConditionalOStream        &out);

  /** Where the results are. @param files see ResultsWriter::list(). */
  void
  print_files(const std::string              &directory,
              const std::vector<std::string> &files,
              dealii::ConditionalOStream     &out);

  /** See Simulation::get_coarse_solver_seconds(). */
  void
  print_coarse_solver_time(const double                seconds,
                           dealii::ConditionalOStream &out);

  /** What the failure of a step means, what may help, and how far the run
   * came: indented lines. */
  std::string
  failure_paragraph(const LoadSteppingResult &result);
} // namespace Biface

#endif
