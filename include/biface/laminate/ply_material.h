// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_ply_material_h
#define biface_laminate_ply_material_h

#include <deal.II/base/symmetric_tensor.h>

#include <memory>
#include <optional>
#include <string>

#include <biface/laminate/failure_criteria.h>

namespace Biface
{
  class CordLaw;
  class MaterialLaw;
  class Relaxation;

  /** What is known of the material of a ply without its position, see
   * MaterialParameters::of_ply(). */
  struct PlyMaterial
  {
    std::string name;
    /** Whether axis L of the ply is that of fibers, rather than any direction
     * of an isotropic material. */
    bool has_fibers = false;
    /** Whether the ply has cords that can go slack. */
    bool has_slack_cords = false;
    /** Whether the law, or that between the cords, is one for large strains. */
    bool is_hyperelastic = false;
    /** Whether the stresses relax. */
    bool relaxes = false;
    /** The density. Unit: mass/volume. */
    double density = 0;
    /** The tangent of the angle by which strains lag behind stresses. */
    double loss_factor = 0;
    /** The conductivity of heat; 0 if it is not given. Unit: power/(length *
     * temperature). */
    double conductivity = 0;
    /** The strengths, if given for the material. */
    std::optional<Strengths> strengths;
  };


  /** The laws of a ply at one position. */
  struct PlyLaws
  {
    /** The stiffness in the axes of the ply; where it is not linear, the
     * initial one. Unit: force/area. */
    dealii::SymmetricTensor<4, 3> stiffness;
    /** What the cords, along axis 1, add to the law of the material; null for
     * nothing. */
    std::shared_ptr<const CordLaw> cords = {};
    /** The law of the material, which is isotropic, without cords; null for the
     * linear one with the stiffness. */
    std::shared_ptr<const MaterialLaw> rubber = {};
    /** The relaxation of the stresses; null for none. */
    std::shared_ptr<const Relaxation> relaxation = {};
  };
} // namespace Biface

#endif
