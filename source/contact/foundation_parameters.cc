// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/foundation_parameters.h>
#include <biface/contact/rigid_plane.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  FoundationParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Foundation",
               type,
               {"plane", "drum", "sphere"},
               "The shape of the rigid foundation: a plane, a drum (a circular "
               "cylinder without end), or a sphere. Contact is that of nodes: "
               "the radius must be several cells.");
    prm.add_parameter("Direction",
                      path.direction,
                      "Direction from the shell toward the foundation, of a "
                      "plane its normal: three components x, y, z, of any "
                      "length but zero. The foundation travels against it, "
                      "and the force on it is counted along it.");
    prm.add_parameter("Point on path",
                      path.point,
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


  std::shared_ptr<const RigidFoundation>
  make_foundation(const FoundationParameters &parameters)
  {
    const RigidFoundation::Path &path = parameters.path;
    unit_vector("Contact/Direction", path.direction);
    check_finite("Contact/Point on path", path.point);
    switch (parameters.type)
      {
        case FoundationParameters::Type::plane:
          return std::make_shared<RigidPlane>(path);
        case FoundationParameters::Type::drum:
          return std::make_shared<RigidDrum>(path, parameters.drum);
        case FoundationParameters::Type::sphere:
          return std::make_shared<RigidSphere>(path, parameters.sphere);
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
