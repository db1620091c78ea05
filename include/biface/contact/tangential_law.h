// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_tangential_law_h
#define biface_contact_tangential_law_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>

#include <biface/contact/contact_state.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/rolling.h>

namespace Biface
{
  /** A point of a face where it may touch a rigid body. */
  struct PointInContact
  {
    /** The number of the point, see ContactPoints. */
    unsigned int point;
    /** The deformed position of the face at the point. */
    dealii::Point<3> x;
    /** The body, kept by reference. */
    const RigidBody &body;
    /** The geometry of the body at the position. */
    BodyPoint at_body;

    /** The particle of a rolling shell that passes the node, if it has a
     * velocity, see Streamlines. */
    struct Particle
    {
      Rolling rolling;
      /** The derivative @f$\partial\mathbf x/\partial\varphi@f$ along the
       * streamline. */
      dealii::Tensor<1, 3> slope;
      /** The derivative of the slope by the position of the adjacent node ahead
       * on the streamline, and minus that by the one behind. */
      double per_neighbor;
    };

    std::optional<Particle> particle{};

    /** The velocity of the particle relative to the ground; zero without
     * one. */
    dealii::Tensor<1, 3>
    relative_velocity() const
    {
      return particle ? particle->rolling.relative_velocity(x, particle->slope)
                      : dealii::Tensor<1, 3>();
    }

    /** The velocity with which the particle slips over the ground: its relative
     * velocity without the part along the normal. */
    dealii::Tensor<1, 3>
    slip_velocity() const
    {
      const dealii::Tensor<1, 3> &n = at_body.normal;
      const dealii::Tensor<1, 3>  v = relative_velocity();
      return v - (n * v) * n;
    }
  };


  /** The traction of the body on the shell at a node in contact, as it enters
   * the linear system from which the multiplier @f$\lambda@f$ of the next
   * iterate is eliminated. */
  struct LinearizedTraction
  {
    /** The traction with the multiplier extrapolated linearly from that of the
     * state to that of the clearance, which it is in converged states. Unit:
     * force/area. */
    dealii::Tensor<1, 3> value;
    /** Minus the derivative of the traction with respect to the position of the
     * node, with the multiplier of the state. */
    dealii::Tensor<2, 3> stiffness;
    /** Minus the derivatives of the traction with respect to the positions of
     * the adjacent nodes along the streamline, behind and ahead. */
    std::array<dealii::Tensor<2, 3>, 2> stiffness_of_neighbors{};
    /** The derivatives of the traction with respect to the velocity of the
     * particle at the node and to the angular velocity. */
    dealii::Tensor<2, 3> per_velocity;
    dealii::Tensor<1, 3> per_angular_velocity;
  };


  /** The law by which a body holds the nodes in contact sideways, each for
   * itself; this base class is that without friction. */
  class TangentialLaw
  {
  public:
    virtual ~TangentialLaw() = default;

    /** Whether the tractions follow from the velocity with which a rolling
     * shell slips, rather than from displacements. */
    virtual bool
    depends_on_velocity() const
    {
      return false;
    }

    /** Whether there is a tangential traction at an active node. */
    virtual bool
    acts_on(const ContactState & /*state*/, const unsigned int /*node*/) const
    {
      return false;
    }

    /** Set what the nodes remember at the start of a stage. */
    virtual void
    start_stage(ContactState &state) const;

    /** Let the nodes of a copy of an equilibrium stick, to hold them in
     * perturbations of it. */
    virtual void
    stick_all(ContactState & /*state*/) const
    {}

    /** Decide whether an active node on which the law acts sticks or slips,
     * given its multipliers in the last iterate.
     * @return whether the iteration has to go on until the node obeys the law.
     */
    virtual bool
    decide(ContactState & /*state*/,
           const PointInContact & /*at*/,
           const dealii::Tensor<1, 3> & /*last*/) const
    {
      return false;
    }

    /** The tangential traction at an active node on which the law acts, with
     * the multiplier of the state. */
    virtual dealii::Tensor<1, 3>
    traction(const ContactState & /*state*/,
             const PointInContact & /*at*/) const
    {
      return {};
    }

    /** Add the tangential traction at an active node and its derivatives. */
    virtual void
    linearize(const ContactState & /*state*/,
              const PointInContact & /*at*/,
              LinearizedTraction & /*traction*/) const
    {}

    /** Set what an active node remembers at the end of a step. Nodes slide
     * freely without friction and in the step in which they enter. */
    virtual void
    commit_step(ContactState &state, const PointInContact &at) const;

    /** The motion over the body at rest of a node that has slipped in a step,
     * whose work with the traction is heat. */
    virtual dealii::Tensor<1, 3>
    slip_in_step(const ContactState & /*before*/,
                 const ContactState & /*after*/,
                 const RigidBody & /*body*/,
                 const unsigned int /*node*/) const
    {
      return {};
    }
  };
} // namespace Biface

#endif
