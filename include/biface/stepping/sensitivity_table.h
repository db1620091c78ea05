// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_sensitivity_table_h
#define biface_stepping_sensitivity_table_h

#include <string>
#include <vector>

namespace Biface
{
  /** The derivatives of results by entries of the parameter file, at the end of
   * a stage. */
  struct SensitivityTable
  {
    struct Quantity
    {
      std::string name;
      double      value;
    };

    std::vector<Quantity> entries;
    std::vector<Quantity> outputs;

    /** The total derivatives `[entry][output]` of the outputs by the
     * entries. */
    std::vector<std::vector<double>> derivatives;

    /** The relative change of an output per relative change of an entry; not a
     * number where the output is zero. */
    double
    logarithmic(const unsigned int entry, const unsigned int output) const;
  };
} // namespace Biface

#endif
