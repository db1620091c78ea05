// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_summary_h
#define biface_model_contact_contact_summary_h


namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /** The figures of a contact zone. */
  struct ContactSummary
  {
    /** Compressive force on the body, along its direction. */
    double force = 0;
    /** The number of nodes, or of points in cells. */
    unsigned int n_nodes = 0;
    /** The number of points that slip at the limit of friction; 0 without
     * friction. */
    unsigned int n_slipping = 0;
    /** Sum of the areas of the active points on the middle surface. */
    double area = 0;
    /** The part of @p area that belongs to slipping points. */
    double slipping_area = 0;
    double max_pressure  = 0;
    /** The mean of the pressures @f$p@f$ at the points, each weighted by the
     * force
     * @f$pA@f$ that it carries: @f$\sum p^2A/\sum pA@f$. For a given force it
     * is lowest if the pressure is the same on as large an area as possible.
     * Nodes that enter or leave do so without pressure and do not change it.
     * Unit: force/area. */
    double weighted_pressure = 0;
    /** The standard deviation of the nodal pressures with the same weights, in
     * parts of this mean: zero if all of the ground that carries is under the
     * same pressure. No unit. */
    double pressure_variation = 0;
  };


  /** The figures of the contact zone of a pair, from the multipliers of the
   * state. Must be called on all ranks. */
  ContactSummary
  summarize(const ContactPair &pair, const State &state, const Loads &loads);

  /** The number of active points of a pair on all ranks, on all of which it
   * must be called. */
  unsigned int
  count_active(const ContactPair &pair, const State &state);

  /** The number of points of a pair that slip at the limit of friction, on all
   * ranks, on all of which it must be called. */
  unsigned int
  count_slipping(const ContactPair &pair,
                 const State       &state,
                 const Loads       &loads);

  /** The work of friction in a step, that is, the heat: at each node the
   * traction at the end of the step times the motion of the stick point. Must
   * be called on all ranks.
   * @param loads at the end of the step. */
  double
  friction_work(const ContactPair &pair,
                const State       &before,
                const State       &after,
                const Loads       &loads);
} // namespace Biface

#endif
