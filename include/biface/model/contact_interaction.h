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
    /** Sum of the areas that belong to the active nodes, on the surface midway
     * between the faces. */
    double area         = 0;
    double max_pressure = 0;
  };


  /**
   * The contact between the outer face of the shell and the foundation: which
   * nodes are in contact, with which tractions, and what the zone adds up to.
   * It keeps no state of its own. ContactForces makes forces of it.
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

      /** Throws InputError where a value is not usable. */
      void
      check() const;
    };

    /** The mesh is kept by reference. Throws InputError where the parameters do
     * not describe a foundation. */
    ContactInteraction(const ShellMesh &mesh, const Parameters &parameters);

    /** The foundation that has moved by @p travel from where it is at rest. */
    RigidFoundation
    foundation(const double travel) const
    {
      return foundation_at_rest.moved(travel);
    }

    /** The travel of the foundation that just touches a free node of the
     * deformed outer face: one that can come into contact. Throws InputError
     * where it passes by the shell, or the shell does not fit into it. */
    double
    touching_travel(const State &state) const;

    /** The nodes of this rank that the foundation has passed through, since
     * supports hold their outer face, and they cannot come into contact. */
    ActiveSet
    pierced_nodes(const State &state, const Loads &loads) const;

    /** How far the foundation travels until it touches a free node of the
     * outer face, see RigidFoundation::travel_to(). */
    double
    travel_to_touch(const State &state, const Loads &loads) const;

    /** Distance between a node's deformed outer face and the foundation. */
    double
    clearance(const State &state, const Loads &loads, const Node &node) const;

    /** Give active nodes the multipliers of the state's displacements, decide
     * anew which nodes are in contact, and give them theirs: one iteration of
     * the primal-dual active set method.
     * @param held nodes that remain in contact, whatever the state; empty for
     * none.
     * @return the number of changes, on all ranks. */
    unsigned int
    update_active_set(State           &state,
                      const Loads     &loads,
                      const ActiveSet &held = {}) const;

    /** Nodes in contact, on all ranks. */
    unsigned int
    count_active(const State &state) const;

    /** What an active node presses on the foundation with. */
    struct Traction
    {
      /** That on the shell, @f$\lambda\mathbf n@f$. Unit: force/area. */
      dealii::Tensor<1, 3> value;
      /** Minus its derivative with respect to the position of the node,
       * @f$\varepsilon\,\mathbf n\mathbf n^T-\lambda\nabla\mathbf n@f$. */
      dealii::SymmetricTensor<2, 3> stiffness;
    };

    Traction
    traction(const State &state, const Loads &loads, const Node &node) const;

    /** The compressive force on the foundation, see ContactSummary, with its
     * derivatives while no node enters or leaves the contact: that of the
     * multipliers which belong to the displacements. */
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

    /** By the multipliers of the state. */
    ContactSummary
    summarize(const State &state, const Loads &loads) const;

    const ShellMesh       &mesh;
    const ContactCondition condition;

  private:
    const RigidFoundation foundation_at_rest;
  };
} // namespace Biface

#endif
