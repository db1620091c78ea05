// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>
#include <map>
#include <memory>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/surface/known_surface.h>
#include <biface/surface/mesh_file.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::shared_ptr<const KnownSurface>
    parse_geometry(const std::string &entry, const std::string &text)
    {
      if (text.empty())
        return {};
      return std::make_shared<const SurfaceOfFormula>(
        Formula(entry, text, {"x", "y", "z"}));
    }
  } // namespace


  void
  MeshFile::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(prm,
               "File",
               "",
               name,
               parse_file_name,
               "The file of the mesh of a surface of type 'mesh': a mesh of "
               "quadrilaterals, or with 'Refine' also of triangles, of Gmsh, "
               "MSH 2.2 or 4.1 in ASCII, or an input file of Abaqus or "
               "CalculiX with shells. Outward is "
               "where the nodes of its cells run counterclockwise. Its "
               "physical groups or sets of nodes are edges, with their free "
               "sides, and those of single nodes are "
               "named points, for 'Edge supports', 'Edge forces', 'Edge "
               "moments', 'Point supports' and so on. Relative to the "
               "parameter file; see 'Tables' for names in double quotes.",
               Unit("length") | RestartChange::always);
    add_parsed(
      prm,
      "Direction",
      "1; 0; 0",
      direction,
      [](const std::string &entry, const std::string &text) {
        std::vector<Formula> formulas;
        for (const std::string &item : split_list(entry, text, ';'))
          formulas.emplace_back(
            entry, item, std::vector<std::string>{"x", "y", "z"});
        if (formulas.size() != 3)
          throw InputError(entry,
                           text,
                           "it must consist of three numbers or "
                           "formulas of x, y, z, separated by "
                           "semicolons");
        return formulas;
      },
      "The direction of alpha_1 on a surface of type 'mesh', from "
      "which the angles of plies count, toward outward normal x "
      "direction: the x, y and z components, numbers or formulas of "
      "the position x, y, z, of a vector that is projected into the "
      "surface; '-y; x; 0' runs around the z axis. v_1 of supports "
      "and loads is along it.");
    prm.add_parameter("Merge distance",
                      options.merge_distance,
                      "Nodes of the mesh that are at most so far apart are one "
                      "node, the first one of them in the file: for parts that "
                      "were meshed one by one. Not negative, and smaller than "
                      "the sides of all cells; 0 for none.",
                      Patterns::Double(),
                      Unit("length"));
    prm.add_parameter("Refine",
                      options.n_refinements,
                      "How often all cells of the mesh are divided: a "
                      "quadrilateral into four, a triangle into three "
                      "quadrilaterals. New nodes are in the middle of sides "
                      "and cells, on the surface of 'Geometry' if there is "
                      "one. At most 10.",
                      Patterns::Integer(0, 10));
    add_parsed(prm,
               "Geometry",
               "",
               options.surface,
               parse_geometry,
               "A formula of the position x, y, z that is zero on the surface, "
               "such as x^2 + y^2 + z^2 - 100^2 for a sphere, and smooth "
               "around it: the nodes of the mesh are moved to it, also the new "
               "ones of 'Refine', and have its normals. Surfaces of several "
               "parts have several formulas, as in z > 0 ? x^2 + y^2 + z^2 - "
               "50^2 : x^2 + y^2 - 50^2; at a fold, the condition must change "
               "beside its nodes. Nodes of the file must be on it "
               "within a tenth of the sides of their cells. Empty: the mesh "
               "itself is the surface, and normals are the means of the cells "
               "around a node.",
               Unit("length"));
    add_parsed(prm,
               "Geometry file",
               "",
               geometry_file,
               parse_file_name,
               "A file of STEP whose faces are the surface, in place of a "
               "formula in 'Geometry'; new nodes at the ends of the surface "
               "and at folds are on its edges. Its lengths are converted to "
               "that of 'Units': mm, cm, m, in or ft, or mm if there is none. "
               "Relative to the parameter file; see 'Tables' for names in "
               "double quotes.",
               RestartChange::always);
    prm.add_parameter("Fold angle",
                      options.fold_angle,
                      "The angle up to which neighboring cells of a mesh form "
                      "a smooth surface with one normal at each node; at "
                      "larger ones they meet at a fold. Positive, at "
                      "most 60; a smooth surface whose cells turn by more than "
                      "20 degrees each is a coarse one.",
                      Patterns::Double(),
                      Unit("degrees"));
    add_parsed(prm,
               "Joints",
               "",
               options.joints,
               parse_joints,
               "How cells of a mesh are joined at the sides of groups of "
               "lines, 'lines: rigid', 'lines: hinge' or 'lines: STIFFNESS', "
               "separated by commas, also where two cells go on smoothly: "
               "'rigid' keeps the angles between the parts, as everywhere else "
               "at folds; 'hinge' exerts no moment; a number is the moment per "
               "length of the line and per angle in radians, a force, between "
               "each pair of parts. Where "
               "three cells or more meet, those that go on smoothly remain one "
               "part.",
               Unit("force"));
  }


  std::vector<JointOfGroup>
  parse_joints(const std::string &entry, const std::string &text)
  {
    const std::string form = "each joint must have the form 'lines: rigid', "
                             "'lines: hinge' or 'lines: STIFFNESS', with a "
                             "positive moment per length and angle";

    std::vector<JointOfGroup> joints;
    for (const std::string &item : split_list(entry, text))
      {
        const auto [group, kind] = split_named(entry, item, form);
        const double stiffness =
          (kind == "rigid"   ? std::numeric_limits<double>::infinity()
           : kind == "hinge" ? 0.
                             : parse_number(entry, kind, form));
        if (kind != "hinge" && !(stiffness > 0))
          throw InputError(entry, item, form);
        for (const JointOfGroup &other : joints)
          if (other.group == group)
            throw InputError(entry, item, "'" + group + "' is named twice");
        joints.push_back({item, group, stiffness});
      }
    return joints;
  }


  void
  MeshFile::read(const std::string &unit, const MPI_Comm communicator)
  {
    if (!geometry_file.empty())
      {
        if (options.surface)
          throw InputError("Surface/Mesh/Geometry file",
                           geometry_file,
                           "there is a formula in 'Geometry', too");
        const std::map<std::string, double> millimeters{{"", 1},
                                                        {"mm", 1},
                                                        {"cm", 10},
                                                        {"m", 1000},
                                                        {"in", 25.4},
                                                        {"ft", 304.8}};
        const auto                          known = millimeters.find(unit);
        if (known == millimeters.end())
          throw InputError("Units",
                           unit,
                           "lengths of 'Surface/Mesh/Geometry file' can be "
                           "converted to mm, cm, m, in or ft only");
        options.surface = surface_of_step(
          read_file(geometry_file, communicator), geometry_file, known->second);
      }
    mesh = std::make_shared<const QuadrilateralMesh>(
      parse_mesh(read_file(name, communicator), name, options));
  }


  Tensor<1, 3>
  MeshFile::direction_at(const Point<3> &x) const
  {
    const std::vector<double> variables{x[0], x[1], x[2]};
    Tensor<1, 3>              result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = direction[d](variables);
    return result;
  }
} // namespace Biface
