// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_material_parameters_h
#define biface_laminate_material_parameters_h

#include <deal.II/base/symmetric_tensor.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/laminate/cord_and_rubber.h>
#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/material.h>
#include <biface/laminate/material_law.h>
#include <biface/laminate/ply_material.h>
#include <biface/laminate/relaxation.h>

namespace Biface
{
  class EntryDeclarations;

  /** The parameters of a named material. */
  struct MaterialParameters
  {
    enum class Type
    {
      isotropic,
      transversely_isotropic,
      orthotropic,
      cord_and_rubber,
      neo_Hooke,
      Mooney_Rivlin,
      Yeoh,
      Ogden
    };

    /** The law of the material between the cords of a ply. */
    enum class Matrix
    {
      linear,
      neo_Hooke
    };

    std::string   name;
    Type          type = Type::isotropic;
    double        E = 0, nu = 0;
    double        E_L = 0, E_T = 0, G_LT = 0, G_TT = 0, nu_LT = 0, nu_TT = 0;
    double        E_1 = 0, E_2 = 0, E_3 = 0;
    double        G_12 = 0, G_13 = 0, G_23 = 0;
    double        nu_12 = 0, nu_13 = 0, nu_23 = 0;
    CordAndRubber cord_and_rubber;
    /** The bulk modulus, 0 if not given. */
    double              K  = 0;
    double              mu = 0, c10 = 0, c20 = 0, c30 = 0, c01 = 0;
    std::vector<double> mu_i, alpha_i;
    Matrix              matrix = Matrix::linear;
    /** A formula of @f$E_L@f$ for Young's modulus along the cords where they
     * are compressed. */
    std::string E_L_compression = "E_L";
    /** The compressive strain from which on the modulus in compression applies;
     * a formula of @f$E_L,G_{LT}@f$. */
    std::string compression_onset = "by matrix";
    Strengths   strengths;
    /** The density. Unit: mass/volume. */
    double density = 0;
    /** The tangent of the angle by which strains lag behind stresses. */
    double loss_factor = 0;
    /** The conductivity of heat. Unit: power/(length * temperature). */
    double thermal_conductivity = 0;
    /** The times and parts of the terms of relaxation, see Relaxation::Term. */
    std::vector<double> relaxation_times, relaxation_moduli;
    Relaxation::Shift   shift;

    void
    add_parameters(EntryDeclarations &prm);

    /** Whether there is no direction in which fibers or cords run. */
    bool
    is_isotropic() const;

    /** Whether the law of the material, or that between the cords, is one for
     * large strains. */
    bool
    is_hyperelastic() const;

    /** Whether the stresses of the material relax. */
    bool
    relaxes() const
    {
      return !relaxation_times.empty();
    }

    /** Whether cords can go slack. Throws InputError if the type of the
     * material has no cords, or if E_L_compression is no formula. */
    bool
    has_slack_cords() const;

    /** Throws InputError if a constant is not admissible. */
    void
    check() const;

    /** What does not depend on the position of a ply. Throws InputError if a
     * constant is not admissible. */
    PlyMaterial
    of_ply() const;

    /**
     * The laws of a ply of the material. Throws InputError if a constant is not
     * admissible.
     *
     * @param cord_fraction the volume fraction of cords, used for cords in
     * rubber only.
     * @param initial_stress of the ply, in its axes. Unit: force/area.
     */
    PlyLaws
    laws(const double                         cord_fraction = 0,
         const dealii::SymmetricTensor<2, 3> &initial_stress =
           dealii::SymmetricTensor<2, 3>()) const;

  private:
    /** The strengths, if given. Throws InputError if only some of them are
     * given. */
    std::optional<Strengths>
    get_strengths() const;

    /** The laws without relaxation. */
    PlyLaws
    elastic_laws(const double                         cord_fraction,
                 const dealii::SymmetricTensor<2, 3> &initial_stress) const;

    /** The relaxation; null for none. */
    std::shared_ptr<const Relaxation>
    relaxation() const;

    /** The constants of a linear law with cords or fibers. */
    Material
    linear_material(const double cord_fraction) const;

    /** The law of a rubber, or of the rubber between cords with the shear
     * modulus @p shear_modulus. */
    std::shared_ptr<const MaterialLaw>
    rubber(const double shear_modulus) const;

    /** Refuse constants that the type of the material does not use. Throws
     * InputError. */
    void
    check_unused() const;

    /** The bulk modulus, which may be given by Poisson's ratio. Unit:
     * force/area. */
    double
    bulk_modulus(const double shear_modulus) const;

    /** Young's modulus along compressed cords, if it is @p E_L in tension. */
    double
    modulus_in_compression(const double E_L) const;

    /** The compressive strain of compression_onset. */
    double
    onset(const double E_L, const double G_LT) const;
  };
} // namespace Biface

#endif
