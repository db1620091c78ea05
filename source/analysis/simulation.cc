// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <biface/analysis/sensitivity_analysis.h>
#include <biface/analysis/simulation.h>
#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/mesh/named_points.h>
#include <biface/problem/check_excitations.h>
#include <biface/problem/proportions.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/frequency_responses.h>
#include <biface/stepping/rolling_report.h>
#include <biface/stepping/stage_buckling.h>
#include <biface/stepping/stage_modes.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_warnings.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Seconds in factorizations and solutions. */
    double
    linear_seconds(const TimerOutput &timer)
    {
      double seconds = 0;
      for (const auto &section :
           timer.get_summary_data(TimerOutput::total_wall_time))
        if (section.first.find("Linear solver: ") == 0 &&
            section.first != "Linear solver: analysis")
          seconds += section.second;
      return seconds;
    }
  } // namespace


  Simulation::Simulation(const Parameters &parameters,
                         const MPI_Comm    communicator,
                         std::ostream     &stream)
    : Simulation(parameters,
                 communicator,
                 stream,
                 make_shell_mesh(parameters, communicator))
  {
    check_proportions(parameters, *mesh);
  }


  Simulation::Simulation(const Parameters                &parameters,
                         const MPI_Comm                   communicator,
                         std::ostream                    &stream,
                         std::shared_ptr<const ShellMesh> shell_mesh)
    : parameters(parameters)
    , stream(stream)
    , out(stream, Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
    , model(parameters, std::move(shell_mesh))
    , mesh(model.mesh)
    , contact(model.contact)
    , equations(model.equations)
    , linear_solver(make_linear_solver(parameters.linear_solver, *mesh, timer))
    , state(contact.unloaded_state())
  {
    check_excitations(parameters, *mesh);
    for (unsigned int i = 0; i < parameters.stages.size(); ++i)
      {
        const Stage      &stage   = parameters.stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        make_control(stage)->check(section, *mesh);
        if (stage.critical_points == CriticalPoints::switch_branch &&
            mesh->prescribes_displacements())
          throw InputError(section + "/Critical points",
                           "switch branch",
                           "supports must not prescribe displacements");
        // beyond, Lanczos' method has no room
        for (const auto &[entry, n] :
             {std::make_pair("/Modes", stage.n_modes),
              std::make_pair("/Buckling", stage.n_buckling)})
          if (n > mesh->n_unknowns() / 4)
            throw InputError(section + entry,
                             std::to_string(n),
                             "it must be at most " +
                               std::to_string(mesh->n_unknowns() / 4) +
                               ", a quarter of the unknowns of the mesh");
      }

    // the run starts with the coarsest mesh; what it cannot have is refused
    // here
    ChartGrid grid = mesh->grid;
    for (unsigned int i = 0; i < parameters.mesh.n_coarse; ++i)
      {
        const ChartGrid coarser = coarser_grid(grid);
        if (coarser.lines == grid.lines)
          throw InputError("Mesh/Coarse meshes",
                           std::to_string(parameters.mesh.n_coarse),
                           "the mesh has too few cells for this number of "
                           "coarser meshes");
        grid = coarser;
      }

    if (!parameters.sensitivities.changes.empty())
      sensitivities = std::make_shared<SensitivityAnalysis>(
        parameters, model, *linear_solver, out, timer);
  }


  Simulation::~Simulation() = default;


  ChartGrid
  Simulation::coarser_grid(const ChartGrid &grid) const
  {
    // both meshes need the nodes of named points and the lines where plies end
    std::array<std::vector<double>, 2> kept;
    for (const NamedPoint &point : mesh->points)
      for (unsigned int a = 0; a < 2; ++a)
        kept[a].push_back(point.alpha[a]);
    for (const PlyDescription &ply : mesh->get_layup().get_plies())
      for (const double end : {ply.begin, ply.end})
        kept[0].push_back(end * mesh->get_surface().coordinate_unit(0));
    return grid.coarsened(kept);
  }


  std::unique_ptr<const NestedPredictor>
  Simulation::run_coarser(const Newton::Stop &stop)
  {
    if (parameters.mesh.n_coarse == 0)
      return nullptr;
    TimerOutput::Scope scope(timer, "Coarser meshes");

    // a coarser run begins with a still coarser one, and only its steps count
    Parameters coarse_parameters = parameters;
    --coarse_parameters.mesh.n_coarse;
    for (Stage &stage : coarse_parameters.stages)
      {
        stage.n_modes = stage.n_buckling = 0;
        stage.frequencies.clear();
        stage.critical_points = CriticalPoints::ignore;
      }
    coarse_parameters.sensitivities = SensitivityParameters();
    // far less than the error of the coarser mesh
    constexpr double sufficient  = 1e-4;
    double          &tolerance   = coarse_parameters.newton.residual_tolerance;
    tolerance                    = std::max(tolerance, sufficient);
    const ChartGrid grid         = coarser_grid(mesh->grid);
    const MPI_Comm  communicator = mesh->communicator;
    Simulation      coarse(coarse_parameters,
                      communicator,
                      stream,
                      make_shell_mesh(parameters, communicator, &grid));

    auto nested = std::make_unique<NestedPredictor>(
      grid, coarse.mesh->n_layers(), parameters.stages);
    // a smaller footprint tells nothing of that on the finer mesh
    constexpr unsigned int   min_footprint = 4;
    bool                     in_contact    = false;
    unsigned int             footprint     = 0;
    const LoadSteppingResult result        = coarse.run(
      [&](const StepReport &report, const State &state) {
        nested->learn(report.instant, GridState(*coarse.mesh, state));
        in_contact = in_contact || report.in_contact;
        if (report.in_contact)
          footprint = std::max(footprint, report.contact.n_nodes);
      },
      stop);
    if (in_contact && footprint < min_footprint)
      {
        out << "On the coarser mesh, the footprint has " << footprint
            << (footprint == 1 ? " node" : " nodes")
            << " at most: its steps are not used." << std::endl;
        nested = std::make_unique<NestedPredictor>();
      }
    if (!result.success)
      out << "On the coarser mesh, " << result.message << '.' << std::endl;
    coarse_solver_seconds =
      coarse.coarse_solver_seconds + linear_seconds(coarse.timer);
    return nested;
  }


  RestorePoints
  Simulation::get_restore_points() const
  {
    return {{state, progress}, ends};
  }


  PerturbedPoints
  Simulation::get_perturbed_points() const
  {
    return sensitivities ? sensitivities->get_restore_points()
                         : PerturbedPoints();
  }


  namespace
  {
    /** See Progress::rearrange_factors(). */
    void
    rearrange_factors(RestorePoints                   &points,
                      const std::vector<unsigned int> &positions)
    {
      points.last.progress.rearrange_factors(positions);
      for (auto &[position, end] : points.ends)
        end.progress.rearrange_factors(positions);
    }
  } // namespace


  void
  Simulation::restore(const Checkpoint &checkpoint)
  {
    const RunRecord &record = checkpoint.get_record();
    for (unsigned int i = 0; i < record.differences.size(); ++i)
      {
        const auto &change = parameters.sensitivities.changes.at(i);
        // the perturbed runs of the checkpoint went with this step
        if (change.step != record.differences[i])
          throw InputError("Sensitivities/Entries",
                           change.name,
                           "the run to be continued used the relative step " +
                             number_to_string(record.differences[i]) +
                             " for it, not " + number_to_string(change.step));
      }
    RestorePoints   points    = checkpoint.run(*mesh);
    PerturbedPoints perturbed = checkpoint.perturbed(*mesh);
    // later stages may name other loads
    const std::vector<unsigned int> positions =
      parameters.stages[0].positions_in(record.stages.at(0));
    rearrange_factors(points, positions);
    for (RestorePoints &points : perturbed.runs)
      rearrange_factors(points, positions);
    state    = points.last.state;
    progress = points.last.progress;
    ends     = points.ends;
    if (sensitivities)
      sensitivities->restore(perturbed);
    for (unsigned int next = progress.stage + 1;
         next < parameters.stages.size();
         ++next)
      {
        const unsigned int before = *stage_before(parameters.stages, next);
        if (before < progress.stage && !progress.has_failed(before) &&
            ends.count(before) == 0)
          throw InputError("Stage " + std::to_string(next + 1) + "/Start from",
                           std::to_string(before + 1),
                           "the run to be continued has not kept the end of "
                           "that stage, since no later stage started from it");
      }
    if (progress.stage_begun)
      {
        Stage before   = record.stages.at(progress.stage);
        before.factors = rearranged(before.factors, positions);
        progress.change_stage(before, parameters.stages.at(progress.stage));
      }
  }


  StageAnalyses
  Simulation::make_analyses(BucklingAnalysis &buckling_analysis)
  {
    const auto with_left = [this](const unsigned int stage) {
      return sensitivities && sensitivities->reads_left_eigenvectors(stage);
    };
    StageAnalyses analyses{std::make_shared<RollingReport>(out),
                           std::make_shared<StepWarnings>(out)};
    if (std::any_of(parameters.stages.begin(),
                    parameters.stages.end(),
                    [](const Stage &stage) { return stage.vibrates(); }))
      analyses.push_back(std::make_shared<FrequencyResponses>(
        equations, contact, model.air.get(), timer, out));
    if (std::any_of(parameters.stages.begin(),
                    parameters.stages.end(),
                    [](const Stage &stage) { return stage.n_modes > 0; }))
      analyses.push_back(std::make_shared<StageModes>(equations,
                                                      contact,
                                                      *linear_solver,
                                                      timer,
                                                      model.air.get(),
                                                      with_left,
                                                      out));
    analyses.push_back(
      std::make_shared<StageBuckling>(buckling_analysis, with_left, out));
    // it reads the results of the others
    if (sensitivities)
      analyses.push_back(sensitivities);
    return analyses;
  }


  LoadSteppingResult
  Simulation::run(const LoadStepping::Observer &observer,
                  const Newton::Stop           &stop,
                  const NestedPredictor        *predictor)
  {
    const std::unique_ptr<const NestedPredictor> nested =
      (predictor ? nullptr : run_coarser(stop));
    if (nested)
      out << "\nFiner mesh of " << mesh->n_cells() << " cells, "
          << mesh->n_unknowns() << " unknowns" << std::endl;
    const NestedPredictor none;

    Newton newton(
      parameters.newton, equations, contact, *linear_solver, out, timer, stop);
    // steps in time have forces of contact over the step, and no active set
    const ContactInteraction no_contact(*mesh,
                                        std::vector<ContactParameters>());
    Newton                   newton_in_time(parameters.newton,
                          equations,
                          no_contact,
                          *linear_solver,
                          out,
                          timer,
                          stop);
    BucklingAnalysis         buckling_analysis(
      equations, contact, *linear_solver, timer);
    LoadStepping       load_stepping(parameters.load_stepping,
                               equations,
                               contact,
                               model.heat.get(),
                               newton,
                               newton_in_time,
                               predictor ? *predictor
                                     : nested  ? *nested
                                               : none,
                               buckling_analysis,
                               make_analyses(buckling_analysis),
                               out);
    LoadSteppingResult result =
      load_stepping.run(parameters.stages, progress, state, ends, observer);
    result.in_use.iterative_solver = parameters.linear_solver.is_iterative();
    if (result.worst)
      result.worst->gradient_factor =
        model.mesh->get_layup().get_shear_law().gradient_factor;
    return result;
  }
} // namespace Biface
