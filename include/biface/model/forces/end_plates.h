// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_end_plates_h
#define biface_model_forces_end_plates_h

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  /** Half of the area, at one of both nodes of a side of a cell on an edge of
   * the first coordinate, between the axis and the edge of the face under
   * pressure, in a plane orthogonal to the axis; times the unit vector along
   * the axis and away from the cavity, in the frame of the node. The edge is a
   * circle or, where the element interpolates positions, the polygon through
   * the nodes. Unit: length^2.
   * @param radius of a circle in place of the edge, if set. Unit: length. */
  dealii::Tensor<1, 3>
  half_of_plane(const ShellMesh            &mesh,
                const Resultants::Face      face,
                const BoundarySegment      &segment,
                const Node                 &node,
                const std::optional<double> radius = {});


  /**
   * The pressure on rigid plates that close edges of a surface of revolution,
   * which pass it on to the edge, see half_of_plane(). With Cavity, whose
   * volume includes what the plates sweep, a sealed gas is conservative.
   */
  class EndPlates : public ForceTerm
  {
  public:
    EndPlates(const ShellMesh &mesh, const PressureLoad &pressure);

    void
    add_dead_forces(const LoadRates &loads,
                    LA::Vector      &nodal_forces) const override
    {
      nodal_forces.add(loads.pressure, at_unit_pressure);
    }

  private:
    LA::Vector at_unit_pressure;
  };
} // namespace Biface

#endif
