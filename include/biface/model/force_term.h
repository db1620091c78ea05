// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_force_term_h
#define biface_model_force_term_h

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * A kind of force on the shell: one term of the sum that ShellEquations
   * brings into equilibrium. Cell by cell, a term adds its forces, their exact
   * derivative with respect to the displacements and, where it depends on the
   * loads, that with respect to them. Forces that do not depend on the
   * displacements are added once for the whole shell.
   */
  class ForceTerm
  {
  public:
    virtual ~ForceTerm() = default;

    /** A cell, and all that its forces may depend on. */
    struct CellState
    {
      /** Its position in ShellMesh::cells. */
      unsigned int index;
      const Cell  &cell;
      /** Its nodal displacements in the state, see MixedElement::dof(). */
      const MixedElement::NodalVector &V;
      const State                     &state;
      const Loads                     &loads;
    };

    /** The forces on the nodes of a cell. */
    struct CellForces
    {
      /** Forces within the shell and those of a foundation. */
      MixedElement::NodalVector force;

      /** Loads: they do not cancel between the cells of a node. */
      MixedElement::NodalVector load;

      /** Minus the derivative of both with respect to the nodal displacements.
       */
      MixedElement::NodalMatrix tangent;

      /** Sum of the squares of all that is added to @p force: the forces that
       * cancel in equilibrium. */
      double square;

      void
      clear();
    };

    /** Whether the term adds anything to a cell. A term that acts on few cells
     * says so, and costs nothing on the others. */
    virtual bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const = 0;

    /** Add what the term gives to a cell that it acts on. */
    virtual void
    add(const CellState &at, CellForces &forces) const = 0;

    /** Add the derivative of the forces on a cell when the loads change at the
     * given rates. */
    virtual void
    add_load_derivative(const CellState & /*at*/,
                        const LoadRates & /*rates*/,
                        MixedElement::NodalVector & /*force*/) const
    {}

    /** Add the forces that do not depend on the displacements, at loads of the
     * given values; they are proportional to them. */
    virtual void
    add_dead_forces(const LoadRates & /*loads*/,
                    LA::Vector & /*nodal_forces*/) const
    {}

    /** Whether the tangent of the term is symmetric at such loads. */
    virtual bool
    is_symmetric(const Loads & /*loads*/) const
    {
      return true;
    }

    /** Whether a linear strain theory linearizes these forces, too. */
    virtual bool
    is_linearized() const
    {
      return true;
    }
  };


  inline void
  ForceTerm::CellForces::clear()
  {
    force = 0;
    load  = 0;
    for (auto &row : tangent)
      row.fill(0);
    square = 0;
  }
} // namespace Biface

#endif
