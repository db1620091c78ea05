// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <biface/base/errors.h>
#include <biface/contact/tread.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Of two springs, the first of which may be rigid. */
    double
    in_series(const std::optional<double> &first, const double second)
    {
      return first ? 1 / (1 / *first + 1 / second) : second;
    }
  } // namespace


  void
  TreadParameters::add_parameters(EntryDeclarations &prm)
  {
    prm.enter_subsection("Tread");
    add_optional_number(
      prm,
      "Height",
      height,
      "none",
      "Height of a tread of rubber that is no ply of the shell: a brush of "
      "bristles between its face and the ground. It replaces 'automatic' of "
      "'Regularization' and 'Tangential regularization' by 4/3 E (1 - v)/h and "
      "1/3 E (1 - v)/h, with the modulus E and the void ratio v; with given "
      "ones it is in series. The face of the shell touches where the tread "
      "does. A positive number, or 'none' for no tread.",
      Unit("length"));
    prm.add_parameter("Modulus",
                      modulus,
                      "Young's modulus of the rubber of the tread. A positive "
                      "number if there is a tread.",
                      Patterns::Double(),
                      Unit("force/area"));
    prm.add_parameter("Void ratio",
                      void_ratio,
                      "The part of the area of the tread that grooves take "
                      "away. A number from 0 to below 1.",
                      Patterns::Double(),
                      Unit::none());
    prm.leave_subsection();
  }


  void
  TreadParameters::check() const
  {
    if (!height)
      {
        if (modulus != 0 || void_ratio != 0)
          throw InputError("the entry 'Contact/Tread/Height' must be given "
                           "together with other entries of the tread.");
        return;
      }
    check_positive("Contact/Tread/Height", *height);
    check_positive("Contact/Tread/Modulus", modulus);
    if (!(void_ratio >= 0 && void_ratio < 1))
      throw InputError("Contact/Tread/Void ratio",
                       number_to_string(void_ratio),
                       "it must be at least 0 and below 1");
  }


  double
  TreadParameters::normal_stiffness() const
  {
    // 4/3 E in compression over E/3 in shear, since the rubber hardly spreads
    // along the ribs
    return 4 * tangential_stiffness();
  }


  double
  TreadParameters::tangential_stiffness() const
  {
    Assert(height, ExcInternalError());
    return (1 - void_ratio) * modulus / (3 * *height);
  }


  std::optional<double>
  TreadParameters::across(const std::optional<double> &given) const
  {
    return height ? in_series(given, normal_stiffness()) : given;
  }


  std::optional<double>
  TreadParameters::along(const std::optional<double> &given) const
  {
    return height ? in_series(given, tangential_stiffness()) : given;
  }
} // namespace Biface
