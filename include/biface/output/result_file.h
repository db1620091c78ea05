// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_result_file_h
#define biface_output_result_file_h

#include <mpi.h>

#include <set>
#include <string>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** Where the files of results are. All functions must be called on all
   * ranks. */
  class ResultsDirectory
  {
  public:
    /** Make the directory, if need be. Throws InputError where that is not
     * possible. */
    ResultsDirectory(const std::string &name, const MPI_Comm communicator);

    /** The path of a file of the directory that is about to be written. */
    std::string
    path(const std::string &file);

    /** Bring the files of all paths given out since the last call to the disk.
     * Throws OutputError. */
    void
    sync();

    const MPI_Comm communicator;

  private:
    const std::string     name;
    std::set<std::string> unsynced;
  };


  /**
   * A file of results, or a series of them with one per step; see
   * doc/output.md for those there are. It knows which steps it holds, so that a
   * restart can continue it. All functions must be called on all ranks.
   */
  class ResultFile
  {
  public:
    /** The directory and the equations are kept by reference. */
    ResultFile(const std::string    &name,
               ResultsDirectory     &directory,
               const ShellEquations &equations);

    virtual ~ResultFile() = default;

    /** Such as "history.csv", or "contact-*.csv" with the number of the step in
     * place of the star. Checkpoints know the file by it. */
    const std::string name;

    /** The name as told to the user, with what the file is for. */
    virtual std::string
    description() const
    {
      return name;
    }

    /** Whether it is asked for, and there is something to write. */
    virtual bool
    is_wanted() const
    {
      return true;
    }

    /** What is asked for and cannot be given: a sentence each. */
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

    /** Start the file. Throws OutputError. */
    virtual void
    start()
    {}

    /** Continue the file of an earlier run after the given steps: what it holds
     * beyond is cut off. Throws InputError where it holds less. */
    void
    resume(const std::vector<unsigned int> &steps);

    /** Write a converged step. Throws OutputError. */
    void
    write_step(const StepReport &report, const State &state);

    /** The steps that the file holds. */
    const std::vector<unsigned int> &
    get_steps() const
    {
      return steps;
    }

  protected:
    /** Cut off what the file holds beyond get_steps(). A series of files has
     * nothing to cut: later steps replace theirs. */
    virtual void
    cut_back()
    {}

    /** Write a step, which is the last one of get_steps(). */
    virtual void
    write(const StepReport &report, const State &state) = 0;

    /** The path of the file, with the number of a step for the star. */
    std::string
    path(const unsigned int step = 0) const;

    const MPI_Comm        communicator;
    ResultsDirectory     &directory;
    const ShellEquations &equations;

  private:
    std::vector<unsigned int> steps;
  };


  /** A file of results that is one table, to which each step appends the same
   * number of lines. Its first column is the step. */
  class StepTable : public ResultFile
  {
  public:
    /** @param header names of the columns, separated by commas. */
    StepTable(const std::string    &name,
              const std::string    &header,
              const unsigned int    lines_per_step,
              ResultsDirectory     &directory,
              const ShellEquations &equations);

    void
    start() override;

  protected:
    void
    cut_back() override;

    /** @param lines each with its end. */
    void
    append(const std::string &lines) const;

  private:
    const std::string  header;
    const unsigned int lines_per_step;
  };


  /** A node's coordinate as a person writes it: degrees for an angle. Free of
   * round-off, so that nodes of one coordinate line agree in it. */
  double
  chart_coordinate(const ReferenceSurface &surface,
                   const Node             &node,
                   const unsigned int      a);
} // namespace Biface

#endif
