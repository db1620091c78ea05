// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_ply_points_h
#define biface_laminate_ply_points_h

#include <deal.II/base/array_view.h>

#include <array>
#include <memory>
#include <vector>

#include <biface/laminate/material_law.h>
#include <biface/laminate/relaxation.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  /**
   * The integration over the thickness of plies of which some are not linear:
   * at each point a law between strains and stresses, and one thickness stress
   * for all.
   *
   * The tangential and the shear strains at a point k are linear in those of
   * the faces, @f$\mathbf e_k=\mathbf L_k\mathbf E@f$. Its thickness strain
   * @f$e_k@f$ is the one at which @f$S_{33}=\sigma/m_k@f$, with the area
   * @f$m_k@f$ at its height relative to that of the middle surface; the
   * stress @f$\sigma@f$ follows from
   * @f$\sum_k t_k e_k = h\,E_{33}@f$. The resultants are
   * @f$\sum_k t_k m_k\mathbf L_k^T\mathbf S_k@f$ and @f$H_{33}=h\sigma@f$: the
   * derivatives of the energy @f$\sum_k t_k m_k\psi_k@f$. Their tangent is that
   * of ThicknessLaw::symmetric with the moduli of the points.
   */
  class PlyPoints
  {
  public:
    /** A point of the integration, at a height within a ply. */
    struct Point
    {
      /** The part of the thickness that the point stands for. Unit: length. */
      double thickness;
      /** The area @f$m_k@f$ relative to that of the middle surface. */
      double area;
      /** The parts of the tangential strains of the faces in that of the point,
       * as `tangential[ab][face]`. */
      std::array<std::array<double, 2>, 3> tangential;
      /** The part of the strain c3 of the face p in the strain a3 of the point,
       * as `shear[p][a][c]`. */
      std::array<dealii::Tensor<2, 2>, 2> shear;
      std::shared_ptr<const MaterialLaw>  law;
      /** The relaxation of the stresses at the point; null for none. */
      std::shared_ptr<const Relaxation> relaxation;
      /** The height above the inner face. Unit: length. */
      double height;
      /** The position of the ply in Laminate::get_plies(). */
      unsigned int ply;

      /** The strains at the point for those of the faces, without the thickness
       * strain. */
      PointStrains::Vector
      strain(const Resultants::Vector &E) const;

      /** Add the resultants of the stresses at the point, but for the thickness
       * stress. */
      void
      add_resultants(const PointStrains::Vector &stress,
                     Resultants::Vector         &resultants) const;
    };

    /** The points of a laminate.
     * @param points all of a laminate.
     * @param thickness h. Unit: length.
     * @param remainder a stiffness to be added, symmetric. Unit:
     * force/length.
     * @param along_normal whether the thickness strain of the faces is without
     * that of a director that leans, see NormalThickness. The laws know shear
     * strains and take the one with it. */
    PlyPoints(std::vector<Point>        points,
              const double              thickness,
              const Resultants::Matrix &remainder,
              const bool                along_normal);

    /** The strains of the faces at the places of the shell that share one
     * thickness stress. */
    using Places = dealii::ArrayView<const Resultants::Vector>;

    /** The relaxation of the stresses of the points, place by place; empty if
     * none relaxes. */
    using RelaxedPoints =
      dealii::ArrayView<const Relaxed<PointStrains::Vector>>;

    /** The thickness stress @f$\sigma@f$ for the mean of @f$E_{33}@f$ over the
     * places, and the thickness strains of their points, place by place; nan
     * where there is none. */
    struct ThicknessState
    {
      double              stress;
      std::vector<double> strains;
    };
    ThicknessState
    thickness_state(const Places &places, const RelaxedPoints &relaxed) const;

    /** The thickness strain @f$E_{33}@f$ of a place with a given thickness
     * stress, by its other strains. */
    double
    thickness_strain(const Resultants::Vector &E,
                     const RelaxedPoints      &relaxed,
                     const double              stress) const;

    /** The energy of a place per area. Unit: force/length.
     * @param number of the place. */
    double
    energy(const Resultants::Vector &E,
           const RelaxedPoints      &relaxed,
           const ThicknessState     &state,
           const unsigned int        number) const;

    /** The resultants of a place, and their derivatives: by the matrix C at
     * constant thickness stress, and by the vector f with the thickness stress,
     * which changes by the mean of @f$\mathbf f\cdot d\mathbf E@f$ over the
     * mean of the compliance. */
    struct Response
    {
      Resultants::Vector H, f;
      Resultants::Matrix C;
      double             compliance;
    };

    /** Compute the response of a place.
     * @param with_changes whether to set more than H. */
    void
    respond(const Resultants::Vector &E,
            const RelaxedPoints      &relaxed,
            const ThicknessState     &state,
            const unsigned int        number,
            const bool                with_changes,
            Response                 &response) const;

    /** The changes of the elastic stresses of the points with the strains, and
     * of the resultants with added stresses: the derivatives of the strains of
     * all points by those of the faces, and their transpose. */
    class Changes
    {
    public:
      /** The changes about a state.
       * @param plies kept by reference. */
      Changes(const PlyPoints      &plies,
              const Places         &places,
              const RelaxedPoints  &relaxed,
              const ThicknessState &state);

      /** The changes of the elastic stresses.
       * @param strains their changes, by place.
       * @param added that of what is added to the stresses of all points, place
       * by place, which changes their thickness strains.
       * @param stresses those of all points, likewise, without relaxation. */
      void
      elastic_stresses(const Places                            &strains,
                       const std::vector<PointStrains::Vector> &added,
                       std::vector<PointStrains::Vector>       &stresses) const;

      /** The changes of the resultants.
       * @param added to the stresses of all points, place by place.
       * @param resultants of each place. */
      void
      resultants(const std::vector<PointStrains::Vector>     &added,
                 const dealii::ArrayView<Resultants::Vector> &resultants) const;

    private:
      const PlyPoints &plies;
      /** The moduli of the elastic law, and the factor of them that is left in
       * the step, place by place. */
      std::vector<PointStrains::Matrix> moduli;
      std::vector<double>               factors;
      /** The derivatives of the thickness strain by the shear strains, place by
       * place. */
      std::vector<std::array<double, 2>> lean;
      double                             compliance = 0;

      double
      modulus_33(const unsigned int k) const
      {
        return factors[k] *
               moduli[k][PointStrains::thickness][PointStrains::thickness];
      }
    };

    double
    get_thickness() const
    {
      return thickness;
    }

    const std::vector<Point> &
    get_points() const
    {
      return points;
    }

    /** The strains of a point of a place. */
    PointStrains::Vector
    strain(const Resultants::Vector &E,
           const ThicknessState     &state,
           const unsigned int        number,
           const unsigned int        point) const
    {
      PointStrains::Vector strain = points[point].strain(E);
      strain[PointStrains::thickness] =
        state.strains[number * points.size() + point];
      return strain;
    }

  private:
    /** The thickness strain @f$E_{33}@f$ of a director that leans. */
    double
    director_strain(const Resultants::Vector &E) const;

    std::vector<Point> points;
    double             thickness;
    Resultants::Matrix remainder;
    bool               along_normal;
  };


  /** The strain 33 at which a law has a given thickness stress; nan if there is
   * none.
   * @param strain the other strains. */
  double
  thickness_strain(const MaterialLaw                   &law,
                   const Relaxed<PointStrains::Vector> &relaxed,
                   PointStrains::Vector                 strain,
                   const double                         stress);
} // namespace Biface

#endif
