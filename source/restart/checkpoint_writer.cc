// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/input/entry_declarations.h>
#include <biface/restart/checkpoint.h>
#include <biface/restart/checkpoint_writer.h>

namespace Biface
{
  using namespace dealii;

  void
  CheckpointWriter::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Write",
                      write,
                      "Whether to write checkpoints to the directory of "
                      "results, from which '--restart' continues the run.",
                      Patterns::Bool());
    prm.add_parameter("Every steps",
                      every_steps,
                      "Number of converged steps between checkpoints; 0: not "
                      "used. A checkpoint is also written after the first step "
                      "that ends three seconds or more after the last one, and "
                      "at the end.",
                      Patterns::Integer(0));
  }


  CheckpointWriter::CheckpointWriter(const Parameters  &parameters,
                                     const std::string &directory,
                                     const ShellMesh   &mesh,
                                     const Progress    &progress,
                                     const std::function<AllPoints()> &points,
                                     ResultsWriter                    &results,
                                     const bool restarted)
    : parameters(parameters)
    , directory(directory)
    , mesh(mesh)
    , progress(progress)
    , points(points)
    , results(results)
    , any_written(restarted)
    , last_step(progress.n_steps)
  {}


  void
  CheckpointWriter::write_if_due(RunRecord &record)
  {
    constexpr double   max_seconds = 3;
    const unsigned int n_steps     = progress.n_steps - last_step;
    // use the clock of one rank
    const double seconds =
      Utilities::MPI::broadcast(mesh.communicator, since_last.wall_time());
    if ((parameters.every_steps > 0 && n_steps >= parameters.every_steps) ||
        seconds >= max_seconds)
      write(record);
  }


  void
  CheckpointWriter::write(RunRecord &record)
  {
    // without a step since, nothing has changed
    if (!parameters.write || (any_written && last_step == progress.n_steps))
      return;

    // a restart finds at least the files of the checkpoint
    results.sync();
    record.written      = results.get_written();
    const AllPoints now = points();
    write_checkpoint(directory, record, mesh, now.run, now.perturbed);
    any_written = true;
    last_step   = progress.n_steps;
    since_last.restart();
  }
} // namespace Biface
