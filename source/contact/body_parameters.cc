// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/contact/body_parameters.h>
#include <biface/contact/body_shapes.h>
#include <biface/contact/formula_surface.h>
#include <biface/contact/friction.h>
#include <biface/contact/ground_parameters.h>
#include <biface/contact/height_field.h>
#include <biface/contact/implicit_body.h>
#include <biface/contact/rigid_body.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/named_numbers.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<RoundedPolygon::Corner>
    parse_profile(const std::string &entry, const std::string &text)
    {
      const std::string form =
        "each corner must be two numbers, or three with its radius";
      std::vector<RoundedPolygon::Corner> corners;
      for (const std::string &item : split_list(entry, text))
        {
          const unsigned int        n = split_words(item).size();
          const std::vector<double> numbers =
            parse_numbers(entry, item, n == 3 ? 3 : 2, form);
          corners.push_back(
            {Point<2>(numbers[0], numbers[1]), n == 3 ? numbers[2] : 0.});
        }
      return corners;
    }


    std::vector<BodyMotion>
    parse_motions(const std::string &entry, const std::string &text)
    {
      const std::string form =
        "each item must have the form 'name: x y z', 'name: x y z turn angle' or "
        "'name: x y z turn angle about x y z'";
      std::vector<BodyMotion> motions;
      for (const auto &[name, motion_text] :
           split_named_list(entry, text, form))
        {
          BodyMotion motion;
          motion.name                          = name;
          const std::vector<std::string> words = split_words(motion_text);
          const unsigned int             n     = words.size();
          if ((n != 3 && n != 5 && n != 9) || (n > 3 && words[3] != "turn") ||
              (n == 9 && words[5] != "about"))
            throw InputError(entry, name + ": " + motion_text, form);
          for (unsigned int i = 0; i < 3; ++i)
            motion.translation[i] = parse_number(entry, words[i], form);
          if (n > 3)
            motion.turn =
              parse_number(entry, words[4], form) * numbers::PI / 180;
          if (n == 9)
            {
              motion.axis = Tensor<1, 3>();
              for (unsigned int i = 0; i < 3; ++i)
                (*motion.axis)[i] = parse_number(entry, words[6 + i], form);
              if (motion.axis->norm() == 0)
                throw InputError(entry,
                                 name + ": " + motion_text,
                                 "the axis must not be the zero vector");
            }
          motions.push_back(motion);
        }
      return motions;
    }


    /** The unit vector orthogonal to an axis that is closest to a direction,
     * or any one if they are parallel. */
    Tensor<1, 3>
    across_axis(const Tensor<1, 3> &direction, const Tensor<1, 3> &axis)
    {
      Tensor<1, 3> across = direction - (direction * axis) * axis;
      for (unsigned int i = 0; i < 3 && across.norm() < 1e-3; ++i)
        {
          across = -axis[i] * axis;
          across[i] += 1;
        }
      return across / across.norm();
    }
  } // namespace


  void
  BodyParameters::add_parameters(EntryDeclarations &prm)
  {
    // the entries of all shapes: make() asks for those that the shape needs;
    // files are only named here, since one rank reads them for all
    add_choice(prm,
               "Shape",
               shape,
               {"plane",
                "sphere",
                "cylinder",
                "torus",
                "cone",
                "step",
                "extruded",
                "revolved",
                "height field",
                "formula"},
               "The shape of the body. 'plane': a half-space, with 'Direction' "
               "into it. 'sphere': 'Point' is its center. 'cylinder': a bar or "
               "a hole, infinitely long. 'torus': a tube with 'Tube radius' "
               "whose center line has the distance 'Radius' from the axis. "
               "'cone': 'Point' is its tip, and it opens along the axis. "
               "'step': a quarter of the space, below 'Point' along "
               "'Direction', and on the side of the cross product of "
               "'Direction' and 'Axis'. 'extruded', 'revolved': the polygon "
               "'Profile' along the axis or about it. 'height field': what "
               "is below the heights of 'Height file'. 'formula': where "
               "'Formula' is negative.");
    prm.add_parameter("Point",
                      point,
                      "A point x, y, z of the axis or of the plane, the edge "
                      "of a step before it is rounded, or the origin of "
                      "'Profile', 'Height file' or 'Formula'.",
                      Unit("length"));
    prm.add_parameter("Direction",
                      direction,
                      "Direction from the shell into the body, for planes, "
                      "steps, extruded profiles and height fields: components "
                      "x, y, z of any nonzero vector.",
                      Unit::none());
    prm.add_parameter("Axis",
                      axis,
                      "Direction of the axis of the other shapes, of extruded "
                      "profiles, of height fields and of the edge of a step, "
                      "and that about which motions turn the body: components "
                      "x, y, z of any nonzero vector; for extruded profiles, "
                      "height fields and steps orthogonal to 'Direction'.",
                      Unit::none());
    add_optional_number(prm,
                        "Radius",
                        radius,
                        "none",
                        "Radius of a sphere or cylinder, negative for a hollow "
                        "one with the shell inside, or of the center line of a "
                        "torus.",
                        Unit("length"));
    add_optional_number(prm,
                        "Tube radius",
                        tube_radius,
                        "none",
                        "Radius of the tube of a torus. A number from 0 to "
                        "'Radius'.",
                        Unit("length"));
    add_optional_number(prm,
                        "Half angle",
                        half_angle,
                        "none",
                        "Angle between the axis and the surface of a cone. A "
                        "number between 0 and 90.",
                        Unit::degrees());
    prm.add_parameter(
      "Edge radius",
      edge_radius,
      "Radius that rounds the edge of a step or the tip of a "
      "cone. It should not be far below the distance of the points "
      "that make contact, nodes or 'Points in cells'.",
      Patterns::Double(),
      Unit("length"));
    add_parsed(prm,
               "Profile",
               "",
               profile,
               parse_profile,
               "Corners of the polygon of an extruded or revolved body, "
               "separated by commas: two coordinates and, if the corner is "
               "rounded, its radius. Extruded: across, along the cross product "
               "of 'Direction' and 'Axis', and the height against 'Direction'. "
               "Revolved: along the axis, and the distance from it. If the "
               "first corner is repeated at the end, the body is inside; else "
               "it is to the right of one who walks along the polygon, which "
               "goes on along its first and last line.",
               Unit("length"));
    add_parsed(prm,
               "Profile file",
               "",
               profile_file,
               parse_file_name,
               "A CSV file with the corners of the profile in place of "
               "'Profile': two coordinates, and a radius in a third column "
               "where the corner is rounded. Relative to the parameter file; "
               "see 'Tables' for names in double quotes.",
               // the contents of the files are compared
               Unit("length") | RestartChange::always);
    add_parsed(prm,
               "Height file",
               "",
               height_file,
               parse_file_name,
               "A CSV file with the points of a height field, in any order: u "
               "across, along the cross product of 'Direction' and 'Axis', v "
               "along 'Axis', and the height against 'Direction', all from "
               "'Point'. The different u and v must form a rectangular grid of "
               "at least 2 by 2 rows, in any distances. The surface is the "
               "bicubic spline through the points; it is level across the "
               "edges of the grid and has the height of the edge beyond. "
               "Relative to the parameter file; see 'Tables' for names in "
               "double quotes.",
               Unit("length") | RestartChange::always);
    prm.add_parameter("Formula",
                      formula,
                      "A smooth function of x, y and z, along the global axes "
                      "from 'Point', that is negative in the body and positive "
                      "outside, such as z - 2*sin(x/30). Its value does not "
                      "matter otherwise.",
                      Patterns::Anything(),
                      Unit::several("x, y, z length"));
    add_optional_number(prm,
                        "Size",
                        size,
                        "none",
                        "The size of the smallest detail of 'Formula', such as "
                        "the smallest radius of its surface: derivatives are "
                        "differences over 1/50 of it, which lose digits if it "
                        "is far smaller. A positive number.",
                        Unit("length"));
    prm.declare_entry("Face",
                      "outer",
                      Patterns::Selection("outer|inner"),
                      "The face of the shell that touches the body.");
    prm.add_action("Face", [this](const std::string &text) {
      touches_inner_face = (text == "inner");
    });
    prm.declare_entry(
      "Moves with",
      "nothing",
      Patterns::Selection("nothing|foundation"),
      "'foundation': the body is an obstacle on the ground of the section "
      "'Contact'. Its place is that while the ground, which moves with it, "
      "is at 'Point on path'; a 'Contact/Tread' lies between both and the "
      "shell. Other bodies touch the shell itself.");
    prm.add_action("Moves with", [this](const std::string &text) {
      on_ground = (text == "foundation");
    });
    add_parsed(prm,
               "Friction",
               "0",
               friction,
               parse_friction,
               "Coefficient of friction between shell and body: a "
               "number, or a formula of the contact pressure p.",
               Unit::none());
    add_parsed(prm,
               "Motions",
               "",
               motions,
               parse_motions,
               "Motions of the body at the factor 1: a comma-separated list "
               "'name: x y z' or 'name: x y z turn angle' of a translation and "
               "of an angle in degrees, right-handed about 'Axis' through "
               "'Point', or about another axis through this point with 'about' "
               "and its components after the angle. The point moves along with "
               "all translations, and an axis with the turns that follow it in "
               "the list. Their factors "
               "are those of 'Load factors' of the stages, by the names "
               "'bodies', 'bodies NAME' or 'bodies NAME name', or 'Load "
               "factor'; or 'Forces on bodies' find them.",
               Unit("length"));
    suspensions.add_parameters(prm, "the names of 'Motions'");
  }


  void
  BodyParameters::read_files(const MPI_Comm communicator)
  {
    if (!height_file.empty())
      for (const auto &row :
           parse_rows(read_file(height_file, communicator),
                      height_file,
                      "each line must contain three numbers, 'u, v, height'",
                      3,
                      3,
                      {"u", "v", "height"}))
        heights.emplace_back(row[0], row[1], row[2]);
    if (profile_file.empty())
      return;
    if (!profile.empty())
      throw InputError("Body " + name + "/Profile file",
                       profile_file,
                       "the corners are given by 'Profile' already");
    for (const auto &row :
         parse_rows(read_file(profile_file, communicator),
                    profile_file,
                    "each line must contain two coordinates and, if the "
                    "corner is rounded, its radius",
                    2,
                    3))
      profile.push_back(
        {Point<2>(row[0], row[1]), row.size() == 3 ? row[2] : 0.});
  }


  void
  BodyParameters::check() const
  {
    make();
    suspensions.check(
      "Body " + name,
      [this](const std::string &motion) {
        return std::any_of(
          motions.begin(), motions.end(), [&](const BodyMotion &item) {
            return item.name == motion;
          });
      },
      "it must be one of 'Motions'");
    if (friction.depends_on_speed())
      throw InputError(
        "Body " + name + "/Friction",
        friction.get_text(),
        "bodies have no steady rolling, and so no slip velocity s");
  }


  bool
  BodyParameters::is_about_y_axis() const
  {
    const auto is_along_y = [](const Tensor<1, 3> &v) {
      return v[0] == 0 && v[2] == 0;
    };
    const bool centered    = is_along_y(point) && is_along_y(axis);
    const bool moves_along = std::all_of(
      motions.begin(), motions.end(), [&](const BodyMotion &motion) {
        return is_along_y(motion.translation) &&
               (motion.turn == 0 || is_along_y(motion.axis.value_or(axis)));
      });
    if (on_ground || !moves_along || !friction.is_zero())
      return false;
    switch (shape)
      {
        case Shape::plane:
          return is_along_y(direction);
        case Shape::sphere:
          return is_along_y(point);
        case Shape::cylinder:
        case Shape::torus:
        case Shape::cone:
        case Shape::revolved:
          return centered;
        // the others have no axis, or none that is known
        default:
          return false;
      }
  }


  RigidBody
  BodyParameters::make() const
  {
    const std::string section = "Body " + name + "/";
    const std::string profile_entry =
      section + (profile_file.empty() ? "Profile" : "Profile file");
    const auto needed = [&](const std::string           &entry,
                            const std::optional<double> &value,
                            const std::string           &allowed) {
      if (!value)
        throw InputError(section + entry, "none", allowed);
      return *value;
    };
    check_finite(section + "Point", point);
    const Tensor<1, 3> a = unit_vector(section + "Axis", axis);
    const Tensor<1, 3> d = unit_vector(section + "Direction", direction);
    check_not_negative(section + "Edge radius", edge_radius);
    if ((shape == Shape::step || shape == Shape::extruded ||
         shape == Shape::height_field) &&
        std::abs(a * d) > 1e-6)
      throw InputError(section + "Axis",
                       vector_to_string(axis),
                       "it must be orthogonal to 'Direction', " +
                         vector_to_string(direction));
    const bool has_profile =
      (shape == Shape::extruded || shape == Shape::revolved);
    if (!profile.empty() && !has_profile)
      throw InputError(profile_entry,
                       number_to_string(profile[0].point[0]) + " " +
                         number_to_string(profile[0].point[1]),
                       "it needs 'Shape = extruded' or 'revolved'");
    if (!height_file.empty() && shape != Shape::height_field)
      throw InputError(section + "Height file",
                       height_file,
                       "it needs 'Shape = height field'");
    if (!formula.empty() && shape != Shape::formula)
      throw InputError(
        section + "Formula", formula, "it needs 'Shape = formula'");

    // a round bar is the same from all directions across its axis, so that
    // 'Direction' may be any for it
    const BodyShape::TravelLine line{d, point},
      across{across_axis(d, a), point};
    std::shared_ptr<const BodyShape> made;
    const auto corner = [](const double u, const double v, const double r = 0) {
      return RoundedPolygon::Corner{Point<2>(u, v), r};
    };
    switch (shape)
      {
        case Shape::plane:
          made = std::make_shared<RigidPlane>(line);
          break;
        case Shape::sphere:
        case Shape::cylinder:
          {
            const double R =
              needed("Radius", radius, "it must be a number other than 0");
            check_not_zero(section + "Radius", R);
            const auto disk = std::make_shared<Disk>(Point<2>(), R);
            if (shape == Shape::sphere)
              made = std::make_shared<RevolvedBody>(line, a, disk);
            else
              made = std::make_shared<ExtrudedBody>(across, a, disk);
            break;
          }
        case Shape::torus:
          {
            const double R =
              needed("Radius", radius, "it must be a positive number");
            check_positive(section + "Radius", R);
            const double tube = needed(
              "Tube radius", tube_radius, "it must be a positive number");
            check_positive(section + "Tube radius", tube);
            check_at_most(section + "Tube radius", tube, R);
            made = std::make_shared<RevolvedBody>(
              line, a, std::make_shared<Disk>(Point<2>(0, R), tube));
            break;
          }
        case Shape::cone:
          {
            const double angle = needed(
              "Half angle", half_angle, "it must be a number between 0 and 90");
            check_positive(section + "Half angle", angle);
            if (angle >= 90)
              throw InputError(section + "Half angle",
                               number_to_string(angle),
                               "it must be below 90");
            // the section goes on below the axis as a mirror image, so that the
            // center of the arc that rounds the tip is on the axis
            const double slope = std::tan(angle * numbers::PI / 180);
            // with room for the radius
            const double length =
              (edge_radius > 0 ? 2 * edge_radius / slope : 1.);
            made = std::make_shared<RevolvedBody>(
              line,
              a,
              std::make_shared<RoundedPolygon>(
                std::vector<RoundedPolygon::Corner>{
                  corner(length, -slope * length),
                  corner(0, 0, edge_radius),
                  corner(length, slope * length)},
                section + "Edge radius"));
            break;
          }
        case Shape::step:
          {
            const double length = (edge_radius > 0 ? 2 * edge_radius : 1.);
            made                = std::make_shared<ExtrudedBody>(
              line,
              a,
              std::make_shared<RoundedPolygon>(
                std::vector<RoundedPolygon::Corner>{corner(0, -length),
                                                                   corner(0, 0, edge_radius),
                                                                   corner(length, 0)},
                section + "Edge radius"));
            break;
          }
        case Shape::extruded:
        case Shape::revolved:
          {
            const auto polygon =
              std::make_shared<RoundedPolygon>(profile, profile_entry);
            if (shape == Shape::revolved)
              for (const auto &item : profile)
                if (item.point[1] < 0)
                  throw InputError(profile_entry,
                                   number_to_string(item.point[1]),
                                   "the distance from the axis must not be "
                                   "negative");
            if (shape == Shape::revolved)
              made = std::make_shared<RevolvedBody>(line, a, polygon);
            else
              made = std::make_shared<ExtrudedBody>(line, a, polygon);
            break;
          }
        case Shape::height_field:
          if (height_file.empty())
            throw InputError(
              section + "Height file", "", "it must be the name of a CSV file");
          made = std::make_shared<ImplicitBody>(
            line,
            std::make_shared<HeightField>(
              heights, cross_product_3d(d, a), a, -d, height_file));
          break;
        case Shape::formula:
          {
            const double length =
              needed("Size", size, "it must be a positive number");
            check_positive(section + "Size", length);
            made = std::make_shared<ImplicitBody>(
              line,
              std::make_shared<FormulaSurface>(
                section + "Formula", formula, section + "Size", length));
            break;
          }
      }
    return RigidBody::without_travel(made);
  }
} // namespace Biface
