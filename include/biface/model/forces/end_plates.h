// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_end_plates_h
#define biface_model_forces_end_plates_h

#include <biface/base/linear_algebra.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The pressure on rigid plates that close edges of a surface of revolution,
   * which pass it on to the edge: along the axis, on the area within the edge
   * of the face under pressure before the deformation. That is the circle or,
   * where the element interpolates positions, the polygon through the nodes, so
   * that the plates balance the pressure on the shell. With Cavity, whose
   * volume includes what the plate sweeps along the axis, a sealed gas remains
   * conservative.
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
