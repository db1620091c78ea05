// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>
#include <utility>

#include <biface/base/input_error.h>
#include <biface/program/simulation.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** @param grid of the mesh; null for that of the parameters. */
    std::unique_ptr<const Discretization>
    make_discretization(const Parameters &parameters,
                        const MPI_Comm    communicator,
                        const ChartGrid  *grid = nullptr)
    {
      std::unique_ptr<const ReferenceSurface> surface =
        make_surface(parameters.surface, communicator);
      const ChartGrid given =
        (grid ? *grid : ChartGrid(parameters.mesh, *surface));
      const Layup layup(
        parameters.laminate, parameters.materials, communicator);
      const std::vector<NamedPoint> points = parameters.points.parse(*surface);
      return std::make_unique<const Discretization>(communicator,
                                                    std::move(surface),
                                                    given,
                                                    layup,
                                                    parameters.supports,
                                                    points);
    }


    std::shared_ptr<TimerOutput>
    make_timer(const MPI_Comm communicator, std::ostream &stream)
    {
      ConditionalOStream out(
        stream, Utilities::MPI::this_mpi_process(communicator) == 0);
      return std::make_shared<TimerOutput>(
        out, TimerOutput::never, TimerOutput::wall_times);
    }
  } // namespace


  Simulation::Simulation(const Parameters &parameters,
                         const MPI_Comm    communicator,
                         std::ostream     &stream)
    : Simulation(parameters,
                 communicator,
                 stream,
                 make_discretization(parameters, communicator),
                 make_timer(communicator, stream))
  {}


  Simulation::Simulation(const Parameters                     &parameters,
                         const MPI_Comm                        communicator,
                         std::ostream                         &stream,
                         std::unique_ptr<const Discretization> mesh,
                         const std::shared_ptr<TimerOutput>   &timer)
    : parameters(parameters)
    , stream(stream)
    , out(stream, Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(timer)
    , discretization(std::move(mesh))
    , contact(parameters.contact)
    , equations(*discretization, contact, parameters.loads, parameters.pressure)
    , linear_solver(
        make_linear_solver(parameters.linear_solver, *discretization, *timer))
    , state(equations.initial_state())
  {
    for (unsigned int i = 0; i < parameters.stages.size(); ++i)
      if (parameters.stages[i].control == Stage::Control::displacement)
        discretization->node_of_point("Stage " + std::to_string(i + 1) +
                                        "/Control point",
                                      parameters.stages[i].control_point);
    if (parameters.mesh.n_coarse > 0 &&
        coarser_grid().lines == discretization->grid.lines)
      throw InputError("Mesh/Coarse meshes",
                       std::to_string(parameters.mesh.n_coarse),
                       "the mesh has too few cells for that many coarser ones: "
                       "one of them would be its own coarser mesh");
  }


  ChartGrid
  Simulation::coarser_grid() const
  {
    std::array<std::vector<double>, 2> kept;
    for (const NamedPoint &point : discretization->points)
      for (unsigned int a = 0; a < 2; ++a)
        kept[a].push_back(point.alpha[a]);
    for (const PlyDescription &ply : discretization->layup.get_plies())
      for (const double end : {ply.begin, ply.end})
        kept[0].push_back(end *
                          discretization->get_surface().coordinate_unit(0));
    return discretization->grid.coarsened(kept);
  }


  std::unique_ptr<const NestedPredictor>
  Simulation::run_coarser() const
  {
    if (parameters.mesh.n_coarse == 0)
      return nullptr;

    Parameters coarse_parameters = parameters;
    --coarse_parameters.mesh.n_coarse;
    const ChartGrid grid         = coarser_grid();
    const MPI_Comm  communicator = discretization->communicator;
    Simulation      coarse(coarse_parameters,
                      communicator,
                      stream,
                      make_discretization(parameters, communicator, &grid),
                      timer);

    auto nested = std::make_unique<NestedPredictor>(grid, parameters.stages);
    const LoadSteppingResult result = coarse.run([&](const StepReport &report,
                                                     const State      &state) {
      if (report.moment)
        nested->learn(*report.moment, GridState(*coarse.discretization, state));
    });
    if (!result.success)
      out << "On the coarser mesh, " << result.message << '.' << std::endl;
    return nested;
  }


  LoadSteppingResult
  Simulation::run(const LoadStepping::Observer &observer)
  {
    const std::unique_ptr<const NestedPredictor> nested = run_coarser();
    if (nested || parameters.mesh.n_coarse > 0)
      out << "Mesh of " << discretization->n_cells() << " cells, "
          << discretization->n_unknowns() << " unknowns" << std::endl;

    Newton newton(parameters.newton, equations, *linear_solver, out, *timer);
    LoadStepping load_stepping(
      parameters.load_stepping, equations, newton, out, nested.get());
    return load_stepping.run(parameters.stages, state, observer);
  }
} // namespace Biface
