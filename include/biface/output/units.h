// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_units_h
#define biface_output_units_h

#include <map>
#include <string>
#include <vector>

namespace Biface
{
  class EntryDeclarations;


  /** The names of the units of the input. Numbers do not depend on them. */
  class Units
  {
  public:
    void
    add_parameters(EntryDeclarations &prm);

    /** The units of fields in VTU files, by their names; empty without names of
     * units. */
    std::map<std::string, std::string>
    of_fields(const std::vector<std::string> &fields) const;

    /** The name of the unit of length; empty without names of units. */
    std::string
    of_length() const
    {
      return names.empty() ? "" : names[0];
    }

  private:
    /** The names of the units of length, force and time, or none. */
    std::vector<std::string> names;
  };
} // namespace Biface

#endif
