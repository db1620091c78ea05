// SPDX-License-Identifier: LGPL-2.1-or-later

// 'Refine' divides triangles into three quadrilaterals and quadrilaterals into
// four, with their groups and sets of nodes; on a known surface all nodes lie
// on it and have its normals, also beside a fold; close nodes become one; and
// what fits neither is refused with its place.

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/surface/known_surface.h>
#include <biface/surface/mesh_options.h>
#include <biface/surface/quadrilateral_mesh.h>

#include "../irregular_mesh.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  MeshOptions
  refined(const unsigned int n, const std::string &formula = "")
  {
    MeshOptions options;
    options.n_refinements = n;
    if (!formula.empty())
      options.surface = std::make_shared<const SurfaceOfFormula>(
        Formula("Geometry", formula, {"x", "y", "z"}));
    return options;
  }


  void
  print(const std::string &name,
        const std::string &text,
        const MeshOptions &options)
  {
    std::cout << name << ": ";
    try
      {
        const QuadrilateralMesh mesh = parse_mesh(text, "m.msh", options);
        std::cout << mesh.nodes.size() << " nodes, " << mesh.cells.size()
                  << " cells, " << mesh.free_sides.size() << " free sides, "
                  << mesh.folds.size() << " folds, groups";
        for (const auto &group : mesh.groups)
          std::cout << " '" << group.name << "' " << group.cells.size() << ' '
                    << group.sides.size() << ' ' << group.nodes.size();
        for (const std::string &remark : mesh.remarks)
          std::cout << "; " << remark;
        std::cout << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }


  double
  area(const QuadrilateralMesh &mesh)
  {
    double area = 0;
    for (const auto &cell : mesh.cells)
      area += cross_product_3d(mesh.nodes[cell[3]] - mesh.nodes[cell[0]],
                               mesh.nodes[cell[2]] - mesh.nodes[cell[1]])
                .norm() /
              2;
    return area;
  }
} // namespace


int
main()
{
  const Point<3>    a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), e(2, 0, 0);
  const std::string quadrilateral = "3 2 5 5 1 2 3 4",
                    triangle = "2 2 6 6 2 5 3", line = "1 2 1 1 1 2",
                    point = "15 2 9 9 3";
  const std::string both =
    gmsh_text({a, b, c, d, e}, {quadrilateral, triangle, line, point});
  print("once", both, refined(1));
  print("twice", both, refined(2));
  check_small("area", area(parse_mesh(both, "m.msh", refined(2))) - 1.5, 1e-14);
  print("not at all", both, refined(0));

  // a cell of four nodes with one of them twice is a triangle
  print("repeated corner", gmsh_text({a, b, c}, {"3 0 1 2 3 3"}), refined(1));

  // the set is that of the bottom and the right: the side of the triangle that
  // joins both is not in it
  const std::string nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n"
                            "4, 0, 1, 0\n5, 1, 1, 0\n6, 2, 1, 0\n";
  print("set around a corner",
        nodes + "*ELEMENT, TYPE=S4\n1, 1,2,5,4\n*ELEMENT, TYPE=S3\n2, 2,3,6\n"
                "3, 2,6,5\n*NSET, NSET=rim\n1, 2, 3, 6\n",
        refined(1));
  // a line across the mesh, from one free side to another
  print("set across",
        nodes + "*ELEMENT, TYPE=S4\n1, 1,2,5,4\n2, 2,3,6,5\n"
                "*NSET, NSET=middle\n2, 5\n",
        refined(2));
  print("set of all nodes",
        nodes + "*ELEMENT, TYPE=S4\n1, 1,2,5,4\n2, 2,3,6,5\n"
                "*NSET, NSET=all, GENERATE\n1, 6\n",
        refined(1));

  print("set of a part",
        nodes + "7, 0, 2, 0\n8, 1, 2, 0\n9, 2, 2, 0\n"
                "*ELEMENT, TYPE=S4\n1, 1,2,5,4\n2, 2,3,6,5\n3, 4,5,8,7\n"
                "4, 5,6,9,8\n*NSET, NSET=all, GENERATE\n1, 9\n",
        refined(1));
  print("cells on each other",
        nodes + "*ELEMENT, TYPE=S4\n1, 1,2,5,4\n2, 1,2,5,4\n",
        {});
  print(
    "cylindrical coordinates", "*NODE, SYSTEM=C\n1, 0, 0, 0\n2, 1, 0, 0\n", {});

  // an irregular part of a sphere
  const std::string part   = gmsh_text(irregular_mesh(4, 4, 0.25, hemisphere)),
                    sphere = "x^2 + y^2 + z^2 - 100";
  for (const unsigned int n : {0, 2})
    {
      const QuadrilateralMesh mesh =
        parse_mesh(part, "m.msh", refined(n, sphere));
      double off = 0, turned = 0;
      for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
        {
          const double r = mesh.nodes[i].distance(Point<3>());
          off            = std::max(off, std::abs(r - 10));
          turned         = std::max(
            turned,
            (mesh.normals[i] - (mesh.nodes[i] - Point<3>()) / r).norm());
        }
      std::cout << "sphere: " << mesh.cells.size() << " cells" << std::endl;
      check_small("off the sphere", off, 1e-13, 10);
      check_small("normals", turned, 1e-9);
    }
  print("facets", part, refined(1));

  // a roof of two arcs that meet at the top: each has its own normals
  const std::string roof = "x < 0 ? (x-3)^2 + z^2 - 25 : (x+3)^2 + z^2 - 25";
  const QuadrilateralMesh folded = parse_mesh(
    gmsh_text(
      {{-2, 0, 0}, {0, 0, 4}, {2, 0, 0}, {-2, 2, 0}, {0, 2, 4}, {2, 2, 0}},
      {"3 0 1 2 5 4", "3 0 2 3 6 5"}),
    "m.msh",
    refined(3, roof));
  double turned = 0;
  for (unsigned int i = 0; i < folded.nodes.size(); ++i)
    {
      const Point<3> &x = folded.nodes[i];
      if (std::abs(x[0]) > 1e-9)
        {
          const Tensor<1, 3> arm({x[0] + (x[0] < 0 ? -3 : 3), 0, x[2]});
          turned = std::max(turned,
                            1 - std::abs(arm / arm.norm() * folded.normals[i]));
        }
    }
  std::cout << "roof: " << folded.folds.size() << " sides of folds"
            << std::endl;
  check_small("normals of the roof", turned, 1e-9);

  // not the inner side of a wall, and no normal where formulas meet
  print("inner side",
        part,
        refined(1, "(x^2 + y^2 + z^2 - 100)*(x^2 + y^2 + z^2 - 99)"));
  const SurfaceOfFormula pyramid(
    Formula("Geometry", "x < 0 ? z - x : sinh(z + x)", {"x", "y", "z"}));
  check_small("normal at a kink",
              pyramid.normal(Point<3>(), Tensor<1, 3>({0, 0, 1}), 1).norm(),
              1e-14);

  // an open seam
  MeshOptions merged;
  merged.merge_distance  = 1e-3;
  const std::string seam = gmsh_text(
    {a, b, c, d, {1.0005, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1.0005, 0}},
    {"3 0 1 2 3 4", "3 0 5 6 7 8", "1 2 1 1 2 3", "1 2 2 2 5 8"});
  print("apart", seam, {});
  print("united", seam, merged);
  merged.merge_distance = 1;
  print("too much", seam, merged);
  print("off the surface", both, refined(1, "z - 0.2"));
  print("no surface", both, refined(1, "z^2 + 1"));
  print("no gradient", both, refined(1, "0*z"));
  print("too many", part, refined(10));
  print("nan", both, refined(1, "sqrt(-1 - z^2)"));
}
