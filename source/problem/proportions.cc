// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/contact/contact_condition.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/proportions.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** In a shell thinner than this, bending is lost beside stretching, as the
     * square of a ratio is beside 1. */
    void
    check_thickness(const ShellMesh &mesh)
    {
      constexpr double least = 1e-8;
      if (mesh.thickness() < least * mesh.size())
        throw InputError(
          "the plies of 'Laminate/Plies' are at most " +
          number_to_string(mesh.thickness()) + " thick, but the shell is " +
          number_to_string(mesh.size()) +
          " large: a shell thinner than 1e-8 of its size cannot be computed.");
    }


    /** A contact much stiffer than the wall leaves nothing of its forces. */
    void
    check_penalty_stiffness(const Parameters &parameters, const ShellMesh &mesh)
    {
      constexpr double most = 1e9;
      const double     automatic =
        ContactCondition({}, mesh.wall_stiffness()).penalty_stiffness();
      const auto check = [&](const std::string           &section,
                             const std::optional<double> &stiffness) {
        if (stiffness.value_or(0) > most * automatic)
          throw InputError(section + "/Regularization",
                           number_to_string(*stiffness),
                           "it must be at most 1e9 times the value of "
                           "'automatic', which is " +
                             number_to_string(automatic) +
                             ": beyond it, round-off decides");
      };
      check("Contact", parameters.contact.condition.penalty_stiffness);
      for (unsigned int i = 0; i < parameters.stages.size(); ++i)
        check("Stage " + std::to_string(i + 1),
              parameters.stages[i].laws.penalty_stiffness);
    }


    double
    shortest_side_of_cells(const ShellMesh &mesh)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const Cell &cell : mesh.wall_elements())
        for (const unsigned int side : GeometryInfo<2>::face_indices())
          {
            const auto end = [&](const unsigned int i) {
              return mesh
                .nodes[cell.nodes[GeometryInfo<2>::face_to_cell_vertices(side,
                                                                         i)]]
                .surface.position;
            };
            shortest = std::min(shortest, end(0).distance(end(1)));
          }
      return Utilities::MPI::min(shortest, mesh.communicator);
    }


    /** Between two points in contact, a smaller body passes through the shell.
     * @param entry of the radius.
     * @param distance of the shell from the body. */
    void
    check_radius(const std::string       &entry,
                 const double             radius,
                 const double             distance,
                 const ContactParameters &contact,
                 const ShellMesh         &mesh)
    {
      // points in cells divide the sides
      const unsigned int k  = contact.condition.points_per_side;
      const double shortest = shortest_side_of_cells(mesh) / std::max(1U, k);
      if (std::abs(radius) + distance < shortest)
        throw InputError(
          entry,
          number_to_string(radius),
          k > 0 ? "it must not be shorter than the distance of the points in "
                  "contact, which is at least " +
                    number_to_string(shortest)
                : "it must not be shorter than the sides of all cells, "
                  "the shortest of which is " +
                    number_to_string(shortest) +
                    " long: only nodes make contact, unless there are "
                    "'Points in cells'");
    }


    void
    check_ground(const ContactParameters &contact, const ShellMesh &mesh)
    {
      using Shape                    = GroundParameters::Shape;
      const GroundParameters &ground = contact.body;
      if (ground.shape == Shape::plane)
        return;
      const bool is_drum = (ground.shape == Shape::drum);
      check_radius(is_drum ? "Contact/Drum/Radius" : "Contact/Sphere/Radius",
                   *(is_drum ? ground.drum.radius : ground.sphere.radius),
                   0,
                   contact,
                   mesh);
    }


    void
    check_body(const BodyParameters    &body,
               const ContactParameters &contact,
               const ShellMesh         &mesh)
    {
      using Shape = BodyParameters::Shape;
      const double distance =
        (body.touches_tread() ? contact.tread.height.value_or(0) : 0);
      const std::string section = "Body " + body.name + "/";
      if (body.shape == Shape::sphere || body.shape == Shape::cylinder)
        check_radius(section + "Radius", *body.radius, distance, contact, mesh);
      if (body.shape == Shape::torus)
        check_radius(
          section + "Tube radius", *body.tube_radius, distance, contact, mesh);
    }


    /** The largest displacement that supports prescribe at any load factor. */
    double
    largest_prescribed(const std::vector<Stage> &stages, const ShellMesh &mesh)
    {
      double value = 0, factor = 0;
      for (const PrescribedDisplacement &p : mesh.prescribed)
        value = std::max(value, std::abs(p.values).sum());
      for (const Stage &stage : stages)
        for (const std::optional<double> &at_end : stage.factors)
          factor = std::max(factor, std::abs(at_end.value_or(0)));
      return factor * Utilities::MPI::max(value, mesh.communicator);
    }


    /** A supported shell cannot stay in contact for longer than it takes to
     * turn it over. */
    void
    check_travel(const std::vector<Stage> &stages, const ShellMesh &mesh)
    {
      const double longest = 2 * mesh.size() + largest_prescribed(stages, mesh);
      for (unsigned int i = 0; i < stages.size(); ++i)
        if (stages[i].contact && stages[i].travel.value_or(0) > longest)
          throw InputError("Stage " + std::to_string(i + 1) + "/Travel",
                           number_to_string(*stages[i].travel),
                           "it must be at most " + number_to_string(longest) +
                             ": farther on, the ground has passed through "
                             "the shell");
    }


    /** With a critical velocity above all velocities, nothing sticks. */
    void
    check_critical_velocity(const Parameters &parameters, const ShellMesh &mesh)
    {
      double fastest = 0;
      for (const Stage &stage : parameters.stages)
        // no radius is larger than the shell
        fastest = std::max(
          {fastest,
           std::abs(stage.ground_velocity.value_or(0)),
           mesh.size() * std::abs(stage.angular_velocity.value_or(0))});
      const double critical = parameters.contact.friction.critical_velocity;
      if (fastest > 0 && critical > fastest)
        throw InputError("Contact/Critical velocity",
                         number_to_string(critical),
                         "it must be less than the velocities of the wheel, "
                         "which are at most " +
                           number_to_string(fastest));
    }
  } // namespace


  void
  check_proportions(const Parameters &parameters, const ShellMesh &mesh)
  {
    check_thickness(mesh);
    check_penalty_stiffness(parameters, mesh);
    const std::vector<Stage> &stages = parameters.stages;
    for (const BodyParameters &body : parameters.bodies)
      check_body(body, parameters.contact, mesh);
    if (std::none_of(stages.begin(), stages.end(), [](const Stage &stage) {
          return stage.contact;
        }))
      return;
    check_ground(parameters.contact, mesh);
    check_travel(stages, mesh);
    check_critical_velocity(parameters, mesh);
  }
} // namespace Biface
