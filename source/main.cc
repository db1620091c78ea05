// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include <biface/program/program.h>

namespace
{
  /**
   * Let Open MPI skip what a single process does not need when it starts: a
   * daemon of its own and the search for networks, half of the start-up time.
   * Variables that are set are kept, and nothing is done under a launcher.
   */
  void
  start_alone()
  {
    for (const char *launcher : {"OMPI_COMM_WORLD_SIZE",
                                 "PMIX_RANK",
                                 "PMI_RANK",
                                 "PMI_SIZE",
                                 "SLURM_PROCID"})
      if (std::getenv(launcher) != nullptr)
        return;
    constexpr int keep = 0;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
    setenv("OMPI_MCA_pml", "ob1", keep);
  }
} // namespace


int
main(int argc, char *argv[])
{
  start_alone();
  // MPI removes its own arguments from the command line; one thread per rank
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return Biface::run_program(
        {argv + 1, argv + argc}, MPI_COMM_WORLD, std::cout, std::cerr);
    }
  catch (const std::bad_alloc &)
    {
      std::cerr << "biface: memory has ended; take fewer cells or layers, or "
                   "more memory. '--check' says what a file needs."
                << std::endl;
    }
  catch (const std::exception &exception)
    {
      std::cerr << "biface: internal error: " << exception.what() << std::endl;
    }
  catch (...)
    {
      std::cerr << "biface: internal error of unknown kind" << std::endl;
    }
  // the other ranks may be waiting for this one
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    MPI_Abort(MPI_COMM_WORLD, Biface::internal_error);
  return Biface::internal_error;
}
