// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_bristles_h
#define biface_contact_bristles_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>
#include <vector>

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/rolling.h>

namespace Biface
{
  /**
   * Coulomb's law of friction of FrictionLaw for a shell that rolls steadily:
   * the history of a particle is its way through the footprint. It is the brush
   * model @cite Pacejka2012 on a deformed shell.
   *
   * Each particle in contact carries an elastic bristle whose tip touches the
   * ground. Along the line on which the material flows, from node to node, its
   * deflection is
   * @f[
   *   \mathbf e_j=\mathrm{proj}\left(\mathbf e_{j-1}+\theta_j
   *     (\mathbf x_j-\mathbf x_{j-1}-\mathbf u_j)\right),\qquad
   *   |\mathbf e_j|\le\mu(p_j)\,p_j/\varepsilon_t,
   * @f]
   * with the motion @f$\mathbf u_j@f$ of the ground during the time
   * @f$\Delta\varphi/|\Omega|@f$, by its tangential part, and the traction on
   * the shell is @f$-\varepsilon_t\mathbf e_j@f$. Nodes that do not touch have
   * no deflection. The factor @f$\theta@f$ is 1, and at the first node that
   * touches the part of the segment before it that does,
   * @f$c_j/(c_j-c_{j-1})@f$ by the clearances, so that the forces are of second
   * order in the distance of the nodes. There is no other parameter than the
   * two of the law of a shell that stands, to which this one is equal.
   */
  class BristleLaw
  {
  public:
    /** The law of bristles. Both objects are kept by reference.
     * @param law its coefficient must not depend on the slip velocity. */
    BristleLaw(const FrictionLaw &law, const ContactCondition &condition)
      : law(law), condition(condition)
    {}

    /** A node of a line, in the order in which the material passes. */
    struct Station
    {
      bool             touches;
      dealii::Point<3> x;
      BodyPoint        at_body;
      /** The tangents of the ground, see RigidBody::tangents(). */
      std::array<dealii::Tensor<1, 3>, 2> tangents;
      /** The derivatives of the tangents by the position. */
      std::array<dealii::Tensor<2, 3>, 2> tangent_gradients;
      /** The angle from the station before; positive, in radians. */
      double angle;
      /** The pressure that limits friction, an unknown of the iteration; that
       * of the clearance if it is not set. Unit: force/area. */
      std::optional<double> pressure{};
    };

    /** The station at a position.
     * @param angle from the station before. */
    static Station
    station(const RigidBody        &body,
            const dealii::Point<3> &x,
            const bool              touches,
            const double            angle);

    struct Bristle
    {
      /** The deflection @f$\mathbf e@f$ of the bristle along the tangents.
       * Unit: length. */
      dealii::Tensor<1, 2> deflection;
      /** The linear change of the deflection by the pressures of the
       * clearances; zero if the stations have these pressures, as in
       * equilibrium. */
      dealii::Tensor<1, 2> extrapolation;
      /** The velocity with which the tip of the bristle has slipped over the
       * ground since the station before. Unit: length/time. */
      dealii::Tensor<1, 2> slip_velocity;
      /** The derivatives of both components of the deflection by the positions
       * of the stations from @p first to this one, and by the angular
       * velocity. */
      unsigned int                                     first = 0;
      std::vector<std::array<dealii::Tensor<1, 3>, 2>> per_position;
      dealii::Tensor<1, 2>                             per_angular_velocity;

      /** Whether the tip slips. */
      bool
      slips() const
      {
        return slip_velocity.norm_square() > 0;
      }
    };

    /** The traction on the shell per deflection of a bristle, against it. Unit:
     * pressure/length. */
    double
    tangential_stiffness() const
    {
      return law.tangential_stiffness();
    }

    /** The bristles of a line. Their derivatives are those of deflection and
     * extrapolation together. */
    std::vector<Bristle>
    deflections(const std::vector<Station> &line, const Rolling &rolling) const;

  private:
    /** Set the bristle of a station from the bristle of the one before. */
    void
    move(const Station &before,
         const Bristle &bristle_before,
         const Station &at,
         const Rolling &rolling,
         Bristle       &bristle) const;

    FrictionLaw      law;
    ContactCondition condition;
  };
} // namespace Biface

#endif
