// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_dead_loads_h
#define biface_model_dead_loads_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/model/force_term.h>
#include <biface/model/pressure_load.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  /**
   * Loads that grow with the load factor, as they are at the load factor 1:
   * forces at named points, on edges, on faces and on the whole shell, which
   * keep their direction, and moments along edges, which may follow.
   */
  struct DeadLoads
  {
    std::string point_forces;
    std::string edge_forces;
    std::string edge_moments;
    /** By the face. */
    std::array<std::string, 2> tractions;
    dealii::Tensor<1, 3>       area_force;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * The nodal forces of all these loads, without moments that follow.
     *
     * @param area what tractions are counted on.
     *
     * Throws InputError where a text is malformed, or names a point or an edge
     * that does not exist.
     */
    LA::Vector
    assemble(const ShellMesh &mesh, const AreaMeasure area) const;
  };


  /** The forces of dead loads: the same at all displacements. */
  class DeadForces : public ForceTerm
  {
  public:
    /** @param area see DeadLoads::assemble(), which throws. */
    DeadForces(const ShellMesh  &mesh,
               const DeadLoads  &loads,
               const AreaMeasure area)
      : at_unit_factor(loads.assemble(mesh, area))
    {}

    bool
    acts_on(const unsigned int, const State &, const Loads &) const override
    {
      return false;
    }

    void
    add(const CellState &, CellForces &) const override
    {}

    void
    add_dead_forces(const LoadRates &loads,
                    LA::Vector      &nodal_forces) const override
    {
      nodal_forces.add(loads.factor, at_unit_factor);
    }

  private:
    const LA::Vector at_unit_factor;
  };
} // namespace Biface

#endif
