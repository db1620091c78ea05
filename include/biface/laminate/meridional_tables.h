// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_meridional_tables_h
#define biface_laminate_meridional_tables_h

#include <deal.II/base/function_lib.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <biface/input/formula.h>
#include <biface/input/read_file.h>

namespace Biface
{
  /** A table of numbers by @f$\alpha_1@f$, which formulas know by its name. */
  struct TableFile
  {
    std::string name;
    PairsFile   file;
  };

  /** Read a list, 'name: file' separated by commas; files are not opened.
   * Throws InputError where the list or a name cannot be used. */
  std::vector<TableFile>
  parse_tables(const std::string &entry, const std::string &text);

  /** The list that parse_tables() takes for these tables. */
  std::string
  print_tables(const std::vector<TableFile> &tables);


  /**
   * The tables that formulas of plies know: linear between their rows, constant
   * beyond their ends.
   */
  class MeridionalTables
  {
  public:
    /** Throws InputError where a table cannot be interpolated. */
    explicit MeridionalTables(const std::vector<TableFile> &tables);

    /**
     * A formula of `alpha_1` and of the tables, by their names, as a function
     * of @f$\alpha_1@f$. It does not need the tables any longer.
     */
    std::function<double(const double)>
    function(Formula formula) const;

    /** Let a formula know the variables. Throws InputError, see
     * Formula::bind(). */
    static void
    bind(Formula &formula, const std::vector<TableFile> &tables);

  private:
    using Table = dealii::Functions::InterpolatedTensorProductGridData<1>;

    std::vector<std::string>                  names;
    std::vector<std::shared_ptr<const Table>> tables;
  };
} // namespace Biface

#endif
