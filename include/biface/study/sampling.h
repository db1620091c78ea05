// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_sampling_h
#define biface_study_sampling_h

#include <mpi.h>

#include <string>
#include <vector>

#include <biface/input/read_file.h>
#include <biface/problem/design_variable.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * The samples of a study: the values of design variables in each of its
   * analyses.
   */
  struct Sampling
  {
    enum class Type
    {
      /** Every combination of the values of the variables; the last variable
       * changes from one sample to the next. */
      grid,
      /** The k-th sample has the k-th value of each variable. */
      list,
      /** Each of n equal parts of the range of a variable contains one of the
       * n samples, at a random position; the parts are combined at random,
       * @cite McKayBeckmanConover1979. */
      latin_hypercube,
      /** The samples are the lines of a CSV file. */
      file
    };

    /** The values given for a variable. */
    struct Values
    {
      std::string         variable;
      std::vector<double> values;
      /** Whether the values are the two ends of a range. */
      bool is_range = false;
    };

    Type                        type = Type::grid;
    std::vector<DesignVariable> variables;
    std::vector<Values>         values;
    unsigned int                n_samples = 100;
    unsigned int                seed      = 1;
    std::string                 file_name;

    /** Declare the entries in the section 'Study'. */
    void
    add_parameters(EntryDeclarations &prm);

    /**
     * The values of the variables in each sample.
     *
     * Throws InputError if entries contradict each other, or the file contains
     * anything but a line of the names of the variables, in any order, and
     * lines of numbers. Must be called on all ranks; the first one reads the
     * file.
     *
     * @param folder that to which the name of the file is relative.
     */
    std::vector<std::vector<double>>
    samples(const std::string &folder, const MPI_Comm communicator) const;

  private:
    /** The values given for a variable. Throws InputError if there are none. */
    const Values &
    values_of(const DesignVariable &variable) const;

    /** The column of each variable in a file whose first line is @p line.
     * Throws InputError if it does not contain their names. */
    std::vector<unsigned int>
    columns_of(const NumberedLine &line) const;

    std::vector<std::vector<double>>
    read_samples(const std::string &folder, const MPI_Comm communicator) const;
  };
} // namespace Biface

#endif
