// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_laminate_h
#define biface_laminate_laminate_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <biface/laminate/ply_material.h>
#include <biface/laminate/ply_points.h>
#include <biface/laminate/relaxation.h>
#include <biface/laminate/resultants.h>
#include <biface/laminate/thickness_functions.h>
#include <biface/laminate/transverse_shear.h>

namespace Biface
{
  struct CordPoint;

  /**
   * How the thickness strain @f$E_{33}@f$, which is constant over the
   * thickness, enters the constitutive law.
   */
  enum class ThicknessLaw
  {
    /**
     * The thickness stress @f$S_{33}@f$ is assumed constant over the thickness
     * and eliminated. Energy-consistent, and free of Poisson thickness locking.
     */
    symmetric,
    /**
     * The law of @cite GrigolyukKulikovPlotnikova2004, eq. (9), as understood
     * here: the tangential resultants are those of plane stress and independent
     * of @f$E_{33}@f$, the thickness resultant is that of the three-dimensional
     * law. Not symmetric.
     */
    asymmetric
  };


  /** A ply at one position of the shell. */
  struct Ply
  {
    PlyLaws laws;
    /** The thickness of the ply. Unit: length. */
    double thickness;
    /** The angle of axis 1 of the ply from @f$\mathbf e_1@f$ toward
     * @f$\mathbf e_2@f$, in radians. */
    double angle;
    /** The initial stress in the axes of the ply. Unit: force/area. */
    dealii::SymmetricTensor<2, 3> initial_stress;
    /** The position of the ply in the layup, from 0 at the inner face. */
    unsigned int number = 0;
    /** The distance of the cords, 0 if they are not described. Unit: length. */
    double      cord_pitch = 0;
    PlyMaterial material   = {};
    /** The start and the end of the part that belongs to a layer, as fractions
     * of the thickness of the ply of the layup. */
    double begin = 0, end = 1;
  };


  /** The strains of the faces at a place, with what the stresses of the plies
   * there have relaxed. */
  struct StrainsOfPlies
  {
    StrainsOfPlies() = default;

    /** Strains at a place where nothing relaxes. */
    StrainsOfPlies(const Resultants::Vector &E) : E(E)
    {}

    Resultants::Vector E;
    /** The relaxation of the stresses at Laminate::ply_points(); empty if none
     * relaxes. */
    std::vector<Relaxed<PointStrains::Vector>> points;
    /** The relaxation of the stresses of Laminate::cord_points(); empty if none
     * relaxes. */
    std::vector<Relaxed<double>> cords;
  };

  /** The mean of the strains at the vertices of a cell. */
  StrainsOfPlies
  mean(const std::array<StrainsOfPlies, 4> &at_vertices);


  /**
   * A stack of plies at one position of the shell, inner ply first, integrated
   * over the thickness with ThicknessFunctions.
   */
  class Laminate
  {
  public:
    /** Integrate the plies over the thickness.
     * @param reference_height the height of the reference surface above the
     * inner face. Unit: length.
     * @param curvature of the reference surface, see ThicknessFunctions; zero
     * for the integrals of a plate.
     * @param wall if the plies are a layer of it.
     * @param along_normal whether the thickness strain is that of
     * NormalThickness. */
    Laminate(std::vector<Ply>             plies,
             const ThicknessLaw           law,
             const double                 reference_height,
             const TransverseShearLaw    &shear_law    = TransverseShearLaw(),
             const std::array<double, 2> &curvature    = {{0, 0}},
             const WallOfLayer           &wall         = {},
             const bool                   along_normal = false);

    const TransverseShear &
    get_transverse_shear() const
    {
      return transverse_shear;
    }

    /** The shear forces @f$Q_1,Q_2@f$ of strains. Unit: force/length. */
    dealii::Tensor<1, 2>
    shear_force(const Resultants::Vector &E) const;


    const std::vector<Ply> &
    get_plies() const
    {
      return plies;
    }

    /** This stack with other laws of its plies, whose number and thickness
     * are the same. In a layer of a wall, the transverse shear stresses keep
     * their distribution over the wall. */
    Laminate
    with_plies(std::vector<Ply> other) const;

    /** The total thickness h. Unit: length. */
    double
    thickness() const;

    /** The stiffness of the wall across its thickness, @f$1/\sum_k
     * h_k/E_k@f$ with the moduli @f$E_k@f$ of the plies in this direction: the
     * pressure on both faces per change of the thickness, if the plies are free
     * to spread. Unit: pressure/length. */
    double
    thickness_stiffness() const;

    /** The stiffness of the wall along its faces, @f$\sum_k h_kE_k@f$ with the
     * highest modulus @f$E_k@f$ of each ply in its plane, kept from contracting
     * across. Unit: force/length. */
    double
    membrane_stiffness() const;

    /** The stiffness against strains along a coordinate that are linear
     * between the faces, with no thickness stress and no strain across: the
     * force on the face p by the strain of the face q. Where plies are not
     * linear, the initial one. Unit: force/length.
     * @param a 0 or 1, the coordinate. */
    std::array<std::array<double, 2>, 2>
    stiffness_along(const unsigned int a) const;

    /** The area at the height @p z above the inner face, relative to that of
     * the middle surface; 1 with the integrals of a plate. */
    double
    area_ratio(const double z) const
    {
      return functions.area(z);
    }

    /**
     * The thickness coordinates @f$\delta^-,\delta^+@f$ of the inner and the
     * outer face. Unit: length.
     */
    std::array<double, 2>
    face_heights() const;

    /**
     * The stiffness @f$\mathbf D@f$ of @cite GrigolyukKulikovPlotnikova2004,
     * eq. (9), in the order of Resultants; where plies are not linear, the
     * initial one, and where cords are slack, without what they lack. Unit:
     * force/length.
     */
    const Resultants::Matrix &
    stiffness() const
    {
      return D;
    }

    /** The stiffness where all cords are slack that can be. Unit:
     * force/length. */
    Resultants::Matrix
    stiffness_of_slack_cords() const;

    /** The law of the materials of all plies; null if all are linear, and
     * stiffness() is their law. */
    const std::shared_ptr<const PlyPoints> &
    ply_points() const
    {
      return points;
    }

    /**
     * The moments of the density with the shape functions of the faces,
     * @f$m^{pq} = \int\varrho\,N^pN^q\,d\alpha_3@f$: all that the inertia of
     * displacements linear in the height depends on. Unit: mass/area.
     */
    std::array<std::array<double, 2>, 2>
    mass_moments() const;

    /** The cords that have a law of their own, at two Gauss points per ply. */
    std::vector<CordPoint>
    cord_points() const;

    /** Whether the cords are slack at the height @p z above the inner face. */
    bool
    is_slack(const Resultants::Vector &E,
             const unsigned int        ply,
             const double              z) const;

    /**
     * The resultants @f$\mathbf H_0@f$ of the initial ply stresses,
     * @f$H_{0,ij}^\pm = \int N^\pm\sigma_{ij}\,d\alpha_3@f$. Unit:
     * force/length.
     */
    Resultants::Vector
    initial_resultants() const;

    /**
     * The strains at the height @p z above the inner face, in the frame of the
     * shell, from the @p strains of the faces and the thickness. If the
     * thickness stress is eliminated, the thickness strain is the one that
     * causes it.
     *
     * @param ply position in get_plies().
     */
    dealii::SymmetricTensor<2, 3>
    strain(const StrainsOfPlies &strains,
           const unsigned int    ply,
           const double          z) const;

    /** The stresses due to strain(), without initial stresses. Unit:
     * force/area. */
    dealii::SymmetricTensor<2, 3>
    stress(const StrainsOfPlies &strains,
           const unsigned int    ply,
           const double          z) const;

    /**
     * The transverse shear stresses @f$\sigma_{13},\sigma_{23}@f$ in
     * equilibrium with the shear forces, see
     * TransverseShear::equilibrium_stress(): zero at both faces, and continuous
     * between plies. Only if the plies are the whole wall; for layers, see
     * InterlaminarShear. Unit: force/area.
     */
    dealii::Tensor<1, 2>
    interlaminar_stress(const Resultants::Vector &E,
                        const unsigned int        ply,
                        const double              z) const;

    /** Whether stiffness() is symmetric. */
    bool
    is_symmetric() const;

  private:
    Resultants::Matrix
    integrate_stiffness() const;

    /** Set the points of plies that are not all linear. */
    void
    set_points();

    /** The coefficients of a point at the height @p z, without its thickness
     * and law. */
    PlyPoints::Point
    point(const unsigned int ply, const double z) const;

    /** The law of the material of a ply in the frame of the shell. */
    std::shared_ptr<const MaterialLaw>
    law_of(const unsigned int ply) const;

    /** The strains at a height by the laws of points. */
    PointStrains::Vector
    point_strain(const StrainsOfPlies &strains,
                 const unsigned int    ply,
                 const double          z) const;

    /** The heights of both sides of a ply above the inner face. */
    std::pair<double, double>
    sides_of_ply(const unsigned int ply) const;

    /** The relaxation of the stress of a ply at a height, from its points. */
    Relaxed<PointStrains::Vector>
    relaxed(const StrainsOfPlies &strains,
            const unsigned int    ply,
            const double          z) const;

    /** The relaxation of the stress of the cords of a ply at a height, from
     * their points. */
    Relaxed<double>
    relaxed_cords(const StrainsOfPlies &strains,
                  const unsigned int    ply,
                  const double          z) const;

    /** The strain along the cords at a height. */
    double
    cord_strain(const Resultants::Vector &E,
                const unsigned int        ply,
                const double              z) const;

    /** The strain 11, 22 or 2*12 at a height. */
    double
    tangential_strain(const Resultants::Vector &E,
                      const unsigned int        ab,
                      const double              z) const;

    std::vector<Ply> plies;
    /** The stiffnesses of the plies in the frame of the shell. Unit:
     * force/area. */
    std::vector<dealii::SymmetricTensor<4, 3>> rotated;
    ThicknessLaw                               law;
    ThicknessFunctions                         functions;
    TransverseShear                            transverse_shear;
    bool                                       along_normal;
    Resultants::Matrix                         D;
    std::shared_ptr<const PlyPoints>           points;
  };
} // namespace Biface

#endif
