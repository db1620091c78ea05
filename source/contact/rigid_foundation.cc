// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/rigid_foundation.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  RigidFoundation::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Foundation",
               shape,
               {"plane", "drum", "sphere"},
               "The shape of the rigid foundation: a plane, a drum (a circular "
               "cylinder without end), or a sphere. Contact is that of nodes: "
               "the radius must be several cells.");
    prm.add_parameter("Direction",
                      line.direction,
                      "Direction from the shell toward the foundation, of a "
                      "plane its normal: three components x, y, z, of any "
                      "length but zero. The foundation travels against it, "
                      "and the force on it is counted along it.");
    prm.add_parameter("Point on path",
                      line.point,
                      "A point x, y, z of the line, along 'Direction', on "
                      "which the center of a sphere, or a point of the axis of "
                      "a drum, travels; any will do for a plane. Unit: "
                      "length.");
    prm.enter_subsection("Drum");
    drum.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Sphere");
    sphere.add_parameters(prm);
    prm.leave_subsection();
  }


  void
  RigidFoundation::Parameters::check() const
  {
    // made, it checks its parameters
    RigidFoundation foundation(*this);
  }


  namespace
  {
    std::shared_ptr<const FoundationShape>
    make_shape(const RigidFoundation::Parameters &parameters)
    {
      using Shape = RigidFoundation::Parameters::Shape;

      const FoundationShape::TravelLine &line = parameters.line;
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


  RigidFoundation::RigidFoundation(const Parameters &parameters)
    : RigidFoundation(make_shape(parameters))
  {}
} // namespace Biface
