// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_material_parameters_h
#define biface_laminate_material_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>

#include <optional>
#include <string>

#include <biface/laminate/cord_and_rubber.h>
#include <biface/laminate/failure_criteria.h>

namespace Biface
{
  /** The parameters of a named material. */
  struct MaterialParameters
  {
    enum class Type
    {
      isotropic,
      transversely_isotropic,
      orthotropic,
      cord_and_rubber
    };

    std::string   name;
    Type          type = Type::isotropic;
    double        E = 0, nu = 0;
    double        E_L = 0, E_T = 0, G_LT = 0, G_TT = 0, nu_LT = 0, nu_TT = 0;
    double        E_1 = 0, E_2 = 0, E_3 = 0;
    double        G_12 = 0, G_13 = 0, G_23 = 0;
    double        nu_12 = 0, nu_13 = 0, nu_23 = 0;
    CordAndRubber cord_and_rubber;
    /** A formula of @f$E_L@f$ for Young's modulus along the cords where they
     * are compressed. */
    std::string E_L_compression = "E_L";
    Strengths   strengths;
    /** Unit: mass/volume. */
    double density = 0;
    /** The tangent of the angle by which strains lag behind stresses. */
    double loss_factor = 0;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * The stiffness in the axes of the material, see
     * Material::stiffness(). Throws InputError if a constant is not
     * admissible.
     *
     * @param cord_fraction the volume fraction of cords, used for cords in
     * rubber only.
     */
    dealii::SymmetricTensor<4, 3>
    stiffness(const double cord_fraction = 0) const;

    /** Whether cords can go slack. Throws InputError if the type of the
     * material has no cords, or if E_L_compression is no formula. */
    bool
    has_slack_cords() const;

    /** By how much the modulus along the cords is smaller where they are
     * compressed, see CordPoint, if it is @p E_L in tension. Unit:
     * force/area. Throws InputError if it is not admissible. */
    double
    compression_loss(const double E_L) const;

    /** The density, 0 if not given. Unit: mass/volume. Throws InputError if
     * it is negative. */
    double
    get_density() const;

    /** The loss factor, 0 if not given. Throws InputError if it is
     * negative. */
    double
    get_loss_factor() const;

    /** The strengths, if given. Throws InputError if only some of them are
     * given. */
    std::optional<Strengths>
    get_strengths() const;
  };
} // namespace Biface

#endif
