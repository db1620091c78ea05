// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdio>

#include <biface/base/errors.h>
#include <biface/restart/checkpoint.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace Biface
{
  using namespace dealii;

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


    /** The grips of nodes as numbers, and back. */
    ActiveSet
    numbers_of(const std::vector<Grip> &grips)
    {
      ActiveSet numbers;
      for (const Grip grip : grips)
        numbers.push_back(static_cast<char>(grip));
      return numbers;
    }

    std::vector<Grip>
    grips_of(const std::vector<double> &numbers)
    {
      std::vector<Grip> grips;
      for (const double number : numbers)
        grips.push_back(static_cast<Grip>(number));
      return grips;
    }


    /** The distributed part of the state of the shell, by name. */
    std::vector<CheckpointFile::Table>
    tables_of(const ShellEquations &equations,
              const State          &state,
              const Progress       &progress)
    {
      const ShellMesh               &mesh = equations.mesh;
      const InternalForces::History &history =
        equations.internal_forces().get_history();

      std::vector<CheckpointFile::Table> tables{
        {"displacement", rows_of(state.displacement, mesh)},
        {"resultants", rows_of(state.resultants, mesh)},
        {"active", rows_of(state.active, mesh)},
        {"multipliers", rows_of(state.multipliers, mesh)},
        {"grips", rows_of(numbers_of(state.grips), mesh)},
        {"stick points",
         rows_of(std::vector<Tensor<1, 3>>(state.stick_points.begin(),
                                           state.stick_points.end()),
                 mesh)},
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
      if (history.balancing_forces.size() > 0)
        tables.emplace_back("balancing forces",
                            rows_of(history.balancing_forces, mesh));
      if (const auto &step = progress.predictor.get_last())
        {
          tables.emplace_back("predictor displacement",
                              rows_of(step->displacement, mesh));
          tables.emplace_back("predictor resultants",
                              rows_of(step->resultants, mesh));
        }
      if (progress.last_change.size() > 0)
        tables.emplace_back("last change", rows_of(progress.last_change, mesh));
      for (const auto &vector : progress.control.vectors)
        tables.emplace_back("control: " + vector.first,
                            rows_of(vector.second, mesh));
      return tables;
    }
  } // namespace


  void
  write_checkpoint(const std::string    &directory,
                   const RunRecord      &record,
                   const ShellEquations &equations,
                   const State          &state)
  {
    const std::vector<char> header = Utilities::pack(record, false);
    CheckpointFile::write(newest(directory),
                          previous(directory),
                          std::string(header.begin(), header.end()),
                          tables_of(equations, state, record.progress),
                          equations.mesh.communicator);
  }


  void
  remove_checkpoints(const std::string &directory, const MPI_Comm communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &path : {newest(directory), previous(directory)})
        std::remove(path.c_str());
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
      warning = "The run continues from the previous checkpoint: " + warning;
  }


  void
  Checkpoint::remove_unusable() const
  {
    if (!warning.empty() &&
        Utilities::MPI::this_mpi_process(reader->communicator) == 0)
      std::remove(newest(directory).c_str());
  }


  void
  Checkpoint::restore(ShellEquations &equations,
                      State          &state,
                      Progress       &progress) const
  {
    const ShellMesh &mesh   = equations.mesh;
    const auto       nodes  = numbers_of_owned_nodes(mesh);
    const auto       cells  = numbers_of_cells(mesh);
    const auto       vector = [&](const std::string &name) {
      return vector_from(reader->rows(name, nodes), mesh);
    };
    // with ghost entries; a temporary would be moved together with its
    // partition, which has only the owned entries
    const auto ghosted = [&](const std::string &name) {
      const LA::Vector owned  = vector(name);
      LA::Vector       result = mesh.ghosted_vector();
      result                  = owned;
      return result;
    };
    const auto modes = [&](const std::string &name) {
      return modes_from(reader->rows(name, cells));
    };

    const auto all_nodes = numbers_of_nodes(mesh);

    state              = State(mesh);
    state.displacement = ghosted("displacement");
    state.resultants   = modes("resultants");
    state.active       = active_from(reader->rows("active", all_nodes));
    state.multipliers  = vectors_from(reader->rows("multipliers", all_nodes));
    state.grips        = grips_of(reader->rows("grips", all_nodes));
    const auto points  = vectors_from(reader->rows("stick points", all_nodes));
    state.stick_points.assign(points.begin(), points.end());

    InternalForces::History history;
    history.initial_resultants = modes("initial resultants");
    history.initial_strains    = modes("initial strains");
    if (reader->has("linearization displacement"))
      {
        State point(mesh);
        point.displacement          = ghosted("linearization displacement");
        point.resultants            = modes("linearization resultants");
        history.linearization_point = point;
      }
    if (reader->has("balancing forces"))
      history.balancing_forces = vector("balancing forces");

    equations.internal_forces().restore(history);

    progress = record.progress;
    if (progress.predictor.get_last())
      {
        SecantPredictor::Step step = *progress.predictor.get_last();
        step.displacement          = vector("predictor displacement");
        step.resultants            = modes("predictor resultants");
        progress.predictor.restore(step);
      }
    if (reader->has("last change"))
      progress.last_change = vector("last change");
    for (auto &known : progress.control.vectors)
      known.second = vector("control: " + known.first);
  }
} // namespace Biface
