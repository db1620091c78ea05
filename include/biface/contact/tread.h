// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_tread_h
#define biface_contact_tread_h

#include <optional>

namespace Biface
{
  class EntryDeclarations;


  /**
   * A tread of rubber on the shell that is no ply of it: a brush whose bristles
   * do not touch each other, between the face of the shell and the body
   * @cite Pacejka2012.
   *
   * With Young's modulus @f$E@f$ of nearly incompressible rubber, the height
   * @f$h@f$ and the part @f$v@f$ of the area that is void, the stiffnesses per
   * area are, across and along the face,
   * @f[
   *   k_n = (1-v)\frac{4E}{3h},\qquad k_t = (1-v)\frac{E}{3h} .
   * @f]
   * The modulus across is that of rubber kept from spreading in one direction,
   * along the ribs of the tread.
   */
  struct TreadParameters
  {
    /** The height of the tread; if it is not set, there is no tread. Unit:
     * length. */
    std::optional<double> height;
    /** Young's modulus of the rubber. Unit: force/area. */
    double modulus    = 0;
    double void_ratio = 0;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check() const;

    /** The stiffness across the face. There must be a tread. Unit:
     * pressure/length. */
    double
    normal_stiffness() const;

    /** The stiffness along the face. There must be a tread. Unit:
     * pressure/length. */
    double
    tangential_stiffness() const;

    /** The penalty stiffness across the face with the tread, if there is one:
     * it replaces an automatic one, and is in series with a given one. Unit:
     * pressure/length. */
    std::optional<double>
    across(const std::optional<double> &given) const;

    /** Like across() along the face. */
    std::optional<double>
    along(const std::optional<double> &given) const;
  };
} // namespace Biface

#endif
