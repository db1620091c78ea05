// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_loss_of_material_h
#define biface_laminate_loss_of_material_h

#include <complex>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  class Laminate;

  /** The energy that plies of a material lose in harmonic vibrations: their
   * moduli are complex multiples of those of the elastic law, which for
   * stresses that relax are the instantaneous ones. */
  struct LossOfMaterial
  {
    /** The tangent of the angle by which strains lag behind stresses at all
     * frequencies. */
    double loss_factor = 0;

    /** The times @f$a\tau_i@f$ and the parts @f$g_i@f$ of a Relaxation. Unit of
     * the times: time. */
    std::vector<std::pair<double, double>> relaxation;

    /** The factor @f$1+i\eta@f$, and with relaxation
     * @f$1-\sum_ig_i/(1+i\omega a\tau_i)@f$, of the moduli in vibrations
     * @f$\propto e^{i\omega t}@f$.
     * @param omega the angular frequency. Unit: 1/time. */
    std::complex<double>
    factor(const double omega) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &loss_factor &relaxation;
    }
  };


  /** The materials of the plies of a laminate that lose energy, by name.
   * @param temperature see TimeStep. */
  std::map<std::string, LossOfMaterial>
  losses(const Laminate &laminate, const double temperature);


  /** The laminate in which all stresses of the plies of a material are
   * multiplied by a factor, those of cords included. */
  Laminate
  with_scaled_material(const Laminate    &laminate,
                       const std::string &material,
                       const double       factor);
} // namespace Biface

#endif
