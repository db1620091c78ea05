// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_interaction_h
#define biface_model_contact_interaction_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/rigid_foundation.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>

namespace Biface
{
  /** The figures of a contact zone. */
  struct ContactSummary
  {
    /** Compressive force on the foundation, along its direction. */
    double       force   = 0;
    unsigned int n_nodes = 0;
    /** Sum of the areas of the active nodes on the middle surface. */
    double area         = 0;
    double max_pressure = 0;
  };


  /**
   * The contact between the outer face of the shell and the foundation: the
   * active set, the tractions, and the figures of the contact zone. It has no
   * state of its own. ContactForces computes the nodal forces.
   */
  class ContactInteraction
  {
  public:
    struct Parameters
    {
      RigidFoundation::Parameters  foundation;
      ContactCondition::Parameters condition;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The mesh is kept by reference. Throws InputError if the parameters are
     * invalid. */
    ContactInteraction(const ShellMesh &mesh, const Parameters &parameters);

    /** The foundation after the given travel from its initial position. */
    RigidFoundation
    foundation(const double travel) const
    {
      return foundation_at_rest.moved(travel);
    }

    /** The travel at which the foundation just touches a free node of the
     * deformed outer face, one that can come into contact. Throws InputError if
     * it misses the shell, or if the shell does not fit into it. */
    double
    touching_travel(const State &state) const;

    /** The nodes of this rank that the foundation has passed through: supports
     * hold their outer face, so they cannot come into contact. */
    ActiveSet
    pierced_nodes(const State &state, const Loads &loads) const;

    /** The travel until the foundation touches a free node of the outer face,
     * see RigidFoundation::travel_to(). */
    double
    travel_to_touch(const State &state, const Loads &loads) const;

    /** Distance between the deformed outer face at a node and the
     * foundation. */
    double
    clearance(const State &state, const Loads &loads, const Node &node) const;

    /** One iteration of the primal-dual active set method: compute the
     * multipliers of the active nodes from the displacements of the state,
     * update the active set, and compute the multipliers of the new set.
     * @param held nodes that remain active in any case; empty for none.
     * @return the number of changes, on all ranks. */
    unsigned int
    update_active_set(State           &state,
                      const Loads     &loads,
                      const ActiveSet &held = {}) const;

    /** Number of active nodes on all ranks. */
    unsigned int
    count_active(const State &state) const;

    /** The contact traction at an active node. */
    struct Traction
    {
      /** The traction on the shell, @f$\lambda\mathbf n@f$. Unit:
       * force/area. */
      dealii::Tensor<1, 3> value;
      /** Minus its derivative with respect to the position of the node,
       * @f$\varepsilon\,\mathbf n\mathbf n^T-\lambda\nabla\mathbf n@f$. */
      dealii::SymmetricTensor<2, 3> stiffness;
    };

    Traction
    traction(const State &state, const Loads &loads, const Node &node) const;

    /** The compressive force on the foundation, see ContactSummary, from the
     * multipliers of the displacements, with its derivatives for a fixed active
     * set. */
    struct Force
    {
      double value;
      /** With respect to the displacements. */
      LA::Vector gradient;
      /** With respect to the travel of the foundation. */
      double per_travel;
    };

    Force
    force(const State &state, const Loads &loads) const;

    /** The figures from the multipliers of the state. */
    ContactSummary
    summarize(const State &state, const Loads &loads) const;

    const ShellMesh       &mesh;
    const ContactCondition condition;

  private:
    const RigidFoundation foundation_at_rest;
  };
} // namespace Biface

#endif
