// SPDX-License-Identifier: LGPL-2.1-or-later

// Bristles on a rigid belt follow a step of the slip over the way through the
// footprint, and end as in steady rolling, whatever part of a cell or how many
// turns particles pass in a step. A ground that shifts takes them along as one
// with a velocity. Under a wheel that is locked, or nearly so, they follow the
// ground. Their derivatives are those of differences, on a plane and on a drum.

#include <cmath>
#include <functional>

#include <biface/contact/bristles.h>
#include <biface/contact/contact_condition_parameters.h>
#include <biface/contact/ground_parameters.h>
#include <biface/contact/rolling.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double half_length = 60, radius = 300, p_0 = 0.8, mu = 0.5,
                   k_t = 0.075, k_n = 0.3, omega = 7;

  ContactCondition
  condition()
  {
    ContactCondition::Parameters parameters;
    parameters.penalty_stiffness = k_n;
    return ContactCondition(parameters, 1);
  }


  /** A rigid belt under a parabolic pressure, whose bristles move on. */
  class Belt
  {
  public:
    Belt(const unsigned int n_cells, const double slip)
      : h(2 * half_length / n_cells)
      , law(FrictionCoefficient("mu", std::to_string(mu)), k_t)
      , contact(condition())
    {
      for (double x = half_length + 1.37 * h; x > -half_length - h; x -= h)
        {
          const double        p = p_0 * (1 - std::pow(x / half_length, 2));
          BristleLaw::Station station;
          station.touches           = p > 0;
          station.x                 = Point<3>(0, 0, x);
          station.at_body.clearance = -p / k_n;
          station.at_body.normal    = Tensor<1, 3>({1, 0, 0});
          station.tangents          = {
                     {Tensor<1, 3>({0, 0, 1}), Tensor<1, 3>({0, 1, 0})}};
          station.angle = h / radius;
          line.push_back(station);
          past.push_back(
            {station.x, station.at_body.clearance, Tensor<1, 2>(), {}});
        }
      rolling.angular_velocity = omega;
      rolling.ground.velocity =
        Tensor<1, 3>({0, -slip * radius * omega, -radius * omega});
    }

    /** Move on by a way in cells. */
    void
    advance(const double cells)
    {
      bristles = BristleLaw(law, contact)
                   .deflections_in_time(
                     line, past, cells * h / (radius * omega), rolling);
      for (unsigned int j = 0; j < line.size(); ++j)
        past[j].deflection = bristles[j].deflection;
    }

    double
    force() const
    {
      double sum = 0;
      for (const BristleLaw::Past &station : past)
        sum += h * k_t * station.deflection[1];
      return sum;
    }

    /** The largest difference from steady rolling, and its scale. */
    std::pair<double, double>
    error_of_end() const
    {
      const auto steady  = BristleLaw(law, contact).deflections(line, rolling);
      double     largest = 0, scale = 0;
      for (unsigned int j = 0; j < line.size(); ++j)
        {
          largest = std::max(
            largest, (past[j].deflection - steady[j].deflection).norm());
          scale = std::max(scale, steady[j].deflection.norm());
        }
      return {largest, scale};
    }

    const double                     h;
    FrictionLaw                      law;
    ContactCondition                 contact;
    std::vector<BristleLaw::Station> line;
    std::vector<BristleLaw::Past>    past;
    std::vector<BristleLaw::Bristle> bristles;
    Rolling                          rolling;
  };


  /** The largest error of the force after a step of a small slip, relative to
   * its end. */
  double
  error_of_response(const unsigned int n_cells, const double cells_per_step)
  {
    constexpr double slip = 1e-4;
    Belt             belt(n_cells, slip);
    const double     end   = 2 * k_t * slip * std::pow(half_length, 2);
    double           error = 0;
    for (double way = belt.h * cells_per_step; way < 2 * half_length;
         way += belt.h * cells_per_step)
      {
        belt.advance(cells_per_step);
        // each particle sticks since the step or since it has entered
        const double exact = k_t * slip * way * (2 * half_length - way / 2);
        error = std::max(error, std::abs(belt.force() - exact) / end);
      }
    return error;
  }


  void
  test_derivatives(const std::string  &name,
                   const RigidBody    &body,
                   const GroundMotion &ground,
                   const double        angular_velocity,
                   const double        cells)
  {
    const FrictionLaw      law(FrictionCoefficient("mu", "0.5 + 0.1*p"), k_t);
    const ContactCondition contact = condition();
    const BristleLaw       bristle_law(law, contact);
    const double           angle    = 8. / radius;
    const double           duration = cells * angle / omega;

    std::vector<Point<3>>         x;
    std::vector<BristleLaw::Past> past;
    for (int j = 0; j < 9; ++j)
      {
        const auto place = [j](const double shift) {
          return Point<3>(0.8 - 0.11 * std::pow(j - 4.3 - shift, 2) +
                            0.05 * std::sin(3. * j),
                          0.1 * j + 0.3 * std::cos(2. * j) - shift,
                          -8. * (j - 4) + 0.2 * std::sin(5. * j) + shift);
        };
        x.push_back(place(0));
        const Point<3> before = place(0.4);
        past.push_back({before, body.clearance(before), {}, {}});
        if (past.back().clearance < 0)
          {
            past.back().deflection =
              Tensor<1, 2>({0.3 * std::sin(2. * j), 0.2 * std::cos(1. * j)});
            past.back().shift = Tensor<1, 3>({0.01, 0.02, -0.03});
          }
      }
    const auto bristles = [&](const std::vector<Point<3>> &x,
                              const double                 omega) {
      std::vector<BristleLaw::Station> line;
      for (const Point<3> &p : x)
        line.push_back(
          BristleLaw::station(body, p, body.clearance(p) < 0, angle));
      Rolling rolling;
      rolling.angular_velocity = omega;
      rolling.ground           = ground;
      return bristle_law.deflections_in_time(line, past, duration, rolling);
    };

    const auto   given = bristles(x, angular_velocity);
    const double step  = 1e-6;
    double       error = 0, scale = 0;
    unsigned int n_touching = 0, n_slipping = 0;
    for (const auto &bristle : given)
      {
        n_touching += bristle.deflection.norm() > 0;
        n_slipping += bristle.slips();
      }
    const auto compare = [](const double exact,
                            const double difference,
                            double      &error,
                            double      &scale) {
      error = std::max(error, std::abs(exact - difference));
      scale = std::max(scale, std::abs(difference));
    };
    for (unsigned int i = 0; i < x.size(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        {
          auto plus = x, minus = x;
          plus[i][k] += step;
          minus[i][k] -= step;
          const auto above = bristles(plus, angular_velocity),
                     below = bristles(minus, angular_velocity);
          for (unsigned int j = 0; j < x.size(); ++j)
            for (unsigned int c = 0; c < 2; ++c)
              compare(i <= j ? given[j].per_position[i][c][k] : 0.,
                      (above[j].deflection[c] - below[j].deflection[c]) /
                        (2 * step),
                      error,
                      scale);
        }
    const double by       = 1e-5 * std::max(1e-3, std::abs(angular_velocity));
    const auto   above    = bristles(x, angular_velocity + by),
               below      = bristles(x, angular_velocity - by);
    double error_of_speed = 0, scale_of_speed = 0;
    for (unsigned int j = 0; j < x.size(); ++j)
      for (unsigned int c = 0; c < 2; ++c)
        compare(given[j].per_angular_velocity[c],
                (above[j].deflection[c] - below[j].deflection[c]) / (2 * by),
                error_of_speed,
                scale_of_speed);
    std::cout << name << ": " << n_touching << " touch, " << n_slipping
              << " slip" << std::endl;
    check_small("  derivative by positions", error, 1e-6, scale);
    check_small("  derivative by the angular velocity",
                error_of_speed,
                1e-5,
                scale_of_speed);
  }
} // namespace


int
main()
{
  check_small("response, a cell in a step", error_of_response(40, 1), 0.01);
  check_small("response, three cells", error_of_response(40, 3), 0.01);
  check_small("response, 2.5 cells", error_of_response(40, 2.5), 0.02);
  check_small("response, half a cell", error_of_response(40, 0.5), 0.02);
  check_range("order",
              std::log2(error_of_response(40, 1) / error_of_response(80, 1)),
              0.9,
              2.2);
  for (const double cells : {0.37, 1., 2.4})
    {
      // slides from the middle of the footprint
      Belt belt(40, 0.04);
      for (unsigned int i = 0; i < 400; ++i)
        belt.advance(cells);
      const auto [error, scale] = belt.error_of_end();
      check_small("end of steps of " + std::to_string(cells) + " cells",
                  error,
                  1e-11,
                  scale);
    }

  Belt turns(40, 0.04);
  turns.advance(1e12);
  check_small("end of a step of many turns",
              turns.error_of_end().first,
              1e-11,
              turns.error_of_end().second);
  for (const double cells : {0.37, 1., 2.4})
    {
      Belt moving(40, 0.02), shifted(40, 0);
      for (BristleLaw::Past &station : shifted.past)
        station.shift = Tensor<1, 3>({0, -0.02 * cells * shifted.h, 0});
      for (unsigned int i = 0; i < 20; ++i)
        {
          moving.advance(cells);
          shifted.advance(cells);
        }
      check_small("shift in steps of " + std::to_string(cells) + " cells",
                  moving.force() - shifted.force(),
                  1e-12,
                  moving.force());
    }

  // on a ground that moves by 0.1 mm
  for (const double speed : {0., 1e-10})
    {
      Belt locked(40, 0);
      locked.rolling.angular_velocity = speed;
      locked.rolling.ground.velocity  = Tensor<1, 3>({0, -3, -4});
      locked.bristles =
        BristleLaw(locked.law, locked.contact)
          .deflections_in_time(locked.line, locked.past, 0.02, locked.rolling);
      for (const unsigned int j : {2u, 20u})
        check_small(
          (speed == 0 ? "locked, station " : "nearly locked, station ") +
            std::to_string(j),
          (locked.bristles[j].deflection - Tensor<1, 2>({0.08, 0.06})).norm(),
          1e-8);
    }

  const BodyShape::TravelLine line;
  const RigidBody             plane(std::make_shared<const RigidPlane>(line));
  RigidDrum::Parameters       drum_parameters;
  drum_parameters.axis   = Tensor<1, 3>({0.05, 1, 0.1});
  drum_parameters.radius = 850;
  const RigidBody drum(
    std::make_shared<const RigidDrum>(line, drum_parameters));
  for (const RigidBody *body : {&plane, &drum})
    for (const double cells : {0.6, 1., 2.5})
      for (const double forward : {1.004, -1.004, 1.2})
        {
          const double speed = radius * omega;
          GroundMotion motion{};
          if (body == &plane)
            motion.velocity = Tensor<1, 3>({0, 0, -speed * forward});
          else
            {
              motion.spin = speed * forward / 850 * drum.cylinder()->axis;
              motion.velocity =
                cross_product_3d(motion.spin, Tensor<1, 3>({-850, 0, 0}));
            }
          motion.velocity[1] += 0.02 * speed;
          test_derivatives((body == &plane ? "plane, " : "drum, ") +
                             std::to_string(cells) + " cells, " +
                             std::to_string(forward),
                           *body,
                           motion,
                           forward > 0 ? omega : -omega,
                           cells);
        }
}
