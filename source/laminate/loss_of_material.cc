// SPDX-License-Identifier: LGPL-2.1-or-later

#include <memory>

#include <biface/laminate/cord_law.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/loss_of_material.h>
#include <biface/laminate/material_law.h>

namespace Biface
{
  namespace
  {
    /** The stresses of another law, multiplied by a factor. */
    class ScaledMaterialLaw : public MaterialLaw
    {
    public:
      ScaledMaterialLaw(std::shared_ptr<const MaterialLaw> law,
                        const double                       factor)
        : law(std::move(law)), factor(factor)
      {}

      double
      energy(const Vector &strain) const override
      {
        return factor * law->energy(strain);
      }

      void
      evaluate(const Vector &strain,
               Vector       &stress,
               Matrix       &moduli) const override
      {
        law->evaluate(strain, stress, moduli);
        stress *= factor;
        moduli *= factor;
      }

      ThicknessStress
      thickness_stress(const Vector &strain) const override
      {
        const ThicknessStress result = law->thickness_stress(strain);
        return {factor * result.stress, factor * result.modulus};
      }

      double
      free_thickness_strain(const Vector &strain) const override
      {
        return law->free_thickness_strain(strain);
      }

      double
      lowest_thickness_strain(const Vector &strain) const override
      {
        return law->lowest_thickness_strain(strain);
      }

    private:
      const std::shared_ptr<const MaterialLaw> law;
      const double                             factor;
    };


    /** The stress of the cords of another law, multiplied by a factor. */
    class ScaledCordLaw : public CordLaw
    {
    public:
      ScaledCordLaw(std::shared_ptr<const CordLaw> law, const double factor)
        : law(std::move(law)), factor(factor)
      {}

      Response
      response(const double strain) const override
      {
        const Response result = law->response(strain);
        return {factor * result.energy,
                factor * result.stress,
                factor * result.modulus};
      }

      bool
      is_slack(const double strain) const override
      {
        return law->is_slack(strain);
      }

      double
      lowest_modulus() const override
      {
        return factor * law->lowest_modulus();
      }

    private:
      const std::shared_ptr<const CordLaw> law;
      const double                         factor;
    };
  } // namespace


  std::complex<double>
  LossOfMaterial::factor(const double omega) const
  {
    std::complex<double> result(1, loss_factor);
    for (const auto &[time, part] : relaxation)
      result -= part / std::complex<double>(1, omega * time);
    return result;
  }


  std::map<std::string, LossOfMaterial>
  losses(const Laminate &laminate, const double temperature)
  {
    std::map<std::string, LossOfMaterial> result;
    for (const Ply &ply : laminate.get_plies())
      {
        const auto &relaxation = ply.laws.relaxation;
        if (!(ply.material.loss_factor > 0) && !relaxation)
          continue;
        LossOfMaterial loss{ply.material.loss_factor, {}};
        if (relaxation)
          for (const Relaxation::Term &term : relaxation->get_terms())
            loss.relaxation.emplace_back(
              term.time * relaxation->factor_of_times(temperature), term.part);
        result.emplace(ply.material.name, loss);
      }
    return result;
  }


  Laminate
  with_scaled_material(const Laminate    &laminate,
                       const std::string &material,
                       const double       factor)
  {
    std::vector<Ply> plies = laminate.get_plies();
    for (Ply &ply : plies)
      if (ply.material.name == material)
        {
          ply.laws.stiffness *= factor;
          if (ply.laws.rubber)
            ply.laws.rubber =
              std::make_shared<ScaledMaterialLaw>(ply.laws.rubber, factor);
          if (ply.laws.cords)
            ply.laws.cords =
              std::make_shared<ScaledCordLaw>(ply.laws.cords, factor);
        }
    return laminate.with_plies(std::move(plies));
  }
} // namespace Biface
