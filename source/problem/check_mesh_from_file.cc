// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  Parameters::read_mesh(const MPI_Comm communicator)
  {
    if (surface.type != ReferenceSurface::Parameters::Type::mesh)
      return;
    if (surface.mesh.name.empty())
      throw InputError(
        "Surface/Mesh/File", "", "a surface of type 'mesh' needs a file");
    const MeshOptions &options = surface.mesh.options;
    if (!(options.fold_angle > 0 && options.fold_angle <= 60))
      throw InputError("Surface/Mesh/Fold angle",
                       number_to_string(options.fold_angle),
                       "it must be positive and at most 60");
    check_not_negative("Surface/Mesh/Merge distance", options.merge_distance);
    surface.mesh.read(units.of_length(), communicator);
    // without coordinates, none of them is closed
    mesh.closed = false;

    for (const QuadrilateralMesh::Group &group : surface.mesh.mesh->groups)
      // a name with separators of lists could not be used
      if (group.nodes.size() == 1 && group.sides.empty() &&
          group.name.find_first_of(",;:\"\n\t") == std::string::npos)
        {
          for (const NamedPoint &point : points.list)
            if (point.name == group.name)
              throw InputError("Named points",
                               point.name,
                               "the mesh has a point of this name");
          NamedPoint point;
          point.name     = group.name;
          point.position = surface.mesh.mesh->nodes[group.nodes[0]];
          points.list.push_back(point);
        }
  }


  void
  Parameters::check_mesh_from_file() const
  {
    const std::string why = " on a mesh from a file, which has no coordinates";

    for (unsigned int edge = 0; edge < supports.edges.size(); ++edge)
      if (!supports.edges[edge].empty() || supports.cyclic[edge])
        throw InputError("the entry 'Supports/" + edge_names[edge] +
                         "' must be 'free'" + why +
                         "; use 'Edge supports' with the groups of lines.");
    if (mesh.n_coarse > 0)
      throw InputError("Mesh/Coarse meshes",
                       std::to_string(mesh.n_coarse),
                       "it must be 0" + why);
    if (linear_solver.is_iterative())
      throw InputError("the section 'Linear solver' must choose the direct "
                       "solver, and not a multigrid," +
                       why + ".");
    for (const std::string &name :
         Formula("Surface/Imperfection/Formula", surface.imperfection.formula)
           .used_names())
      if (name != "x" && name != "y" && name != "z")
        throw InputError("Surface/Imperfection/Formula",
                         surface.imperfection.formula,
                         "it must be a formula of x, y and z" + why);
    if (formulation != Formulation::standard)
      throw InputError("the entry 'Formulation' must be 'standard'" + why +
                       ".");
    if (laminate.integrals == ThicknessIntegrals::shell)
      throw InputError("Laminate/Integrals",
                       "shell",
                       "it must be 'plate'" + why + " or curvatures");
    for (const PlyParameters &ply : laminate.plies)
      if (ply.range)
        throw InputError("Laminate/Plies",
                         ply.text,
                         "a ply cannot go from one coordinate to another" +
                           why + "; use 'in GROUP'");
    if (!laminate.tables.empty())
      throw InputError("the entry 'Laminate/Tables' must be empty" + why +
                       " by which tables go.");
    if (!laminate.initial_resultants.empty())
      throw InputError("the entry 'Laminate/Initial resultants' must be empty" +
                       why + ".");
    for (const EdgeForce &force : loads.edge_forces)
      if (force.true_length)
        throw InputError("Loads/Edge forces",
                         force.text,
                         "'true length' is not possible" + why);
    for (const std::string &output : sensitivities.outputs)
      for (const std::string of_footprint : {"footprint_length",
                                             "footprint_width",
                                             "footprint_area",
                                             "mean_pressure",
                                             "load_ratio"})
        if (output == of_footprint)
          throw InputError("Sensitivities/Outputs",
                           output,
                           "on a mesh from a file it has no derivative, since "
                           "it jumps with each node in contact");
    if (!pressure.end_plates.empty())
      throw InputError("the entry 'Loads/End plates' must be empty" + why +
                       ".");
    if (gas.ambient_pressure && gas.cavity.rim_radius)
      throw InputError("Gas/Rim radius",
                       number_to_string(*gas.cavity.rim_radius),
                       "it must be 'edges'" + why);
  }
} // namespace Biface
