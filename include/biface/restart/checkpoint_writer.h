// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_restart_checkpoint_writer_h
#define biface_restart_checkpoint_writer_h

#include <deal.II/base/timer.h>

#include <functional>
#include <string>

namespace Biface
{
  struct AllPoints;
  class EntryDeclarations;
  struct Progress;
  class ResultsWriter;
  struct RunRecord;
  class ShellMesh;


  /** Decides when checkpoints are written to the directory of results. All
   * functions must be called on all ranks. */
  class CheckpointWriter
  {
  public:
    struct Parameters
    {
      bool         write       = true;
      unsigned int every_steps = 0;

      void
      add_parameters(EntryDeclarations &prm);
    };

    /**
     * The objects are kept by reference.
     * @param progress that of the run, as the last converged step leaves it.
     * @param points returns what a checkpoint contains.
     * @param restarted whether a checkpoint of the last step exists.
     */
    CheckpointWriter(const Parameters                 &parameters,
                     const std::string                &directory,
                     const ShellMesh                  &mesh,
                     const Progress                   &progress,
                     const std::function<AllPoints()> &points,
                     ResultsWriter                    &results,
                     const bool                        restarted);

    /** Write a checkpoint if one is due. Throws OutputError. */
    void
    write_if_due(RunRecord &record);

    /** Write a checkpoint, unless one of the last step exists. Throws
     * OutputError. */
    void
    write(RunRecord &record);

  private:
    const Parameters                 parameters;
    const std::string                directory;
    const ShellMesh                 &mesh;
    const Progress                  &progress;
    const std::function<AllPoints()> points;
    ResultsWriter                   &results;

    bool          any_written = false;
    unsigned int  last_step   = 0;
    dealii::Timer since_last;
  };
} // namespace Biface

#endif
