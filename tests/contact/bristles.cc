// SPDX-License-Identifier: LGPL-2.1-or-later

// Bristles on a rigid belt under a parabolic pressure have the forces and the
// aligning moment of Pacejka's brush model, with an error of second order.
// Their derivatives are those of differences, on a plane and on a drum.

#include <cmath>
#include <iomanip>

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
                   k_t = 0.075, k_n = 0.3;

  ContactCondition
  condition()
  {
    ContactCondition::Parameters parameters;
    parameters.penalty_stiffness = k_n;
    return ContactCondition(parameters, 1);
  }


  struct Forces
  {
    double longitudinal = 0, lateral = 0, moment = 0;
  };


  /** The forces over mu times the normal force, and the moment over that times
   * the half length.
   * @param z the deflection at the trailing edge over that of full sliding,
   * times its direction. */
  Forces
  brush(const unsigned int n_cells,
        const double       z_longitudinal,
        const double       z_lateral)
  {
    const FrictionLaw law(FrictionCoefficient("mu", std::to_string(mu)), k_t);
    const ContactCondition contact = condition();
    const double           h       = 2 * half_length / n_cells;
    // of the slip: Pacejka's theta
    const double theta = k_t * half_length / (2 * mu * p_0);

    std::vector<BristleLaw::Station> line;
    // nodes do not meet the edges
    for (double x = half_length + 1.37 * h; x > -half_length - h; x -= h)
      {
        const double        p = p_0 * (1 - std::pow(x / half_length, 2));
        BristleLaw::Station station;
        station.touches           = p > 0;
        station.x                 = Point<3>(0, 0, x);
        station.at_body.clearance = -p / k_n;
        station.at_body.normal    = Tensor<1, 3>({1, 0, 0});
        station.tangents = {{Tensor<1, 3>({0, 0, 1}), Tensor<1, 3>({0, 1, 0})}};
        station.angle    = h / radius;
        line.push_back(station);
      }
    Rolling rolling;
    rolling.angular_velocity = 7;
    const double speed       = radius * rolling.angular_velocity;
    // without slip the ground moves with the belt
    rolling.ground.velocity = Tensor<1, 3>(
      {0, -z_lateral / theta * speed, -speed - z_longitudinal / theta * speed});

    Forces       forces;
    const auto   bristles = BristleLaw(law, contact).deflections(line, rolling);
    const double scale    = mu * p_0 * 4 * half_length / 3;
    for (unsigned int j = 0; j < line.size(); ++j)
      {
        const Tensor<1, 2> e = bristles[j].deflection;
        forces.longitudinal += h * k_t * e[0] / scale;
        forces.lateral += h * k_t * e[1] / scale;
        forces.moment += h * k_t * e[1] * line[j].x[2] / scale / half_length;
      }
    return forces;
  }


  void
  test_brush(const double z_longitudinal, const double z_lateral)
  {
    const double z     = std::hypot(z_longitudinal, z_lateral);
    const double force = 3 * z - 3 * z * z + z * z * z;
    const double trail = std::pow(1 - z, 3) / (3 - 3 * z + z * z);
    const Forces exact{force * z_longitudinal / z,
                       force * z_lateral / z,
                       -force * z_lateral / z * trail};
    const auto   error = [&](const unsigned int n) {
      const Forces f = brush(n, z_longitudinal, z_lateral);
      return std::max({std::abs(f.longitudinal - exact.longitudinal),
                       std::abs(f.lateral - exact.lateral),
                       std::abs(f.moment - exact.moment)});
    };
    std::cout << "z = " << z_longitudinal << ", " << z_lateral << ", force "
              << std::fixed << std::setprecision(3) << force
              << std::defaultfloat << std::setprecision(6) << std::endl;
    check_small("  error on 40 cells", error(40), 2e-4);
    // single errors depend on how the end of sticking lies between nodes
    double coarse = 0, fine = 0;
    for (unsigned int n = 20; n < 30; ++n)
      {
        coarse += error(n);
        fine += error(8 * n);
      }
    check_range("  order", std::log(coarse / fine) / std::log(8.), 1.85, 2.3);
  }


  void
  test_derivatives(const std::string  &name,
                   const RigidBody    &body,
                   const GroundMotion &ground,
                   const double        angular_velocity,
                   const double        side)
  {
    const FrictionLaw      law(FrictionCoefficient("mu", "0.5 + 0.1*p"), k_t);
    const ContactCondition contact = condition();
    const BristleLaw       bristle_law(law, contact);

    std::vector<Point<3>> x;
    for (int j = 0; j < 9; ++j)
      x.emplace_back(0.8 - 0.11 * std::pow(j - 4.3, 2) +
                       0.05 * std::sin(3. * j),
                     side * j + 0.3 * std::cos(2. * j),
                     -8. * (j - 4) + 0.2 * std::sin(5. * j));
    const auto bristles = [&](const std::vector<Point<3>> &x,
                              const double                 omega) {
      std::vector<BristleLaw::Station> line;
      for (const Point<3> &p : x)
        {
          line.push_back(
            BristleLaw::station(body, p, body.clearance(p) < 0, 8. / radius));
        }
      Rolling rolling;
      rolling.angular_velocity = omega;
      rolling.ground           = ground;
      return bristle_law.deflections(line, rolling);
    };

    const auto   given = bristles(x, angular_velocity);
    const double step  = 1e-6;
    double       error = 0, scale = 0;
    unsigned int n_touching = 0, n_slipping = 0;
    for (const auto &bristle : given)
      {
        n_touching += bristle.per_position.size() > 1;
        n_slipping += bristle.slips();
      }
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
              {
                const double difference =
                  (above[j].deflection[c] - below[j].deflection[c]) /
                  (2 * step);
                const int    place = static_cast<int>(i - given[j].first);
                const double exact = (i >= given[j].first && i <= j &&
                                          given[j].per_position.size() > 1
                                        ? given[j].per_position[place][c][k]
                                        : 0.);
                error = std::max(error, std::abs(exact - difference));
                scale = std::max(scale, std::abs(exact));
              }
        }
    const double relative = 1e-5;
    const double by    = relative * std::max(1e-3, std::abs(angular_velocity));
    const auto   above = bristles(x, angular_velocity + by),
               below   = bristles(x, angular_velocity - by);
    double error_of_speed = 0, scale_of_speed = 0;
    for (unsigned int j = 0; j < x.size(); ++j)
      for (unsigned int c = 0; c < 2; ++c)
        {
          const double difference =
            (above[j].deflection[c] - below[j].deflection[c]) / (2 * by);
          error_of_speed =
            std::max(error_of_speed,
                     std::abs(given[j].per_angular_velocity[c] - difference));
          scale_of_speed = std::max(scale_of_speed, std::abs(difference));
        }
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
  for (const double z : {0.2, 0.5, 0.8})
    test_brush(0, z);
  test_brush(0.3, 0);
  test_brush(0.3, -0.4);

  const BodyShape::TravelLine line;
  const RigidBody             plane(std::make_shared<const RigidPlane>(line));
  RigidDrum::Parameters       drum_parameters;
  drum_parameters.axis   = Tensor<1, 3>({0.05, 1, 0.1});
  drum_parameters.radius = 850;
  const RigidBody drum(
    std::make_shared<const RigidDrum>(line, drum_parameters));
  const double speed = radius * 7;

  for (const RigidBody *body : {&plane, &drum})
    {
      const auto motion = [&](const double forward, const double aside) {
        GroundMotion result{};
        if (body == &plane)
          result.velocity = Tensor<1, 3>({0, 0, -speed * forward});
        else
          {
            // about its axis, from the point where it touches
            result.spin = speed * forward / 850 * drum.cylinder()->axis;
            result.velocity =
              cross_product_3d(result.spin, Tensor<1, 3>({-850, 0, 0}));
          }
        result.velocity[1] += speed * aside;
        return result;
      };
      const std::string name = (body == &plane ? "plane" : "drum");
      test_derivatives(
        name + ", a little slip", *body, motion(1.004, 0.02), 7, 0.1);
      test_derivatives(
        name + ", backward", *body, motion(-1.004, 0.02), -7, 0.1);
      test_derivatives(name + ", sliding", *body, motion(1.2, 0.2), 7, 0.1);
      test_derivatives(
        name + ", nearly locked", *body, motion(1, 0.2), 1e-4, 0.1);
    }
}
