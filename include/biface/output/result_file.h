// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_result_file_h
#define biface_output_result_file_h

#include <mpi.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <biface/output/units.h>

namespace Biface
{
  struct Node;
  class ReferenceSurface;
  class ShellEquations;
  struct State;
  struct StepReport;


  /** The directory of the files of results. It belongs to this object as long
   * as that exists: a second run in it is refused, also that of another
   * program. All functions must be called on all ranks. */
  class ResultsDirectory
  {
  public:
    /** Create the directory if it does not exist, and lock it. Throws
     * InputError if that fails, or if another run writes there. */
    ResultsDirectory(const std::string &name,
                     const MPI_Comm     communicator,
                     const Units       &units = {});

    ~ResultsDirectory();

    ResultsDirectory(const ResultsDirectory &) = delete;
    ResultsDirectory &
    operator=(const ResultsDirectory &) = delete;

    /** Keep a file that this run reads. */
    void
    keep(const std::string &path)
    {
      kept.push_back(path);
    }

    /** Throw InputError if one of the files to keep has a name in this
     * directory that matches a regular expression, and so would be overwritten.
     */
    void
    refuse_input(const std::string &names) const;

    /** Remove the files whose names match a regular expression, as far as the
     * system lets it, but those to keep.
     * @param last_step if set, only those with a greater number as the first
     * subexpression. */
    void
    remove(const std::string                 &names,
           const std::optional<unsigned long> last_step = {}) const;

    /** The path of a file in the directory, which is about to be written. */
    std::string
    path(const std::string &file);

    /** Flush the files of all paths requested since the last call to the disk.
     * Throws OutputError. */
    void
    sync();

    const MPI_Comm communicator;
    /** The names of the units of the results. */
    const Units units;

  private:
    void
    unlock();

    const std::string        name;
    std::set<std::string>    unsynced;
    std::vector<std::string> kept;
    /** The open directory, on the first rank; -1 if it cannot be locked. */
    int lock = -1;
  };


  /**
   * A file of results, or a series with one file per step; see doc/output.md
   * for a list. It records which steps it contains, so that a restart can
   * continue it. All functions must be called on all ranks.
   */
  class ResultFile
  {
  public:
    /** The directory and the equations are kept by reference. */
    ResultFile(const std::string    &name,
               ResultsDirectory     &directory,
               const ShellEquations &equations);

    virtual ~ResultFile() = default;

    /** The name of the file, such as "history.csv", or of a series, such as
     * "contact-*.csv" with a star instead of the number of the step.
     * Checkpoints identify the file by it. */
    const std::string name;

    /** The name and the purpose of the file, for the user. */
    virtual std::string
    description() const
    {
      return name;
    }

    /** Whether the file is requested and there is something to write. */
    virtual bool
    is_wanted() const
    {
      return true;
    }

    /** A sentence for each requested result that is not available. */
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

    /** A regular expression for the names of the files, in a series with the
     * number of the step as a subexpression. */
    virtual std::string
    names_of_files() const;

    /** Whether the steps are lines of one file, and not files. */
    virtual bool
    is_table() const
    {
      return false;
    }

    /** Start the file. Throws OutputError. */
    virtual void
    start()
    {}

    /** Continue the file of an earlier run after the given steps; later ones
     * are removed. Throws InputError if some of them are missing. */
    void
    resume(const std::vector<unsigned int> &steps);

    /** Write a converged step, if it belongs to the file. Throws
     * OutputError. */
    void
    write_step(const StepReport &report, const State &state);

    /** Write what write_step() has left to be prepared meanwhile. Throws
     * OutputError. */
    virtual void
    complete_step()
    {}

    /** The steps in the file. */
    const std::vector<unsigned int> &
    get_steps() const
    {
      return steps;
    }

  protected:
    /** Whether a step belongs to the file. */
    virtual bool
    contains(const StepReport & /*report*/) const
    {
      return true;
    }

    /** Remove what the file contains beyond get_steps(). In a series of files,
     * later steps replace the old files. */
    virtual void
    cut_back()
    {}

    /** Write a step, which is the last one of get_steps(). */
    virtual void
    write(const StepReport &report, const State &state) = 0;

    /** The path of the file, with the number of a step instead of the star. */
    std::string
    path(const unsigned int step = 0, const std::string &part = {}) const;

    const MPI_Comm        communicator;
    ResultsDirectory     &directory;
    const ShellEquations &equations;

  private:
    std::vector<unsigned int> steps;
  };


  /** A file of results that is a single table, to which each of its steps
   * appends lines, usually the same number. The first column is the step. */
  class StepTable : public ResultFile
  {
  public:
    /** A table in which each step has the same number of lines, or says how
     * many.
     * @param header the names of the columns, separated by commas.
     * @param lines_per_step 0 if the second column says how many.
     * @param wanted see is_wanted(). */
    StepTable(const std::string    &name,
              const std::string    &header,
              const unsigned int    lines_per_step,
              ResultsDirectory     &directory,
              const ShellEquations &equations,
              const bool            wanted = true);

    bool
    is_table() const override
    {
      return true;
    }

    bool
    is_wanted() const override
    {
      return wanted;
    }

    void
    start() override;

  protected:
    void
    cut_back() override;

    /** Append the lines of a step.
     * @param lines complete lines, including line ends. */
    void
    append(const std::string &lines) const;

  private:
    /** The number of lines of a step, which one of its lines tells. */
    unsigned int
    n_lines_of(const std::string &line) const;

    const std::string  header;
    const unsigned int lines_per_step;
    const bool         wanted;
  };


  /** The coordinate of a node in the user's unit: degrees for an angle.
   * Rounded, so that all nodes of a coordinate line have the same value. */
  double
  chart_coordinate(const ReferenceSurface &surface,
                   const Node             &node,
                   const unsigned int      a);
} // namespace Biface

#endif
