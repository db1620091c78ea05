// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_coordinate_h
#define biface_input_coordinate_h

#include <optional>
#include <string>

#include <biface/input/formula.h>

namespace Biface
{
  /**
   * A coordinate in an entry that is read before the surface is known: a
   * number, a formula of numbers such as `360/7`, or a formula of `end`, the
   * largest value of the coordinate on the surface.
   */
  class Coordinate
  {
  public:
    /**
     * @param entry the entry, for error messages.
     * @param text the number or formula.
     * @param item the part of the entry that contains it, for error messages.
     * @param allowed its allowed form, for error messages.
     *
     * Throws InputError if the text is neither.
     */
    Coordinate(const std::string &entry,
               const std::string &text,
               const std::string &item,
               const std::string &allowed);

    /** Whether the coordinate depends on `end`. */
    bool
    uses_end() const
    {
      return formula_of_end.has_value();
    }

    /** The value of the coordinate, in the unit of parameter files. Throws
     * InputError if it depends on @p end, which is infinite for a coordinate
     * without one. */
    double
    value(const double end) const;

  private:
    std::string            entry;
    std::string            item;
    double                 number = 0;
    std::optional<Formula> formula_of_end;
  };
} // namespace Biface

#endif
