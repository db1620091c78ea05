// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_read_file_h
#define biface_input_read_file_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Biface
{
  /**
   * The text of a file. The first rank reads it for all; must be called on all
   * ranks. Lines end with '\\n' alone, and the mark that some editors put in
   * front of UTF-8 is left out.
   *
   * Throws InputError on all ranks where the file cannot be read, is not a
   * text, or has more than 64 MiB.
   */
  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator);


  /**
   * Read pairs of numbers from the text of a CSV file, a pair a line; empty
   * lines and lines that begin with '#' are skipped, and a first line of column
   * names.
   *
   * Throws InputError, naming @p name and the line, where a line holds anything
   * else.
   *
   * @param text what the file holds.
   * @param name of the file, for error messages.
   * @param meaning names of the two columns, for error messages.
   */
  std::vector<dealii::Point<2>>
  parse_pairs(const std::string &text,
              const std::string &name,
              const std::string &meaning);


  /** A file of pairs of numbers that an entry names. */
  struct PairsFile
  {
    /** Empty for none. */
    std::string                   name;
    std::vector<dealii::Point<2>> pairs;

    /** Read the pairs, see read_file() and parse_pairs(). */
    void
    read(const std::string &meaning, const MPI_Comm communicator);
  };


  /**
   * The name of a file as an entry has it: as it is, or in double quotes, where
   * %XX is the byte with this hexadecimal number. With quotes, it may hold what
   * a parameter file or a list could not: '#', braces, commas.
   *
   * Throws InputError where quotes or bytes are not complete.
   */
  std::string
  parse_file_name(const std::string &entry, const std::string &text);

  /** The text that parse_file_name() takes for a name. */
  std::string
  print_file_name(const std::string &name);
} // namespace Biface

#endif
