// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_quadrilateral_geometry_h
#define biface_element_quadrilateral_geometry_h

#include <deal.II/base/tensor.h>

#include <array>
#include <memory>

#include <biface/element/element_geometry.h>
#include <biface/surface/surface_point.h>

namespace Biface
{
  /** What a cell without coordinates is made of: positions and frames at its
   * vertices in the order of deal.II, and the heights of its faces. */
  struct QuadrilateralPoints
  {
    /** Position, normal and frame; the first vectors of the frames need not be
     * along the sides. */
    std::array<SurfacePoint, 4> vertices;
    /** The heights @f$\delta^-,\delta^+@f$. Unit: length. */
    std::array<std::array<double, 2>, 4> heights;
    /** The first direction of the material, which is projected into the
     * cell. */
    dealii::Tensor<1, 3> direction;
    /** The thickness of the wall of which the element may be a layer; 0 for its
     * own. Unit: length. */
    double wall_thickness = 0;
  };

  /** The vectors of the frame at a point in the columns of a matrix. */
  dealii::Tensor<2, 3>
  in_columns(const SurfacePoint &point);

  /** The strains of the cell.
   * @param formulation not that of the paper.
   * @param normal_thickness see ElementGeometry. */
  std::shared_ptr<const Quadrilateral>
  make_quadrilateral(const QuadrilateralPoints &points,
                     const Formulation          formulation,
                     const bool                 normal_thickness);

  /** The faces of a cell between straight sides, see
   * ElementGeometry::Stations. */
  ElementGeometry::Stations
  straight_stations(const QuadrilateralPoints &points);

  /** The geometry of an element with Formulation::standard on a cell of any
   * shape, which need not lie along coordinate lines. */
  ElementGeometry
  quadrilateral_geometry(const QuadrilateralPoints &points,
                         const bool                 normal_thickness);
} // namespace Biface

#endif
