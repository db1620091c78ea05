// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_thickness_functions_h
#define biface_laminate_thickness_functions_h

#include <deal.II/base/quadrature_lib.h>

#include <array>

namespace Biface
{
  /**
   * How the strains and areas of the faces of a shell become those within its
   * wall, at the height z above the inner face.
   *
   * In a plate, strains are linear between the faces, with the shape functions
   * @f$N^\pm@f$, and all areas are equal. That is what
   * @cite GrigolyukKulikovPlotnikova2004 assumes in a shell, too. There,
   * displacements are linear, but the lengths to which they refer are not the
   * same: with @f$\zeta_a(z)=1+k_a\,(z-z_0)@f$ the tangential strains of the
   * linear theory are those of the faces times
   * @f$w_a^\pm=N^\pm\zeta_a^\pm/\zeta_a(z)@f$, and an area within the wall is
   * @f$\mu/\bar\mu=\zeta_1\zeta_2/\bar\zeta_1\bar\zeta_2@f$ times that of the
   * middle surface.
   */
  class ThicknessFunctions
  {
  public:
    /** The functions of a wall.
     * @param thickness h. Unit: length.
     * @param reference_height the height @f$z_0@f$ of the reference surface.
     * @param curvature of the reference surface, zero for the functions of a
     * plate. Unit: 1/length. */
    ThicknessFunctions(const double                 thickness,
                       const double                 reference_height,
                       const std::array<double, 2> &curvature)
      : thickness(thickness)
      , reference_height(reference_height)
      , curvature(curvature)
    {
      for (unsigned int a = 0; a < 2; ++a)
        {
          at_faces[a] = {{zeta(a, 0), zeta(a, thickness)}};
          mean_area *= zeta(a, thickness / 2);
        }
    }

    /** The shape function @f$N^p@f$ of a face at the height @p z. */
    double
    shape(const unsigned int p, const double z) const
    {
      return p == 0 ? 1 - z / thickness : z / thickness;
    }

    /** The part of a tangential strain of the face @p p, 11, 22 or 12, in that
     * at the height @p z. The strain 12 has one part of each direction. */
    double
    strain(const unsigned int ab, const unsigned int p, const double z) const
    {
      const auto ratio = [&](const unsigned int a) {
        return at_faces[a][p] / zeta(a, z);
      };
      return shape(p, z) * (ab < 2 ? ratio(ab) : (ratio(0) + ratio(1)) / 2);
    }

    /** The area @f$\mu/\bar\mu@f$ at the height @p z relative to that of the
     * middle surface. */
    double
    area(const double z) const
    {
      return zeta(0, z) * zeta(1, z) / mean_area;
    }

    /** Call @p f with the heights and the weights of the points of a quadrature
     * between two heights: exact for strains of a plate, and as good as exact
     * for those of a shell. */
    template <typename Function>
    void
    integrate(const double begin, const double end, const Function &f) const
    {
      static const dealii::QGauss<1> for_plate(2), for_shell(4);
      const bool is_plate = curvature[0] == 0 && curvature[1] == 0;
      const dealii::QGauss<1> &quadrature = is_plate ? for_plate : for_shell;
      for (unsigned int i = 0; i < quadrature.size(); ++i)
        f(begin + (end - begin) * quadrature.point(i)[0],
          quadrature.weight(i) * (end - begin));
    }

    double                thickness, reference_height;
    std::array<double, 2> curvature;

  private:
    double
    zeta(const unsigned int a, const double z) const
    {
      return 1 + curvature[a] * (z - reference_height);
    }

    /** The lengths @f$\zeta_a^p@f$ at the faces, as `at_faces[a][p]`. */
    std::array<std::array<double, 2>, 2> at_faces;
    double                               mean_area = 1;
  };


  /** The integrals @f$\int N^p\mu/\bar\mu\,dz@f$ and
   * @f$\int N^p N^q\mu/\bar\mu\,dz@f$ over a part of the thickness. */
  struct FaceMoments
  {
    std::array<double, 2>                first{};
    std::array<std::array<double, 2>, 2> second{};

    FaceMoments(const ThicknessFunctions &functions,
                const double              z_0,
                const double              z_1)
    {
      functions.integrate(z_0, z_1, [&](const double z, const double weight) {
        const double mu = functions.area(z);
        for (unsigned int p = 0; p < 2; ++p)
          {
            const double by_p = weight * functions.shape(p, z);
            first[p] += by_p * mu;
            for (unsigned int q = 0; q < 2; ++q)
              second[p][q] += by_p * functions.shape(q, z) * mu;
          }
      });
    }

    /** The moments of a plate of thickness @p h. */
    FaceMoments(const double z_0, const double z_1, const double h)
      : FaceMoments(ThicknessFunctions(h, 0, {{0, 0}}), z_0, z_1)
    {}
  };


  /** The integrals of strains and areas over a part of the thickness, by the
   * tangential strains @f$ab,cd@f$ and the faces. */
  struct StrainMoments
  {
    template <typename T>
    using ByFace = std::array<T, 2>;

    /** The integrals @f$\int w_{ab}^p\,dz@f$ as `first[ab][p]`, and with the
     * areas, @f$\int w_{ab}^p\mu/\bar\mu\,dz@f$, as `stressed[ab][p]`. */
    std::array<ByFace<double>, 3> first{}, stressed{};
    /** The integrals @f$\int w_{ab}^p w_{cd}^q\mu/\bar\mu\,dz@f$ as
     * `second[ab][cd][p][q]`. */
    std::array<std::array<ByFace<ByFace<double>>, 3>, 3> second{};
    /** The integrals @f$\int\mu/\bar\mu\,dz@f$ and
     * @f$\int\bar\mu/\mu\,dz@f$. */
    double area = 0, inverse_area = 0;

    StrainMoments(const ThicknessFunctions &w,
                  const double              z_0,
                  const double              z_1)
    {
      w.integrate(z_0, z_1, [&](const double z, const double weight) {
        const double mu = w.area(z);
        area += weight * mu;
        inverse_area += weight / mu;
        for (unsigned int ab = 0; ab < 3; ++ab)
          for (unsigned int p = 0; p < 2; ++p)
            {
              const double by_p = weight * w.strain(ab, p, z);
              first[ab][p] += by_p;
              stressed[ab][p] += by_p * mu;
              for (unsigned int cd = 0; cd < 3; ++cd)
                for (unsigned int q = 0; q < 2; ++q)
                  second[ab][cd][p][q] += by_p * w.strain(cd, q, z) * mu;
            }
      });
    }
  };
} // namespace Biface

#endif
