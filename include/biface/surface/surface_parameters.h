// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_surface_parameters_h
#define biface_surface_surface_parameters_h

#include <memory>
#include <string>
#include <vector>

#include <biface/input/pairs_file.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/cord_equilibrium.h>
#include <biface/surface/imperfection.h>
#include <biface/surface/mesh_file.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/straight_line.h>

namespace Biface
{
  class EntryDeclarations;


  /** The choice of the reference surface. */
  struct ReferenceSurface::Parameters
  {
    enum class Type
    {
      revolution,
      plane,
      mesh
    };

    enum class MeridianType
    {
      circular_arc,
      straight_line,
      spline,
      cord_equilibrium
    };

    Type                        type     = Type::revolution;
    MeridianType                meridian = MeridianType::circular_arc;
    CircularArc::Parameters     circular_arc;
    StraightLine::Parameters    straight_line;
    CordEquilibrium::Parameters cord_equilibrium;
    /** The file of the points (radius, axial coordinate) of a spline. */
    PairsFile points_file;
    /** The least radius of curvature of the kinks among the points; 0 for a
     * spline through all of them. Unit: length. */
    double                   corner_radius = 0;
    MeshFile                 mesh;
    Imperfection::Parameters imperfection;

    void
    add_parameters(EntryDeclarations &prm);
  };


  /** Create the surface. Throws InputError if the parameters do not describe
   * one. */
  std::unique_ptr<ReferenceSurface>
  make_surface(const ReferenceSurface::Parameters &parameters);

  /** Sentences on a surface that is valid but perhaps not as intended: points
   * of a meridian that were taken as one, kinks, an outward normal that points
   * to the axis over most of its length, and a mesh of facets. Throws
   * InputError like make_surface(). */
  std::vector<std::string>
  remarks_on_surface(const ReferenceSurface::Parameters &parameters);
} // namespace Biface

#endif
