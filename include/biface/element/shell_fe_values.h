// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_shell_fe_values_h
#define biface_element_shell_fe_values_h

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_manifold.h>
#include <deal.II/grid/tria.h>

#include <array>

#include <biface/element/element_geometry.h>
#include <biface/surface/surface_point.h>

namespace Biface
{
  class ReferenceSurface;

  /**
   * The geometry of a shell, cell by cell, in the manner of dealii::FEValues:
   * reinit() goes to a cell, and the other functions give the geometry of the
   * shell at its vertices (the points of QTrapezoid) and at its center (that of
   * QMidpoint).
   *
   * Derivatives of the shape functions and areas are those of
   * dealii::FEValues with the bilinear FE_Q and MappingManifold; frames, Lamé
   * parameters and curvatures are those of the manifold.
   *
   * @code
   *   ShellFEValues fe_values(surface);
   *   for (const auto &cell : triangulation.active_cell_iterators())
   *     {
   *       fe_values.reinit(cell, face_heights);
   *       const MixedElement element(fe_values.get_geometry(), V);
   *       force += element.internal_force(H, H_0);
   *     }
   * @endcode
   *
   * The geometry of the undeformed shell does not change: ShellMesh visits
   * each cell once and stores its get_geometry().
   */
  class ShellFEValues
  {
  public:
    /** The heights @f$\delta^-,\delta^+@f$ of the faces at each vertex, see
     * Laminate::face_heights(). Unit: length. */
    using FaceHeights = std::array<std::array<double, 2>, 4>;

    /** @param surface the manifold of all cells. It must outlive this object.
     * @param normal_thickness see ElementGeometry. */
    explicit ShellFEValues(
      const ReferenceSurface &surface,
      const Formulation       formulation      = Formulation::standard,
      const bool              normal_thickness = false);

    /**
     * Go to a cell, the sides of which must be coordinate lines.
     *
     * @param face_heights assumed bilinear in the coordinates.
     * @param wall_thickness of which the element may be a layer; 0 for its own
     * thickness.
     */
    void
    reinit(const dealii::Triangulation<2, 3>::cell_iterator &cell,
           const FaceHeights                                &face_heights,
           const double wall_thickness = 0);

    /** The reference surface at a vertex: frame, @f$A_a@f$, @f$k_a@f$,
     * @f$B_a@f$. */
    const SurfacePoint &
    surface_at_vertex(const unsigned int vertex) const
    {
      return points[vertex];
    }

    /** The reference surface at the center. */
    const SurfacePoint &
    surface_at_center() const
    {
      return center;
    }

    /** The cell's area on the reference surface, by the midpoint rule. Unit:
     * length^2. */
    double
    JxW() const
    {
      return at_center.JxW(0);
    }

    /** The geometry as MixedElement needs it. */
    const ElementGeometry &
    get_geometry() const
    {
      return geometry;
    }

  private:
    /** Replace the exact geometry of the faces by a bilinear one. */
    void
    interpolate_positions(const FaceHeights &face_heights,
                          const double       wall_thickness);

    /** Set ElementGeometry::stations. */
    void
    set_stations(const FaceHeights &face_heights);

    const ReferenceSurface             &surface;
    const dealii::MappingManifold<2, 3> mapping;
    const dealii::FE_Q<2, 3>            fe;
    dealii::FEValues<2, 3>              at_vertices;
    dealii::FEValues<2, 3>              at_center;

    std::array<SurfacePoint, 4> points;
    SurfacePoint                center;
    ElementGeometry             geometry;
  };
} // namespace Biface

#endif
