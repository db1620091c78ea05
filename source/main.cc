// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>

#include <biface/program/program.h>

int
main(int argc, char *argv[])
{
  // MPI removes its own arguments from the command line; one thread per rank
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return Biface::run_program(
        argc, argv, MPI_COMM_WORLD, std::cout, std::cerr);
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
  MPI_Abort(MPI_COMM_WORLD, Biface::internal_error);
  return Biface::internal_error;
}
