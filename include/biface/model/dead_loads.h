// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_dead_loads_h
#define biface_model_dead_loads_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/model/discretization.h>

namespace Biface
{
  /**
   * Loads that keep their size and direction, as they are at the load factor 1:
   * forces at named points, on edges, and on the whole shell.
   */
  struct DeadLoads
  {
    std::string          point_forces;
    std::string          edge_forces;
    dealii::Tensor<1, 3> area_force;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * The nodal forces of all these loads.
     *
     * Throws InputError where a text is malformed, or names a point or an edge
     * that does not exist.
     */
    LA::Vector
    assemble(const Discretization &discretization) const;
  };


  /** The nodal forces of a unit pressure on the inner face, counted on the
   * surface midway between the faces. */
  LA::Vector
  assemble_unit_pressure(const Discretization &discretization);
} // namespace Biface

#endif
