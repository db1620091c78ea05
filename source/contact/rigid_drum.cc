// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/rigid_drum.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  RigidDrum::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Radius",
                      radius,
                      "Radius of the drum; negative for a hollow one, which "
                      "the shell presses on from within. Not 0. Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Axis",
                      axis,
                      "Direction of the drum's axis: three components x, y, z, "
                      "of any length but zero, not along 'Direction'.");
  }


  RigidDrum::RigidDrum(const Path &path, const Parameters &parameters)
    : RigidFoundation(path)
    , axis(unit_vector("Contact/Drum/Axis", parameters.axis))
    , section({direction - (direction * axis) * axis, point}, parameters.radius)
  {
    check_not_zero("Contact/Drum/Radius", parameters.radius);
    check_not_parallel(
      "Contact/Drum/Axis", parameters.axis, "Direction", direction);
  }


  FoundationPoint
  RigidDrum::evaluate(const Point<3> &x) const
  {
    FoundationPoint result = section.evaluate(x - (axis * (x - point)) * axis);
    SymmetricTensor<2, 3> &G = result.normal_gradient;
    G -= (axis * (G * axis)) * symmetrize(outer_product(axis, axis));
    return result;
  }


  double
  RigidDrum::travel_to(const Point<3> &x) const
  {
    return section.travel_to(x - (axis * (x - point)) * axis) /
           (section.direction * direction);
  }
} // namespace Biface
