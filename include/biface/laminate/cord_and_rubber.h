// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_cord_and_rubber_h
#define biface_laminate_cord_and_rubber_h

#include <memory>
#include <string>

#include <biface/input/pairs_file.h>
#include <biface/laminate/force_curve.h>
#include <biface/laminate/material.h>

namespace Biface
{
  class EntryDeclarations;


  /** A ply of parallel cords in rubber, described by the data of its
   * constituents. */
  struct CordAndRubber
  {
    /** The way to the moduli across the cords from those of the
     * constituents. */
    enum class Homogenization
    {
      /** The equations of Halpin and Tsai, @cite HalpinKardos1976. */
      halpin_tsai,
      /** The limit of inextensible cords in incompressible rubber,
       * @cite AkasakaHirano1972. */
      akasaka_hirano
    };

    /** The dependence of the thickness of the ply on the distance of the
     * cords. */
    enum class Thickness
    {
      /** Rubber keeps its volume: the product of thickness and distance is
       * constant. */
      constant_volume,
      /** The thickness of the ply is that given, everywhere. */
      as_given
    };

    /** Young's moduli of cords and rubber. Unit: force/area. */
    double E_cord = 0, E_rubber = 0;
    /** The stretch and the force of a cord, given instead of @p E_cord, see
     * ForceCurve. */
    PairsFile curve;
    double    nu_cord = 0.3, nu_rubber = 0.49;
    /** The diameter of a cord, taken as a full circle. Unit: length. */
    double cord_diameter = 0;
    /** The distance between the centers of neighboring cords, across them, at
     * the crown. Unit: length. */
    double         cord_pitch     = 0;
    Homogenization homogenization = Homogenization::halpin_tsai;
    Thickness      thickness      = Thickness::constant_volume;

    void
    add_parameters(EntryDeclarations &prm);

    /** Check the numbers. Throws InputError that names the material @p name. */
    void
    check(const std::string &name) const;

    /** The curve of a cord; null for none. Throws InputError if it cannot be
     * used. */
    std::shared_ptr<const ForceCurve>
    force_curve() const;

    /** Young's modulus of the cords; with a curve, that at the stretch 1. Unit:
     * force/area. */
    double
    cord_modulus() const;

    /** The area of a cord. Unit: area. */
    double
    cord_area() const;

    /**
     * The transversely isotropic material with the volume fraction
     * @p fraction of cords, between 0 and 1:
     * @f[
     *   E_L = v E_c + (1 - v) E_r ,
     * @f]
     * @f$\nu_{LT}, E_T, G_{LT}@f$ by the homogenization, and @f$G_{TT}@f$ from
     * the plane strain bulk modulus @f$K_T@f$ of a composite of cylinders
     * @cite Hill1964,
     * @f[
     *   \frac4{E_T} = \frac1{G_{TT}} + \frac1{K_T} + \frac{4\nu_{LT}^2}{E_L} .
     * @f]
     */
    Material
    ply_material(const double fraction) const;
  };
} // namespace Biface

#endif
