// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_end_plates_h
#define biface_model_forces_end_plates_h

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  /**
   * The nodal forces of a unit pressure on planes orthogonal to the axis at
   * edges of the first coordinate: along the axis, away from the cavity, on the
   * undeformed area within the edge of the face under pressure. The edge is a
   * circle or, where the element interpolates positions, the polygon through
   * the nodes, so that the planes balance the pressure on the shell. As a
   * derivative by the nodal unknowns, they are that of the volume that the
   * planes sweep as they move along the axis.
   * @param radius of circles in place of the edges, if set. Unit: length.
   */
  LA::Vector
  forces_on_planes(const ShellMesh            &mesh,
                   const Resultants::Face      face,
                   const std::vector<Edge>    &edges,
                   const std::optional<double> radius = {});


  /**
   * The pressure on rigid plates that close edges of a surface of revolution,
   * which pass it on to the edge, see forces_on_planes(). With Cavity, whose
   * volume includes what the plates sweep, a sealed gas is conservative.
   */
  class EndPlates : public ForceTerm
  {
  public:
    EndPlates(const ShellMesh &mesh, const PressureLoad &pressure)
      : at_unit_pressure(
          forces_on_planes(mesh, pressure.face, pressure.end_plates))
    {}

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
