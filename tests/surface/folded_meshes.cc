// SPDX-License-Identifier: LGPL-2.1-or-later

// Where cells meet at more than the fold angle, each smooth part has nodes of
// its own: two parts at a fold, two also where a web meets a flange that goes
// on, three at the corners of a box. Gaps between faces that bound one wedge
// are known, and hinges separate smooth surfaces, too.

#include <biface/base/errors.h>
#include <biface/surface/mesh_file.h>
#include <biface/surface/quadrilateral_mesh.h>

#include "../irregular_mesh.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  void
  print(const std::string &name,
        const std::string &text,
        const std::string &joints     = "",
        const double       fold_angle = 20)
  {
    std::cout << name << ": ";
    try
      {
        MeshOptions options;
        options.fold_angle           = fold_angle;
        options.joints               = parse_joints("Joints", joints);
        const QuadrilateralMesh mesh = parse_mesh(text, "m.msh", options);
        std::cout << mesh.nodes.size() << " nodes, " << mesh.folds.size()
                  << " folds, " << mesh.free_sides.size() << " free sides";
        for (const auto &joint : mesh.joints)
          {
            std::cout << "; joint";
            for (const unsigned int n : joint)
              std::cout << ' ' << mesh.normals[n];
          }
        std::cout << "; gaps between cells";
        for (const auto &fold : mesh.folds)
          for (unsigned int face = 0; face < 2; ++face)
            for (const auto &wedge : fold.wedges[face])
              std::cout << (face == 0 ? " inner " : " outer ")
                        << mesh.cell_numbers[fold.cells[wedge[0]].cell] << '-'
                        << mesh.cell_numbers[fold.cells[wedge[1]].cell];
        std::cout << "; corners of";
        for (const auto &corner : mesh.corners[0])
          {
            // outward, if the nodes run counterclockwise
            Tensor<1, 3> outward;
            for (const unsigned int n : corner)
              outward += mesh.normals[n];
            const Tensor<1, 3> area = cross_product_3d(
              mesh.normals[corner[1]] - mesh.normals[corner[0]],
              mesh.normals[corner[2]] - mesh.normals[corner[0]]);
            std::cout << ' ' << corner.size()
                      << (area * outward > 0 ? "" : " CLOCKWISE");
          }
        for (const auto &group : mesh.groups)
          std::cout << "; '" << group.name << "' " << group.sides.size()
                    << " sides " << group.nodes.size() << " nodes";
        std::cout << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }
} // namespace


int
main()
{
  const Point<3> a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), e(2, 0, 0),
    f(2, 1, 0), g(1, 0, 1), h(1, 1, 1), i(0, 0, 1), j(0, 1, 1);
  const std::vector<Point<3>> nodes{a, b, c, d, e, f, g, h, i, j};
  const std::string           one = "3 0 1 2 3 4", two = "3 0 2 5 6 3",
                    web  = "3 0 2 7 8 3";
  const std::string line = "1 2 1 1 2 3";

  // along the x axis, then up: on the inner side the faces are apart
  print("fold", gmsh_text(nodes, {one, web, line}));
  print("fold of the other orientation",
        gmsh_text(nodes, {"3 0 4 3 2 1", web}));
  print("smooth with a larger angle",
        gmsh_text({a, b, c, d, {1.8, 0, .6}, {1.8, 1, .6}}, {one, two}),
        "",
        40);
  print("web on a flange", gmsh_text(nodes, {one, two, web, line}));
  print("web on a flange, outer face first",
        gmsh_text(nodes, {"3 0 4 3 2 1", two, web}));
  print("box",
        gmsh_text({a, b, c, d, i, g, h, j},
                  {"3 0 1 4 3 2",
                   "3 0 5 6 7 8",
                   "3 0 1 2 6 5",
                   "3 0 2 3 7 6",
                   "3 0 3 4 8 7",
                   "3 0 4 1 5 8"}));
  print("hinge", gmsh_text(nodes, {one, two, line}), "1: hinge");
  print("hinge of a web", gmsh_text(nodes, {one, two, web, line}), "1: hinge");
  print("spring", gmsh_text(nodes, {one, web, line}), "1: 2.5");

  print("spring in a plane", gmsh_text(nodes, {one, two, line}), "1: 2.5");
  print("spring at an edge", gmsh_text(nodes, {one, "1 2 1 1 1 2"}), "1: 2.5");
  print("no lines", gmsh_text(nodes, {one, two}), "1: hinge");
  print(
    "on each other",
    gmsh_text({a, b, c, d, {0, 0, 1e-4}, {0, 1, 1e-4}}, {one, "3 0 2 5 6 3"}));
  for (const std::string joint :
       {"1", "1: stiff", "1: 0", "1: -2", "1: nan", "1: hinge, 1: rigid"})
    print(joint, gmsh_text(nodes, {one, two, line}), joint);
}
