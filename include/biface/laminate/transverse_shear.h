// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_transverse_shear_h
#define biface_laminate_transverse_shear_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Biface
{
  /** How the transverse shear strains of the faces determine stresses. */
  struct TransverseShearLaw
  {
    enum class Kind
    {
      /** The strain is linear between the faces, and the stress in each ply
       * follows from it: the law of @cite GrigolyukKulikovPlotnikova2004, which
       * is too stiff. */
      constant_strain,
      /** The same, with the stiffness multiplied by a factor. */
      factor,
      /** The stress is that in equilibrium with bending, see TransverseShear.
       */
      equilibrium
    };

    Kind kind = Kind::constant_strain;
    /** Above 0 and at most 1. */
    double factor = 1;
    /** At least 1: multiplies the stiffness against a difference of the strains
     * of both faces that has no shear force, which is that against a gradient
     * of the thickness strain. */
    double gradient_factor = 1;
  };

  /** Read 'constant strain', 'equilibrium' or a factor, a number or a formula
   * such as 5/6. Throws InputError where it is none of these. */
  TransverseShearLaw
  parse_transverse_shear(const std::string &entry, const std::string &text);

  /** Read TransverseShearLaw::gradient_factor, or nothing from 'by layers'.
   * Throws InputError where it is neither this nor a number from 1 to 1000. */
  std::optional<double>
  parse_gradient_factor(const std::string &entry, const std::string &text);


  class TransverseShear;

  /** The wall of which some plies are a layer. */
  struct WallOfLayer
  {
    /** With all plies; null if there are no others. */
    std::shared_ptr<const TransverseShear> shear;
    /** The number of plies below the layer, and their thickness. */
    unsigned int n_below      = 0;
    double       height_below = 0;
  };


  /**
   * The transverse shear of a stack of plies: its stiffness, and the
   * distribution of the stresses over the thickness.
   *
   * The stresses in equilibrium with the bending stresses of the plies are
   * @f$\sigma_{a3}(z) = F_{ac}(z)\,Q_c@f$, where @f$Q_c@f$ are the shear forces
   * and the column c of @f$\mathbf F@f$ belongs to cylindrical bending that
   * varies along @f$\alpha_c@f$, in the manner of @cite RolfesRohwer1997. They
   * vanish at both faces, are continuous, and
   * @f$\int\mathbf F\,dz = \mathbf 1@f$. doc/theory.md derives the stiffness
   * from their energy.
   *
   * In all functions, z is the height above the inner face.
   */
  class TransverseShear
  {
  public:
    /** The shear strains @f$2\varepsilon_{a3}@f$ of the inner and the outer
     * face. */
    using FaceStrains = std::array<dealii::Tensor<1, 2>, 2>;

    struct Ply
    {
      /** The heights of its sides. */
      double begin, end;
      /** @f$q_{abcd}@f$ by the pairs 11, 22, 12. */
      dealii::Tensor<2, 3> plane_stress;
      /** @f$b_{a3c3}@f$ */
      dealii::Tensor<2, 2> shear;
      /** @f$\mathbf F@f$ at its inner side. */
      dealii::Tensor<2, 2> F;
    };

    /**
     * @param thicknesses of the plies, inner ply first. Unit: length.
     * @param stiffnesses of the plies in the frame of the shell. Unit:
     * force/area.
     * @param wall whose stresses in equilibrium are those of the layer, too.
     */
    TransverseShear(
      const TransverseShearLaw                         &law,
      const std::vector<double>                        &thicknesses,
      const std::vector<dealii::SymmetricTensor<4, 3>> &stiffnesses,
      const WallOfLayer                                &wall = {});

    const std::vector<Ply> &
    get_plies() const
    {
      return plies;
    }

    double
    get_thickness() const
    {
      return thickness;
    }

    /** That of the wall of which the plies are a layer, or else of the plies.
     */
    const TransverseShear &
    of_wall() const
    {
      return wall.shear ? *wall.shear : *this;
    }

    /** @f$D_{a3c3}^{pq}@f$ for the faces p and q. Unit: force/length. */
    dealii::Tensor<2, 2>
    stiffness(const unsigned int p, const unsigned int q) const
    {
      return D[p][q];
    }

    /** The shear forces @f$Q_a=\int\sigma_{a3}\,dz@f$. Unit: force/length. */
    dealii::Tensor<1, 2>
    shear_force(const FaceStrains &strains) const;

    /** The stresses @f$\sigma_{a3}@f$ within a ply whose integrals with the
     * shape functions of the faces are the resultants. Unit: force/area. */
    dealii::Tensor<1, 2>
    stress(const FaceStrains &strains,
           const unsigned int ply,
           const double       z) const;

    /** The strains @f$2\varepsilon_{a3}@f$ within a ply. */
    dealii::Tensor<1, 2>
    strain(const FaceStrains &strains,
           const unsigned int ply,
           const double       z) const;

    /** The stresses @f$\mathbf F\mathbf Q@f$ in equilibrium with the shear
     * forces, for every law, if the plies are the whole wall. Unit:
     * force/area. */
    dealii::Tensor<1, 2>
    equilibrium_stress(const FaceStrains &strains,
                       const unsigned int ply,
                       const double       z) const
    {
      return distribution(ply, z) * shear_force(strains);
    }

    /** @f$\mathbf F@f$, of the wall if the plies are a layer of it. Unit:
     * 1/length. */
    dealii::Tensor<2, 2>
    distribution(const unsigned int ply, const double z) const;

  private:
    /** Set gradient and @p F of the plies. */
    void
    set_distribution();

    /** Set s_0. @return the stiffness against a difference of the strains of
     * both faces that has no shear force, @f$\mathbf R@f$. */
    dealii::Tensor<2, 2>
    set_residual();

    /** Replace the stiffness D of constant strain by that of the energy of the
     * equilibrium stresses. */
    void
    set_equilibrium_stiffness();

    /** The factor of @f$\mathbf F@f$ in the stresses of the law
     * `equilibrium`. */
    dealii::Tensor<1, 2>
    amplitude(const FaceStrains &strains) const;

    TransverseShearLaw law;
    WallOfLayer        wall;
    std::vector<Ply>   plies;
    double             thickness;

    /** `gradient[c][p]`: the gradients along @f$\alpha_c@f$ of the tangential
     * strains 11, 22, 2*12 of the face p for a unit shear force
     * @f$Q_c@f$. */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 2> gradient;

    std::array<std::array<dealii::Tensor<2, 2>, 2>, 2> D;

    /** Of a layer of a wall: from the strains of the faces to amplitude(). */
    std::array<dealii::Tensor<2, 2>, 2> to_amplitude;

    /** Where the stiffness of constant strain vanishes: a strain proportional
     * to @f$s-\mathbf s_0@f$, with @f$s@f$ from -1 to 1, has no shear force. */
    dealii::Tensor<2, 2> s_0;
  };
} // namespace Biface

#endif
