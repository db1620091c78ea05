// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/surface/mesh_file.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  MeshFile::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(prm,
               "File",
               "",
               name,
               parse_file_name,
               "The file of the mesh of a surface of type 'mesh': a mesh of "
               "quadrilaterals of Gmsh, MSH 2.2 or 4.1 in ASCII, or an "
               "input file of Abaqus or CalculiX with shells of four, eight "
               "or nine nodes. Outward is "
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
    prm.add_parameter("Fold angle",
                      fold_angle,
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
               joints,
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
  MeshFile::read(const MPI_Comm communicator)
  {
    mesh = std::make_shared<const QuadrilateralMesh>(
      parse_mesh(read_file(name, communicator), name, fold_angle, joints));
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
