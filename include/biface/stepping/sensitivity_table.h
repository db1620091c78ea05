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

    /** `[entry][output]`: the total derivatives. */
    std::vector<std::vector<double>> derivatives;

    /** The change of an output in parts of its value by that of an entry in
     * parts of its value; not a number where the output is zero. */
    double
    logarithmic(const unsigned int entry, const unsigned int output) const;
  };
} // namespace Biface

#endif
