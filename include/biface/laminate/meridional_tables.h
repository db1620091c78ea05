// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_meridional_tables_h
#define biface_laminate_meridional_tables_h

#include <deal.II/base/function_lib.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace Biface
{
  /**
   * Tables of numbers as functions of @f$\alpha_1@f$, for the formulas of
   * plies: linear between their rows, constant beyond their ends.
   */
  class MeridionalTables
  {
  public:
    /**
     * Read the tables of a list of 'name: file' separated by commas; for the
     * files see parse_pairs(). Must be called on all ranks.
     *
     * Throws InputError if the list, a name or a file is invalid.
     */
    MeridionalTables(const std::string &list, const MPI_Comm communicator);

    /**
     * A formula of `alpha_1` and the names of the tables as a function of
     * @f$\alpha_1@f$. It keeps its own copy of the tables.
     *
     * Throws InputError like Formula.
     */
    std::function<double(const double)>
    parse(const std::string &entry, const std::string &text) const;

  private:
    using Table = dealii::Functions::InterpolatedTensorProductGridData<1>;

    void
    check_name(const std::string &name) const;

    std::map<std::string, std::shared_ptr<const Table>> tables;
  };
} // namespace Biface

#endif
