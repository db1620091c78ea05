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
   * ranks. Line ends are converted to '\\n', and a UTF-8 byte order mark is
   * removed.
   *
   * Throws InputError on all ranks if the file cannot be read, is not a text,
   * or exceeds 64 MiB.
   */
  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator);


  /** A line of a text. */
  struct NumberedLine
  {
    /** The name of the text and the number of the line, for error messages. */
    std::string place;
    std::string text;
  };

  /** The lines of the text of a CSV file, but those without cells, those that
   * start with '#' or '%', and a first line such as 'sep=;', which tells a
   * separator. Throws InputError if a line is too long. */
  std::vector<NumberedLine>
  lines_of_csv(const std::string &text,
               const std::string &name,
               const std::string &form);


  /** The cells of a line, without blanks around them.
   * @param separator between two cells; ' ' for any number of blanks and
   * tabs. */
  std::vector<std::string>
  split_cells(const std::string &line, const char separator);

  /** Whether the text of a number has a decimal comma, as in '1,5'. */
  bool
  is_decimal_comma(const std::string &number);


  /** What a line of numbers in a CSV file must contain. */
  struct CsvRowForm
  {
    /** A sentence for error messages. */
    std::string  meaning;
    unsigned int n_min = 1;
    unsigned int n_max = 1;
    /** Whether the first line may contain the names of the columns. */
    bool header_allowed = false;
    /** The names of the columns in their order, to which those of a file may
     * refer. */
    std::vector<std::string> columns = {};
    /** The name of the unit of length of columns that are lengths; empty if it
     * is not known. */
    std::string unit_of_length = "";

    /** The sentence, with the separators of several numbers. */
    std::string
    text() const;
  };


  /**
   * Rows of numbers, one per line. They are separated by commas, semicolons,
   * tabs or blanks, the same in all lines, and may have decimal commas where
   * these do not separate them. Cells may be in double quotes.
   *
   * The first line may contain names of columns. If they are those of the form
   * in another order, the numbers of each row are put in order: 'z, r' as names
   * of a radius and an axial coordinate. A unit in brackets may follow a name.
   *
   * Throws InputError, naming the line, if a line contains anything else, if
   * names of columns leave their order open, if a unit is not that of the form,
   * or if commas may separate decimals as well as thousands.
   */
  std::vector<std::vector<double>>
  parse_rows(const std::vector<NumberedLine> &lines, const CsvRowForm &form);


  /**
   * Read rows of numbers from the text of a CSV file, one per line. Empty
   * lines, lines that start with '#' or '%' and a first line of column names
   * are skipped; for separators see parse_rows() of lines.
   *
   * Throws InputError, naming @p name and the line, if a line contains anything
   * else.
   *
   * @param text the contents of the file.
   * @param name the name of the file, for error messages.
   * @param meaning what a line must contain, for error messages.
   * @param n_min,n_max the numbers in a row.
   * @param columns see CsvRowForm.
   */
  std::vector<std::vector<double>>
  parse_rows(const std::string              &text,
             const std::string              &name,
             const std::string              &meaning,
             const unsigned int              n_min,
             const unsigned int              n_max,
             const std::vector<std::string> &columns = {});


  /** Rows of two numbers, see parse_rows().
   * @param meaning the names of the two columns, separated by a comma.
   * @param unit_of_length of columns that are lengths; empty if it is not
   * known. */
  std::vector<dealii::Point<2>>
  parse_pairs(const std::string &text,
              const std::string &name,
              const std::string &meaning,
              const std::string &unit_of_length = "");


  /**
   * The name of a file in an entry: as it is, or in double quotes, where %XX is
   * the byte with this hexadecimal code. In quotes it may contain what is not
   * possible in a parameter file or a list: '#', braces, commas.
   *
   * Throws InputError if quotes or codes are incomplete.
   */
  std::string
  parse_file_name(const std::string &entry, const std::string &text);

  /** The text from which parse_file_name() reads the name. */
  std::string
  print_file_name(const std::string &name);
} // namespace Biface

#endif
