// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_checkpoint_h
#define biface_program_checkpoint_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <biface/model/state.h>
#include <biface/output/results_writer.h>
#include <biface/restart/checkpoint_file.h>
#include <biface/stepping/progress.h>

namespace Biface
{
  struct Parameters;
  class Simulation;


  /** When checkpoints are written. */
  struct CheckpointParameters
  {
    bool         write         = true;
    unsigned int every_steps   = 1;
    double       every_minutes = 0;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Throws InputError where a value is not usable. */
    void
    check() const;
  };


  /** A step with contact, in the table at the end of a run. */
  struct LoadDeflection
  {
    double         approach;
    ContactSummary contact;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &approach &contact.force &contact.n_nodes &contact.area &contact
        .max_pressure;
    }
  };


  /** What a checkpoint holds beside the shell itself, see doc/restart.md. */
  struct RunRecord
  {
    /** Of the program that wrote it. */
    std::string version;
    /** All parameters of the run, as the text of a parameter file. */
    std::string parameters;
    /** The contents of other files that were read, by what they are for. */
    std::map<std::string, std::string> files;

    Progress                    progress;
    double                      predictor_size = 0;
    ResultsWriter::Written      written;
    std::vector<LoadDeflection> curve;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &version &parameters &files &progress &predictor_size &written
        &curve;
    }
  };


  /**
   * Writes checkpoints into the directory of results, two generations of them.
   * All functions must be called on all ranks.
   */
  class CheckpointWriter
  {
  public:
    /**
     * The objects are kept by reference.
     * @param restarted whether the checkpoint of the last step is there.
     */
    CheckpointWriter(const CheckpointParameters &parameters,
                     const std::string          &directory,
                     const Simulation           &simulation,
                     ResultsWriter              &results,
                     const bool                  restarted);

    /** Write a checkpoint, if it is time for one. Throws OutputError. */
    void
    write_if_due(RunRecord &record);

    /** Write a checkpoint, unless the one of the last step is there. Throws
     * OutputError. */
    void
    write(RunRecord &record);

    /** Remove the checkpoints of a directory, before another run begins
     * there. */
    static void
    remove(const std::string &directory, const MPI_Comm communicator);

  private:
    const CheckpointParameters parameters;
    const std::string          directory;
    const Simulation          &simulation;
    ResultsWriter             &results;

    bool          any_written = false;
    unsigned int  last_step   = 0;
    dealii::Timer since_last;
  };


  /** A checkpoint to continue from. All functions must be called on all ranks.
   */
  class Checkpoint
  {
  public:
    /**
     * Read the newest checkpoint of a directory that is not damaged. Throws
     * InputError where there is none.
     */
    Checkpoint(const std::string &directory, const MPI_Comm communicator);

    /** Where the newest one could not be used: a sentence. */
    const std::string &
    get_warning() const
    {
      return warning;
    }

    /** Remove the newest one where it could not be used, so that it will not
     * take the place of the one before. */
    void
    remove_unusable() const;

    const RunRecord &
    get_record() const
    {
      return record;
    }

    /** Put a simulation of the same shell where it was.
     * @param before, now the stages of the run that is continued, and those to
     * go on with; see check_continuation(). */
    void
    restore(Simulation               &simulation,
            const std::vector<Stage> &before,
            const std::vector<Stage> &now) const;

  private:
    const std::string                       directory;
    std::unique_ptr<CheckpointFile::Reader> reader;
    std::string                             warning;
    RunRecord                               record;
  };
} // namespace Biface

#endif
