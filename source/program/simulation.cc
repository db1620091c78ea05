// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <memory>

#include <biface/program/simulation.h>

namespace Biface
{
  using namespace dealii;

  Simulation::Simulation(const Parameters &parameters,
                         const MPI_Comm    communicator,
                         std::ostream     &stream)
    : parameters(parameters)
    , out(stream, Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
    , laminate(parameters.laminate)
    , discretization(communicator,
                     make_surface(parameters.surface, communicator),
                     ChartGrid(parameters.mesh,
                               *make_surface(parameters.surface, communicator)),
                     laminate.faces(),
                     parameters.supports)
    , contact(parameters.contact)
    , equations(discretization, laminate, contact)
    , linear_solver(communicator, timer)
    , state(equations.initial_state())
  {}


  LoadSteppingResult
  Simulation::run(const LoadStepping::Observer &observer)
  {
    Newton newton(parameters.newton, equations, linear_solver, out, timer);
    LoadStepping load_stepping(
      parameters.load_stepping, equations, newton, out);
    return load_stepping.run(parameters.stages, state, observer);
  }
} // namespace Biface
