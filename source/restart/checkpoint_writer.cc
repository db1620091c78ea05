// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
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
                      "used. A checkpoint is always written at the end.",
                      Patterns::Integer(0));
    prm.add_parameter("Every minutes",
                      every_minutes,
                      "Wall time between checkpoints, checked after each "
                      "step; 0: not used.",
                      Patterns::Double(0),
                      Unit("minutes"));
  }


  void
  CheckpointWriter::Parameters::check() const
  {
    check_not_negative("Checkpoint/Every minutes", every_minutes);
  }


  CheckpointWriter::CheckpointWriter(const Parameters              &parameters,
                                     const std::string             &directory,
                                     const ShellMesh               &mesh,
                                     const Progress                &progress,
                                     const std::function<Points()> &points,
                                     ResultsWriter                 &results,
                                     const bool                     restarted)
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
    const unsigned int n_steps = progress.n_steps - last_step;
    // use the clock of one rank
    const double minutes =
      Utilities::MPI::broadcast(mesh.communicator, since_last.wall_time() / 60);
    if ((parameters.every_steps > 0 && n_steps >= parameters.every_steps) ||
        (parameters.every_minutes > 0 && minutes >= parameters.every_minutes))
      write(record);
  }


  void
  CheckpointWriter::write(RunRecord &record)
  {
    if (!parameters.write || (any_written && last_step == progress.n_steps))
      return;

    // a restart finds at least the files of the checkpoint
    results.sync();
    record.written   = results.get_written();
    const Points now = points();
    write_checkpoint(directory, record, mesh, now.run, now.perturbed);
    any_written = true;
    last_step   = progress.n_steps;
    since_last.restart();
  }
} // namespace Biface
