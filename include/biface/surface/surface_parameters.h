// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_surface_parameters_h
#define biface_surface_surface_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <mpi.h>

#include <memory>
#include <string>

#include <biface/surface/circular_arc.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/straight_line.h>

namespace Biface
{
  /** The choice of the reference surface. */
  struct SurfaceParameters
  {
    enum class Type
    {
      revolution,
      plane
    };

    enum class MeridianType
    {
      circular_arc,
      straight_line,
      spline
    };

    Type                     type     = Type::revolution;
    MeridianType             meridian = MeridianType::circular_arc;
    CircularArc::Parameters  circular_arc;
    StraightLine::Parameters straight_line;
    /** A CSV file, see parse_pairs(). */
    std::string points_file;

    void
    add_parameters(dealii::ParameterHandler &prm);
  };


  /**
   * Create the surface. Throws InputError if the parameters are invalid.
   *
   * @param communicator the ranks; one of them reads files for all.
   */
  std::unique_ptr<ReferenceSurface>
  make_surface(const SurfaceParameters &parameters,
               const MPI_Comm           communicator);
} // namespace Biface

#endif
