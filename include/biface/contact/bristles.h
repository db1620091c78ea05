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
       * ground since the station before, or in a step in time, as a mean. Unit:
       * length/time. */
      dealii::Tensor<1, 2> slip_velocity;
      /** The derivatives of both components of the deflection by the positions
       * of the stations from @p first to this one, and by the angular
       * velocity. */
      unsigned int                                     first = 0;
      std::vector<std::array<dealii::Tensor<1, 3>, 2>> per_position;
      dealii::Tensor<1, 2>                             per_angular_velocity;
      /** Whether the deflection is at the limit of friction. */
      bool is_limited = false;

      /** Whether the tip slips. */
      bool
      slips() const
      {
        return is_limited;
      }
    };

    /** The traction on the shell per deflection of a bristle, against it. Unit:
     * pressure/length. */
    double
    tangential_stiffness() const
    {
      return law.tangential_stiffness();
    }

    /** The bristles of a line in steady rolling. Their derivatives are those of
     * deflection and extrapolation together. */
    std::vector<Bristle>
    deflections(const std::vector<Station> &line, const Rolling &rolling) const;

    /** A station at the start of a step. */
    struct Past
    {
      dealii::Point<3> x;
      /** The clearance from the body where it was. Unit: length. */
      double clearance = 0;
      /** The deflection along the tangents; zero for a station that did not
       * touch. Unit: length. */
      dealii::Tensor<1, 2> deflection;
      /** How the body there has been moved in the step, beside the motion
       * under a wheel that Rolling::ground has. Unit: length. */
      dealii::Tensor<1, 3> shift;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &x &clearance &deflection &shift;
      }
    };

    /**
     * The bristles of a line at the end of a step in time, see deflections().
     * Of the segment before a station, particles pass the part
     * @f$C_j=|\Omega|\,\Delta t/(m\,\Delta\varphi_j)\le 1@f$ in each of
     * @f$m@f$ equal parts of the step, and
     * @f[
     *   \mathbf e_j\leftarrow\mathrm{proj}\left(
     *     (1-P_j)\left(\mathbf e_j+\theta^t_j\,
     *       (\mathbf x_j-\mathbf x^-_j)\right)+
     *     P_j\left(\mathbf e_{j-1}+\theta^\varphi_j\,
     *       (\mathbf x_j-\mathbf x^-_{j-1})\right)-
     *     \gamma_j\,\Delta\mathbf g_j\right)
     * @f]
     * with the positions @f$\mathbf x^-@f$ at the start of the part, the motion
     * @f$\Delta\mathbf g@f$ of the body, and @f$P=C@f$ and @f$\gamma=1@f$
     * except at the first station that touches, see section 10 of
     * doc/theory.md. The steady state is that of deflections().
     *
     * @param past the stations at the start of the step.
     * @param duration of the step. Unit: time.
     * @param rolling the mean motion in the step.
     */
    std::vector<Bristle>
    deflections_in_time(const std::vector<Station> &line,
                        const std::vector<Past>    &past,
                        const double                duration,
                        const Rolling              &rolling) const;

  private:
    /** A part of a step in time, from one fraction of the step to another. */
    struct PartOfStep
    {
      double from, to;
      /** Unit: time. */
      double duration;
    };

    /** The bristle of a station at the end of a part of a step, from those at
     * its start.
     * @param j the position of the station in the line; not the first. */
    Bristle
    move_in_time(const std::vector<Station> &line,
                 const std::vector<Past>    &past,
                 const std::vector<Bristle> &at_start,
                 const PartOfStep           &part,
                 const unsigned int          j,
                 const Rolling              &rolling) const;

    /** Set a bristle, whose derivatives are those of a trial deflection, to
     * that with the limit of a pressure.
     * @param trial, trial_extrapolation without limit, times the scale.
     * @param pressure, exact_pressure in the iteration, and that of the
     * clearance.
     * @param pressure_per_position by that of the station. */
    void
    limit(Bristle                    &bristle,
          const dealii::Tensor<1, 2> &trial,
          const dealii::Tensor<1, 2> &trial_extrapolation,
          const double                scale,
          const double                pressure,
          const double                exact_pressure,
          const dealii::Tensor<1, 3> &pressure_per_position) const;

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
