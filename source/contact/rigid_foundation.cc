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
               "The shape of the rigid foundation: a plane, a drum (an "
               "infinitely long circular cylinder), or a sphere. Only nodes "
               "make contact, so the radius must be several times the cell "
               "size.");
    prm.add_parameter("Direction",
                      line.direction,
                      "Direction from the shell toward the foundation, for a "
                      "plane its normal: components x, y, z of any nonzero "
                      "vector. The foundation travels against it, and the "
                      "reported force is the component along it.");
    prm.add_parameter("Point on path",
                      line.point,
                      "A point x, y, z of the line along which the center of "
                      "a sphere or the axis of a drum travels, parallel to "
                      "'Direction'; without effect for a plane. Unit: length.");
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
    // the constructor checks its parameters
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
