// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_coefficient_h
#define biface_contact_friction_coefficient_h

#include <memory>
#include <optional>
#include <string>

namespace Biface
{
  class Formula;


  /** A coefficient of friction: a number, or a formula of the contact pressure
   * `p` and of the slip velocity `s`, which is 0 unless the shell rolls. Copies
   * share the formula. */
  class FrictionCoefficient
  {
  public:
    /** The number 0. */
    FrictionCoefficient() = default;

    /** @param entry for error messages.
     *
     * Throws InputError if the text is neither a number nor a formula that is
     * finite for some pressure and velocity, or if the number is negative. */
    FrictionCoefficient(const std::string &entry, const std::string &text);

    /** Whether it is the number 0. */
    bool
    is_zero() const
    {
      return constant && *constant == 0;
    }

    /** Whether it depends neither on the pressure nor on the slip velocity. */
    bool
    is_constant() const
    {
      return constant.has_value();
    }

    /** Whether it depends on the slip velocity. */
    bool
    depends_on_speed() const;

    /** The coefficient; 0 where the formula is negative, and NaN where it is
     * not finite.
     * @param speed the slip velocity. */
    double
    value(const double pressure, const double speed) const;

    const std::string &
    get_text() const
    {
      return text;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::string now = text;
      archive    &now;
      if (now != text)
        *this = FrictionCoefficient("Friction", now);
    }

  private:
    std::string                    text     = "0";
    std::optional<double>          constant = 0;
    std::shared_ptr<const Formula> formula;
  };

  /** Read a coefficient, see its constructor. */
  FrictionCoefficient
  parse_friction(const std::string &entry, const std::string &text);
} // namespace Biface

#endif
