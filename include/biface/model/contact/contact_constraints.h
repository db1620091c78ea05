// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_constraints_h
#define biface_model_contact_contact_constraints_h

#include <deal.II/base/types.h>

#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  class ContactInteraction;
  struct Loads;
  struct State;


  /** A point of a pair, the same on all ranks: the number of the pair, and the
   * number of the node or of the point in a cell, which do not depend on the
   * number of ranks. */
  using ContactPoint =
    std::pair<unsigned int, dealii::types::global_cell_index>;


  /** The contact points by their positions on this rank, in the order of
   * ContactInteraction::active_points(). */
  std::vector<ContactPoint>
  contact_points(const ContactInteraction &contact);


  /** The contact constraint at a point, linearized: how a unit multiplier acts
   * on the shell along the normal of the body, and how the displacements change
   * the clearance. */
  struct ContactConstraint
  {
    /** The forces per unit of the multiplier, without those at supports. */
    LA::Vector forces;
    /** The derivative of the motion into the body by the displacements: the
     * positions among the entries of a vector on this rank, with values. */
    std::vector<std::pair<unsigned int, double>> gradient;
    /** The clearance at the point, see ContactPair::clearance(). Unit:
     * length. */
    double clearance = 0;
    /** The stiffness of the multiplier, see
     * ContactCondition::penalty_stiffness(). Unit: pressure/length. */
    double stiffness = 0;
  };


  /** The contact constraints at the given points, whose bodies are there. Must
   * be called on all ranks. */
  std::vector<ContactConstraint>
  contact_constraints(const ContactInteraction        &contact,
                      const State                     &state,
                      const Loads                     &loads,
                      const std::vector<ContactPoint> &points);
} // namespace Biface

#endif
