// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_interlaminar_shear_h
#define biface_laminate_interlaminar_shear_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/laminate/transverse_shear.h>

namespace Biface
{
  /**
   * The transverse shear stresses of a wall of several layers, in equilibrium
   * with bending and with the shear forces of the layers.
   *
   * In cylindrical bending that varies along @f$\alpha_c@f$, the strains
   * @f$cc@f$ and 12 of the L + 1 faces have gradients, which are linear between
   * the faces of a layer. They follow from the 2(L + 1) conditions that the
   * gradients of both membrane forces vanish, and that the stresses of
   * equilibrium in each layer have given shear forces along and across: that of
   * the layer along @f$\alpha_c@f$, and where plies at an angle couple both
   * coordinates, the parts of TransverseShear::distribution() of the whole wall
   * across. The stresses vanish at the inner and the outer face of the wall and
   * are continuous. With one layer they are those of
   * TransverseShear::equilibrium_stress().
   *
   * The stresses that follow from the law of each layer jump between the layers
   * and do not vanish at the faces.
   */
  class InterlaminarShear
  {
  public:
    /** The distributions of the stresses in a wall.
     * @param layers inner layer first; copied.
     * @param wall with the plies of all of them. */
    InterlaminarShear(const std::vector<TransverseShear> &layers,
                      const TransverseShear              &wall);

    /**
     * The stresses @f$\sigma_{13},\sigma_{23}@f$. Unit: force/area.
     *
     * @param shear_forces of the layers, see TransverseShear::shear_force().
     * Unit: force/length.
     * @param layer,ply,z the ply within its layer, and the height above the
     * inner face of this layer.
     */
    dealii::Tensor<1, 2>
    stress(const std::vector<dealii::Tensor<1, 2>> &shear_forces,
           const unsigned int                       layer,
           const unsigned int                       ply,
           const double                             z) const;

  private:
    std::vector<TransverseShear> layers;

    /** The gradients along @f$\alpha_c@f$ of the strains 11, 22, 2*12 of the
     * faces for a unit shear force of the layer k along @f$\alpha_c@f$, i = 0,
     * or across, as `gradients[c][2 k + i][face]`. */
    std::array<std::vector<std::vector<dealii::Tensor<1, 3>>>, 2> gradients;

    /** The integrals of TransverseShear::distribution() of the wall over each
     * layer. */
    std::vector<dealii::Tensor<2, 2>> parts_of_wall;
  };
} // namespace Biface

#endif
