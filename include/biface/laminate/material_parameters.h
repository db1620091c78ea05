// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_material_parameters_h
#define biface_laminate_material_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/material.h>

namespace Biface
{
  /** The parameters of a named material. */
  struct MaterialParameters
  {
    enum class Type
    {
      isotropic,
      transversely_isotropic,
      orthotropic
    };

    std::string name;
    Type        type = Type::isotropic;
    double      E = 0, nu = 0;
    double      E_L = 0, E_T = 0, G_LT = 0, G_TT = 0, nu_LT = 0, nu_TT = 0;
    double      E_1 = 0, E_2 = 0, E_3 = 0;
    double      G_12 = 0, G_13 = 0, G_23 = 0;
    double      nu_12 = 0, nu_13 = 0, nu_23 = 0;
    Strengths   strengths;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * The stiffness in the axes of the material, see
     * OrthotropicMaterial::stiffness(). Throws InputError if a constant is not
     * admissible.
     */
    dealii::SymmetricTensor<4, 3>
    stiffness() const;

    /** The strengths, if given. Throws InputError if only some of them are
     * given. */
    std::optional<Strengths>
    get_strengths() const;
  };
} // namespace Biface

#endif
