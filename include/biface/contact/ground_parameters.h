// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_ground_parameters_h
#define biface_contact_ground_parameters_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

namespace Biface
{
  class EntryDeclarations;


  /** The line along which a ground travels. */
  struct TravelLine
  {
    /** The direction from the shell toward the ground, which travels
     * against it; any nonzero vector. */
    dealii::Tensor<1, 3> direction{{1, 0, 0}};
    dealii::Point<3>     point;
  };


  /** The parameters of RigidSphere. */
  struct SphereParameters
  {
    /** The radius; it must be set if the ground is a sphere. */
    std::optional<double> radius;

    void
    add_parameters(EntryDeclarations &prm);
  };


  /** The parameters of RigidDrum. */
  struct DrumParameters
  {
    /** The radius; it must be set if the ground is a drum. */
    std::optional<double> radius;
    dealii::Tensor<1, 3>  axis{{0, 1, 0}};

    void
    add_parameters(EntryDeclarations &prm);
  };


  /** The ground on which the shell is pressed. */
  struct GroundParameters
  {
    enum class Shape
    {
      plane,
      drum,
      sphere
    };

    Shape            shape = Shape::plane;
    TravelLine       line;
    DrumParameters   drum;
    SphereParameters sphere;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check() const;
  };
} // namespace Biface

#endif
