// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_component_h
#define biface_model_mesh_component_h

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

#include <biface/surface/surface_point.h>

namespace Biface
{
  class ReferenceSurface;

  /** A component of a displacement: in the frame of the node, Cartesian, or
   * about the axis of a surface of revolution. All directions are those of the
   * undeformed shell. */
  enum class Component
  {
    v_1,
    v_2,
    v_3,
    x,
    y,
    z,
    radial,
    axial,
    circumferential
  };

  /** The names of the components in parameter files, in the order of
   * Component. */
  const std::vector<std::string> &
  component_names();

  /** The unit vector of a component at a point of the surface, in the frame of
   * the point. */
  dealii::Tensor<1, 3>
  direction(const Component             component,
            const SurfacePoint         &point,
            const dealii::Tensor<1, 3> &axis);

  /** Throw an InputError that names @p entry if the component refers to an
   * axis, and the surface has none. */
  void
  check_component(const std::string      &entry,
                  const Component         component,
                  const ReferenceSurface &surface);
} // namespace Biface

#endif
