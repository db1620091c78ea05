// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <biface/contact/tangential_law.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** See RollingSummary. */
    Point<3>
    contact_center(const RigidBody &ground)
    {
      // Newton's method; exact for a plane
      constexpr unsigned int max_iterations = 20;
      constexpr double       tolerance      = 1e-14;

      // in the plane of the wheel, which is orthogonal to the axle
      Tensor<1, 3> down = ground.direction();
      down[1]           = 0;
      Point<3> center;
      for (unsigned int i = 0; i < max_iterations; ++i)
        {
          const BodyPoint at = ground.evaluate(center);
          if (std::abs(at.clearance) <= tolerance * center.norm())
            break;
          center += at.clearance / (at.normal * down) * down;
        }
      return center;
    }
  } // namespace


  std::vector<Tensor<1, 3>>
  slip_velocities(const ContactPair &contact,
                  const State       &state,
                  const Loads       &loads)
  {
    std::vector<Tensor<1, 3>> velocities(contact.mesh.nodes.size());
    const BristleLines        lines = contact.bristle_lines(state, loads);
    if (lines.exist())
      {
        for (unsigned int n = 0; n < velocities.size(); ++n)
          velocities[n] = lines.slip_velocity(n);
        return velocities;
      }
    for (unsigned int n = 0; n < velocities.size(); ++n)
      if (contact.state_of(state).active[n])
        velocities[n] = contact.at_point(state, loads, n).slip_velocity();
    return velocities;
  }


  std::optional<double>
  angular_velocity_without_slip(const ContactPair &contact,
                                const State       &state,
                                const Loads       &loads)
  {
    // the sums of the velocities of the ground and of those per angular
    // velocity
    std::vector<double> sums(2);
    if (contact.body(loads) && loads.rolling)
      for (const Cell &cell : contact.mesh.wall_elements())
        for (const unsigned int n : cell.nodes)
          if (contact.state_of(state).active[n])
            {
              const PointInContact at    = contact.at_point(state, loads, n);
              const Tensor<1, 3>   v     = loads.rolling->ground.at(at.x);
              const double         speed = v.norm();
              if (!at.particle || speed == 0)
                continue;
              const double force =
                cell.geometry.weight / 4 * contact.state_of(state).pressure(n);
              // -Omega x' - v_g along the velocity of the ground vanishes in
              // the mean, weighted by the forces
              sums[0] += force * speed;
              sums[1] -= force * (at.particle->slope * v) / speed;
            }
    Utilities::MPI::sum(sums, contact.mesh.communicator, sums);
    if (!(sums[0] > 0) || sums[1] == 0)
      return {};
    return sums[0] / sums[1];
  }


  RollingSummary
  summarize_rolling(const ShellEquations     &equations,
                    const ContactInteraction &interaction,
                    const State              &state,
                    const Loads              &loads,
                    const ForceOnShell       &exerted)
  {
    const ContactPair  &contact = interaction.ground();
    const RigidBody    &ground  = contact.body(loads)->body;
    const Rolling      &rolling = *loads.rolling;
    const GroundMotion &motion  = rolling.ground;
    const Point<3>      center  = contact_center(ground);
    const WheelAxes     axes(ground.evaluate(center).normal);
    const auto          in_axes = [&](const Tensor<1, 3> &v) {
      return Tensor<1, 3>({axes.forward * v, axes.left * v, axes.up * v});
    };

    // each column of the mass adds up to a quarter
    std::vector<double> powers(2);
    const ShellMesh    &mesh = contact.mesh;
    for (const Cell &cell : mesh.wall_elements())
      for (const unsigned int n : cell.nodes)
        if (contact.state_of(state).active[n])
          {
            const double area = cell.geometry.weight / 4;
            const auto   traction =
              contact.traction_of_multipliers(state, loads, n);
            const Tensor<1, 3> v =
              contact.at_point(state, loads, n).relative_velocity();
            powers[0] -= area * (traction.friction * v);
            powers[1] += area * ((traction.total - traction.friction) * v);
          }
    Utilities::MPI::sum(powers, mesh.communicator, powers);

    RollingSummary result;
    result.force         = in_axes(exerted.force);
    result.moment        = in_axes(exerted.moment_about(center));
    result.loaded_radius = center.norm();
    result.axle_moment   = axle_moment(interaction, state, loads).value;
    result.rolling_radius =
      (rolling.angular_velocity != 0
         ? -(motion.velocity * axes.forward) / rolling.angular_velocity
         : std::numeric_limits<double>::quiet_NaN());
    // the balance of powers, section 10 of doc/theory.md
    result.axle_power   = result.axle_moment * rolling.angular_velocity;
    result.ground_power = exerted.force * motion.velocity +
                          exerted.moment_about(motion.point) * motion.spin;
    result.friction_power    = powers[0];
    result.normal_power      = powers[1];
    result.sliding_power     = result.friction_power;
    const BristleLines lines = contact.bristle_lines(state, loads);
    if (lines.exist())
      {
        const BristleLines::Powers of_bristles =
          lines.powers(rolling.angular_velocity);
        result.sliding_power = of_bristles.sliding;
        result.release_power = of_bristles.release;
      }
    result.mismatch =
      result.axle_power + result.ground_power - result.friction_power;
    const bool is_steady = !state.rolling_step && state.velocity.size() == 0;
    if (mesh.get_layup().has_loss() && is_steady)
      {
        result.hysteresis =
          find_hysteresis(equations, state, rolling.angular_velocity);
        result.mismatch -= Hysteresis::power(result.hysteresis->of_relaxation,
                                             rolling.angular_velocity);
        result.hysteresis_power = Hysteresis::power(result.hysteresis->energy(),
                                                    rolling.angular_velocity);
        const double speed      = motion.velocity.norm();
        result.rolling_resistance =
          (speed > 0 ? result.hysteresis_power / speed
                     : std::numeric_limits<double>::quiet_NaN());
      }
    // the balance, and the cycles of the strains, are those of a shape that
    // does not change
    if (!is_steady)
      for (double *power : {&result.friction_power,
                            &result.normal_power,
                            &result.sliding_power,
                            &result.release_power,
                            &result.mismatch,
                            &result.hysteresis_power,
                            &result.rolling_resistance})
        *power = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
} // namespace Biface
