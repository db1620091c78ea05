// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdio>

#include <biface/base/errors.h>
#include <biface/contact/friction_coefficient.h>
#include <biface/restart/checkpoint.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/set.hpp>
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


    /** The tangential states of nodes as numbers, and back. */
    ActiveSet
    status_codes(const std::vector<ContactStatus> &statuses)
    {
      ActiveSet numbers;
      for (const ContactStatus status : statuses)
        numbers.push_back(static_cast<char>(status));
      return numbers;
    }

    std::vector<ContactStatus>
    statuses_of(const std::vector<double> &numbers)
    {
      std::vector<ContactStatus> statuses;
      for (const double number : numbers)
        statuses.push_back(static_cast<ContactStatus>(number));
      return statuses;
    }


    /** The prefixes of the names of tables: of the end of a stage, and of a
     * run with a changed entry. */
    std::string
    prefix_of_end(const unsigned int position)
    {
      return "end of stage " + std::to_string(position + 1) + ": ";
    }

    std::string
    prefix_of_perturbed_run(const unsigned int number)
    {
      return "neighbor " + std::to_string(number + 1) + ": ";
    }


    /** The names of the tables of a force term. */
    std::string
    at_nodes(const std::string &term)
    {
      return term + " at nodes";
    }

    /** The names of the tables of a ContactState. */
    std::array<std::string, 4>
    names_of_contact(const unsigned int number)
    {
      const std::string contact = " of contact " + std::to_string(number + 1);
      return {{"active nodes" + contact,
               "multipliers" + contact,
               "grips" + contact,
               "stick points" + contact}};
    }


    std::string
    at_cells(const std::string &term)
    {
      return term + " at cells";
    }


    /** Add the distributed part of a restore point, by name after a prefix.
     * @return its numbers. */
    RunRecord::Point
    add_tables(const std::string                  &prefix,
               const RestorePoint                 &point,
               const ShellMesh                    &mesh,
               std::vector<CheckpointFile::Table> &tables)
    {
      const auto &[state, progress] = point;
      const auto add = [&](const std::string &name, const auto &values) {
        tables.emplace_back(prefix + name, rows_of(values, mesh));
      };
      add("displacement", state.displacement);
      if (state.velocity.size() > 0)
        add("velocity", state.velocity);
      add("resultants", state.resultants);
      for (unsigned int i = 0; i < state.contacts.size(); ++i)
        {
          const ContactState &contact    = state.contacts[i];
          const auto          name       = names_of_contact(i);
          const auto          add_points = [&](const std::string &name_of_table,
                                      const auto        &values) {
            tables.emplace_back(prefix + name_of_table,
                                rows_of(values, mesh, contact.per_cell));
          };
          add_points(name[0], contact.active);
          add_points(name[1], contact.multipliers);
          add_points(name[2], status_codes(contact.statuses));
          add_points(name[3],
                     std::vector<Tensor<1, 3>>(contact.stick_points.begin(),
                                               contact.stick_points.end()));
        }
      RunRecord::Point numbers;
      numbers.progress = progress;
      if (!state.contacts.empty())
        numbers.contacts_per_cell = state.ground().per_cell;
      for (const auto &[name, term] : state.terms)
        {
          numbers.of_terms[name] = term.numbers;
          for (auto &table :
               {CheckpointFile::Table(prefix + at_nodes(name),
                                      rows_of_nodes(term.at_nodes, mesh)),
                CheckpointFile::Table(prefix + at_cells(name),
                                      rows_of_cells(term.at_cells, mesh))})
            // a term that remembers nothing there has no table
            if (table.second.width > 0)
              tables.push_back(table);
        }
      if (const auto &prestress = state.prestress)
        {
          add("initial resultants", prestress->resultants);
          add("initial strains", prestress->strains);
          if (prestress->balancing_forces.size() > 0)
            add("balancing forces", prestress->balancing_forces);
        }
      if (const auto &base = state.linearization_point)
        {
          add("linearization displacement", base->displacement);
          add("linearization resultants", base->resultants);
        }
      if (const auto &step = progress.predictor.get_last())
        {
          add("predictor displacement", step->displacement);
          add("predictor resultants", step->resultants);
        }
      if (progress.last_change.size() > 0)
        add("last change", progress.last_change);
      if (progress.branch.size() > 0)
        add("branch", progress.branch);
      for (const auto &vector : progress.control.vectors)
        add("control: " + vector.first, vector.second);
      return numbers;
    }


    /** Likewise for all points of a run.
     * @return their numbers. */
    RunRecord::Points
    add_tables(const std::string                  &prefix,
               const RestorePoints                &points,
               const ShellMesh                    &mesh,
               std::vector<CheckpointFile::Table> &tables)
    {
      RunRecord::Points numbers;
      numbers.last = add_tables(prefix, points.last, mesh, tables);
      for (const auto &[position, end] : points.ends)
        numbers.ends[position] =
          add_tables(prefix + prefix_of_end(position), end, mesh, tables);
      return numbers;
    }
  } // namespace


  void
  write_checkpoint(const std::string     &directory,
                   RunRecord             &record,
                   const ShellMesh       &mesh,
                   const RestorePoints   &run,
                   const PerturbedPoints &perturbed)
  {
    std::vector<CheckpointFile::Table> tables;
    record.run = add_tables("", run, mesh, tables);
    record.perturbed.clear();
    for (unsigned int i = 0; i < perturbed.runs.size(); ++i)
      record.perturbed.push_back(add_tables(
        prefix_of_perturbed_run(i), perturbed.runs[i], mesh, tables));
    record.lost_stages             = perturbed.lost_stages;
    record.unsettled               = perturbed.unsettled;
    const std::vector<char> header = Utilities::pack(record, false);
    CheckpointFile::write(newest(directory),
                          previous(directory),
                          std::string(header.begin(), header.end()),
                          tables,
                          mesh.communicator);
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
    // a file system may have damaged the newest one, or the run ended between
    // the renames
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


  RestorePoint
  Checkpoint::read_point(const std::string      &prefix,
                         const RunRecord::Point &numbers,
                         const ShellMesh        &mesh) const
  {
    // vectors get their ghost entries by communication; what contact and force
    // terms remember is read at all nodes of a rank
    const auto nodes     = owned_node_numbers(mesh);
    const auto all_nodes = node_numbers(mesh);
    const auto cells     = cell_numbers(mesh);
    const auto has       = [&](const std::string &name) {
      return reader->has(prefix + name);
    };
    const auto rows = [&](const std::string &name, const auto &numbers) {
      return reader->rows(prefix + name, numbers);
    };
    const auto vector = [&](const std::string &name) {
      return vector_from(rows(name, nodes), mesh);
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
      return modes_from(rows(name, cells));
    };

    State state(mesh);
    state.displacement = ghosted("displacement");
    if (has("velocity"))
      state.velocity = ghosted("velocity");
    state.resultants = modes("resultants");
    state.contacts.clear();
    for (unsigned int i = 0; has(names_of_contact(i)[0]); ++i)
      {
        const auto   name = names_of_contact(i);
        ContactState contact;
        contact.per_cell    = numbers.contacts_per_cell;
        const auto &owners  = (contact.per_cell > 0 ? cells : all_nodes);
        contact.active      = active_from(rows(name[0], owners));
        contact.multipliers = vectors_from(rows(name[1], owners));
        contact.statuses    = statuses_of(rows(name[2], owners));
        const auto points   = vectors_from(rows(name[3], owners));
        contact.stick_points.assign(points.begin(), points.end());
        state.contacts.push_back(contact);
      }

    for (const auto &[name, of_term] : numbers.of_terms)
      {
        TermState &term = state.terms[name];
        term.numbers    = of_term;
        if (has(at_nodes(name)))
          term.at_nodes =
            table_from(rows(at_nodes(name), all_nodes), all_nodes.size());
        if (has(at_cells(name)))
          term.at_cells = table_from(rows(at_cells(name), cells), cells.size());
      }
    if (has("initial resultants"))
      {
        auto prestress        = std::make_shared<Prestress>();
        prestress->resultants = modes("initial resultants");
        prestress->strains    = modes("initial strains");
        if (has("balancing forces"))
          prestress->balancing_forces = vector("balancing forces");
        state.prestress = prestress;
      }
    if (has("linearization displacement"))
      {
        // prestress is that of the state and not stored twice
        State base(mesh);
        base.displacement         = ghosted("linearization displacement");
        base.resultants           = modes("linearization resultants");
        base.prestress            = state.prestress;
        state.linearization_point = std::make_shared<const State>(base);
      }

    RestorePoint result{state, numbers.progress};
    if (const auto &last = numbers.progress.predictor.get_last())
      {
        // the header has its numbers, the tables its vectors
        SecantPredictor::Step step = *last;
        step.displacement          = vector("predictor displacement");
        step.resultants            = modes("predictor resultants");
        result.progress.predictor.restore(step);
      }
    if (has("last change"))
      result.progress.last_change = vector("last change");
    if (has("branch"))
      result.progress.branch = vector("branch");
    for (auto &known : result.progress.control.vectors)
      known.second = vector("control: " + known.first);
    return result;
  }


  RestorePoints
  Checkpoint::read_points(const std::string       &prefix,
                          const RunRecord::Points &numbers,
                          const ShellMesh         &mesh) const
  {
    RestorePoints points{read_point(prefix, numbers.last, mesh), {}};
    for (const auto &[position, end] : numbers.ends)
      points.ends.emplace(
        position, read_point(prefix + prefix_of_end(position), end, mesh));
    return points;
  }


  RestorePoints
  Checkpoint::run(const ShellMesh &mesh) const
  {
    return read_points("", record.run, mesh);
  }


  PerturbedPoints
  Checkpoint::perturbed(const ShellMesh &mesh) const
  {
    PerturbedPoints result{{}, record.lost_stages, record.unsettled};
    for (unsigned int i = 0; i < record.perturbed.size(); ++i)
      result.runs.push_back(
        read_points(prefix_of_perturbed_run(i), record.perturbed[i], mesh));
    return result;
  }
} // namespace Biface
