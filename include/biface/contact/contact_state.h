// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_state_h
#define biface_contact_contact_state_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

#include <biface/contact/active_set.h>

namespace Biface
{
  /** The way in which a body holds a node sideways. */
  enum class ContactStatus : char
  {
    /** The node was not in contact at the end of the last step and has no
     * history: friction begins at the end of the step in which it enters. */
    none,
    /** The node sticks to its point of the body. */
    stick,
    /** The node slips at the limit of friction. */
    slip,
    /** The node sticks, however large the traction. */
    glued
  };


  /** What happens between a face of the shell and one rigid body, at the points
   * of this rank by their numbers, see ContactPoints. */
  struct ContactState
  {
    ContactState() = default;

    /** The state in which no point is in contact.
     * @param per_cell the number of points in a cell; 0 if they are the
     * nodes. */
    explicit ContactState(const unsigned int n_points,
                          const unsigned int per_cell = 0)
      : per_cell(per_cell)
      , active(n_points, 0)
      , multipliers(n_points)
      , statuses(n_points, ContactStatus::none)
      , stick_points(n_points)
    {}

    /** The number of points in a cell, see ContactPoints::per_cell(). */
    unsigned int per_cell = 0;

    /** The active set: the points in contact. */
    ActiveSet active;

    /**
     * The contact multipliers, at nodes bilinear on the face,
     * @cite GrigolyukKulikovPlotnikova2004, eq. (10): the traction on the
     * shell per area of the middle surface. The first component, along the
     * normal of the body, is minus the pressure; the two tangential
     * components, see RigidBody::tangents(), are zero without friction.
     * In the iteration, the first component is an unknown like the resultants:
     * the solution of the last linear system, zero at nodes that have just
     * entered. In converged states it is that of the clearance.
     * Unit: force/area.
     */
    std::vector<dealii::Tensor<1, 3>> multipliers;

    /** The statuses of the nodes in friction, and the points of the body at
     * rest to which they stick. In a step a node may start and cease to slip;
     * everything else is the history of friction up to the end of the last
     * step, see TangentialLaw::commit_step(). While the shell rolls, friction
     * has no history: the statuses tell where it slips, and the stick points
     * are those from which it could stand. */
    std::vector<ContactStatus>    statuses;
    std::vector<dealii::Point<3>> stick_points;

    /** The contact pressure at a node; 0 if it is not in contact. */
    double
    pressure(const unsigned int node) const
    {
      return active[node] ? -multipliers[node][0] : 0.;
    }

    /** Whether a node slips at the limit of friction. */
    bool
    slips(const unsigned int node) const
    {
      return active[node] && statuses[node] == ContactStatus::slip;
    }

    /** Let all nodes stick that have a stick point, where nothing is known
     * about the slip: too many slipping nodes have too little stiffness. */
    void
    make_slipping_points_stick()
    {
      for (ContactStatus &status : statuses)
        if (status == ContactStatus::slip)
          status = ContactStatus::stick;
    }

    /** Let the glued ones of the given nodes forget their stick points,
     * like nodes that leave the body and enter it again.
     * @return whether there are any. */
    bool
    release_glue(const ActiveSet &nodes)
    {
      AssertDimension(nodes.size(), statuses.size());
      bool any = false;
      for (unsigned int n = 0; n < nodes.size(); ++n)
        if (nodes[n] && statuses[n] == ContactStatus::glued)
          {
            statuses[n] = ContactStatus::none;
            any         = true;
          }
      return any;
    }

    /** Let a node forget its stick point. */
    void
    forget_stick_point(const unsigned int node)
    {
      statuses[node]     = ContactStatus::none;
      stick_points[node] = dealii::Point<3>();
    }
  };
} // namespace Biface

#endif
