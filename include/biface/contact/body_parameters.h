// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_body_parameters_h
#define biface_contact_body_parameters_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/contact/body_motion.h>
#include <biface/contact/body_section.h>
#include <biface/contact/friction_coefficient.h>
#include <biface/contact/suspension_parameters.h>

namespace Biface
{
  class EntryDeclarations;
  class RigidBody;


  /** A rigid body beside the ground: an obstacle on it, a rim, a piston. */
  struct BodyParameters
  {
    enum class Shape
    {
      /** A half-space bounded by a plane. */
      plane,
      sphere,
      /** An infinitely long cylinder. */
      cylinder,
      torus,
      cone,
      /** A quarter of the space with a rounded edge. */
      step,
      /** A polygon extruded along an axis. */
      extruded,
      /** A polygon revolved about an axis. */
      revolved,
      /** The body below heights over a grid, see HeightField. */
      height_field,
      /** The body where a formula is negative, see FormulaSurface. */
      formula
    };

    std::string          name;
    Shape                shape = Shape::plane;
    dealii::Point<3>     point;
    dealii::Tensor<1, 3> direction{{1, 0, 0}};
    dealii::Tensor<1, 3> axis{{0, 1, 0}};
    /** The radius of a sphere, cylinder or torus, and that of the tube of a
     * torus. Unit: length. */
    std::optional<double> radius, tube_radius;
    /** The angle between the axis and the surface of a cone. Unit: degrees. */
    std::optional<double> half_angle;
    /** The radius of the edge of a step and of the tip of a cone. Unit:
     * length. */
    double                              edge_radius = 0;
    std::vector<RoundedPolygon::Corner> profile;
    /** The name of a file of the corners of the profile, in place of the entry;
     * empty for none. */
    std::string profile_file;
    /** The name of a file of the points of a height field; empty for none. */
    std::string height_file;
    /** The points of a height field as (across, along the axis, up). Unit:
     * length. */
    std::vector<dealii::Point<3>> heights;
    /** The formula of the surface, which is negative in the body. */
    std::string formula;
    /** The length over which the formula is smooth. Unit: length. */
    std::optional<double> size;

    /** Whether the body touches the inner face. */
    bool touches_inner_face = false;
    /** Whether the body moves with the ground. */
    bool on_ground = false;

    /** Whether the body touches the tread, as the ground does, and not the
     * shell itself, as a rim does. */
    bool
    touches_tread() const
    {
      return on_ground && !touches_inner_face;
    }

    /** The coefficient of friction; it must not depend on the slip velocity. */
    FrictionCoefficient friction;

    std::vector<BodyMotion> motions;
    /** What resists the motions, by their names. */
    SuspensionParameters suspensions;

    void
    add_parameters(EntryDeclarations &prm);

    /** Read the file of the profile or of heights, if there is one. Must be
     * called on all ranks. Throws InputError if it cannot be read. */
    void
    read_files(const MPI_Comm communicator);

    /** Throws InputError if a value is invalid. */
    void
    check() const;

    /** Whether the body remains one of revolution about the y axis in all its
     * motions, and holds nothing sideways: under a wheel with this axle it is
     * the same at any angle. */
    bool
    is_about_y_axis() const;

    /** The body at rest. Throws InputError if a value is invalid. */
    RigidBody
    make() const;
  };
} // namespace Biface

#endif
