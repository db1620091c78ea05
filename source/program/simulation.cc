// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <memory>

#include <biface/program/simulation.h>
#include <biface/surface/surface_of_revolution.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::unique_ptr<ReferenceSurface> make_surface(const Parameters &parameters)
    {
      switch (parameters.meridian)
        {
          case Parameters::MeridianType::circular_arc:
            return std::make_unique<SurfaceOfRevolution>(
              std::make_shared<CircularArc>(parameters.circular_arc));
        }
      Assert(false, ExcInternalError());
      return {};
    }


    ChartGrid make_grid(const Parameters &parameters)
    {
      return ChartGrid(parameters.mesh, *make_surface(parameters));
    }
  } // namespace


  Simulation::Simulation(const Parameters &parameters,
                         const MPI_Comm    communicator,
                         std::ostream     &stream)
    : parameters(parameters)
    , out(stream, Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
    , laminate(parameters.laminate)
    , discretization(communicator,
                     make_surface(parameters),
                     make_grid(parameters),
                     laminate.faces(),
                     parameters.supports)
    , contact(parameters.contact)
    , equations(discretization, laminate, contact)
    , linear_solver(communicator, timer)
    , state(equations.initial_state())
  {}


  LoadSteppingResult Simulation::run(const LoadStepping::Observer &observer)
  {
    Newton newton(parameters.newton, equations, linear_solver, out, timer);
    LoadStepping load_stepping(
      parameters.load_stepping, equations, newton, out);
    return load_stepping.run(parameters.stages, state, observer);
  }
} // namespace Biface
