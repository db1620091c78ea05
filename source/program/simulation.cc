// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <memory>

#include <biface/program/simulation.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::unique_ptr<const Discretization>
    make_discretization(const Parameters &parameters,
                        const MPI_Comm    communicator)
    {
      std::unique_ptr<const ReferenceSurface> surface =
        make_surface(parameters.surface, communicator);
      const ChartGrid grid(parameters.mesh, *surface);
      const Layup     layup(
        parameters.laminate, parameters.materials, communicator);
      const std::vector<NamedPoint> points = parameters.points.parse(*surface);
      return std::make_unique<const Discretization>(communicator,
                                                    std::move(surface),
                                                    grid,
                                                    layup,
                                                    parameters.supports,
                                                    points);
    }
  } // namespace


  Simulation::Simulation(const Parameters &parameters,
                         const MPI_Comm    communicator,
                         std::ostream     &stream)
    : parameters(parameters)
    , out(stream, Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
    , discretization(make_discretization(parameters, communicator))
    , contact(parameters.contact)
    , equations(*discretization, contact, parameters.loads, parameters.pressure)
    , linear_solver(
        make_linear_solver(parameters.linear_solver, *discretization, timer))
    , state(equations.initial_state())
  {
    for (unsigned int i = 0; i < parameters.stages.size(); ++i)
      if (parameters.stages[i].control == Stage::Control::displacement)
        discretization->node_of_point("Stage " + std::to_string(i + 1) +
                                        "/Control point",
                                      parameters.stages[i].control_point);
  }


  LoadSteppingResult
  Simulation::run(const LoadStepping::Observer &observer)
  {
    Newton newton(parameters.newton, equations, *linear_solver, out, timer);
    LoadStepping load_stepping(
      parameters.load_stepping, equations, newton, out);
    return load_stepping.run(parameters.stages, state, observer);
  }
} // namespace Biface
