// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_greatest_deviation_h
#define biface_surface_greatest_deviation_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <array>

#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** The greatest of the deviations from a surface at many points, in parts of
   * the smaller radius of curvature there. Flat places have no limit. */
  class GreatestDeviation
  {
  public:
    /** The part that is allowed. Since the laminate is that of the surface, the
     * displacement of a cylinder under pressure is wrong by three to four times
     * this part (doc/theory.md). */
    static constexpr double allowed = 0.1;

    /** Add a point.
     * @param deviation along the normal. Unit: length.
     * @param curvature the larger principal curvature without its sign. Unit:
     * 1/length.
     * @param x the position.
     * @param alpha the coordinates in internal units, if the surface has any.
     */
    void
    add(const double            deviation,
        const double            curvature,
        const dealii::Point<3> &x,
        const dealii::Point<2> &alpha);

    /** Throws InputError, on all ranks, if that of any rank is too large. Must
     * be called on all ranks. */
    void
    check(const ReferenceSurface &surface, const MPI_Comm communicator) const;

  private:
    /** Minus the part of the radius, the position, the deviation, both
     * coordinates: of several points with the same part, the first one
     * counts. */
    std::array<double, 7> worst{};
  };
} // namespace Biface

#endif
