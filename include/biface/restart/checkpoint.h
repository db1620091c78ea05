// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_restart_checkpoint_h
#define biface_restart_checkpoint_h

#include <mpi.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <biface/input/pairs_file.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/output/results_writer.h>
#include <biface/output/rig_table.h>
#include <biface/output/summary_table.h>
#include <biface/restart/checkpoint_file.h>
#include <biface/stepping/restore_point.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /** The contents of a checkpoint except the fields of the shell, see
   * doc/restart.md. */
  struct RunRecord
  {
    /** The version of the program that wrote the checkpoint. */
    std::string version;
    /** All parameters of the run, as the text of a parameter file. */
    std::string parameters;
    /** The stages of the run. */
    std::vector<Stage> stages;
    /** The pairs in other files that were read, by entry. */
    PairsByEntry files;

    /** The differences of entries by which derivatives are taken, see
     * SensitivityParameters. */
    std::vector<double> differences;

    /** The numbers of a RestorePoint; its fields are in tables. */
    struct Point
    {
      Progress progress;
      /** The numbers of TermState, by the names of the terms. */
      std::map<std::string, std::vector<double>> of_terms;
      /** The number of points in contact per cell, see ContactState. */
      unsigned int contacts_per_cell = 0;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &progress &of_terms &contacts_per_cell;
      }
    };

    /** The numbers of RestorePoints. */
    struct Points
    {
      Point last;
      /** The points at the ends of stages, see StageEnds. */
      std::map<unsigned int, Point> ends;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &last &ends;
      }
    };

    Points run;
    /** The numbers of the perturbed runs, see PerturbedPoints. */
    std::vector<Points>                             perturbed;
    std::set<unsigned int>                          lost_stages;
    std::set<std::pair<unsigned int, unsigned int>> unsettled;
    ResultsWriter::Written                          written;
    /** The points of a tire test, so far. */
    RigTable::Points rig_points;
    /** The lines so far of the table at the end of the run. */
    SummaryTable summary;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &version &parameters &stages &files     &differences;
      archive &run &perturbed &lost_stages &unsettled &written;
      archive &rig_points                             &summary;
    }
  };


  /** Write a checkpoint into a directory, keeping the previous one. Must be
   * called on all ranks. Throws OutputError.
   * @param record without the numbers of the points, which are set.
   * @param mesh of the run, whose nodes and cells are those of perturbed runs,
   * too. */
  void
  write_checkpoint(const std::string     &directory,
                   RunRecord             &record,
                   const ShellMesh       &mesh,
                   const RestorePoints   &run,
                   const PerturbedPoints &perturbed = {});

  /** Remove the checkpoints of a directory, before another run starts
   * there. */
  void
  remove_checkpoints(const std::string &directory, const MPI_Comm communicator);


  /** A checkpoint to continue from. All functions must be called on all ranks.
   */
  class Checkpoint
  {
  public:
    /**
     * Read the latest valid checkpoint of a directory. Throws InputError if
     * there is none.
     */
    Checkpoint(const std::string &directory, const MPI_Comm communicator);

    /** A sentence that says why the latest checkpoint could not be used; empty
     * if it could. */
    const std::string &
    get_warning() const
    {
      return warning;
    }

    /** Remove the latest checkpoint if it could not be used, so that it never
     * becomes the previous one. */
    void
    remove_unusable() const;

    const RunRecord &
    get_record() const
    {
      return record;
    }

    /** The restore points of the run, on the same shell. */
    RestorePoints
    run(const ShellMesh &mesh) const;

    /** The restore points of the runs with changed entries. */
    PerturbedPoints
    perturbed(const ShellMesh &mesh) const;

  private:
    /** The state and progress that were written after a step.
     * @param prefix of the names of its tables. */
    RestorePoint
    read_point(const std::string      &prefix,
               const RunRecord::Point &numbers,
               const ShellMesh        &mesh) const;

    /** The restore points of one run.
     * @param prefix see read_point(). */
    RestorePoints
    read_points(const std::string       &prefix,
                const RunRecord::Points &numbers,
                const ShellMesh         &mesh) const;

    const std::string                       directory;
    std::unique_ptr<CheckpointFile::Reader> reader;
    std::string                             warning;
    RunRecord                               record;
  };
} // namespace Biface

#endif
