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
  /** The way from the transverse shear strains of the faces to stresses. */
  struct TransverseShearLaw
  {
    enum class Kind
    {
      /** The strain is linear between the faces, and the stress in each ply
       * follows from it: the law of @cite GrigolyukKulikovPlotnikova2004, which
       * is too stiff. */
      constant_strain,
      /** The stress in each ply follows from a strain that is linear between
       * the faces, with the stiffness multiplied by a factor. */
      factor,
      /** The stress is in equilibrium with bending, see TransverseShear. */
      equilibrium
    };

    Kind kind = Kind::constant_strain;
    /** The factor of the stiffness, above 0 and at most 1. */
    double factor = 1;
    /** The factor, at least 1, of the stiffness against a difference of the
     * strains of both faces that has no shear force, which is that against a
     * gradient of the thickness strain. */
    double gradient_factor = 1;
  };

  /** Read 'constant strain', 'equilibrium' or a factor, a number or a formula
   * such as 5/6; nothing from 'automatic'. Throws InputError if it is none of
   * these. */
  std::optional<TransverseShearLaw>
  parse_transverse_shear(const std::string &entry, const std::string &text);

  /** Read TransverseShearLaw::gradient_factor, or nothing from 'by layers'.
   * Throws InputError if it is neither this nor a number from 1 to 1000. */
  std::optional<double>
  parse_gradient_factor(const std::string &entry, const std::string &text);


  class TransverseShear;

  /** The wall of which some plies are a layer. */
  struct WallOfLayer
  {
    /** The transverse shear of all plies of the wall; null if there are no
     * others. */
    std::shared_ptr<const TransverseShear> shear;
    /** The number of plies below the layer, and their thickness (length). */
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
      /** The heights of both sides of the ply. */
      double begin, end;
      /** The stiffness @f$q_{abcd}@f$ in plane stress, by the pairs 11, 22, 12.
       * Unit: force/area. */
      dealii::Tensor<2, 3> plane_stress;
      /** The stiffness @f$b_{a3c3}@f$ in transverse shear. Unit: force/area. */
      dealii::Tensor<2, 2> shear;
      /** The distribution @f$\mathbf F@f$ at the inner side of the ply. Unit:
       * 1/length. */
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

    const TransverseShearLaw &
    get_law() const
    {
      return law;
    }

    const WallOfLayer &
    get_wall() const
    {
      return wall;
    }

    double
    get_thickness() const
    {
      return thickness;
    }

    /** The transverse shear of the wall of which the plies are a layer, or else
     * of the plies. */
    const TransverseShear &
    of_wall() const
    {
      return wall.shear ? *wall.shear : *this;
    }

    /** The stiffness @f$D_{a3c3}^{pq}@f$ for the faces p and q. Unit:
     * force/length. */
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

    /** The distribution @f$\mathbf F@f$ at the height @p z in a ply, that of
     * the wall if the plies are a layer of it. Unit: 1/length. */
    dealii::Tensor<2, 2>
    distribution(const unsigned int ply, const double z) const;

  private:
    /** Set @p gradient, and @p F of the plies. */
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

    /** The factor of @f$\mathbf F@f$ in the stresses of the law `equilibrium`.
     * Unit: force/length. */
    dealii::Tensor<1, 2>
    amplitude(const FaceStrains &strains) const;

    TransverseShearLaw law;
    WallOfLayer        wall;
    std::vector<Ply>   plies;
    double             thickness;

    /** The gradients along @f$\alpha_c@f$ of the tangential strains 11, 22,
     * 2*12 of the face p for a unit shear force @f$Q_c@f$, as
     * `gradient[c][p]`. */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 2> gradient;

    std::array<std::array<dealii::Tensor<2, 2>, 2>, 2> D;

    /** The matrices from the strains of the faces of a layer of a wall to
     * amplitude(). */
    std::array<dealii::Tensor<2, 2>, 2> to_amplitude;

    /** The matrix @f$\mathbf s_0@f$ for which a strain proportional to
     * @f$s-\mathbf s_0@f$, with @f$s@f$ from -1 to 1 over the thickness, has no
     * shear force in the law of constant strain. */
    dealii::Tensor<2, 2> s_0;
  };
} // namespace Biface

#endif
