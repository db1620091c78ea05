// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/contact/friction_coefficient.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  namespace
  {
    /** Throws the InputError of a formula of pressure and slip velocity that is
     * finite at none of many values, since units are not known. */
    void
    check_somewhere_finite(const Formula &coefficient)
    {
      std::optional<InputError> first;
      // powers of ten, whatever the units; a shell that stands has the slip
      // velocity 0
      for (int p = -12; p <= 12; ++p)
        for (int s = -7; s <= 7; ++s)
          try
            {
              coefficient({std::pow(10., p), s == -7 ? 0. : std::pow(10., s)});
              return;
            }
          catch (const InputError &error)
            {
              if (!first)
                first = error;
            }
      throw InputError(*first);
    }
  } // namespace


  FrictionCoefficient::FrictionCoefficient(const std::string &entry,
                                           const std::string &text)
    : text(text)
    , constant()
    , formula(std::make_shared<const Formula>(
        entry, text, std::vector<std::string>{"p", "s"}))
  {
    if (formula->used_names().empty())
      {
        constant = (*formula)({0., 0.});
        check_not_negative(entry, *constant);
      }
    else
      check_somewhere_finite(*formula);
  }


  bool
  FrictionCoefficient::depends_on_speed() const
  {
    if (constant)
      return false;
    const std::vector<std::string> names = formula->used_names();
    return std::find(names.begin(), names.end(), "s") != names.end();
  }


  double
  FrictionCoefficient::value(const double pressure, const double speed) const
  {
    if (constant)
      return *constant;
    // not on all ranks: the step fails
    const double result = formula->unchecked({pressure, speed});
    return std::isfinite(result) ? std::max(0., result)
                                 : std::numeric_limits<double>::quiet_NaN();
  }


  FrictionCoefficient
  parse_friction(const std::string &entry, const std::string &text)
  {
    return FrictionCoefficient(entry, text);
  }
} // namespace Biface
