// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_suspension_h
#define biface_contact_suspension_h

#include <functional>
#include <string>

#include <biface/input/named_numbers.h>

namespace Biface
{
  class EntryDeclarations;


  /** What resists a motion that a force finds, beside the shell; all zero for
   * nothing. Those of a motion that only turns have moments and angles. */
  struct Suspension
  {
    /** The stiffness of a spring without force at the factor 0. Unit:
     * force/length, or force*length per radian. */
    double spring = 0;
    /** Unit: force*time/length, or force*length*time per radian. */
    double damper = 0;
    /** The mass, or the moment of inertia. Unit: mass, or mass*length². */
    double mass = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &spring &damper &mass;
    }
  };


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
  };
} // namespace Biface

#endif
