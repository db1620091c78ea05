// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdio>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/program/checkpoint.h>
#include <biface/program/simulation.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace Biface
{
  using namespace dealii;

  void
  CheckpointParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Write",
                      write,
                      "Whether to write the state of the run into the "
                      "directory of results, from which '--restart' continues.",
                      Patterns::Bool());
    prm.add_parameter("Every steps",
                      every_steps,
                      "After how many steps since the last checkpoint the next "
                      "one is written; 0: not by steps. One is written at the "
                      "end in any case.",
                      Patterns::Integer(0));
    prm.add_parameter("Every minutes",
                      every_minutes,
                      "After how much time since the last checkpoint the next "
                      "one is written, when a step is done; 0: not by time. "
                      "Unit: minutes.",
                      Patterns::Double(0));
  }


  void
  CheckpointParameters::check() const
  {
    check_not_negative("Checkpoint/Every minutes", every_minutes);
  }


  namespace
  {
    std::string
    newest(const std::string &directory)
    {
      return directory + "/checkpoint.bin";
    }

    std::string
    previous(const std::string &directory)
    {
      return directory + "/checkpoint-previous.bin";
    }


    /** The distributed part of the shell's state, by names. */
    std::vector<CheckpointFile::Table>
    tables_of(const Simulation &simulation)
    {
      const ShellEquations         &equations = simulation.get_equations();
      const ShellMesh              &mesh      = equations.mesh;
      const State                  &state     = simulation.get_state();
      const Progress               &progress  = simulation.get_progress();
      const ShellEquations::History history   = equations.get_history();

      std::vector<CheckpointFile::Table> tables{
        {"displacement", rows_of(state.displacement, mesh)},
        {"resultants", rows_of(state.resultants, mesh)},
        {"active", rows_of(state.active, mesh)},
        {"initial resultants", rows_of(history.initial_resultants, mesh)},
        {"initial strains", rows_of(history.initial_strains, mesh)}};
      if (history.linearization_point)
        {
          const State &point = *history.linearization_point;
          tables.emplace_back("linearization displacement",
                              rows_of(point.displacement, mesh));
          tables.emplace_back("linearization resultants",
                              rows_of(point.resultants, mesh));
        }
      if (const auto &step = progress.predictor.get_last())
        {
          tables.emplace_back("predictor displacement",
                              rows_of(step->displacement, mesh));
          tables.emplace_back("predictor resultants",
                              rows_of(step->resultants, mesh));
        }
      if (progress.n_arc_steps > 0)
        tables.emplace_back("last change", rows_of(progress.last_change, mesh));
      return tables;
    }
  } // namespace


  CheckpointWriter::CheckpointWriter(const CheckpointParameters &parameters,
                                     const std::string          &directory,
                                     const Simulation           &simulation,
                                     ResultsWriter              &results,
                                     const bool                  restarted)
    : parameters(parameters)
    , directory(directory)
    , simulation(simulation)
    , results(results)
    , any_written(restarted)
    , last_step(simulation.get_progress().n_steps)
  {}


  void
  CheckpointWriter::remove(const std::string &directory,
                           const MPI_Comm     communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &path : {newest(directory), previous(directory)})
        std::remove(path.c_str());
  }


  void
  CheckpointWriter::write_if_due(RunRecord &record)
  {
    const unsigned int n_steps = simulation.get_progress().n_steps - last_step;
    // the clock of one rank counts
    const double minutes =
      Utilities::MPI::broadcast(simulation.get_equations().mesh.communicator,
                                since_last.wall_time() / 60);
    if ((parameters.every_steps > 0 && n_steps >= parameters.every_steps) ||
        (parameters.every_minutes > 0 && minutes >= parameters.every_minutes))
      write(record);
  }


  void
  CheckpointWriter::write(RunRecord &record)
  {
    const unsigned int n_steps = simulation.get_progress().n_steps;
    if (!parameters.write || (any_written && last_step == n_steps))
      return;

    // a restart finds at least what the checkpoint says
    results.sync();
    record.progress = simulation.get_progress();
    record.written  = results.get_written();
    if (const auto &step = record.progress.predictor.get_last())
      record.predictor_size = step->size;
    const std::vector<char> header = Utilities::pack(record, false);
    CheckpointFile::write(newest(directory),
                          previous(directory),
                          std::string(header.begin(), header.end()),
                          tables_of(simulation),
                          simulation.get_equations().mesh.communicator);
    any_written = true;
    last_step   = n_steps;
    since_last.restart();
  }


  Checkpoint::Checkpoint(const std::string &directory,
                         const MPI_Comm     communicator)
    : directory(directory)
  {
    try
      {
        reader = std::make_unique<CheckpointFile::Reader>(newest(directory),
                                                          communicator);
      }
    catch (const InputError &error)
      {
        warning = error.what();
      }
    if (!reader)
      try
        {
          reader = std::make_unique<CheckpointFile::Reader>(previous(directory),
                                                            communicator);
        }
      catch (const InputError &error)
        {
          throw InputError("there is no checkpoint to restart from: " +
                           warning.substr(0, warning.size() - 1) + ", and " +
                           error.what());
        }
    const std::string      &header = reader->get_header();
    const std::vector<char> bytes(header.begin(), header.end());
    record = Utilities::unpack<RunRecord>(bytes, false);
    if (!warning.empty())
      warning =
        "The run continues from the checkpoint before the last one: " + warning;
  }


  void
  Checkpoint::remove_unusable() const
  {
    if (!warning.empty() &&
        Utilities::MPI::this_mpi_process(reader->communicator) == 0)
      std::remove(newest(directory).c_str());
  }


  void
  Checkpoint::restore(Simulation               &simulation,
                      const std::vector<Stage> &before,
                      const std::vector<Stage> &now) const
  {
    const ShellEquations &equations = simulation.get_equations();
    const ShellMesh      &mesh      = equations.mesh;
    const auto            nodes     = numbers_of_owned_nodes(mesh);
    const auto            cells     = numbers_of_cells(mesh);
    const auto            vector    = [&](const std::string &name) {
      return vector_from(reader->rows(name, nodes), mesh);
    };
    // to be read at all nodes of this rank; a temporary would be moved, and
    // bring along that it has the owned ones only
    const auto ghosted = [&](const std::string &name) {
      const LA::Vector owned  = vector(name);
      LA::Vector       result = mesh.ghosted_vector();
      result                  = owned;
      return result;
    };
    const auto modes = [&](const std::string &name) {
      return modes_from(reader->rows(name, cells));
    };

    State state        = equations.initial_state();
    state.displacement = ghosted("displacement");
    state.resultants   = modes("resultants");
    state.active = active_from(reader->rows("active", numbers_of_nodes(mesh)));

    ShellEquations::History history;
    history.initial_resultants = modes("initial resultants");
    history.initial_strains    = modes("initial strains");
    if (reader->has("linearization displacement"))
      {
        State point                 = equations.initial_state();
        point.displacement          = ghosted("linearization displacement");
        point.resultants            = modes("linearization resultants");
        history.linearization_point = point;
      }

    Progress progress = record.progress;
    if (reader->has("predictor displacement"))
      {
        SecantPredictor::Step step;
        step.displacement = vector("predictor displacement");
        step.resultants   = modes("predictor resultants");
        step.size         = record.predictor_size;
        progress.predictor.restore(step);
      }
    if (reader->has("last change"))
      progress.last_change = vector("last change");
    if (progress.stage_begun)
      progress.change_stage(before.at(progress.stage), now.at(progress.stage));
    simulation.restore(history, state, progress);
  }
} // namespace Biface
