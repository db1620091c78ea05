// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/model/mesh/component.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  const std::vector<std::string> &
  component_names()
  {
    static const std::vector<std::string> names{
      "v_1", "v_2", "v_3", "x", "y", "z", "radial", "axial", "circumferential"};
    return names;
  }


  Tensor<1, 3>
  direction(const Component     component,
            const SurfacePoint &point,
            const Tensor<1, 3> &axis)
  {
    Tensor<1, 3> unit;
    switch (component)
      {
        case Component::v_1:
        case Component::v_2:
        case Component::v_3:
          unit[static_cast<unsigned int>(component)] = 1;
          return unit;
        case Component::x:
        case Component::y:
        case Component::z:
          unit[static_cast<unsigned int>(component) -
               static_cast<unsigned int>(Component::x)] = 1;
          return point.to_frame(unit);
        case Component::axial:
          return point.to_frame(axis);
        case Component::radial:
          // the second coordinate lines run around the axis
          return point.to_frame(cross_product_3d(axis, point.frame[1]));
        case Component::circumferential:
          unit[1] = 1;
          return unit;
      }
    Assert(false, ExcInternalError());
    return unit;
  }


  void
  check_component(const std::string      &entry,
                  const Component         component,
                  const ReferenceSurface &surface)
  {
    if (component >= Component::radial && surface.axis().norm() == 0)
      throw InputError(entry,
                       component_names()[static_cast<unsigned int>(component)],
                       "only a surface of revolution has the components "
                       "radial, axial and circumferential");
  }
} // namespace Biface
