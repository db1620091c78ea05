// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_histories_h
#define biface_stepping_load_histories_h

#include <mpi.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/input/formula.h>
#include <biface/input/table_file.h>

namespace Biface
{
  class EntryDeclarations;


  /** The loads of a stage that are formulas of the time t since its start,
   * which may name tables of the time. */
  class LoadHistories
  {
  public:
    void
    add_parameters(EntryDeclarations &prm);

    /** Read the tables and let the formulas know them. Must be called on all
     * ranks. Throws InputError if a file cannot be read, or if a formula uses
     * another name.
     * @param section that of the stage. */
    void
    read_tables(const std::string &section, const MPI_Comm communicator);

    /** The names of the loads, in the order of the file. */
    std::vector<std::string>
    names() const;

    bool
    has(const std::string &name) const;

    /** The value of a load at a time; none if it has no history. Throws
     * InputError if it is not finite. */
    std::optional<double>
    value(const std::string &name, const double t) const;

    std::vector<TableFile> tables;

  private:
    /** The formulas by the names of the loads. */
    std::vector<std::pair<std::string, Formula>> formulas;
    std::vector<InterpolatedTable>               interpolated;
  };
} // namespace Biface

#endif
