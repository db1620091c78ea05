// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_worst_strains_h
#define biface_model_quantities_worst_strains_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <optional>
#include <string>

#include <biface/model/forces/internal_forces.h>

namespace Biface
{
  /** A strain, or another number, at a vertex of a cell. */
  struct ValueAtPlace
  {
    double value = 0;
    /** The inner or the outer face; not set for the thickness strain. */
    std::optional<unsigned int> face;
    /** The layer, counted from the inner face; not set if there is a single
     * one. */
    std::optional<unsigned int> layer;
    /** The coordinates of the place, in the unit of parameter files. */
    dealii::Point<2> alpha;
    /** The position of the place on the undeformed reference surface. */
    dealii::Point<3> position;
    /** The number of the cell in the grid, see ChartGrid::cell_number(). */
    dealii::types::global_cell_index cell = 0;
  };


  /** The largest strains and their places, to look at if a step fails. */
  struct WorstStrains
  {
    /** The maximum compression: the minimum of the principal tangential strains
     * of both faces and of the thickness strains. */
    ValueAtPlace compression;
    /** The maximum transverse shear, the length of
     * @f$(2E_{13},2E_{23})@f$. */
    ValueAtPlace shear;

    /** A wave of one face that is short against the thickness. */
    struct ShortWave
    {
      /** The stiffness against the wave, relative to that without
       * resultants. */
      ValueAtPlace stiffness;
      /** The direction of the wave, from @f$\mathbf e_1@f$ toward
       * @f$\mathbf e_2@f$. Unit: degrees. */
      double direction = 0;
    };

    /**
     * The short wave with the least stiffness in cells that are shorter than
     * the layer is thick, around the node that the last iteration moved most;
     * none if there are no such cells. With the unit vector n along the wave,
     * the stiffness is the lowest eigenvalue of
     * @f$\mathbf D_n^{-1}(\mathbf D_n+\mathbf N)@f$, where @f$D_n^{pq}@f$ are
     * the stiffnesses against the transverse shear strains of the faces along
     * n, and @f$\mathbf N@f$ has the diagonal entries @f$H_{ab}^pn_an_b@f$. A
     * face wrinkles where it is negative: the gradient factor of the laminate
     * raises it.
     */
    std::optional<ShortWave> short_wave;

    /** Whether the law of any ply is linear. */
    bool linear_law = true;

    /** The factor of the gradients, see TransverseShearLaw::gradient_factor. */
    double gradient_factor = 1;
  };

  /** The short wave with the least stiffness, see WorstStrains::short_wave.
   * Must be called on all ranks.
   * @param node the cells around the node with this number count. */
  std::optional<WorstStrains::ShortWave>
  softest_short_wave(const ShellMesh                       &mesh,
                     const InternalForces                  &forces,
                     const State                           &state,
                     const dealii::types::global_cell_index node);

  /**
   * Green's strain at which a St. Venant-Kirchhoff material has no stiffness
   * left in uniaxial stress: the force @f$\lambda E@f$ has its minimum at
   * @f$\lambda=1/\sqrt3@f$.
   */
  constexpr double least_stable_strain = -1. / 3;

  /** The worst strains of a state without the short wave, the same on all ranks
   * and on any number of them: of equal strains, that in the cell of the lowest
   * number. Must be called on all ranks. */
  WorstStrains
  worst_strains(const ShellMesh      &mesh,
                const InternalForces &forces,
                const State          &state);

  /** Sentences for the user such as "the shell is compressed most at ..."; they
   * name the material if the compression is close to @p least_stable_strain,
   * and a face that is about to wrinkle. */
  std::string
  describe(const WorstStrains &worst);
} // namespace Biface

#endif
