// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/physics/transformations.h>

#include <cmath>

#include <biface/contact/body_motion.h>
#include <biface/contact/ground_parameters.h>
#include <biface/contact/rigid_body.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  GroundParameters::add_parameters(EntryDeclarations &prm)
  {
    add_choice(prm,
               "Foundation",
               shape,
               {"plane", "drum", "sphere"},
               "The shape of the ground, the rigid body on which the shell "
               "is pressed and which entries and tables call "
               "'foundation': a plane, a drum (an infinitely long "
               "circular cylinder), or a sphere. By "
               "default only nodes make contact, so the radius must be several "
               "times the cell size.");
    prm.add_parameter("Direction",
                      line.direction,
                      "Direction from the shell toward the ground, for a "
                      "plane its normal: components x, y, z of any nonzero "
                      "vector. The ground travels against it, and the "
                      "reported force is the component along it.",
                      Unit::none());
    prm.add_parameter("Point on path",
                      line.point,
                      "A point x, y, z of the line along which the center of "
                      "a sphere or the axis of a drum travels, parallel to "
                      "'Direction'; without effect for a plane.",
                      Unit("length"));
    prm.enter_subsection("Drum");
    drum.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Sphere");
    sphere.add_parameters(prm);
    prm.leave_subsection();
  }


  void
  GroundParameters::check() const
  {
    // the constructor checks its parameters
    RigidBody ground(*this);
  }


  namespace
  {
    std::shared_ptr<const BodyShape>
    make_shape(const RigidBody::Parameters &parameters)
    {
      using Shape = RigidBody::Parameters::Shape;

      const BodyShape::TravelLine &line = parameters.line;
      unit_vector("Contact/Direction", line.direction);
      check_finite("Contact/Point on path", line.point);
      switch (parameters.shape)
        {
          case Shape::plane:
            return std::make_shared<RigidPlane>(line);
          case Shape::drum:
            return std::make_shared<RigidDrum>(line, parameters.drum);
          case Shape::sphere:
            return std::make_shared<RigidSphere>(line, parameters.sphere);
        }
      Assert(false, ExcInternalError());
      return {};
    }
  } // namespace


  RigidBody::RigidBody(const Parameters &parameters)
    : RigidBody(make_shape(parameters))
  {}


  double
  RigidBody::Screw::rate(
    const double                                     travel,
    const std::function<double(const unsigned int)> &rate_of) const
  {
    return factor == BodyMotion::travel_of_ground ? travel : rate_of(factor);
  }


  RigidBody
  RigidBody::displaced(const Tensor<1, 3>                &slide,
                       const double                       turn,
                       const Point<3>                    &pivot,
                       const std::optional<Tensor<1, 3>> &about) const
  {
    if (turn == 0 && slide.norm() == 0)
      return *this;
    return after({slide,
                  Physics::Transformations::Rotations::rotation_matrix_3d(
                    Point<3>(about.value_or(shape->direction)), turn),
                  pivot});
  }


  RigidBody
  RigidBody::rotated(const Tensor<1, 3> &axis, const double angle) const
  {
    if (angle == 0)
      return *this;
    return after({{},
                  Physics::Transformations::Rotations::rotation_matrix_3d(
                    Point<3>(axis), angle),
                  {}});
  }


  RigidBody
  RigidBody::after_motions(
    const std::vector<BodyMotion>                   &motions,
    const std::function<double(const unsigned int)> &factor_of,
    const Tensor<1, 3>                              &axis,
    const Point<3>                                  &on_axis) const
  {
    Tensor<1, 3>              slide;
    Tensor<2, 3>              rotation = unit_symmetric_tensor<3>();
    std::vector<Tensor<1, 3>> spins;
    for (const BodyMotion &motion : motions)
      {
        const double       factor = factor_of(motion.factor);
        const Tensor<1, 3> about =
          motion.axis ? *motion.axis / motion.axis->norm() : axis;
        const Tensor<2, 3> turned =
          Physics::Transformations::Rotations::rotation_matrix_3d(
            Point<3>(about), factor * motion.turn);
        slide += factor * motion.translation;
        // a turn in the list carries along the axes of those before it
        for (Tensor<1, 3> &spin : spins)
          spin = turned * spin;
        spins.push_back(motion.turn * about);
        rotation = turned * rotation;
      }
    RigidBody result = after({slide, rotation, on_axis});
    for (unsigned int i = 0; i < motions.size(); ++i)
      result.screws.push_back(
        {motions[i].factor, motions[i].translation, spins[i], on_axis + slide});
    return result;
  }


  Tensor<1, 3>
  RigidBody::velocity(
    const Point<3>                                  &x,
    const double                                     travel,
    const std::function<double(const unsigned int)> &rate_of) const
  {
    // the ground travels against its direction, toward the shell
    Tensor<1, 3> result = (travels ? -travel * direction() : Tensor<1, 3>());
    for (const Screw &screw : screws)
      result +=
        screw.rate(travel, rate_of) *
        (screw.translation + cross_product_3d(screw.spin, x - screw.point));
    return result;
  }


  Tensor<1, 3>
  RigidBody::change_of_velocity(
    const Point<3>                                  &x,
    const double                                     travel,
    const std::function<double(const unsigned int)> &rate_of,
    const double                                     other_travel,
    const std::function<double(const unsigned int)> &other_rate_of) const
  {
    Tensor<1, 3> result;
    for (unsigned int i = 0; i < screws.size(); ++i)
      for (unsigned int j = 0; j < screws.size(); ++j)
        {
          // section 6 of doc/theory.md: at a fixed point the velocity changes
          // as the axis moves, and as later motions in the list turn it
          const Screw &screw = screws[i], &other = screws[j];
          const double rates = screw.rate(travel, rate_of) *
                               other.rate(other_travel, other_rate_of);
          const Tensor<1, 3> of_axis =
            other.translation +
            cross_product_3d(other.spin, screw.point - other.point);
          result -= rates * cross_product_3d(screw.spin, of_axis);
          if (j > i)
            result +=
              rates * cross_product_3d(cross_product_3d(other.spin, screw.spin),
                                       x - screw.point);
        }
    return result;
  }


  Tensor<1, 3>
  RigidBody::rotation_vector() const
  {
    if (!displacement)
      return {};
    const Tensor<2, 3> &R = displacement->rotation;
    // twice the sine and the cosine
    const Tensor<1, 3> axis(
      {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]});
    const double cosine = trace(R) - 1, sine = axis.norm();
    const double angle = std::atan2(sine, cosine);
    if (sine > 1e-6)
      return angle / sine * axis;
    if (cosine > 0)
      return axis / 2;
    // half a turn: the symmetric part has the axis
    Tensor<1, 3> along;
    for (unsigned int i = 0; i < 3; ++i)
      {
        Tensor<1, 3> column;
        for (unsigned int j = 0; j < 3; ++j)
          column[j] = R[j][i] + (i == j ? 1. : 0.);
        if (column.norm() > along.norm())
          along = column;
      }
    return angle / along.norm() * along;
  }


  Tensor<1, 3>
  RigidBody::angular_velocity(
    const double                                     travel,
    const std::function<double(const unsigned int)> &rate_of) const
  {
    Tensor<1, 3> result;
    for (const Screw &screw : screws)
      result += screw.rate(travel, rate_of) * screw.spin;
    return result;
  }


  RigidBody
  RigidBody::after(Displacement further) const
  {
    RigidBody result = *this;
    // the rates of the motions belong to the body and turn along with it
    for (Screw &screw : result.screws)
      {
        screw.translation = further.rotation * screw.translation;
        screw.spin        = further.rotation * screw.spin;
        screw.point       = further.pivot + further.slide +
                      further.rotation * (screw.point - further.pivot);
      }
    if (displacement)
      {
        // from the pivot of the first motion
        const Tensor<1, 3> arm = displacement->pivot - further.pivot;
        further.slide += further.rotation * (arm + displacement->slide) - arm;
        further.rotation = further.rotation * displacement->rotation;
        further.pivot    = displacement->pivot;
      }
    result.displacement = further;
    return result;
  }


  std::optional<BodyShape::Cylinder>
  RigidBody::cylinder() const
  {
    auto result = shape->cylinder();
    if (result && displacement)
      result->axis = displacement->rotation * result->axis;
    return result;
  }


  Point<3>
  RigidBody::back(const Point<3> &x) const
  {
    if (!displacement)
      return x;
    const Displacement &d = *displacement;
    return d.pivot + transpose(d.rotation) * (x - d.slide - d.pivot);
  }


  Point<3>
  RigidBody::present(const Point<3> &at_rest) const
  {
    // the travel first, then slide and turn, as x(X) in section 6 of
    // doc/theory.md
    const Point<3> x = at_rest - travel * shape->direction;
    if (!displacement)
      return x;
    const Displacement &d = *displacement;
    return d.pivot + d.slide + d.rotation * (x - d.pivot);
  }


  BodyPoint
  RigidBody::evaluate(const Point<3> &x) const
  {
    // shapes know the body at rest only; a tread of springs touches where the
    // carcass is at the height of the tread
    BodyPoint at = shape->evaluate(at_rest(x));
    at.clearance -= distance;
    if (displacement)
      {
        const Tensor<2, 3> &R = displacement->rotation;
        at.normal             = R * at.normal;
        at.normal_gradient =
          symmetrize(R * Tensor<2, 3>(at.normal_gradient) * transpose(R));
      }
    return at;
  }


  std::array<Tensor<1, 3>, 2>
  RigidBody::tangents_of_direction() const
  {
    // the axis farthest from the direction has the longest part across it, by
    // which can safely be divided
    const Tensor<1, 3> &d        = shape->direction;
    unsigned int        farthest = 0;
    for (unsigned int i = 1; i < 3; ++i)
      if (std::abs(d[i]) < std::abs(d[farthest]))
        farthest = i;
    Tensor<1, 3> first = -d[farthest] * d;
    first[farthest] += 1;
    first /= first.norm();
    std::array<Tensor<1, 3>, 2> result{{first, cross_product_3d(d, first)}};
    if (displacement)
      for (Tensor<1, 3> &t : result)
        t = displacement->rotation * t;
    return result;
  }


  std::pair<Tensor<1, 3>, std::array<Tensor<1, 3>, 2>>
  RigidBody::reference_of_tangents(const Tensor<1, 3> &normal) const
  {
    Tensor<1, 3> start    = direction();
    auto         tangents = tangents_of_direction();
    // the shortest rotation is not unique if the normal is opposite
    if (normal * start < -0.5)
      {
        start *= -1;
        tangents[1] *= -1;
      }
    return {start, tangents};
  }


  std::array<Tensor<1, 3>, 2>
  RigidBody::tangents(const Tensor<1, 3> &normal) const
  {
    auto [start, result] = reference_of_tangents(normal);
    // the shortest rotation from the start to the normal
    for (Tensor<1, 3> &t : result)
      t -= (normal * t) / (1 + normal * start) * (normal + start);
    return result;
  }


  std::array<Tensor<2, 3>, 2>
  RigidBody::tangent_derivatives(const Tensor<1, 3> &normal) const
  {
    // the derivative of the rotated tangent t - n.t/(1 + n.s) (n + s) by the
    // normal n, with the start s
    const auto [start, tangents]    = reference_of_tangents(normal);
    const double                sum = 1 + normal * start;
    std::array<Tensor<2, 3>, 2> result;
    for (unsigned int i = 0; i < 2; ++i)
      {
        const double part = normal * tangents[i] / sum;
        result[i] =
          -outer_product(normal + start, (tangents[i] - part * start) / sum) -
          part * Tensor<2, 3>(unit_symmetric_tensor<3>());
      }
    return result;
  }
} // namespace Biface
