// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_suspension_parameters_h
#define biface_contact_suspension_parameters_h

#include <functional>
#include <string>
#include <vector>

#include <biface/contact/suspension.h>
#include <biface/input/named_numbers.h>

namespace Biface
{
  class EntryDeclarations;


  /** The suspensions of several motions, by their names. */
  struct SuspensionParameters
  {
    NamedNumbers springs, dampers, masses;

    /** @param names what the names in the lists are, for the documentation. */
    void
    add_parameters(EntryDeclarations &prm, const std::string &names);

    /** Throws InputError if a value is negative or a name is not known.
     * @param known what the names must be, as part of a sentence. */
    void
    check(const std::string                              &section,
          const std::function<bool(const std::string &)> &is_known,
          const std::string                              &known) const;

    Suspension
    of(const std::string &name) const;

    /** A number of a list. */
    struct Item
    {
      /** The entry of the list, such as "Masses". */
      std::string entry;
      std::string name;
      double      value;
    };

    /** All numbers, list by list. */
    std::vector<Item>
    items() const;
  };
} // namespace Biface

#endif
