// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_study_table_h
#define biface_study_study_table_h

#include <array>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * The table of a study, `study.csv`, with a row for each sample. A sample
   * writes its row to the file `sample.csv` in a directory of its own when it
   * has finished; any rank can collect the rows from there.
   */
  class StudyTable
  {
  public:
    static constexpr const char *file_name = "study.csv";

    /** The cells of a row that follow the values of the variables. */
    struct Results
    {
      /** The results of the sample; not a number where there is none. */
      std::vector<double> outputs;
      /** The reason of a failure, the status of the row; empty for "ok". */
      std::string  failure;
      unsigned int n_steps      = 0;
      unsigned int n_iterations = 0;
      double       seconds      = 0;
    };

    /** The names of the first column, and of those after the variables and
     * outputs. */
    static constexpr std::array<const char *, 5> own_columns = {
      {"sample", "status", "steps", "iterations", "seconds"}};

    /** The table of the samples in the directory of a study.
     * @param directory that of the study.
     * @param columns the names of the variables and outputs.
     * @param samples the values of the variables.
     * @param reference the number of the sample to whose outputs those of all
     * samples are related, from 1; 0 for none. */
    StudyTable(const std::string                      &directory,
               const std::vector<std::string>         &columns,
               const std::vector<std::vector<double>> &samples,
               const unsigned int                      reference);

    /** The directory of a sample. */
    std::string
    sample_directory(const unsigned int sample) const;

    /** The file with the row of a sample. */
    std::string
    row_file(const unsigned int sample) const;

    /** The text of the file with the row of a sample. */
    std::string
    row_text(const unsigned int sample, const Results &results) const;

    /** Read the rows that are new since the last call.
     * @return their samples. */
    std::vector<unsigned int>
    collect();

    /** Whether a collected row belongs to another study. */
    bool
    has_foreign_row() const;

    /** The text of the table: the collected rows, with the outputs over those
     * of the reference. */
    std::string
    text() const;

    /** The samples whose rows are not collected. */
    std::vector<unsigned int>
    missing() const;

    /** The number of collected rows with the status "ok". */
    unsigned int
    n_ok() const;

    /** The status in a collected row. */
    std::string
    status(const unsigned int sample) const;

    /** The seconds in a collected row. */
    std::string
    seconds(const unsigned int sample) const;

    /** Remove the rows in the directories of samples of any study. */
    static void
    remove_rows(const std::string &directory);

  private:
    /** The cells with the number of a sample and the values of its
     * variables. */
    std::string
    first_cells(const unsigned int sample) const;

    /** The outputs in the row of a sample, not a number where there is none. */
    std::vector<double>
    outputs(const std::string &row) const;

    std::string                      directory;
    std::string                      header;
    std::vector<std::string>         names_of_outputs;
    unsigned int                     reference;
    std::vector<std::vector<double>> samples;
    /** The row of each sample; empty if not collected. */
    std::vector<std::string> rows;
  };
} // namespace Biface

#endif
